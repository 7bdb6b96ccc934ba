"""The diagrams S, dS/dφ and d²S/dφ² of a cam's follower over one turn, on one base."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board import graphs
from graphic_tmm.board.charts import Chart
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.graphs import Axes, Base
from graphic_tmm.board.operations.formulas import to_board, turn_per_mm
from graphic_tmm.board.operations.graph_curves import graph_of_stretch
from graphic_tmm.board.operations.instruments import join, lay_off, measure_along, parallel, square
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Number
from graphic_tmm.chapters.cam import formulas as f
from graphic_tmm.chapters.cam import formulas_plate
from graphic_tmm.chapters.cam import words as why
from graphic_tmm.chapters.cam.course import along_base, slides, take_place
from graphic_tmm.chapters.cam.integral import Integral, draw_integral, lay_integral
from graphic_tmm.chapters.cam.laws import formulas as law
from graphic_tmm.chapters.cam.laws import laws
from graphic_tmm.chapters.cam.laws.ground import Ground
from graphic_tmm.chapters.cam.operations import in_turn, phase_end
from graphic_tmm.chapters.cam.phases import Phase, Turn
from graphic_tmm.chapters.cam.task import CamTask
from graphic_tmm.chapters.cam.task_motion import BY_DIAGRAM

VIEWS = {"S": "cam S", "V": "cam dS", "A": "cam ddS"}
BY_TRAVEL = {"S": "cam S", "V": "cam slope", "A": "cam bend"}
"""Of a cam that slides."""
ROOM = 50.0
"""Room for the largest ordinate of d²S/dφ², mm."""


@dataclass(frozen=True)
class Diagram:
    """One diagram: its axes, its chart; points, curves and readings (Length) by stretch, in their order.

    ``reading``: the ordinates of all positions in one (Length); of d²S/dφ² there are two where it jumps, and
    that of the earlier stretch stands here.
    """

    axes: Axes
    chart: Chart
    points: tuple[Mark, ...]
    curves: tuple[Mark, ...]
    readings: tuple[Mark, ...]
    reading: Mark


@dataclass(frozen=True)
class Diagrams:
    """The three diagrams, and what they share.

    ``angle``: the cam's angle of every position (Angle); ``steps``: that between two positions
    (Angle), ``phases`` the whole phase (Number, rad), ``strokes`` (Number), for each moving phase; ``stroke``
    of them all (Number); ``integrals``: of the phases that are given by their acceleration diagram. Of a cam
    that slides ``angle`` and ``phases`` are lengths of its ``travel`` (Number, m).
    """

    turn: Turn
    base: Base
    angle: Mark
    stroke: Mark
    steps: tuple[Mark, ...]
    phases: tuple[Mark, ...]
    strokes: tuple[Mark, ...]
    S: Diagram
    V: Diagram
    A: Diagram
    integrals: tuple[Integral, ...]
    travel: Mark | None = None

    @property
    def stretches(self) -> tuple[tuple[Phase, int, int], ...]:
        """Every stretch of the turn: its phase, its first and its last position."""
        return tuple((p, *ends) for p in self.turn.phases for ends in p.stretches)


class _Common(NamedTuple):
    order: CamTask
    turn: Turn
    base: Base
    lifts: tuple[_Lift, ...]
    extents: tuple[Mark, ...]
    phases: tuple[Mark, ...]
    shares: tuple[tuple[Mark, ...], ...]
    integrals: tuple[Integral | None, ...]
    ends: tuple[Mark | None, Mark | None]


class _Lift(NamedTuple):
    """How far the follower goes in a phase (Number), on the diagram of S (Length), and above what (Length)."""

    stroke: Mark
    height: Mark
    low: Mark | None = None


def draw_diagrams(draft: Draft, order: CamTask, turn: Turn) -> Diagrams:
    """Draw the diagrams of the follower's motion.

    Its scales: that of S follows from the stroke's height, that of dS/dφ is the same unless the order says,
    that of d²S/dφ² is free unless the order says.
    """
    draft.open(VIEWS["S"])
    letters = order.letters
    length = draft.take(Length, "L", order.base, "mm")
    travel = draft.take(Number, "L_c", turn.whole, "m") if order.slides else None
    if travel is not None:
        mu_phi = draft.draw(formulas_plate.scale_of_travel, "μ_s", travel, length, unit="m/mm")
    else:
        mu_phi = draft.draw(turn_per_mm, "μ_φ", length, unit="rad/mm")
    base = Base(turn.positions, length, length, mu_phi, mu_phi)
    angle = take_place(draft, base, "", np.array(turn.angles)[None, :])
    x = along_base(draft, base, "x_s" if order.slides else "x_φ", angle)
    base = base._replace(x=x, zero=draft.direction(0.0), closed=not order.slides)
    unit = order.units["S"]
    stroke = draft.take(Number, "h", order.stroke, unit)
    mu_S, height = _scale_of_S(draft, order, stroke, unit)
    extents, steps, phases, shares = _divided(draft, turn, base, travel)
    whole = _Lift(stroke, height)
    # of a cam that slides s is its travel
    lifts, start, level = (whole,) * len(turn.phases), None, "y" if order.slides else "s"
    if order.phases:
        lifts = tuple(_lift(draft, phase, mu_S, unit, level) for phase in turn.phases)
        start = _level(draft, f"{level}_0", turn.phases[0].ends[0], mu_S, unit)
    finish = start
    if not turn.closed:
        finish = _level(draft, f"{level}_N", turn.phases[-1].ends[1], mu_S, unit)
    common = _Common(order, turn, base, lifts, extents, phases, shares, (), (start, finish))
    integrals = _integrals(draft, common)
    common = common._replace(integrals=integrals)
    views = BY_TRAVEL if order.slides else VIEWS
    mu_V, per = mu_S, {which: order.scale_unit(which) for which in VIEWS}
    if order.mu_V is not None or order.slides:
        draft.open(views["V"])
        name = f"μ_{{{letters['V']}}}"
        mu_V = (
            draft.scale(name, per["V"])
            if order.slides
            else draft.take(Number, name, order.mu_V, per["V"])
        )
    draft.open(views["A"])
    mu_A = draft.scale(f"μ_{{{letters['A']}}}", per["A"])
    scales = (("S", mu_S), ("V", mu_V), ("A", mu_A))
    S, V, A = (_diagram(draft, common, which, mu, order.units[which]) for which, mu in scales)
    drawn = tuple(i for i in integrals if i is not None)
    strokes = tuple(lift.stroke for lift in lifts)
    return Diagrams(turn, base, angle, stroke, steps, phases, strokes, S, V, A, drawn, travel)


def _lift(draft: Draft, phase: Phase, mu: Mark, unit: str, level: str) -> _Lift:
    """Take the stroke of a phase and where it begins."""
    k = phase.number
    stroke = draft.take(Number, f"h_{k}", phase.motion.stroke, unit)
    height = draft.draw(to_board, f"h_{{S{k}}}", stroke, mu)
    return _Lift(stroke, height, _level(draft, f"{level}_{k}", phase.low, mu, unit))


def _level(draft: Draft, letter: str, high: float, mu: Mark, unit: str) -> Mark | None:
    """Return a place above the lowest on the diagram of S (Length); None where it is the lowest."""
    if high == 0.0:
        return None
    return draft.draw(to_board, letter, draft.take(Number, letter.upper(), high, unit), mu)


def _scale_of_S(draft: Draft, order: CamTask, stroke: Mark, unit: str) -> tuple[Mark, Mark]:
    """Return the scale of S and the height of the stroke on its diagram (Length)."""
    scale, high = f"μ_{order.letters['S']}", f"h_{order.letters['S']}"
    if order.mu_S is not None:
        mu = draft.take(Number, scale, order.mu_S, f"{unit}/mm")
        return mu, draft.draw(to_board, high, stroke, mu)
    height = draft.take(Length, high, order.height, "mm")
    return draft.draw(f.scale_of_stroke, scale, stroke, height, unit=f"{unit}/mm"), height


def _divided(draft: Draft, turn: Turn, base: Base, travel: Mark | None) -> tuple[Any, ...]:
    """Take the phases and their even division: extents, steps (Angle), radians, shares of every stretch.

    Of a ``travel`` the lengths themselves stand for the radians.
    """
    rows = []
    for phase in turn.phases:
        name = phase.number
        extent = take_place(draft, base, str(name), phase.extent)
        parts = draft.take(Number, f"N_{name}", float(phase.parts))
        if travel is not None:
            step = draft.draw(
                formulas_plate.share_of_travel, f"Δ_{name}", extent, parts, travel, unit="°"
            )
            radians = extent
        else:
            step = draft.draw(f.angle_of_part, f"Δφ_{name}", extent, parts, unit="°")
            radians = draft.draw(f.radians_of, f"Φ_{name}", extent, unit="rad")
        shares = []
        for ends in phase.stretches:
            k = np.arange(ends[0], ends[1] + 1)
            far = k - phase.first if phase.sign > 0 else phase.last - k
            number = draft.take(Number, f"i_{name}", turn.over(ends, far.astype(float)))
            shares.append(draft.draw(law.share_of_parts, f"u_{name}", number, parts))
        rows.append((extent, step, radians, tuple(shares)))
    return tuple(zip(*rows, strict=True))


def _integrals(draft: Draft, common: _Common) -> tuple[Integral | None, ...]:
    found: list[Integral | None] = []
    for phase, lift in zip(common.turn.phases, common.lifts, strict=True):
        if phase.law.name == BY_DIAGRAM:
            rest = (common.turn, phase, lift.stroke, common.order)
            found.append(draw_integral(draft, common.base, *rest))
        else:
            found.append(None)
    return tuple(found)


def _diagram(draft: Draft, common: _Common, which: str, mu: Mark, unit: str) -> Diagram:
    """Draw one diagram over the turn: both phases, the dwells between them, the readings."""
    letter, view = common.order.letters[which], (BY_TRAVEL if slides(common.base) else VIEWS)[which]
    draft.open(view)
    axes = graphs.draw_axes(draft, view, common.base, mu)
    points: list[Mark] = []
    for k, integral in enumerate(common.integrals):
        height = common.lifts[k].height
        ground = _ground(draft, common, k, axes, common.lifts[k].low if which == "S" else None)
        if integral is None:
            points += laws()[ground.of.law.name].points(draft, ground, which, height)
        else:
            points += lay_integral(draft, ground, integral, which, height)
        draft.open(view)
    stretches = [ends for phase in common.turn.phases for ends in phase.stretches]
    curves: list[Mark] = []
    readings: list[Mark] = []
    for spots, (first, last) in zip(points, stretches, strict=True):
        curves.append(
            draft.draw(
                graph_of_stretch, f"({spots.letter}–{spots.letter})", spots, first=first, last=last
            )
        )
        readings.append(
            draft.draw(
                measure_along,
                f"{letter}_{len(readings) + 1}",
                axes.feet,
                spots,
                axes.up,
                why=why.DIAGRAM_READ,
            )
        )
    _outline(draft, common, axes, points, which)
    merged = merge(draft, common.turn, readings, letter)
    chosen = which == "A" or (which == "V" and slides(common.base))
    wanted = common.order.mu_A if which == "A" else None
    chart = Chart(view, letter, unit, mu, tuple(readings), chosen, wanted, ROOM)
    return Diagram(axes, chart, tuple(points), tuple(curves), tuple(readings), merged)


def merge(draft: Draft, turn: Turn, readings: Sequence[Mark], letter: str) -> Mark:
    """Make one row of readings of those of the stretches, in their order."""
    stretches = [ends for phase in turn.phases for ends in phase.stretches]
    found = readings[-1]
    for k in range(len(readings) - 2, -1, -1):
        at = draft.take(Number, "σ", turn.inside(*stretches[k]))
        rest = ",".join(str(n) for n in range(k + 1, len(readings) + 1))
        name = letter if k == 0 else f"{letter}_{{{rest}}}"
        found = draft.draw(in_turn, name, readings[k], found, at)
    return found


def _ground(draft: Draft, common: _Common, k: int, axes: Axes, low: Mark | None) -> Ground:
    """Mark on the base where a phase begins and ends, and its divisions; the turn begins at its origin.

    ``low``: how high above the base the phase stands (Length), if not on it.
    """
    phase, base = common.turn.phases[k], common.base
    ends = (phase.start, phase.start + phase.extent)
    draft.say(phase.name)
    feet = []
    for angle, name in zip(ends if phase.sign > 0 else ends[::-1], ("o", "e"), strict=True):
        if angle == 0.0:
            feet.append(axes.origin)
            continue
        x = along_base(draft, base, f"x_{name}", take_place(draft, base, name, angle))
        feet.append(draft.draw(lay_off, name, axes.along, x, free=True, why=why.PHASE_FOOT))
    if low is None:
        near, far = feet
        inward = draft.draw(parallel, "(o)", near, axes.along, sense=phase.sign)
    else:
        near, far = (_over(draft, axes, foot, low) for foot in feet)
        inward = draft.draw(join, "(oe)", near, far, why=why.LEVEL)
    out = draft.draw(parallel, "(o)", near, axes.along, sense=-phase.sign)
    whole = along_base(draft, base, "l", common.extents[k])
    divisions = []
    for share in common.shares[k]:
        x = draft.draw(law.even_height, "x", share, whole)
        divisions.append(draft.draw(lay_off, "n", inward, x, free=True, why=why.PHASE_PART))
    rise = draft.draw(square, "(y)", near, axes.along, sense=1)
    drop = draft.draw(square, "(y)", near, axes.along, sense=-1)
    rest = (common.phases[k], common.lifts[k].stroke, axes.mu)
    return Ground(
        phase, common.shares[k], tuple(divisions), axes.along, near, far, out, rise, drop, *rest
    )


def _over(draft: Draft, axes: Axes, foot: Mark, high: Mark) -> Mark:
    """Mark the point over a place of the base."""
    line = draft.draw(square, f"({foot.letter})", foot, axes.along, sense=1, why=why.LEVEL)
    return draft.draw(lay_off, foot.letter, line, high, free=True, why=why.LEVEL)


def _outline(draft: Draft, common: _Common, axes: Axes, points: Sequence[Mark], which: str) -> None:
    """Tell what is drawn besides the curves: the dwells, and the jumps of the acceleration."""
    turn, start, finish = common.turn, axes.origin, axes.end
    rows = [(p, ends) for p in turn.phases for ends in p.stretches]

    def end(spots: Mark, at: int) -> Mark:
        return draft.draw(phase_end, f"{spots.letter}_e", spots, at=at, free=True)

    if which == "S":
        start, finish = (
            foot if high is None else _over(draft, axes, foot, high)
            for foot, high in zip((start, finish), common.ends, strict=True)
        )
    late = which == "A" and turn.phases[0].start > 0.0
    feet = [end(axes.feet, 0)] if late else []
    draft.figure("outline", "start", start, *feet, end(points[0], 0))
    for (spots, (_, (_, last))), (after, (_, (first, _))) in pairwise(
        zip(points, rows, strict=True)
    ):
        feet = [end(axes.feet, at) for at in (last, first)] if which == "A" and first > last else []
        draft.figure("outline", "between", end(spots, last), *feet, end(after, first))
    last = turn.phases[-1].last
    feet = [end(axes.feet, last)] if which == "A" else []
    draft.figure("outline", "lower dwell", end(points[-1], last), *feet, finish)
