"""What can be made of any scene, a batch of them: sheets, tables, notes, pages, as the commands make them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cached_property
from pathlib import Path
from typing import NamedTuple

from graphic_tmm.classroom.batch.work import Done, Work
from graphic_tmm.classroom.variants.start import begun, kept_composition
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.fitting.compose import Composed
from graphic_tmm.fitting.composition import FILE as COMPOSITION
from graphic_tmm.fitting.composition import Composition, text
from graphic_tmm.note.note import note_files
from graphic_tmm.note.note import wanted as drawn_for
from graphic_tmm.page import FORMAT
from graphic_tmm.page.page import page
from graphic_tmm.paper.lettering.letters import missing
from graphic_tmm.readers.findings import all_warnings
from graphic_tmm.readers.table import table
from graphic_tmm.scene.build import drawn_by
from graphic_tmm.scene.packaged import FILE as SCENE
from graphic_tmm.scene.packaged import scene_name
from graphic_tmm.scene.read import judged
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import composed_sheets, files_of, make

Texts = dict[str, str | bytes]
OPERATION = f"{__name__}:make_request"
"""The operation of works that make what is asked of a scene."""


class Request(NamedTuple):
    """What is made of a scene.

    ``text``, ``source``: what its file holds, and where that would stand: files are called by it. ``makes``:
    of `MAKES`; ``sheets``, ``tables``, ``notes``: the formats of each. ``composition``: as its file holds it,
    "" for none: one to draw it by or, ``lent``, that of the scene that it is a variant of, to begin with.
    ``language``: "" for the scene's own; ``hand``, ``seed``: None for its own.
    """

    text: str
    source: str
    makes: tuple[str, ...] = ("draw",)
    sheets: tuple[str, ...] = ("svg",)
    tables: tuple[str, ...] = ("csv",)
    notes: tuple[str, ...] = ("md",)
    composition: str = ""
    lent: bool = False
    language: str = ""
    hand: str | None = None
    seed: int | None = None


def work(name: str, asked: Request) -> Work:
    """Return the work of making that of a scene; its files stand in a folder of its name.

    What is made in which formats stands in the name of the work: what else was made of it before stays.
    """
    formats = {"draw": asked.sheets, "table": asked.tables, "note": asked.notes}
    made = ("-".join((one, *formats.get(one, ()))) for one in asked.makes)
    return Work(f"{name}/{'+'.join(made)}", OPERATION, (name, asked))


def make_request(given: tuple[str, Request]) -> Done:
    """Make what is asked of a scene: the name of its folder, and that.

    Raises
    ------
    TmmError
        If the scene is not good, or cannot be drawn so.
    """
    folder, asked = given
    desk = _Desk(asked)
    files = {
        f"{folder}/{name}": text for one in asked.makes for name, text in MAKES[one](desk).items()
    }
    return Done(files, tuple(desk.messages()))


class _Desk:
    """A scene, read once, and what is drawn of it, once for all that is made of that."""

    def __init__(self, asked: Request) -> None:
        self.asked = asked
        self.scene = scene_asked(asked)
        self.stem = scene_name(self.scene.source)
        self.drawings: list[tuple[DrawnScene, bool]] = []
        """What was drawn, and whether for sheets: what is to be told of it."""

    @property
    def own(self) -> str:
        """The language of the scene's text, if another is asked for."""
        asked = self.asked
        return scene_asked(asked._replace(language="")).language if asked.language else ""

    @cached_property
    def composed(self) -> tuple[DrawnScene, Composed]:
        """Its sheets: they show one drawing."""
        text = self.asked.composition
        if self.asked.lent or not text:
            made, found = begun(self.scene, text, self.own)
        else:
            made, found = composed_sheets(self.scene, kept_composition(text, self.scene.source))
        self.drawings.append((made, True))
        return made, found

    @cached_property
    def given(self) -> Composition | None:
        """The composition that all else is drawn by, if it has one."""
        if self.asked.lent:
            return self.composed[1].composition
        return kept_composition(self.asked.composition, self.scene.source)

    @cached_property
    def papers(self) -> Texts:
        """Sheets in all formats, a page if that is wanted."""
        makes = self.asked.makes
        formats = [*(self.asked.sheets if "draw" in makes else ())]
        if "page" in makes and FORMAT not in formats:
            formats.append(FORMAT)
        return files_of(*self.composed, formats, whole={FORMAT: page})

    def messages(self) -> Iterator[str]:
        """Yield what people are told of what was drawn, each once."""
        language = self.scene.language
        lines = (
            str(line)
            for made, sheets in self.drawings
            for line in all_warnings(made, language, sheets=sheets)
        )
        yield from dict.fromkeys(lines)


def scene_asked(asked: Request) -> Scene:
    """Return the scene of what is asked: in the language and by the hand that are.

    Raises
    ------
    SceneError
        With every fault of its text.
    """
    scene = judged(asked.text.encode("utf-8"), Path(asked.source), missing=missing)
    return drawn_by(scene.spoken_in(asked.language), asked.hand, asked.seed)


def _draw(desk: _Desk) -> Texts:
    paged = f"{desk.stem}.{FORMAT}"
    asked = FORMAT in desk.asked.sheets
    return {name: text for name, text in desk.papers.items() if asked or name != paged}


def _page(desk: _Desk) -> Texts:
    name = f"{desk.stem}.{FORMAT}"
    return {name: desk.papers[name]}


def _table(desk: _Desk) -> Texts:
    drawn = make(desk.scene, given=desk.given)
    desk.drawings.append((drawn, False))
    found = {form: table(drawn, form) for form in desk.asked.tables}
    return {f"{desk.stem}.{form}": text for form, text in found.items() if isinstance(text, str)}


def _note(desk: _Desk) -> Texts:
    drawn = make(desk.scene, wanted=drawn_for(desk.scene), given=desk.given)
    desk.drawings.append((drawn, False))
    return note_files(drawn, f"{desk.stem}-note", desk.asked.notes)


def _scene(desk: _Desk) -> Texts:
    """Return the scene itself, and the composition of its sheets: with both anybody draws them again."""
    _, found = desk.composed
    return {SCENE: desk.asked.text, COMPOSITION: text(found.composition, found.scales)}


MAKES: dict[str, Callable[[_Desk], Texts]] = {
    "draw": _draw,
    "table": _table,
    "note": _note,
    "page": _page,
    "scene": _scene,
}
"""What can be made of a scene, by the name of the command that makes it of one; and that scene."""
TABLES = ("csv", "json")
"""What a table can be written as."""
