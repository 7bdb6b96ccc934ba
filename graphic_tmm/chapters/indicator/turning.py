"""The pressure at any angle of the crank: read off the diagram as drawn, over where the piston stands."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Curve, Reals
from graphic_tmm.chapters.indicator.cylinder import INDICATOR
from graphic_tmm.drawn import Drawn
from graphic_tmm.moving import Between, Turn

HALVINGS = 40
"""How often the part of an arc is halved in which a place of it is sought: to 1e-12 of the arc."""


def between(drawn: Drawn, turn: Turn) -> Between:
    """Return the pressure of each side at every angle; at the positions it is that which was laid off."""
    made, found = INDICATOR.on(drawn).indicator, dict[Mark, object]()
    by_mark = {step.it: step for step in drawn.construction.steps}
    feet = turn.read([made.feet])[made.feet][0].real
    mu = float(drawn.numbers.drawn[made.chart.mu][0, 0])
    for side in made.sides:
        height = by_mark[side.points].uses[1]
        pressure = by_mark[height].uses[0]
        heights = over(drawn.numbers.drawn[side.curve], turn.numbers, feet)
        found[pressure] = (heights * mu)[None, :]
    return found


def over(curve: Curve, numbers: Reals, feet: Reals) -> Reals:
    """Return the heights, mm, of a closed curve over feet, each on the arc that its number tells.

    A foot beyond both ends of its arc (the piston turns between two positions) has the nearer end's height.
    """
    count = curve.knots.shape[1]
    first = np.floor(numbers).astype(int) % count
    ends = (first, (first + 1) % count)
    p, q = (curve.knots[0, k] for k in ends)
    m, n = (curve.tangents[0, k] for k in ends)
    low, high = np.zeros_like(feet), np.ones_like(feet)
    rises = np.where(q.real >= p.real, 1.0, -1.0)
    for _ in range(HALVINGS):
        u = (low + high) / 2.0
        before = (_at(p.real, q.real, m.real, n.real, u) - feet) * rises < 0.0
        low, high = np.where(before, u, low), np.where(before, high, u)
    return _at(p.imag, q.imag, m.imag, n.imag, (low + high) / 2.0)


def _at(p: Reals, q: Reals, m: Reals, n: Reals, u: Reals) -> Reals:
    """Return a coordinate of cubic arcs between ends p and q with tangents m and n."""
    return np.asarray(
        p * (2 * u + 1) * (u - 1) ** 2
        + m * u * (u - 1) ** 2
        + q * u**2 * (3 - 2 * u)
        + n * u**2 * (u - 1)
    )
