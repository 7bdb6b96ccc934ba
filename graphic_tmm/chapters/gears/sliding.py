"""The diagram of specific sliding under the line of action: ϑ1 and ϑ2 over the distance x from N1.

In a limit point itself nothing is calculated: the one ϑ falls without end there, the other is 1.

The stations of a curve stand in a geometric series from its own limit point on: there it falls without end, and
its points stand the closer together the steeper it is. At the other limit point it is 1.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from graphic_tmm.board.charts import Chart
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.operations.formulas import to_board
from graphic_tmm.board.operations.instruments import lay_off, measure_along, ray, square
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Number, Point, Reals
from graphic_tmm.chapters.gears import words as why
from graphic_tmm.chapters.gears.dimensions import GearSizes
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
    """The diagram: its chart (μ_ϑ), origin in N1, N2, the curves of both wheels, P.

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
    """What the stations stand on: the base, N1N2, the numbers of teeth."""

    base: Mark
    length: Mark
    teeth: tuple[Mark, Mark]


def draw_sliding(draft: Draft, sizes: GearSizes, line: ActionLine, rows: Rows) -> Sliding:
    """Draw the diagram; lengths along its base are those measured on the line of action."""
    draft.open(VIEW)
    mu = draft.scale("μ_{ϑ}", "1/mm")
    draft.lay_out()
    origin = draft.take(Point, "N_{1}", 0j)
    base = draft.draw(ray, "(N_{1}N_{2})", origin, draft.direction(0.0), why=why.STATION)
    end = draft.draw(lay_off, "N_{2}", base, line.length, why=why.STATION)
    ground = _Ground(base, line.length, (sizes.wheels[0].z, sizes.wheels[1].z))
    ends = {
        letter: _stations(draft, ground, line.to_ends[end], letter)
        for letter, end in zip("ab", line.ends, strict=True)
        if end in line.to_ends
    }
    pole = _stations(draft, ground, line.to_pole, "P")
    floor = _floor(draft, line, mu, [mark for one in ends.values() for mark in one.sliding])
    branches = (
        _branch(draft, ground, 0, rows.row(_shares(sizes.order.z1 / sizes.order.z2, floor))),
        _branch(draft, ground, 1, rows.row(_shares(sizes.order.z2 / sizes.order.z1, floor))),
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
    return Sliding(chart, origin, end, branches, ends, pole, further, floor)


def _stations(draft: Draft, ground: _Ground, x: Mark, letter: str) -> Stations:
    """Calculate both slidings at places, lay them off over the base."""
    (z1, z2) = ground.teeth
    rest = draft.draw(remainder, f"N_{{2}}{letter}", ground.length, x)
    sliding = (
        draft.draw(specific_sliding, f"ϑ_{{1{letter}}}", z1, z2, rest, x),
        draft.draw(specific_sliding, f"ϑ_{{2{letter}}}", z2, z1, x, rest),
    )
    feet = draft.draw(lay_off, letter, ground.base, x, free=True, why=why.STATION)
    lines = draft.draw(square, f"({letter})", feet, ground.base, sense=1, why=why.SLIDING_AT)
    points = []
    for k, mark in enumerate(sliding):
        height = draft.draw(to_board, f"[ϑ_{{{k + 1}{letter}}}]", mark)
        points.append(
            draft.draw(lay_off, f"{letter}_{{{k + 1}}}", lines, height, why=why.SLIDING_AT)
        )
    return Stations(x, sliding, feet, (points[0], points[1]))


def _branch(draft: Draft, ground: _Ground, k: int, shares: Reals) -> Branch:
    """Draw the curve of wheel ``k`` (0 or 1) through points over a row of shares of N1N2 from its own limit."""
    i = k + 1
    share = draft.take(Number, f"f_{i}", shares)
    near = draft.draw(part_of, f"N_{i}i", share, ground.length)
    far = draft.draw(remainder, f"N_{2 - k}i", ground.length, near)
    x = near if k == 0 else far
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


def _shares(ratio: float, floor: float) -> Reals:
    """Return the shares of N1N2 from a wheel's limit point, the first where ϑ is −``floor``, the last 1.

    ``ratio``: of the wheel's teeth to those of the other.
    """
    least = ratio / (ratio + 1.0 + floor)
    return np.asarray(least ** np.linspace(1.0, 0.0, STATIONS))
