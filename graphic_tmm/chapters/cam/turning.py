"""A cam at any angle: what its law gives there, drawn once more as at the positions; a curve is read off.

The steps of a law run again over other parts of its phase. Of a law whose displacements were found from one
position to the next the curves that are drawn through them are read.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from graphic_tmm.board.operations.graphs import erect
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.cam.centre import Centre
from graphic_tmm.chapters.cam.diagrams import VIEWS, Diagrams
from graphic_tmm.chapters.cam.laws.formulas import share_of_parts
from graphic_tmm.chapters.cam.phases import Phase
from graphic_tmm.chapters.cam.plan import CAM_PLAN, Cam
from graphic_tmm.chapters.cam.record import BESIDE
from graphic_tmm.chapters.cam.task import CAM
from graphic_tmm.chapters.cam.task_motion import BY_POINTS, TURN
from graphic_tmm.chapters.cam.turn import TurnDiagram
from graphic_tmm.drawn import Drawn
from graphic_tmm.project import Project
from graphic_tmm.readers.any_angles.turn import ENDS, Between, Turn, Turning, TurnQuantity


def quantities(project: Project) -> Iterator[TurnQuantity]:
    """Yield the motion of the follower, the pressure angle, forces of a spring, the points of both profiles."""
    made, beside = CAM_PLAN.on(project), BESIDE.of(project)
    diagrams = (made.diagrams.S, made.diagrams.V, made.diagrams.A)
    for name, one in zip(("S", "dS", "ddS"), diagrams, strict=True):
        yield TurnQuantity(CAM, "columns", name, one.reading, one.chart.mu)
    if beside is not None and beside.velocity is not None and beside.acceleration is not None:
        names = ("omega", "eps") if made.order.rocks else ("v", "a")
        for name, mark in zip(names, (beside.velocity, beside.acceleration), strict=True):
            yield TurnQuantity(CAM, "columns", name, mark)
    if isinstance(made.centre, Centre):
        yield TurnQuantity(CAM, "columns", "pressure", made.centre.pressure)
    for name, diagram in _forces(made).items():
        chart = diagram.chart
        yield TurnQuantity(CAM, "columns", name, chart.ordinates[0], chart.mu)
    profile = made.profile
    yield TurnQuantity(CAM, "profile", "K", profile.working.points, profile.mu)
    if profile.theoretical is not None and profile.theoretical is not profile.working:
        yield TurnQuantity(CAM, "profile", "B", profile.theoretical.points, profile.mu)


def between(drawn: Drawn, turn: Turn) -> Between:
    """Return the angle of the cam and the ordinates of its three diagrams: level while the follower rests.

    Where two stretches meet, the earlier one holds, as in the table.
    """
    diagrams = CAM_PLAN.on(drawn).diagrams
    assert turn.angles is not None
    phi, whole = np.mod(turn.angles, TURN), diagrams.turn.whole
    if diagrams.travel is not None:
        beside = (turn.angles < -ENDS) | (turn.angles > whole + ENDS)
        phi = np.where(beside, np.nan, np.clip(turn.angles, 0.0, whole))
    inside = [_inside(diagrams, first, last, phi) for _, first, last in diagrams.stretches]
    known: dict[Mark, Any] = {diagrams.angle: phi}
    rows = zip(_numbers(drawn), diagrams.stretches, inside, strict=True)
    for number, (phase, _, _), there in rows:
        known[number] = np.where(there, _far(phase, phi), np.nan)
    known |= _off_curves(drawn, turn, known, inside)
    found: dict[Mark, object] = {diagrams.angle: phi}
    for one in (diagrams.S, diagrams.V, diagrams.A):
        reading, rest = turn.read(one.readings, known), np.where(np.isnan(phi), np.nan, 0.0)
        values = rest if one is not diagrams.S else _levels(drawn, diagrams, phi) + rest
        for mark, there in zip(one.readings[::-1], inside[::-1], strict=True):
            values = np.where(there, reading[mark], values)
        found[one.reading] = values
    return found | _pressing(drawn, turn, known | found, inside)


def _forces(made: Cam) -> dict[str, TurnDiagram]:
    """Return what a spring is judged by over the turn, by the names of columns."""
    return {} if made.spring is None else dict(zip("PNM", made.spring.diagrams, strict=True))


def _pressing(drawn: Drawn, turn: Turn, known: Between, inside: list[Any]) -> dict[Mark, object]:
    """Return the inertia force, the force of contact and the moment, each under its first ordinate.

    They follow from the motion; while the follower rests only the spring and a load press.
    """
    found: dict[Mark, object] = {}
    made = CAM_PLAN.on(drawn)
    none = 0.0 * np.asarray(known[made.diagrams.angle])
    for one in _forces(made).values():
        rest = [] if one.rest is None else [one.rest]
        reading, mu = turn.read((*one.chart.ordinates, *rest), known), drawn.value(one.chart.mu)
        values = sum((reading[mark] / mu for mark in rest), none)
        for mark, there in zip(one.chart.ordinates[::-1], inside[::-1], strict=True):
            values = np.where(there, reading[mark], values)
        found[one.chart.ordinates[0]] = values
    return found


def _numbers(drawn: Drawn) -> list[Mark]:
    """Return the marks that tell, of each stretch, in which part of its phase a position stands (given)."""
    steps = (s for s in drawn.construction.steps if s.it.view == VIEWS["S"])
    return [step.uses[0] for step in steps if step.op is share_of_parts]


def _inside(diagrams: Diagrams, first: int, last: int, phi: Reals) -> Any:
    angles = diagrams.turn.angles
    return (phi >= angles[first] - ENDS) & (phi <= angles[last] + ENDS)


def _far(phase: Phase, phi: Reals) -> Reals:
    """Return how many parts of its phase lie between its outer end and an angle."""
    far = np.clip((phi - phase.start) / phase.extent, 0.0, 1.0)
    return np.asarray(phase.parts * (far if phase.sign > 0 else 1.0 - far))


def _levels(drawn: Drawn, diagrams: Diagrams, phi: Reals) -> Reals:
    """Return the ordinate of S at which the follower rests behind the phase that is over, (trial, angle)."""
    lasts = [last for _, _, last in diagrams.stretches]
    heights = [
        drawn.numbers.drawn[mark][:, last : last + 1]
        for mark, last in zip(diagrams.S.readings, lasts, strict=True)
    ]
    level = heights[-1]
    if not diagrams.turn.closed:
        first = diagrams.stretches[0][1]
        level = drawn.numbers.drawn[diagrams.S.readings[0]][:, first : first + 1]
    for last, height in zip(lasts, heights, strict=True):
        level = np.where(phi >= diagrams.turn.angles[last], height, level)
    return np.asarray(level)


def _off_curves(
    drawn: Drawn, turn: Turn, known: Between, inside: list[Any]
) -> Iterator[tuple[Mark, object]]:
    """Yield the points of the diagrams of laws that are read off the curves drawn."""
    diagrams = CAM_PLAN.on(drawn).diagrams
    for one in (diagrams.S, diagrams.V, diagrams.A):
        feet = turn.read([one.axes.feet], known)[one.axes.feet]
        rows = zip(one.points, one.curves, diagrams.stretches, inside, strict=True)
        for spots, curve, (phase, _, _), there in rows:
            if phase.law.name in BY_POINTS:
                foot = np.where(there, feet, np.nan)
                yield spots, erect.run(drawn.numbers.drawn[curve], foot)


TURNING = Turning(between=between, told=quantities, plan=CAM)
