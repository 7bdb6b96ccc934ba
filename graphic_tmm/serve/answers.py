"""What a desk answers when a browser asks for more than it follows: forms, changes, titles, files."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Callable, Mapping, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

from graphic_tmm.errors import SceneError, TmmError
from graphic_tmm.fitting.composition import composition_file, known_composition
from graphic_tmm.note.note import note_files, wanted
from graphic_tmm.page import FORMAT
from graphic_tmm.page.page import page
from graphic_tmm.readers.table import table
from graphic_tmm.scene.packaged import FILE, scene_name
from graphic_tmm.serve import jobs, photos
from graphic_tmm.serve.desk import URGENT, Desk, Scene, said_of
from graphic_tmm.serve.jobs import File, Refused, Task, refusing, scene_of
from graphic_tmm.serve.kept import SceneFault, hashed
from graphic_tmm.serve.limits import DOWNLOAD, JUDGING
from graphic_tmm.serve.scheme.act import SchemeAct
from graphic_tmm.serve.worker import Broken, Gone, TooLong, Worker
from graphic_tmm.studio import make, sheet_files

T = TypeVar("T")
Files = Mapping[str, str | bytes]
EXTRAS = {"pdf": ("typst",), "png": ("typst",), "dxf": ("ezdxf",), "note": ("pypandoc", "typst")}
"""What a format needs that may not be installed."""
ALWAYS = (1980, 1, 1, 0, 0, 0)
"""When the files of a ZIP were made: a download does not depend on the clock."""


def forms() -> tuple[str, ...]:
    """Return what a scene can be downloaded as."""
    return tuple(form for form in FORMS if all(map(_there, EXTRAS.get(form, ()))))


def photographs() -> bool:
    """Whether photographs can be checked."""
    return all(map(_there, ("PIL", "cv2")))


def _there(module: str) -> bool:
    return find_spec(module) is not None


@refusing
def downloaded(task: Task, form: str) -> File:
    """Return the file of a scene in a format; of several a ZIP."""
    found = FORMS[form](task)
    if len(found) == 1:
        ((name, text),) = found.items()
        return File(name, _bytes(text))
    return File(f"{scene_name(task.file)}-{form}.zip", zipped(found))


def zipped(files: Files) -> bytes:
    """Return files in a ZIP."""
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in files.items():
            archive.writestr(zipfile.ZipInfo(name, ALWAYS), _bytes(text), zipfile.ZIP_DEFLATED)
    return made.getvalue()


def _bytes(text: str | bytes) -> bytes:
    return text.encode() if isinstance(text, str) else text


def _sheets(form: str) -> Callable[[Task], Files]:
    def files(task: Task) -> Files:
        given = None
        if task.given is not None:
            given = known_composition(task.given, composition_file(task.file))
        return sheet_files(scene_of(task), (form,), given=given, whole={FORMAT: page})[1]

    return files


def _tables(task: Task) -> Files:
    text = table(make(scene_of(task)), "csv")
    return {f"{scene_name(task.file)}.csv": str(text)}


def _note(task: Task) -> Files:
    scene = scene_of(task)
    made = make(scene, wanted=wanted(scene))
    return note_files(made, f"{scene_name(task.file)}-note", ("docx",))


def _itself(task: Task) -> Files:
    return {Path(task.file).name: task.data}


FORMS: dict[str, Callable[[Task], Files]] = {
    **{form: _sheets(form) for form in ("svg", "pdf", "png", "dxf", FORMAT)},
    "csv": _tables,
    "note": _note,
    "toml": _itself,
}
"""What a browser may take away, by the name that its address has."""


class Form(NamedTuple):
    """The values of a scene as a form, and the version of the text that they stand in."""

    version: str
    groups: list[dict[str, Any]]


class Written(NamedTuple):
    """The version that a file has; ``done``: what was to be set is set in it, else it was changed meanwhile."""

    version: str
    done: bool


class Sent(NamedTuple):
    """What a scheme is sent with: the text that it is of, and the version of the file; "" at first."""

    text: str
    version: str


class Scheme(NamedTuple):
    """A scheme after an act, and the version of its file; ``done``: else the file has changed meanwhile."""

    version: str
    done: bool
    scheme: dict[str, Any]


class Answers:
    """A desk, as it is asked."""

    def __init__(self, desk: Desk) -> None:
        self.desk = desk

    async def titles(self) -> dict[str, str]:
        """Return what the scenes of the folder call themselves, by name; "" where that cannot be told."""
        there = dict[str, Task]()
        for name, file in self.desk.folder.scenes().items():
            try:
                data = self.desk.folder.read(file)
            except SceneError:
                data = b""
            there[name] = Task(data, str(file))
        return dict(zip(there, await self.titles_of(list(there.values())), strict=True))

    async def titles_of(self, tasks: Sequence[Task]) -> list[str]:
        """Return what scenes call themselves, in order."""
        found = await self._judged(jobs.titled, tasks)
        return [""] * len(tasks) if isinstance(found, Refused) else list(found)

    async def form(self, scene: Scene) -> Form | Refused:
        """Return the values of a scene's file, as it is now."""
        try:
            data = self.desk.folder.read(scene.file)
        except SceneError as error:
            return Refused(self.desk.unread(scene, error))
        found = await self._judged(
            jobs.formed, Task(data, str(scene.file), None, self.desk.language)
        )
        return found if isinstance(found, Refused) else Form(hashed(data), found)

    async def change(
        self, scene: Scene, version: str, changes: Mapping[str, str]
    ) -> Written | Refused:
        """Set values in a scene's file, all of them or none; one after the other of those who write."""
        async with scene.writing:
            try:
                data = self.desk.folder.read(scene.file)
                if hashed(data) != version:
                    return Written(hashed(data), False)
                task = Task(data, str(scene.file), None, self.desk.language)
                new = await self._judged(jobs.changed, task, changes)
                if isinstance(new, Refused):
                    return new
                now = self.desk.folder.read(scene.file)  # an editor may have saved it meanwhile
                if now != data:
                    return Written(hashed(now), False)
                if new != data:
                    self.desk.folder.write(scene.file, new)
            except TmmError as error:
                return Refused(self.desk.unread(scene, error))
        self.desk.look(scene.kept.name)
        return Written(hashed(new), True)

    async def scheme(self, scene: Scene | None, asked: SchemeAct, sent: Sent) -> Scheme | Refused:
        """Return the scheme of a scene after an act, written into its file where it has one and is whole."""
        if scene is None:
            task = Task(
                sent.text.encode(),
                str(self.desk.folder.root / FILE),
                None,
                self.desk.speech(None).language,
            )
            found = await self._judged(jobs.schemed, task, asked)
            return found if isinstance(found, Refused) else Scheme("", True, found)
        async with scene.writing:
            try:
                data = self.desk.folder.read(scene.file)
            except SceneError as error:
                return Refused(self.desk.unread(scene, error))
            version = hashed(data)
            if sent.version not in ("", version):
                return Scheme(version, False, {})
            base = sent.text.encode() if sent.version else data
            task = Task(base, str(scene.file), None, self.desk.speech(Task(data, "")).language)
            found = await self._judged(jobs.schemed, task, asked)
            if isinstance(found, Refused):
                return found
            new = (found["text"] or "").encode()
            if (
                not new
                or found["errors"]
                or new == data
                or not sent.version
                or self.desk.folder.fixed
            ):
                return Scheme(version, True, found)
            if self.desk.folder.read(scene.file) != data:
                return Scheme(hashed(self.desk.folder.read(scene.file)), False, {})
            try:
                self.desk.folder.write(scene.file, new)
            except TmmError as error:
                return Refused(self.desk.unread(scene, error))
        self.desk.look(scene.kept.name)
        return Scheme(hashed(new), True, found)

    async def create(self, text: str, title: str) -> str | Refused:
        """Put a scene that was drawn into the folder; return the name that it has there."""
        task = Task(text.encode(), FILE, None, self.desk.speech(None).language)
        files = await self._judged(jobs.begun_files, task, title)
        if isinstance(files, Refused):
            return files
        try:
            return self.desk.folder.create(title, {k: one.encode() for k, one in files.items()})
        except TmmError as error:
            return Refused(jobs.faults(error, "", self.desk.speech(None)))

    async def download(self, scene: Scene, form: str) -> File | Refused:
        """Return a scene's file in a format, drawn apart from what is looked at."""
        return await self._of_scene(self.desk.aside, scene, downloaded, form)

    async def plans(self, scene: Scene) -> dict[str, Any] | Refused:
        """Return the plans of a scene that may be clicked; who has drawn its sheets knows them."""
        return await self._of_scene(self.desk.behind, scene, photos.clickable)

    async def check(self, scene: Scene, clicked: photos.Clicked) -> photos.Checked | Refused:
        """Return what the check of a photograph says, apart from what is looked at."""
        return await self._of_scene(self.desk.aside, scene, photos.photo_checked, clicked)

    async def propose(
        self, scene: Scene, clicked: photos.Clicked
    ) -> list[dict[str, Any]] | Refused:
        """Return the plans that a photograph seems to show."""
        return await self._of_scene(self.desk.aside, scene, photos.plans_proposed, clicked)

    async def _of_scene(
        self, worker: Worker, scene: Scene, job: Callable[..., T], *given: Any
    ) -> T | Refused:
        """Return what a job gives for a scene as it is now."""
        if scene.data is None:
            return Refused(scene.kept.errors)
        task = Task(scene.data, str(scene.file), scene.beside, self.desk.language)
        try:
            return await worker.ask(job, task, *given, limit=DOWNLOAD)
        except (TooLong, Gone, Broken) as error:
            return Refused((SceneFault(0, "", said_of(error, self.desk.speech(task))),))

    async def _judged(self, job: Callable[..., Any], *given: Any) -> Any:
        try:
            return await self.desk.front.ask(job, *given, limit=JUDGING, urgency=URGENT)
        except (TooLong, Gone, Broken) as error:
            speech = self.desk.speech(next(filter(_is_task, given), None))
            return Refused((SceneFault(0, "", said_of(error, speech)),))


def _is_task(given: object) -> bool:
    return isinstance(given, Task)
