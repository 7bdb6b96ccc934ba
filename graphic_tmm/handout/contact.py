"""The overview of series: all pictures small, with their numbers, under the titles of their views."""

from __future__ import annotations

from collections.abc import Sequence

from graphic_tmm.handout.ink import times
from graphic_tmm.handout.series import Picture, Series
from graphic_tmm.handout.sheets import BETWEEN, CAPTION, TITLE, advance, paper, set_rows
from graphic_tmm.handout.words import broken
from graphic_tmm.paper.drawing import Drawing, Label, shifted

ACROSS = (3, 4, 5, 6)
"""Pictures beside one another: so few that one sheet holds all of them, else as many as can be."""
HIGH = 1.1
"""How high a picture is at most, of its width."""
GAP = 5.0
"""Between pictures beside one another, mm."""
NUMBER = 3.5
"""Height of their numbers, mm."""
ABOVE = 1.5
"""Clear between a number and its picture, mm."""


def overview(some: Sequence[Series], title: str, language: str) -> list[list[Drawing]]:
    """Return what stands on the sheets of the overview, a list a sheet, without their frames."""
    tried = (_overview(some, title, language, across) for across in ACROSS)
    return next((found for found in tried if len(found) == 1), None) or _overview(
        some, title, language, ACROSS[-1]
    )


def _overview(
    some: Sequence[Series], title: str, language: str, across: int
) -> list[list[Drawing]]:
    room = paper(language)
    told = list(broken(title, TITLE, room.right - room.head.real))
    head = Drawing("overview title", title, (), tuple(set_rows(told, room.head)))
    start = room.top - max(sum(map(advance, told)), ROOM) - BETWEEN
    wide = (room.right - room.left - GAP * (across - 1)) / across
    found: list[list[Drawing]] = []
    top = room.bottom
    for one in some:
        high = NUMBER + ABOVE + _factor(one, wide) * (one.box[3] - one.box[1])
        for k in range(0, len(one.pictures), across):
            heading = list(broken(one.title, CAPTION, room.right - room.left)) if k == 0 else []
            above = sum(map(advance, heading)) + (ABOVE if heading else 0.0)
            if top - above - high < room.bottom:
                found.append([head])
                top = start
            if heading:
                labels = tuple(set_rows(heading, complex(room.left, top)))
                found[-1].append(Drawing(f"{one.name} heading", one.title, (), labels))
            top -= above
            for n, picture in enumerate(one.pictures[k : k + across]):
                at = complex(room.left + n * (wide + GAP), top)
                found[-1].append(_small(one, picture, at, wide))
            top -= high + GAP
    return found


ROOM = 9.0
"""The head of a sheet is no lower, mm: the frame has something beside it."""


def _factor(one: Series, wide: float) -> float:
    """Return how many times smaller the pictures of a series stand here; ``wide``: their room, mm."""
    x0, y0, x1, y1 = one.box
    return min(1.0, wide / (x1 - x0), HIGH * wide / (y1 - y0))


def _small(one: Series, picture: Picture, at: complex, wide: float) -> Drawing:
    """Return a picture made small, without its letters: they could not be read."""
    factor = _factor(one, wide)
    x0, _, x1, y1 = (factor * edge for edge in one.box)
    by = at - 1j * (NUMBER + ABOVE) + (wide - (x1 - x0)) / 2 - complex(x0, y1)
    strokes = tuple(shifted(times(stroke, factor), by) for stroke in picture.ink)
    number = Label(str(picture.number), at - 1j * NUMBER, NUMBER)
    return Drawing(f"{one.name} small {picture.number}", one.title, strokes, (number,))
