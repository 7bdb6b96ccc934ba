"""Where a task goes on on its next sheet: before a heading rather than before a sentence, all sheets filled."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from itertools import pairwise
from typing import NamedTuple

from graphic_tmm.paper.drawing import Drawing

AMID = 0.12
"""A break that is not before a heading is as bad as this share of a sheet left white, squared."""


class Band(NamedTuple):
    """What stands side by side: drawings and where their upper left corners (0) come to from that of the band.

    ``height``, ``above``: how high it is, what is clear above, mm; ``heads``: whether a heading begins it.
    """

    parts: tuple[tuple[Drawing, complex], ...]
    height: float
    above: float
    heads: bool


class Paged(NamedTuple):
    """The bands of each sheet, and how bad that is: sheets left white, squared, and breaks amid a list."""

    sheets: tuple[Sequence[Band], ...]
    bad: float


Chosen = tuple[float, tuple[int, ...]]
"""How bad breaks are, and before which bands they are."""


def paged(bands: Sequence[Band], first: float, other: float, between: float) -> Paged:
    """Return the bands of each sheet; ``first``, ``other``: what the first and other sheets hold, mm.

    ``between``: clear above what begins a sheet, mm. What no sheet holds has one of its own.
    """

    @cache
    def best(begin: int) -> tuple[int, Chosen]:
        """Return how many sheets there are from a band on, how bad, and where they end."""
        if begin == len(bands):
            return 0, (0.0, ())
        room = first if begin == 0 else other
        found = list[tuple[int, Chosen]]()
        used = 0.0
        for end in range(begin + 1, len(bands) + 1):
            last = bands[end - 1]
            used += last.height + (last.above if end - 1 > begin or begin == 0 else between)
            if used > room + 1e-9 and end > begin + 1:
                break
            count, (bad, ends) = best(end)
            amid = AMID if end < len(bands) and not bands[end].heads else 0.0
            cost = (1.0 - min(used / room, 1.0)) ** 2 + amid + bad
            found.append((count + 1, (cost, (end, *ends))))
        return min(found)

    _, (bad, ends) = best(0)
    return Paged(tuple(bands[at:end] for at, end in pairwise((0, *ends))), bad)
