"""The files of a scene as a browser takes them away: one as it is, several in a ZIP; the same bytes always."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Callable, Mapping
from importlib.util import find_spec
from pathlib import Path

from graphic_tmm.fitting.composition import beside, known_composition
from graphic_tmm.note.note import note_files, wanted
from graphic_tmm.page import FORMAT
from graphic_tmm.page.page import page
from graphic_tmm.readers.table import table
from graphic_tmm.scene.packaged import scene_name
from graphic_tmm.serve.jobs import File, Task, scene_of, told
from graphic_tmm.studio import make, sheet_files

Files = Mapping[str, str | bytes]
EXTRAS = {"pdf": ("typst",), "png": ("typst",), "dxf": ("ezdxf",), "note": ("pypandoc", "typst")}
"""What a format needs that may not be installed."""
ALWAYS = (1980, 1, 1, 0, 0, 0)
"""When the files of a ZIP were made: a download does not depend on the clock."""


def forms() -> tuple[str, ...]:
    """Return what a scene can be downloaded as."""
    return tuple(form for form in FORMS if all(map(_there, EXTRAS.get(form, ()))))


def _there(module: str) -> bool:
    return find_spec(module) is not None


@told
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
            given = known_composition(task.given, beside(task.file))
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
