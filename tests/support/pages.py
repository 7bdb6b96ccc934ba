"""Pages of the scenes of the package, each written once, and what Python's own readers say of their views."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cache
from typing import NamedTuple

from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.page import page as of_page
from graphic_tmm.page.crank import Turned, crank
from graphic_tmm.page.page import page
from graphic_tmm.paper.drawing import Drawing, Sheet
from graphic_tmm.paper.figure import Picture, pictures
from graphic_tmm.paper.lettering.letters import plain
from graphic_tmm.studio import sheets
from support import gallery

LANGUAGES = ("en", "ru")


class View(NamedTuple):
    """A view of a sheet that is drawn in steps: its board, its sheet, its number there, its pictures."""

    board: Drawn
    sheet: Sheet
    number: int
    pictures: tuple[Picture, ...]

    @property
    def drawing(self) -> Drawing:
        return self.sheet.drawings[self.number]

    @property
    def title(self) -> str:
        return " ".join(plain(self.drawing.title).split())


TURNED: dict[tuple[int, int, bool], tuple[object, Turned | None]] = {}


def turned_once(made: DrawnScene, sheets: Sequence[Sheet], *, live: bool = False) -> Turned | None:
    """Return a mechanism as its crank turns; of one drawing on the same sheets what was returned before.

    Pages with and without practice, weighed or not, have it alike; it is most of what they cost.
    """
    key = id(made), id(sheets), live
    if key not in TURNED:
        TURNED[key] = (made, sheets), crank(made, sheets, live=live)
    return TURNED[key][1]


of_page.crank = turned_once  # type: ignore[attr-defined]


def language(name: str) -> str:
    """The language that a scene of the package is in."""
    return gallery.scene(name).language


@cache
def on_sheets(name: str, spoken: str) -> tuple[DrawnScene, tuple[Sheet, ...]]:
    """Return a scene of the package on its sheets, in a language."""
    scene = gallery.scene(name)
    return (
        gallery.paper(name) if spoken == scene.language else sheets(replace(scene, language=spoken))
    )


@cache
def text(name: str, spoken: str) -> str:
    """Return the page of a scene of the package in a language."""
    return page(*on_sheets(name, spoken))


@cache
def views(name: str, spoken: str) -> tuple[View, ...]:
    """Return the views of a scene that are drawn in more than one picture, sheet by sheet."""
    return tuple(_views(name, spoken))


def _views(name: str, spoken: str) -> Iterator[View]:
    made, found = on_sheets(name, spoken)
    for sheet in found:
        for number, drawing in enumerate(sheet.drawings):
            for board in made.boards:
                there = {view.name for view in board.construction.views}
                if any(view in there for view in drawing.shows):
                    inked = {
                        s.position for s in (*drawing.strokes, *drawing.rubbed, *drawing.labels)
                    }
                    row = board.row(drawing.shows[-1])
                    there = sorted(k for k in inked if k is not None)
                    main = next((k for k in there if row[k] == board.main), None)
                    shown = pictures(board.construction, drawing, main)
                    if len(shown) > 1:
                        yield View(board, sheet, number, shown)
                    break
