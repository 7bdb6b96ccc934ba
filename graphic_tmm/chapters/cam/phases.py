"""The turn of a cam divided: phases, positions, stretches; what is chosen before the log is written."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.cam.refusals import (
    SLACK,
    WHOLE,
    Changed,
    balanced,
    jumps,
    keys_of_law,
    moved,
    plain,
    refuse,
)
from graphic_tmm.chapters.cam.task import CamTask
from graphic_tmm.chapters.cam.task_motion import (
    BY_DIAGRAM,
    BY_TABLE,
    SAME,
    SHARED,
    TURN,
    Law,
    Stage,
    drawn_laws,
    levels,
)
from graphic_tmm.chapters.cam.uneven import evened
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.scene.declare import bound_of


class Phase(NamedTuple):
    """A moving phase: its number among those of the turn, dwells counted; where it begins (degrees).

    ``motion``: what is asked of it, ``law``: its law as drawn; ``first`` and ``last`` of its positions.
    ``breaks``: the positions inside it at which its stretches meet, where the acceleration jumps or has a
    corner. ``changed``: how the diagram of its law was changed for that, and so that its areas are equal.
    ``ends``: how high the follower stands before and behind it (m, or rad). ``lone``: of the usual cam.
    """

    number: int
    start: float
    motion: Stage
    law: Law
    first: int
    last: int
    breaks: tuple[int, ...] = ()
    changed: Changed = Changed()
    ends: tuple[float, float] = (0.0, 0.0)
    lone: bool = True

    @property
    def sign(self) -> int:
        """1 of a rise, −1 of a return."""
        return self.motion.sign

    @property
    def extent(self) -> float:
        """How long it is, degrees."""
        return self.motion.angle

    @property
    def name(self) -> str:
        """Whether it is a rise or a return."""
        return "rise" if self.sign > 0 else "return"

    @property
    def called(self) -> str:
        """What its views and results are called by."""
        return self.name if self.lone else str(self.number)

    @property
    def low(self) -> float:
        """How high the follower stands in its lower place (m, or rad)."""
        return min(self.ends)

    @property
    def parts(self) -> int:
        """Into how many even parts it is divided."""
        return self.last - self.first

    @property
    def stretches(self) -> tuple[tuple[int, int], ...]:
        """The first and the last position of each stretch over which the law is smooth."""
        return tuple(pairwise((self.first, *self.breaks, self.last)))


class Turn(NamedTuple):
    """The positions of a turn, their angles (degrees, from its beginning), the moving phases.

    Of a cam that slides its ``whole`` travel (m) is the turn, and angles are lengths of it.
    """

    angles: tuple[float, ...]
    phases: tuple[Phase, ...]
    whole: float = TURN

    @property
    def positions(self) -> int:
        """How many positions there are."""
        return len(self.angles)

    @property
    def closed(self) -> bool:
        """Whether the follower ends where it began."""
        return abs(self.phases[0].ends[0] - self.phases[-1].ends[1]) <= SLACK

    @property
    def rise(self) -> Phase:
        """The first rise."""
        return next(phase for phase in self.phases if phase.sign > 0)

    @property
    def fall(self) -> Phase:
        """The first return."""
        return next(phase for phase in self.phases if phase.sign < 0)

    @property
    def ways(self) -> tuple[Phase, ...]:
        """The first rise and the first return: the limits of either are those of all its kind."""
        firsts = {phase.sign: phase for phase in self.phases[::-1]}
        return tuple(firsts[sign] for sign in (1, -1) if sign in firsts)

    def like(self, phase: Phase) -> Iterator[Phase]:
        """Yield all rises, or all returns."""
        return (one for one in self.phases if one.sign == phase.sign)

    def among(self, phase: Phase) -> list[int]:
        """Return the positions of all rises, or of all returns."""
        return [k for one in self.like(phase) for k in range(one.first, one.last + 1)]

    def rest(self, phase: Phase) -> float:
        """How long the follower rests behind a phase, degrees."""
        after = self.phases[(self.phases.index(phase) + 1) % len(self.phases)]
        gap = (after.start - phase.start - phase.extent) % self.whole
        return gap if SAME < gap < self.whole - SAME else 0.0

    @property
    def lowest(self) -> Phase:
        """The return behind which the follower rests longest in its lowest place."""
        return max((one for one in self.phases if one.ends[1] == 0.0), key=self.rest)

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
    phases, angles, start = list[Phase](), list[float](), 0.0
    rows = zip(order.stages, pairwise(levels(order.stages)), strict=True)
    for k, (motion, ends) in enumerate(rows, 1):
        if motion.sign:
            division = _division(order, motion)
            parts, angle = division.parts, motion.angle
            shared = bool(angles) and abs(angles[-1] - start) <= SLACK
            made = _phase(k, start, motion, len(angles) - shared, division)
            phases.append(made._replace(ends=ends, lone=not order.phases))
            angles += [start + angle * i / parts for i in range(parts + 1)][shared:]
        start += motion.angle
    return Turn(tuple(angles), tuple(phases), order.whole)


class _Division(NamedTuple):
    """How many even parts a phase has, the shares of it at which its stretches meet, its law as drawn."""

    parts: int
    shares: list[float]
    law: Law
    moved: tuple[tuple[float, float], ...] = ()


def _phase(number: int, start: float, motion: Stage, first: int, division: _Division) -> Phase:
    parts, shares, law, told = division
    breaks = tuple(first + round(share * parts) for share in shares)
    factor = 1.0
    if law.name == BY_DIAGRAM:
        points, factor = balanced(law.points)
        law = replace(law, points=points)
    changed = Changed(factor, told)
    return Phase(number, start, motion, law, first, first + parts, breaks, changed)


def _division(order: CamTask, motion: Stage) -> _Division:
    """Divide a phase: at every jump of the acceleration there stands a position.

    Where the corners of an acceleration diagram can have positions too, with one between any two, they have.
    Where not even its jumps can, they are moved, as far as a ruler leaves them open.
    """
    assert motion.law is not None
    if motion.law.name == BY_TABLE:
        return _Division(len(motion.law.points) - 1, [], evened(motion.law))
    law, extent = replace(motion.law, points=plain(motion.law.points)), motion.angle
    wanted = order.divisions
    if order.per_turn is not None:
        wanted = max(
            int(bound_of(CamTask, "parts").least), round(order.per_turn * extent / order.whole)
        )
    breaks, corners = _jumps(law), sorted({u for u, _ in law.points if SLACK < u < 1.0 - SLACK})
    for shares, most, least in ((corners or breaks, 2, 2), (breaks, 4, 1)):
        for parts in range(wanted, most * wanted + 1):
            at = [share * parts for share in (0.0, *shares, 1.0)]
            whole = all(abs(x - round(x)) <= parts * SLACK for x in at)
            if whole and min(b - a for a, b in pairwise(at)) > least - 0.5:
                return _Division(parts, shares, law)
    base = WHOLE * extent / order.whole
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
        f"cam.{keys_of_law(order, motion)[1]}",
        head=f"cam, {'rise' if motion.sign > 0 else 'return'}",
    )


def _jumps(law: Law) -> list[float]:
    """Return the shares inside a phase at which the acceleration jumps."""
    if law.name != BY_DIAGRAM:
        return [law.split] if law.name == SHARED else list(drawn_laws()[law.name].jumps)
    return jumps(law.points)
