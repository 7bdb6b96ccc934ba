"""The diagram of specific sliding under the line of action: ϑ1 and ϑ2 over the distance x from N1.

In a limit point itself nothing is calculated: the one ϑ falls without end there, the other is 1.

The stations of a curve stand in a geometric series from its own limit point on: there it falls without end, and
its points stand the closer together the steeper it is. At the other limit point it is 1.

In a ring both limits lie on one side of P: the diagram goes from N1 to b, and the ring's curve is flat. So it
does with a rack, whose N2 is infinitely far: its curve is a straight line.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from graphic_tmm.board.charts import Chart
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.operations.formulas import to_board, total
from graphic_tmm.board.operations.instruments import lay_off, measure_along, ray, square
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Number, Point, Reals
from graphic_tmm.chapters.gears import words as why
from graphic_tmm.chapters.gears.dimensions import GearSizes
from graphic_tmm.chapters.gears.driven_rack import sliding_on_rack
from graphic_tmm.chapters.gears.formulas import part_of, remainder, specific_sliding
from graphic_tmm.chapters.gears.line import ActionLine
from graphic_tmm.chapters.gears.rolling import smooth_through
from graphic_tmm.chapters.gears.teeth import STATIONS, Rows

VIEW = "sliding"
ROOM = 80.0
"""Room for the lowest ordinate, mm."""
FLOOR = (4.0, 16.0)
"""The lowest ordinate shown: at least, at most."""
DEEPER = 1.2
"""How much deeper it lies than the sliding on the working line."""


@dataclass(frozen=True)
class Stations:
    """Places on the line of action: x from N1 (Length), ϑ of wheel 1 and of wheel 2 (Number), their points."""

    x: Mark
    sliding: tuple[Mark, Mark]
    feet: Mark
    points: tuple[Mark, Mark]


@dataclass(frozen=True)
class Branch:
    """The curve of one wheel: ϑ (Number) at a row of places, their points, the curve through them.

    ``x``: of the places from N1, ``near``: from the limit point of the wheel itself (Length).
    """

    near: Mark
    x: Mark
    sliding: Mark
    feet: Mark
    points: Mark
    curve: Mark


@dataclass(frozen=True)
class Sliding:
    """The diagram: its chart (μ_ϑ), origin in N1, its end in N2, of ring or rack in b, both curves, P.

    ``ends``: a and b by these letters, but those that are limit points themselves; ``further``: at the
    distances the task names, if it does; ``floor``: the lowest ordinate of the curves is minus so much.
    """

    chart: Chart
    origin: Mark
    end: Mark
    branches: tuple[Branch, Branch]
    ends: Mapping[str, Stations]
    pole: Stations
    further: Stations | None
    floor: float


@dataclass(frozen=True)
class _Ground:
    """What the stations stand on: the base, N1N2 (of a rack N1P), the teeth; of a ring or rack N1b."""

    base: Mark
    length: Mark
    teeth: tuple[Mark, ...]
    reach: Mark | None

    def slidings(self, draft: Draft, letter: str, x: Mark, rest: Mark | None) -> tuple[Mark, ...]:
        """Calculate both slidings at places so far from the limit points."""
        if rest is None:
            ways = ((self.length, x), (x, self.length))
            return tuple(
                draft.draw(sliding_on_rack, f"ϑ_{{{i}{letter}}}", *way)
                for i, way in enumerate(ways, 1)
            )
        (z1, z2) = self.teeth
        return (
            draft.draw(specific_sliding, f"ϑ_{{1{letter}}}", z1, z2, rest, x),
            draft.draw(specific_sliding, f"ϑ_{{2{letter}}}", z2, z1, x, rest),
        )

    def rest(self, draft: Draft, letter: str, x: Mark) -> Mark | None:
        """Calculate how far a place is from the other limit point; None where that is infinitely far."""
        if len(self.teeth) == 1:
            return None
        if self.reach is None:
            return draft.draw(remainder, letter, self.length, x)
        return draft.draw(total, letter, self.length, x)


def draw_sliding(
    draft: Draft,
    sizes: GearSizes,
    line: ActionLine,
    rows: Rows,
    value: Callable[[Mark], float],
) -> Sliding:
    """Draw the diagram; lengths along its base are those measured on the line of action."""
    draft.open(VIEW)
    mu = draft.scale("μ_{ϑ}", "1/mm")
    draft.lay_out()
    origin = draft.take(Point, "N_{1}", 0j)
    name = "(N_{1}N_{2})" if sizes.rack is None else "(N_{1}b)"
    base = draft.draw(ray, name, origin, draft.direction(0.0), why=why.STATION)
    reach = line.to_ends[line.ends[1]] if sizes.ring or sizes.rack else None
    ground = _Ground(base, line.length, tuple(wheel.z for wheel in sizes.wheels), reach)
    end = None
    if reach is None:
        end = draft.draw(lay_off, "N_{2}", base, line.length, why=why.STATION)
    ends = {
        letter: _stations(draft, ground, line.to_ends[end], letter)
        for letter, end in zip("ab", line.ends, strict=True)
        if end in line.to_ends
    }
    pole = _stations(draft, ground, line.to_pole, "P")
    floor = _floor(draft, line, mu, [mark for one in ends.values() for mark in one.sliding])
    shares = _both_shares(sizes, floor, value)
    branches = (
        _branch(draft, ground, 0, rows.row(shares[0])),
        _branch(draft, ground, 1, rows.row(shares[1])),
    )
    up = draft.draw(square, "(N_{1}ϑ)", origin, base, sense=1, why=why.SLIDING_AT)
    read = tuple(
        draft.draw(measure_along, f"y_{k + 1}", branch.feet, branch.points, up, why=why.SLIDING_AT)
        for k, branch in enumerate(branches)
    )
    further = None
    if sizes.order.stations:
        given = draft.take(Length, "x_{s}", rows.row(sizes.order.stations), "mm")
        further = _stations(draft, ground, given, "s")
    chart = Chart(VIEW, "ϑ", "", mu, read, True, sizes.order.mu_sliding, ROOM)
    return Sliding(chart, origin, end or ends["b"].feet, branches, ends, pole, further, floor)


def _stations(draft: Draft, ground: _Ground, x: Mark, letter: str) -> Stations:
    """Calculate both slidings at places, lay them off over the base."""
    sliding = ground.slidings(draft, letter, x, ground.rest(draft, f"N_{{2}}{letter}", x))
    feet = draft.draw(lay_off, letter, ground.base, x, free=True, why=why.STATION)
    lines = draft.draw(square, f"({letter})", feet, ground.base, sense=1, why=why.SLIDING_AT)
    points = []
    for k, mark in enumerate(sliding):
        height = draft.draw(to_board, f"[ϑ_{{{k + 1}{letter}}}]", mark)
        points.append(
            draft.draw(lay_off, f"{letter}_{{{k + 1}}}", lines, height, why=why.SLIDING_AT)
        )
    return Stations(x, (sliding[0], sliding[1]), feet, (points[0], points[1]))


def _branch(draft: Draft, ground: _Ground, k: int, shares: Reals) -> Branch:
    """Draw the curve of wheel ``k`` (0 or 1) through points over a row of shares of N1N2 from its own limit."""
    i = k + 1
    share = draft.take(Number, f"f_{i}", shares)
    own_part = ground.reach or ground.length
    near = draft.draw(part_of, f"N_{1 if ground.reach else i}i", share, own_part)
    far = ground.rest(draft, f"N_{2 if ground.reach else 2 - k}i", near)
    if far is None:
        x, way = near, (ground.length, near)
        sliding = draft.draw(sliding_on_rack, f"ϑ_{i}", *(way[::-1] if k else way))
    else:
        if ground.reach and k:
            near, far = far, near
        x = far if k else near
        own, other = ground.teeth[k], ground.teeth[1 - k]
        sliding = draft.draw(specific_sliding, f"ϑ_{i}", own, other, far, near)
    feet = draft.draw(lay_off, f"i_{{{i}}}", ground.base, x, why=why.STATION)
    lines = draft.draw(square, f"(i_{i})", feet, ground.base, sense=1, why=why.SLIDING_AT)
    height = draft.draw(to_board, f"[ϑ_{i}]", sliding)
    points = draft.draw(lay_off, f"i_{{{i}}}′", lines, height, why=why.SLIDING_AT)
    curve = draft.draw(smooth_through, f"(ϑ_{i})", points, row=STATIONS)
    return Branch(near, x, sliding, feet, points, curve)


def _floor(draft: Draft, line: ActionLine, mu: Mark, slidings: list[Mark]) -> float:
    """Choose the lowest ordinate by the sliding on the working line."""
    given = {**draft.given, line.mu: 1.0, mu: 1.0}
    reading = execute(draft.board.construction(), given, slidings)
    found = [abs(float(reading[mark][0, 0])) for mark in slidings]
    known = [value for value in found if math.isfinite(value)]
    return min(max(FLOOR[0], DEEPER * max(known, default=0.0)), FLOOR[1])


def _both_shares(
    sizes: GearSizes, floor: float, value: Callable[[Mark], float]
) -> tuple[Reals, Reals]:
    """Return the shares at which the curves of both wheels are drawn, of N1N2; of a ring or rack of N1b."""
    if sizes.rack is not None:
        wheel = sizes.wheels[0]
        pole = value(wheel.r) * math.sin(math.radians(value(sizes.alpha)))
        reach = math.sqrt(value(wheel.top) ** 2 - value(wheel.r_b) ** 2)
        least = pole / reach / (1.0 + floor)
        return least ** np.linspace(1.0, 0.0, STATIONS), np.linspace(0.0, 1.0, STATIONS)
    z1, z2 = sizes.order.teeth
    if sizes.ring is None:
        return _shares(z1 / z2, floor), _shares(z2 / z1, floor)
    length = value(sizes.a_w) * math.sin(math.radians(value(sizes.alpha_w)))
    least = length / (value(sizes.wheels[1].lowest) - length) / ((1.0 + floor) * z2 / z1 - 1.0)
    return least ** np.linspace(1.0, 0.0, STATIONS), np.linspace(0.0, 1.0, STATIONS)


def _shares(ratio: float, floor: float) -> Reals:
    """Return the shares of N1N2 from a wheel's limit point, the first where ϑ is −``floor``, the last 1.

    ``ratio``: of the wheel's teeth to those of the other.
    """
    least = ratio / (ratio + 1.0 + floor)
    return np.asarray(least ** np.linspace(1.0, 0.0, STATIONS))
