"""What is told once of a row of views, above it: its title and the scale factor that all of it shares.

A heading is one line where its row is as wide, else two. On whatever sheet a part of the row stands, the first
of its views there has the heading above its line, and so has what is broken off and stands elsewhere there;
so it is found from where the views stand.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from graphic_tmm.paper.drawing import HEADING, Drawing, Heading, Label, Stand
from graphic_tmm.paper.lettering.letters import letter
from graphic_tmm.paper.packing import Box, bounds

CLEAR = 0.7
"""Clear height below a line of a heading, of the height of its capitals."""
UNDER = 0.6
"""So much of a line stands below one that has a heading where both are read as one row; by eye."""
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
    there = [(view.stand, bounds(view), bounds(view)[1] + view.foot) for view in views]
    counts: dict[str, int] = {}
    for block, heading, box in boxes(there):
        counts[block] = counts.get(block, 0) + 1
        again = f"-{counts[block]}" if counts[block] > 1 else ""
        yield _drawn(f"heading-{block}{again}", heading, box)


def boxes(views: Iterable[tuple[Stand, Box, float]]) -> Iterator[tuple[str, Heading, Box]]:
    """Yield the block of every heading of a sheet, the heading, and its box.

    ``views``: how the views stand, their boxes, the heights at which their captions begin, mm. A heading stands
    in the middle above the views on one line with the first of its block; another one above a line of which too
    little stands below a line that has one.
    """
    there = list(views)
    headed = [view for view in there if view[0].heading is not None]
    for block, heading in dict.fromkeys((stand.block, stand.heading) for stand, _, _ in headed):
        assert heading is not None
        members = [view for view in headed if view[0].block == block]
        known: Box | None = None
        for row in _rows(members):
            left, right, top = (
                min(b[0] for b in row),
                max(b[2] for b in row),
                max(b[3] for b in row),
            )
            shared = min(right, known[2]) - max(left, known[0]) if known is not None else 0.0
            if shared >= UNDER * (right - left) > 0.0:
                continue
            wide, high = room(heading, right - left)
            middle = (left + right - wide) / 2
            box = (middle, top, middle + wide, top + high)
            if known is None or not any(_meet(box, other) for _, other, _ in there):
                known = (left, top, right, top)
                yield block, heading, box


def _rows(members: Sequence[tuple[Stand, Box, float]]) -> Iterator[list[Box]]:
    """Yield the boxes of a block line by line, in the order of its views."""
    left = list(members)
    while left:
        level = left[0][2]
        yield [box for _, box, base in left if abs(base - level) <= LEVEL]
        left = [view for view in left if abs(view[2] - level) > LEVEL]


def _meet(one: Box, other: Box) -> bool:
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


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
