"""Where on the line of action the specific sliding is told: N1, a, P, b, N2, the stations of the task."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.gears.beside import BESIDE
from graphic_tmm.chapters.gears.plan import GEARS_PLAN
from graphic_tmm.drawn import Drawn


class Station(NamedTuple):
    """A place: its name; x from N1 (mm on the sheet), ϑ of both wheels, (trial,), −∞ at the own limit."""

    name: str
    x: Reals
    sliding: tuple[Reals, Reals]


def stations(drawn: Drawn) -> list[Station]:
    """Return the places from N1 to N2."""
    return sorted(_places(drawn), key=lambda one: float(one.x[0]))


def _places(drawn: Drawn) -> Iterator[Station]:
    gear, beside, reading = GEARS_PLAN.on(drawn), BESIDE.on(drawn), drawn.reading
    sliding, (at_first, at_second) = gear.sliding, beside.limits

    def falls(end: Reals) -> Reals:
        return np.full_like(end, -np.inf)

    first, second = reading[at_first][:, 0], reading[at_second][:, 0]
    at_limits = (
        Station("N_{1}", reading[beside.start][:, 0], (falls(first), first)),
        Station("N_{2}", reading[gear.line.length][:, 0], (second, falls(second))),
    )
    yield from at_limits
    for name, end in zip("ab", gear.line.ends, strict=True):
        if end in gear.line.limits:
            yield at_limits[gear.line.limits.index(end)]._replace(name=name)
    for name, one in (*sliding.ends.items(), ("P", sliding.pole)):
        x, *found = (reading[mark][:, 0] for mark in (one.x, *one.sliding))
        if one is sliding.pole:  # neither slides there, whatever the ruler makes of x
            found = [np.zeros_like(row) for row in found]
        yield Station(name, x, (found[0], found[1]))
    if sliding.further is not None:
        marks = (sliding.further.x, *sliding.further.sliding)
        for k in range(len(gear.order.stations)):
            x, *found = (reading[mark][:, k] for mark in marks)
            yield Station(str(k + 1), x, (found[0], found[1]))
