"""When what is drawn: a scene again when its file has changed, its sheets first, its page behind them.

Two processes draw. The one in front puts a scene that was drawn before on sheets in the sizes, and where it can
at the places, of then, which takes a part of the time; the one behind composes it anew, as ``draw`` does, and
makes its page. Where both come to the same sheets, nothing is sent twice. What comes of a text that has changed
meanwhile is thrown away.
"""

from __future__ import annotations

import asyncio
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from graphic_tmm.errors import SceneError, TmmError
from graphic_tmm.language.catalogue import Speech, speaking
from graphic_tmm.language.reader import reader
from graphic_tmm.language.said import said
from graphic_tmm.scene.document import spoken
from graphic_tmm.serve import jobs
from graphic_tmm.serve.folder import Folder
from graphic_tmm.serve.jobs import Drafted, Refused, Task
from graphic_tmm.serve.kept import Kept, SceneFault, as_sheets, hashed, with_lines
from graphic_tmm.serve.limits import DRAWING, JUDGING
from graphic_tmm.serve.worker import Broken, Gone, TooLong, Worker

URGENT, USUAL, IDLE = 0, 1, 2
"""Whose turn comes first: who waits for an answer, what is shown, what nobody looks at."""


@dataclass
class Scene:
    """A scene on the desk: its file, what is kept of it, what it was drawn from.

    ``data``: its text; ``beside``: the composition that stands beside it. ``composition``: how its sheets were
    composed last; ``done``: what the text said, and what stood beside it, of which sheets and page are;
    ``urgency``: `IDLE` while nobody looks at more than its sheets among those of others.
    """

    file: Path
    kept: Kept
    data: bytes | None = None
    beside: bytes | None = None
    composition: bytes | None = None
    done: tuple[str, bytes | None] = ("", None)
    urgency: int = IDLE
    writing: asyncio.Lock = field(default_factory=asyncio.Lock)
    drawing: asyncio.Task[None] | None = None


class Desk:
    """The scenes of a folder that somebody looks at, and the processes that draw them: ``aside`` downloads."""

    def __init__(self, folder: Folder, language: str = "") -> None:
        self.folder, self.language = folder, language
        self.scenes: dict[str, Scene] = {}
        self.front, self.behind, self.aside = (
            Worker(jobs.warmed, patient=patient) for patient in (False, True, True)
        )
        self._warming: list[asyncio.Task[None]] = []

    def open(self) -> None:
        """Begin the processes; nobody waits for them yet."""
        self._warming = [asyncio.create_task(_warm(one)) for one in (self.front, self.behind)]

    def close(self) -> None:
        """End all that is being drawn, at once."""
        for worker in (self.front, self.behind, self.aside):
            worker.close()
        drawing = [one.drawing for one in self.scenes.values() if one.drawing is not None]
        for task in (*self._warming, *drawing):
            task.cancel()

    # ------------------------------------------------------------ looking

    def wanted(self, name: str, urgency: int = USUAL) -> Scene | None:
        """Return a scene that somebody looks at, by its name; None if there is none.

        ``urgency``: `IDLE` if its sheets alone are looked at, among those of others.
        """
        if name not in self.scenes:
            file = self.folder.scenes().get(name)
            if file is None:
                return None
            self.scenes[name] = Scene(file, Kept(name), urgency=urgency)
            self.look(name)
        scene = self.scenes[name]
        if urgency < scene.urgency:
            scene.urgency = urgency
            if scene.data is not None:
                self._begin(scene, scene.data)
        return scene

    def look_all(self) -> None:
        """Read all scenes again that somebody looks at."""
        for name in self.scenes:
            self.look(name)

    def look(self, name: str) -> None:
        """Read a scene again, and draw it if its text, or the composition beside it, has changed."""
        scene = self.scenes[name]
        try:
            data = self.folder.read(scene.file)
            beside = self.folder.composition(scene.file)
        except SceneError as error:
            self._stop(scene)
            scene.data = None
            scene.kept.tell(fresh=False)
            _refuse(scene.kept, "", self.unread(scene, error))
            return
        if (data, beside) == (scene.data, scene.beside):
            return
        scene.beside = beside
        self._begin(scene, data)

    def draw_again(self, scene: Scene) -> None:
        """Draw a scene once more that was not drawn to its end."""
        if scene.kept.failed and scene.data is not None:
            self._begin(scene, scene.data)

    def _begin(self, scene: Scene, data: bytes) -> None:
        """Begin to draw a scene; what is being drawn of it is of no use any more."""
        self._stop(scene)
        scene.data = data
        task = Task(data, str(scene.file), scene.beside, self.language)
        scene.drawing = asyncio.create_task(self._drawn(scene, task))

    @staticmethod
    def _stop(scene: Scene) -> None:
        if scene.drawing is not None:
            scene.drawing.cancel()
            scene.drawing = None

    def unread(self, scene: Scene, error: TmmError) -> tuple[SceneFault, ...]:
        """Return what is told of a file that cannot be read or written."""
        return jobs.faults(error, str(scene.file), self.speech(None))

    # ------------------------------------------------------------ drawing

    async def _drawn(self, scene: Scene, task: Task) -> None:
        """Draw a scene, its sheets first; tell every step of it."""
        version = hashed(task.data)
        scene.kept.tell(busy=True, fresh=False, failed="", text_version=version)
        first = scene.composition is None
        try:
            refused = await self._stages(scene, task)
        except (TooLong, Gone, Broken) as error:
            says = said_of(error, self.speech(task))
            scene.kept.tell(ok=False, busy=False, errors=(), failed=says)
            return
        if refused is not None:
            _refuse(scene.kept, version, with_lines(refused.faults, task.data))
            return
        scene.kept.tell(busy=False)
        if first and scene.urgency != IDLE:  # so that the next edit finds it warm
            await self._drafted(scene, task, IDLE)

    async def _stages(self, scene: Scene, task: Task) -> Refused | None:
        """Draw in front in the sizes of before, behind anew, then the page; return what it is refused for."""
        soon = IDLE if scene.urgency == IDLE else URGENT
        meaning = await self.front.ask(jobs.meant, task, limit=JUDGING, urgency=soon)
        if isinstance(meaning, Refused):
            return meaning
        if scene.done == (meaning, task.given):
            scene.kept.tell(ok=True, fresh=True, errors=())
            return None
        draft = asyncio.create_task(self._drafted(scene, task, soon, show=True))
        try:
            found = await self.behind.ask(
                jobs.drawn_sheets, task, limit=DRAWING, urgency=scene.urgency
            )
        finally:
            draft.cancel()
        if isinstance(found, Refused):
            return found
        _show(scene, found.sheets, warnings=found.warnings)
        scene.composition = found.composition
        if scene.urgency == IDLE:
            return None
        page = await self.behind.ask(jobs.paged, task, limit=DRAWING)
        if isinstance(page, Refused):
            return page
        scene.kept.tell(page=scene.kept.keep(page))
        scene.done = meaning, task.given
        return None

    async def _drafted(self, scene: Scene, task: Task, urgency: int, *, show: bool = False) -> None:
        """Draw a scene as it was composed before, if it was; what goes wrong so may go well anew."""
        given = scene.composition if task.given is None else task.given
        if given is None:
            return
        task = task._replace(given=given)
        with suppress(TooLong, Gone, Broken):
            found = await self.front.ask(jobs.drafted, task, limit=DRAWING, urgency=urgency)
            if show and not isinstance(found, Refused):
                _show(scene, found)

    def speech(self, task: Task | None) -> Speech:
        """Return the language that a scene is told in."""
        own = spoken(task.data.decode("utf-8", "replace")) if task is not None else ""
        language = self.language or own
        return speaking(language) if language else reader()


def _show(scene: Scene, drawn: Drafted, **told: Any) -> None:
    """Show sheets that were drawn, and what is told of them; the page that is there is of others now."""
    scene.done = ("", None)
    sheets = as_sheets(scene.kept, drawn)
    scene.kept.tell(ok=True, fresh=True, errors=(), sheets=sheets, **told)


def _refuse(kept: Kept, version: str, faults: tuple[SceneFault, ...]) -> None:
    """Tell what a text is refused for; the sheets that are there stay."""
    kept.tell(ok=False, busy=False, text_version=version, errors=faults)


def said_of(error: TooLong | Gone | Broken, speech: Speech) -> str:
    """Return what is told of a process that did not do what it was to."""
    if isinstance(error, TooLong):
        return speech(
            said("this took longer than {seconds:g} s and was broken off", seconds=error.args[0])
        )
    if isinstance(error, Broken):
        return speech(error.args[0])
    return speech(said("the process that draws has ended; the next change begins it anew"))


async def _warm(worker: Worker) -> None:
    with suppress(TooLong, Gone, Broken):
        await worker.ask(jobs.warmed, limit=DRAWING, urgency=IDLE)


QUIET = 60
"""What changes within so many ms is looked at together: an editor writes and renames."""
STEP = 10
"""How often it is asked, ms, whether something has changed."""
POLL = 300
"""How often files are looked at where the system does not tell, ms."""
LATE = 300
"""So long after a watch has begun files are looked at once more, ms."""
AGAIN = 2.0
"""After a folder could not be watched, or has gone, it is tried again, s."""


async def watch(desk: Desk) -> None:
    """Look at the scenes again whenever a file in their folders has changed; for ever."""
    while True:
        try:
            await _watched(desk, desk.folder.watched())
        except OSError:  # too many files are watched, or the folder has gone
            await asyncio.sleep(AGAIN)
            desk.look_all()


async def _watched(desk: Desk, folders: frozenset[Path]) -> None:
    """Look at scenes again as folders change; until there are others to be watched."""
    from watchfiles import awatch

    desk.look_all()
    late = True
    async for changes in awatch(
        *folders,
        watch_filter=lambda change, path: _is_scene(path),
        debounce=QUIET,
        step=STEP,
        poll_delay_ms=POLL,
        recursive=False,
        ignore_permission_denied=True,
        rust_timeout=LATE,
        yield_on_timeout=True,
    ):
        if not changes and not late:
            continue
        late = False  # what changes between the look before and the watch is told by nobody
        desk.look_all()
        if desk.folder.watched() != folders:
            return


def _is_scene(path: str) -> bool:
    """Whether a path may be that of a scene, of a composition, or of a new folder."""
    name = path.rpartition("/")[2].rpartition("\\")[2]
    return name.endswith(".toml") or "." not in name
