"""The overview of series: all pictures small, with their numbers, under the titles of their views."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from graphic_tmm.handout.ink import times
from graphic_tmm.handout.series import Picture, Series
from graphic_tmm.handout.sheets import BETWEEN, CAPTION, TITLE, advance, paper, set_rows
from graphic_tmm.handout.words import broken
from graphic_tmm.paper.drawing import Drawing, Label, shifted

ACROSS = 6
"""Pictures beside one another."""
HIGH = 27.0
"""How high a picture is at most, mm."""
GAP = 5.0
"""Between pictures beside one another, mm."""
NUMBER = 3.5
"""Height of their numbers, mm."""
ABOVE = 1.5
"""Clear between a number and its picture, mm."""


def overview(some: Sequence[Series], title: str, language: str) -> list[list[Drawing]]:
    """Return what stands on the sheets of the overview, a list a sheet, without their frames."""
    room = paper(language)
    told = list(broken(title, TITLE, room.right - room.head.real))
    head = Drawing("overview title", title, (), tuple(set_rows(told, room.head)))
    found: list[list[Drawing]] = []
    top = room.bottom
    wide = (room.right - room.left - GAP * (ACROSS - 1)) / ACROSS
    first = room.top - max(sum(map(advance, told)), ROOM) - BETWEEN
    for one in some:
        rows = list(_rows(one))
        for n, row in enumerate(rows):
            heading = list(broken(one.title, CAPTION, room.right - room.left)) if n == 0 else []
            high = NUMBER + ABOVE + _factor(one, wide) * (one.box[3] - one.box[1])
            above = sum(map(advance, heading)) + (ABOVE if heading else 0.0)
            if top - above - high < room.bottom or not found:
                found.append([head])
                top = first
            labels = tuple(set_rows(heading, complex(room.left, top)))
            if labels:
                found[-1].append(Drawing(f"{one.name} heading", one.title, (), labels))
            top -= above
            for k, picture in enumerate(row):
                at = complex(room.left + k * (wide + GAP), top)
                found[-1].append(_small(one, picture, at, wide))
            top -= high + GAP
    return found


ROOM = 9.0
"""The head of a sheet is no lower, mm: the frame has something beside it."""


def _rows(one: Series) -> Iterator[Sequence[Picture]]:
    for k in range(0, len(one.pictures), ACROSS):
        yield one.pictures[k : k + ACROSS]


def _factor(one: Series, wide: float) -> float:
    """Return how many times smaller the pictures of a series stand here; ``wide``: their room, mm."""
    x0, y0, x1, y1 = one.box
    return min(1.0, wide / (x1 - x0), HIGH / (y1 - y0))


def _small(one: Series, picture: Picture, at: complex, wide: float) -> Drawing:
    """Return a picture made small, without its letters: they could not be read."""
    factor = _factor(one, wide)
    x0, _, x1, y1 = (factor * edge for edge in one.box)
    by = at - 1j * (NUMBER + ABOVE) + (wide - (x1 - x0)) / 2 - complex(x0, y1)
    strokes = tuple(shifted(times(stroke, factor), by) for stroke in picture.ink)
    number = Label(str(picture.number), at - 1j * NUMBER, NUMBER)
    return Drawing(f"{one.name} small {picture.number}", one.title, strokes, (number,))
