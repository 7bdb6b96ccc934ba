"""The plans of a mechanism at any angle of its crank: what they tell there, the figures that move with it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.operations.outside import stand, stand_out
from graphic_tmm.board.record import Figure, Mark
from graphic_tmm.chapters.kinematics.closings import GuideLeg, PinLeg, legs_of
from graphic_tmm.chapters.kinematics.ink_numbers import Letters
from graphic_tmm.chapters.kinematics.ink_plans import Place, draw_plan
from graphic_tmm.chapters.kinematics.ink_positions import FULL, PATHS, PositionsInk, path_stays
from graphic_tmm.chapters.kinematics.plan import ALL, KINEMATICS_PLAN, KinematicPlans
from graphic_tmm.chapters.kinematics.reaches import Reach, reach_of
from graphic_tmm.chapters.kinematics.scales import REACHES, reaches
from graphic_tmm.chapters.kinematics.sides import standing
from graphic_tmm.chapters.kinematics.survey import least_angle
from graphic_tmm.chapters.kinematics.table import UNITS, plan_columns
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, POSITIONS, VELOCITIES
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject
from graphic_tmm.page.strands import Moving, MovingFigures, Output
from graphic_tmm.paper.drawing import Drawing, Ink
from graphic_tmm.paper.figure import Manner, figure
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.views import mu_text
from graphic_tmm.project import Project
from graphic_tmm.readers.any_angles.turn import (
    Between,
    Passed,
    Plan,
    Quantity,
    Turn,
    Turning,
    TurnQuantity,
)
from graphic_tmm.scene.captions import captions
from graphic_tmm.scene.records import Scene

VECTORS: tuple[tuple[Plan, Quantity, Quantity], ...] = (
    ("velocities", "velocities", "omega"),
    ("accelerations", "accelerations", "epsilon"),
)
"""The plans of vectors: what stands for what of points and of links."""

CUT = 0.01
"""A guide that is shorter than it is used by less than this is not cut short, mm."""


def free(scene: Scene) -> Scene:
    """Return the scene with direct plans, accelerations among them, and no path of a point."""
    row = scene.row if scene.row.accelerations else replace(scene.row, accelerations=ALL)
    return replace(scene, row=row, turned=False, trajectories=())


def quantities(project: Project) -> Iterator[TurnQuantity]:
    """Yield places, velocities and accelerations of all points, then ω and ε of links that turn."""
    made = KINEMATICS_PLAN.on(project)
    bodies = made.positions.bodies
    names = [(letter, n) for n, body in bodies.items() for letter in body.link.points]
    origin = made.mechanism.frame.points[made.structure.origin]
    for letter, n in names:
        mark = bodies[n].marks[letter]
        yield TurnQuantity("positions", "places", (letter, n), mark, made.mu_l, origin=origin)
    for plan, quantity, turning in VECTORS:
        motion = made.motion(plan)
        if motion is None:
            continue
        for letter, n in names:
            image: Mark = motion.images.by_letter[n][letter]
            yield TurnQuantity(plan, quantity, (letter, n), image, motion.mu)
        for n, rate in motion.rates.items():
            yield TurnQuantity(plan, turning, n, rate)


def between(drawn: Drawn, turn: Turn) -> Between:
    """Return how far the drive has gone, that no angle is an extra one, on which side each group stands."""
    made, log = KINEMATICS_PLAN.on(drawn), drawn.construction
    if turn.angles is not None:
        there = {made.positions.row[0]: turn.angles} | standing(made, turn.angles)
        return there | _changing(drawn, made, turn)
    found: dict[Mark, object] = {
        mark: turn.turned[None, :] for mark in log.given if mark.role == roles.ROW
    }
    none = np.zeros((1, turn.turned.size))
    found |= {step.uses[2]: none for step in log.steps if step.op in (stand, stand_out)}
    angles = float(drawn.numbers.drawn[made.positions.row[0]][0, 0]) + turn.turned[None, :]
    return found | standing(made, angles, carried=True) | _changing(drawn, made, turn)


def _changing(drawn: Drawn, made: KinematicPlans, turn: Turn) -> dict[Mark, object]:
    """Return what is given of a drive whose rates change, between positions in proportion."""
    drive = made.mechanism.drive
    if not drive.rates and not drive.gains:
        return {}
    own = np.ravel(drawn.numbers.drawn[made.positions.row[0]])[: made.count]
    period = made.tried.sweep.high if made.closed else None
    gone = np.abs(own - own[0])
    at = np.abs(turn.turned) if period is None else (drive.sense * turn.turned) % period
    rates = [mark for mark in drawn.construction.given if mark.role == roles.RATE]
    return {
        mark: np.interp(at, gone, np.ravel(np.asarray(drawn.given[mark])), period=period)[None, :]
        for mark in rates
    }


def moving(drawn: Drawn) -> Iterator[Moving]:
    """Yield the mechanism in one position, and its plans of velocities and accelerations there."""
    made, language = KINEMATICS_PLAN.on(drawn), drawn.scene.language
    words = captions(language)
    yield Moving(
        POSITIONS,
        words[POSITIONS],
        mu_text(drawn.scales[POSITIONS], language),
        _mechanism(drawn),
        lambda name: POSITIONS,
        lambda: _about(drawn, made),
        lambda: plan_columns(drawn, POSITIONS),
        crank=made.led,
        output=_output(made),
    )
    for plan in (VELOCITIES, ACCELERATIONS):
        if made.motion(plan) is not None and plan in drawn.scales and drawn.of(plan) is not None:
            yield _plan(drawn, plan, words[plan])


def _output(made: KinematicPlans) -> Output | None:
    """Return what the last group moves on the frame."""
    for closing, leg in reversed([*legs_of(made.positions.closings, POSITIONS)]):
        pivot = leg.pivot if isinstance(leg, PinLeg) else None
        own = [mark for mark in made.positions.bodies[leg.link].marks.values() if mark != pivot]
        slides_within = isinstance(leg, GuideLeg) and leg.inner
        if leg.body == made.mechanism.frame.number and own and not slides_within:
            return Output(leg.link, closing.point if closing.point in own else own[0], pivot)
    return None


def _mechanism(drawn: Drawn) -> Callable[[int], Drawing]:
    size = heights(drawn.scene, POSITIONS).point
    ink = PositionsInk(drawn.construction, drawn.reading, reaches(drawn), [0])
    names = (ink.frame.name, *ink.names)

    def at(place: int) -> Drawing:
        wanted = tuple(ink.letters(names, place, size))
        return Drawing(POSITIONS, "", (*ink.guides(), *ink.heavy(place)), wanted=wanted)

    return at


def _about(drawn: Drawn, made: KinematicPlans) -> Drawing:
    """Return what stands about the mechanism: the crank's circle, paths, extreme positions, numbers."""
    left_out = {*drawn.undrawn, *made.repeated}
    places = [k for k in drawn.all if k not in left_out]
    ink = PositionsInk(drawn.construction, drawn.reading, reaches(drawn), places)
    traces = figure(ink.seen, Manner(PATHS, path_stays))
    strokes: list[Ink] = [*ink.crank_circles(made.arms, whole=made.ends is None), *traces.staying]
    for k in made.extremes:
        strokes += ink.thin(k, FULL) if k in places else []
    high = heights(drawn.scene, POSITIONS)
    wanted = tuple(ink.numbers(made.led, drawn.names, Letters(high.number, high.point)))
    return Drawing(POSITIONS, "", tuple(strokes), wanted=wanted)


def _plan(drawn: Drawn, plan: str, title: str) -> Moving:
    reading, scale, row = drawn.of(plan), drawn.scales[plan], drawn.row(plan)
    assert reading is not None
    on = subject(drawn, "", plan)._replace(reading=reading)

    def at(place: int) -> Drawing:
        stood = [Place(row.index(place) if len(row) < len(drawn.names) else place)]
        return draw_plan(on, plan, stood, scale.value, UNITS[plan], helping=False)

    return Moving(
        plan,
        title,
        mu_text(scale, drawn.scene.language),
        at,
        lambda name: f"{plan}-{name}",
        columns=lambda: plan_columns(drawn, plan),
    )


def _passed(project: Project) -> Passed:
    plans = KINEMATICS_PLAN.on(project)
    if plans.ends is None:
        return Passed(not plans.assembly.ranges, least_angle(plans.tried))
    points = [closing.point for closing in plans.tried.positions.closings]
    reading = plans.tried.whole(points, plans.ends)[1]
    whole = all(np.isfinite(reading[point]).all() for point in points)
    return Passed(whole, least_angle(plans.tried, plans.ends), ends=True)


def _reaches(sheet: Drawn, drawn: Drawn) -> dict[str, dict[Figure, Reach]]:
    """Return how far every guide is used in a drawing at all angles, as it caches that.

    Those that a sheet cuts short are as they are there.
    """
    made, per = KINEMATICS_PLAN.on(drawn), 1.0 / sheet.scales[POSITIONS].value
    found = {}
    for guide, shown in reaches(sheet).items():
        whole = made.reaches[guide].times(per)
        cut = max(abs(shown.low - whole.low), abs(shown.high - whole.high)) > CUT
        found[guide] = (
            shown if cut else reach_of(drawn.construction, drawn.reading, guide, whole.anchor)
        )
    return {REACHES: found}


TURNING = Turning(between=between, passed=_passed, told=quantities, free=free)
FIGURES = MovingFigures(moving, _reaches)
