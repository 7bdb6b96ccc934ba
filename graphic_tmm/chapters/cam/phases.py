"""The turn of a cam divided: phases, positions, stretches; what is chosen before the log is written."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.cam.refusals import (
    SLACK,
    TURN,
    WHOLE,
    Changed,
    balanced,
    jumps,
    moved,
    plain,
    refuse,
)
from graphic_tmm.chapters.cam.task import BY_DIAGRAM, CamTask, Law, drawn_laws
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.scene.declare import bound_of


class Phase(NamedTuple):
    """A moving phase: where it begins and how long it is (degrees), its law, its positions first … last.

    ``breaks``: the positions inside it at which its stretches meet, where the acceleration jumps or has a
    corner. ``changed``: how the diagram of its law was changed for that, and so that its areas are equal.
    """

    name: str
    sign: int
    start: float
    extent: float
    law: Law
    first: int
    last: int
    breaks: tuple[int, ...] = ()
    changed: Changed = Changed()

    @property
    def number(self) -> int:
        """Which of the four phases of the turn it is, the dwells counted: 1 or 3."""
        return 1 if self.sign > 0 else 3

    @property
    def parts(self) -> int:
        """Into how many even parts it is divided."""
        return self.last - self.first

    @property
    def stretches(self) -> tuple[tuple[int, int], ...]:
        """The first and the last position of each stretch over which the law is smooth."""
        return tuple(pairwise((self.first, *self.breaks, self.last)))


class Turn(NamedTuple):
    """The positions of a turn, their angles (degrees, from the beginning of the rise), the phases."""

    angles: tuple[float, ...]
    rise: Phase
    fall: Phase

    @property
    def positions(self) -> int:
        """How many positions there are."""
        return len(self.angles)

    @property
    def phases(self) -> tuple[Phase, Phase]:
        """Rise and return."""
        return (self.rise, self.fall)

    def over(self, stretch: tuple[int, int], values: Reals) -> Reals:
        """Return values of the positions of a stretch as a row (1, position), NaN elsewhere."""
        row = np.full((1, self.positions), np.nan)
        row[0, stretch[0] : stretch[1] + 1] = values
        return row

    def inside(self, first: int, last: int) -> Reals:
        """Return 1 at the positions first … last of the row (1, position), 0 elsewhere."""
        k = np.arange(self.positions)
        return np.where((k >= first) & (k <= last), 1.0, 0.0)[None, :]


def divide(order: CamTask) -> Turn:
    """Divide the turn into positions.

    Raises
    ------
    StructureError
        If what is asked of the cam makes no sense; it says what to change.
    """
    refuse(order)
    first, second = (
        _division(order, *row)
        for row in (("rise", order.rise, order.rise_law), ("return", order.fall, order.return_law))
    )
    top = order.rise + order.upper_dwell
    at = first.parts + (1 if order.upper_dwell > SLACK else 0)
    rise = _phase("rise", 1, 0.0, order.rise, 0, first)
    fall = _phase("return", -1, top, order.fall, at, second)
    there = [order.rise * k / first.parts for k in range(first.parts + 1)]
    back = [top + order.fall * k / second.parts for k in range(second.parts + 1)]
    return Turn((*there, *(back if at > first.parts else back[1:])), rise, fall)


class _Division(NamedTuple):
    """How many even parts a phase has, the shares of it at which its stretches meet, its law as drawn."""

    parts: int
    shares: list[float]
    law: Law
    moved: tuple[tuple[float, float], ...] = ()


def _phase(
    name: str, sign: int, start: float, extent: float, first: int, division: _Division
) -> Phase:
    parts, shares, law, told = division
    breaks = tuple(first + round(share * parts) for share in shares)
    factor = 1.0
    if law.name == BY_DIAGRAM:
        points, factor = balanced(law.points)
        law = replace(law, points=points)
    changed = Changed(factor, told)
    return Phase(name, sign, start, extent, law, first, first + parts, breaks, changed)


def _division(order: CamTask, name: str, extent: float, law: Law) -> _Division:
    """Divide a phase: at every jump of the acceleration there stands a position.

    Where the corners of an acceleration diagram can have positions too, with one between any two, they have.
    Where not even its jumps can, they are moved, as far as a ruler leaves them open.
    """
    law = replace(law, points=plain(law.points))
    wanted = order.divisions
    if order.per_turn is not None:
        wanted = max(int(bound_of(CamTask, "parts").least), round(order.per_turn * extent / TURN))
    breaks, corners = _jumps(law), sorted({u for u, _ in law.points if SLACK < u < 1.0 - SLACK})
    for shares, most, least in ((corners or breaks, 2, 2), (breaks, 4, 1)):
        for parts in range(wanted, most * wanted + 1):
            at = [share * parts for share in (0.0, *shares, 1.0)]
            whole = all(abs(x - round(x)) <= parts * SLACK for x in at)
            if whole and min(b - a for a, b in pairwise(at)) > least - 0.5:
                return _Division(parts, shares, law)
    base = WHOLE * extent / TURN
    for parts in range(wanted, 4 * wanted + 1):
        if law.name == BY_DIAGRAM and (found := moved(law.points, parts, base)) is not None:
            points, shares = found
            told = zip(jumps(law.points), shares, strict=True)
            return _Division(parts, shares, replace(law, points=points), tuple(told))
    raise StructureError(
        said(
            "no division into {wanted} … {most} parts has a position at every jump of the "
            "acceleration: let the jumps stand at simple shares of the phase",
            wanted=wanted,
            most=4 * wanted,
        ),
        "cam.law_points" if name == "rise" else "cam.return_points",
        head=f"cam, {name}",
    )


def _jumps(law: Law) -> list[float]:
    """Return the shares inside a phase at which the acceleration jumps."""
    if law.name != BY_DIAGRAM:
        return list(drawn_laws()[law.name].jumps)
    return jumps(law.points)
