"""How the quantities of a log answer to slips: what the method leaves, what each sort of slip adds.

Slips are small and independent, so the variances that they leave add up, each by the square of its size. A log
that was drawn a few times by each sort of slip alone tells what any hand does with it, on a drawing of any
size: what slips in mm weighs the less, the larger the drawing; a ray that is turned by an angle does not.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import hypot, sqrt
from typing import NamedTuple

import numpy as np

from graphic_tmm.accuracy.drawing import References
from graphic_tmm.accuracy.quantities import Quantity
from graphic_tmm.board.execute import prepare
from graphic_tmm.board.hand import EXACT, HANDS, Hand
from graphic_tmm.board.values import Reals
from graphic_tmm.project import Project

SORTS = ("swing", "prick", "compass", "reading")
"""The sorts of slips that are left to chance; the rounding of a ruler is one of its reading."""
IN_MM = frozenset(SORTS) - {"swing"}
"""The sorts that weigh the less, the larger the drawing."""
UNIT = HANDS["careful"]
"""The hand by whose slips a log is tried: so small that they add up, larger than any rounding."""
DRAWINGS = 48
"""How often each sort slips: with a dozen positions a spread is then known to some 5 %."""
SHARE = 0.9
"""An error is so large that this share of all readings keeps within it. The largest of all would grow with
their number."""
HALVINGS = 24
"""Halvings that an error is narrowed down by."""


def size(who: Hand, sort: str) -> float:
    """Return the standard deviation of a sort of slip; a length read off a ruler is rounded, too."""
    if sort == "reading":
        return hypot(who.reading, (who.ruler or 0.0) / sqrt(12.0))
    return float(getattr(who, sort))


class Drawing(NamedTuple):
    """Who draws, and how many times as large as the scene asks for."""

    who: Hand
    times: float = 1.0

    def slip(self, sort: str) -> float:
        """Return the standard deviation of a sort of slip as it weighs on the drawing of the scene's size."""
        return size(self.who, sort) / (self.times if sort in IN_MM else 1.0)


class Response(NamedTuple):
    """A quantity of a log, each value in % of its largest over the turn, (value,).

    ``method``: how far it is off without any slip. ``slips``: by sort, the variance that a slip of 1 mm (1° of
    a ray) leaves, nothing else slipping.
    """

    method: Reals
    slips: Mapping[str, Reals]

    def variance(self, drawn: Sequence[Drawing]) -> Reals:
        """Return the variance of each value by each hand, (hand, value)."""
        found = np.zeros((len(drawn), self.method.size))
        for sort, variance in self.slips.items():
            found += variance * np.array([[one.slip(sort) ** 2] for one in drawn])
        return found

    def errors(self, drawn: Sequence[Drawing]) -> Reals:
        """Return what nine readings of ten keep within, %: of normal deviations about the method's own."""
        if not self.method.size:
            return np.full(len(drawn), np.nan)
        spread = np.sqrt(self.variance(drawn))
        off = np.abs(self.method)
        low, high = np.zeros(len(drawn)), np.max(off + 4.0 * spread, axis=1)
        for _ in range(HALVINGS):
            middle = 0.5 * (low + high)
            less = np.mean(_within(middle[:, None], off, spread), axis=1) < SHARE
            low, high = np.where(less, middle, low), np.where(less, high, middle)
        return np.asarray(high)


def _within(limit: Reals, off: Reals, spread: Reals) -> Reals:
    """Return the probability that a normal deviation about ``off`` stays within ± ``limit``."""
    scale = sqrt(2.0) * np.maximum(spread, 1e-12 * np.maximum(limit, 1e-300))
    return np.asarray(0.5 * (_erf((limit - off) / scale) + _erf((limit + off) / scale)))


def _erf(x: Reals) -> Reals:
    """Return the error function to 1.5e-7 (Abramowitz and Stegun 7.1.26)."""
    t = 1.0 / (1.0 + 0.3275911 * np.abs(x))
    sum_ = ((((1.061405429 * t - 1.453152027) * t) + 1.421413741) * t - 0.284496736) * t
    bell = np.exp(-np.minimum(x * x, 700.0))
    return np.asarray(np.copysign(1.0 - (sum_ + 0.254829592) * t * bell, x))


def responses(
    drawing: Project, wanted: Sequence[Quantity], references: References
) -> dict[str, Response]:
    """Return how the wanted quantities of a drawing answer, by name; none of what has no true value."""
    program = prepare(drawing.construction, [mark for q in wanted for mark in q.marks])
    exact = program.run(drawing.given)
    drawn = {}
    for sort in SORTS:
        alone: dict[str, object] = {sort: size(UNIT, sort)}
        who = EXACT._replace(trials=DRAWINGS, **alone)  # type: ignore[arg-type]
        drawn[sort] = program.run(drawing.given, hand=who)
    found = {}
    for quantity in wanted:
        due, largest = references.of(quantity, drawing), references.largest(quantity, drawing)
        if due is None or not largest > 0.0:
            continue
        own = quantity.read(exact, 1)
        there = np.isfinite(due[0]) & np.isfinite(own[0])
        slips = {}
        for sort, reading in drawn.items():
            off = 100.0 * (quantity.read(reading, DRAWINGS) - own)[:, there] / largest
            known = np.isfinite(off)
            square = np.sum(np.where(known, off, 0.0) ** 2, axis=0)
            slips[sort] = square / np.maximum(known.sum(axis=0), 1) / size(UNIT, sort) ** 2
        method = 100.0 * (own - due)[0, there] / largest
        found[quantity.name] = Response(method, slips)
    return found
