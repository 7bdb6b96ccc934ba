"""What is told once of a row of views, above it: its title and the scale factor that all of it shares.

A heading is one line where its row is as wide, else two. On whatever sheet a part of the row stands, the first
of its views there has the heading above its line; so it is found from where the views stand.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from graphic_tmm.paper.drawing import HEADING, Drawing, Heading, Label, Stand
from graphic_tmm.paper.lettering.letters import letter
from graphic_tmm.paper.packing import Box, bounds

CLEAR = 0.7
"""Clear height below a line of a heading, of the height of its capitals."""
LEVEL = 0.05
"""Views whose captions begin within so many mm stand on one line."""


def _lines(heading: Heading, width: float) -> list[tuple[str, float]]:
    """Return the lines of a heading above a row so wide, mm, each with its height."""
    title, scale = heading.sizes
    if not heading.scale:
        return [(heading.title, title)]
    whole = f"{heading.title}, {heading.scale}"
    if letter(whole, size=title).width <= width:
        return [(whole, title)]
    return [(heading.title, title), (heading.scale, scale)]


def room(heading: Heading, width: float) -> tuple[float, float]:
    """Return how wide and high a heading is above a row so wide, with what is clear below it, mm."""
    told = [(letter(text, size=size), size) for text, size in _lines(heading, width)]
    high = sum(one.ascent + one.descent + CLEAR * size for one, size in told)
    return max(one.width for one, _ in told), high


def headings(views: Sequence[Drawing]) -> Iterator[Drawing]:
    """Yield the headings of views that stand on a sheet, in their order."""
    for block, heading, box in boxes(
        (view.stand, bounds(view), bounds(view)[1] + view.foot) for view in views
    ):
        yield _drawn(f"heading-{block}", heading, box)


def boxes(views: Iterable[tuple[Stand, Box, float]]) -> Iterator[tuple[str, Heading, Box]]:
    """Yield the block of every heading of a sheet, the heading, and its box.

    ``views``: how the views stand, their boxes, the heights at which their captions begin, mm. A heading stands
    in the middle above the views on one line with the first of its block.
    """
    blocks: dict[str, list[tuple[Stand, Box, float]]] = {}
    for view in views:
        blocks.setdefault(view[0].block, []).append(view)
    for block, members in blocks.items():
        stand, _, level = min(members, key=lambda view: view[0].heading is None)
        if stand.heading is None:
            continue
        row = [box for _, box, base in members if abs(base - level) <= LEVEL]
        left, right, top = min(b[0] for b in row), max(b[2] for b in row), max(b[3] for b in row)
        wide, high = room(stand.heading, right - left)
        middle = (left + right - wide) / 2
        yield block, stand.heading, (middle, top, middle + wide, top + high)


def _drawn(name: str, heading: Heading, box: Box) -> Drawing:
    labels, base, middle = list[Label](), box[1], (box[0] + box[2]) / 2
    told = _lines(heading, box[2] - box[0] + LEVEL)
    for text, size in reversed(told):
        made = letter(text, size=size)
        base += CLEAR * size + made.descent
        labels.append(Label(text, complex(middle, base), size, "middle"))
        base += made.ascent
    title = ", ".join(text for text, _ in told)
    return Drawing(name, title, labels=tuple(reversed(labels)), role=HEADING)
