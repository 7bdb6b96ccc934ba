"""What the process does that draws: it is given texts and reads no file; a refusal is something it returns."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import fields
from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple, ParamSpec, TypeVar

from graphic_tmm.drawn import DrawnScene
from graphic_tmm.errors import DrawnRemedy, Fault, SceneError, StructureError, TmmError, printable
from graphic_tmm.fitting import compose
from graphic_tmm.fitting.compose import Composed
from graphic_tmm.fitting.composition import Composition, composition_file, known_composition, text
from graphic_tmm.language.catalogue import Speech, speaking
from graphic_tmm.language.reader import reader, reading
from graphic_tmm.language.said import said
from graphic_tmm.page.assemblies import in_square
from graphic_tmm.page.page import page
from graphic_tmm.paper.formats import AUTO
from graphic_tmm.paper.lettering.letters import missing
from graphic_tmm.paper.write.svg import svg
from graphic_tmm.readers.findings import all_warnings
from graphic_tmm.scene.document import spoken, toml
from graphic_tmm.scene.new import begun
from graphic_tmm.scene.read import judged
from graphic_tmm.scene.records import Scene
from graphic_tmm.serve.edit import edited
from graphic_tmm.serve.form import form
from graphic_tmm.serve.form import form_json as fields_told
from graphic_tmm.serve.kept import SceneFault
from graphic_tmm.serve.plainly import place_words, plainly
from graphic_tmm.serve.scheme.act import SchemeAct, scheme
from graphic_tmm.serve.shell import title_of
from graphic_tmm.studio import composed_sheets, make

P = ParamSpec("P")
T = TypeVar("T")
STANDS = said(
    "no speed is given: the driving link stands, and plans of velocities are of possible ones, whose ratios "
    "alone count; write its speed to have real ones"
)
"""What is to be known of a scene as it is begun in the studio."""
REMEMBERED = 2
"""So many drawings a process remembers: that of before, and that of now."""


class Task(NamedTuple):
    """A scene to be drawn.

    ``data``: what its file holds; ``file``: where that stands, for messages and names. ``given``: a composition
    to draw it by, as its file holds it; ``language``: that all is told in, "" for the scene's own.
    """

    data: bytes
    file: str
    given: bytes | None = None
    language: str = ""


Drafted = tuple[tuple[str, float, float, str], ...]
"""Sheets: name, width and height in mm, SVG."""


class Sheets(NamedTuple):
    """The sheets of a scene, what is told of it, and how they are composed."""

    sheets: Drafted
    warnings: tuple[str, ...]
    composition: bytes


class Refused(NamedTuple):
    """What a scene is refused for."""

    faults: tuple[SceneFault, ...]


class File(NamedTuple):
    """A file to be written by a browser: its name, what it holds."""

    name: str
    data: bytes


def refusing(job: Callable[P, T]) -> Callable[P, T | Refused]:
    """Make a task (its first argument is a `Task`) return what its scene is refused for."""

    def held(*given: P.args, **named: P.kwargs) -> T | Refused:
        task = given[0]
        assert isinstance(task, Task)
        language = _language(task)
        with reading(language):
            try:
                return job(*given, **named)
            except TmmError as error:
                return Refused(faults(error, task.file, speaking(language)))

    held.__name__ = held.__qualname__ = getattr(job, "__name__", "")
    held.__module__ = job.__module__
    return held


def _language(task: Task) -> str:
    return task.language or spoken(task.data.decode("utf-8", "replace")) or reader().language


def faults(error: TmmError, file: str, speech: Speech) -> tuple[SceneFault, ...]:
    """Return the faults of a scene; its file is known, and not told."""
    if isinstance(error, SceneError):
        return tuple(_in_words(one, speech) for one in error.faults)
    says = printable(error.in_language(speech))
    place = re.match(rf"{re.escape(printable(file))}(?::(\d+))?: ", says)
    line = int(place[1] or 0) if place else 0
    says = plainly(says[place.end() :] if place else says, speech)
    found = error.pictures if isinstance(error, StructureError) else ()
    return (SceneFault(line, "", says, pictures=tuple(_small(found))),)


def _small(found: Sequence[DrawnRemedy]) -> Iterator[dict[str, object]]:
    """Yield pictures, with what is written then."""
    for one, lines in zip(found, in_square(found), strict=True):
        yield {"lines": lines, "values": dict(one.values)}


def _in_words(fault: Fault, speech: Speech) -> SceneFault:
    shown = fault.for_reader(speech)
    says = plainly(shown.message, speech, fault.key)
    return SceneFault(shown.line, shown.key, says, place=place_words(fault.key, speech))


def scene_of(task: Task) -> Scene:
    """Return the scene of a task, in the language that was asked for.

    Raises
    ------
    SceneError
        With every fault of its text.
    """
    scene = judged(task.data, Path(task.file), missing=missing)
    return scene.spoken_in(task.language)


@lru_cache(REMEMBERED)
def composed(task: Task) -> tuple[DrawnScene, Composed]:
    """Return a scene as drawn, and its sheets: composed as it is given, else anew."""
    return composed_sheets(scene_of(task), composition_of(task))


def composition_of(task: Task) -> Composition | None:
    """Return the composition that a task gives its scene; None if there is none."""
    return (
        None if task.given is None else known_composition(task.given, composition_file(task.file))
    )


@refusing
def drawn_sheets(task: Task) -> Sheets:
    """Return the sheets of a scene."""
    made, found = composed(task)
    language = made.scene.language
    warnings = [
        plainly(printable(one), speaking(language))
        for one in all_warnings(made, language, sheets=True)
    ]
    if made.scene.at_rest:
        warnings.append(speaking(language)(STANDS))
    return Sheets(_svg(found), tuple(warnings), text(found.composition, found.scales).encode())


@refusing
def drafted(task: Task) -> Drafted:
    """Return the sheets of a scene in the sizes, and where it can be at the places, that another had."""
    given = composition_of(task)
    scene = scene_of(task)
    made = make(scene, wanted=scene.shown_places, given=given)
    return _svg(compose.composed(made.scene, made.boards, given, near=True))


def _svg(found: Composed) -> Drafted:
    return tuple((one.name, one.width, one.height, svg(one)) for one in found.sheets)


@refusing
def meant(task: Task) -> str:
    """Return a name for what a scene says: comments, layout and the lines it stands on are nothing to it."""
    scene = scene_of(task)
    names = (one.name for one in fields(scene) if one.compare and one.name != "told")
    return hashlib.sha256(repr([getattr(scene, name) for name in names]).encode()).hexdigest()


@refusing
def paged(task: Task) -> bytes:
    """Return a scene as a page for a browser, with what lets a person draw its plans himself."""
    made, found = composed(task)
    return page(made, found.sheets, practised=True).encode()


@refusing
def formed(task: Task) -> list[dict[str, Any]]:
    """Return the values of a scene as a form, as JSON takes it."""
    return fields_told(form(task.data, Path(task.file)), _language(task))


@refusing
def schemed(task: Task, asked: SchemeAct) -> dict[str, Any]:
    """Return a scheme after an act, as JSON takes it."""
    return scheme(task.data, Path(task.file), asked, speaking(_language(task)), missing)


@refusing
def begun_files(task: Task, title: str) -> dict[str, str]:
    """Return the files of a scene that was drawn, under a title, by name.

    Raises
    ------
    SceneError
        If it is none.
    """
    file = Path(task.file)
    data = edited(task.data, {"title": title} if title.strip() else {}, file, missing)
    judged(data, file, missing=missing)
    sheet = f"\n[[sheet]]\nformat = {toml(AUTO)}\n"
    return begun(data.decode() + sheet, speaking(_language(task)))


def titled(tasks: Sequence[Task]) -> list[str]:
    """Return what scenes call themselves, however wrong they are; "" where that cannot be told."""
    return [title_of(task.data, Path(task.file)) for task in tasks]


@refusing
def changed(task: Task, changes: Mapping[str, str]) -> bytes:
    """Return what a scene's file holds with values set in it."""
    return edited(task.data, changes, Path(task.file), missing)


def warmed() -> None:
    """Do nothing: what a drawing needs is loaded when this is."""
