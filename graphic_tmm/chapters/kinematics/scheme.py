"""The mechanism of a task: in one position that nobody has to draw, to a scale, with what acts on it."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator
from dataclasses import replace
from functools import partial
from typing import NamedTuple, TypeVar

import numpy as np

from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import LENGTHS, standard_length
from graphic_tmm.board.values import Reals, undefined
from graphic_tmm.chapters.kinematics.closings import ClosingLeg, GuideLeg, PinLeg, legs_of, pair_of
from graphic_tmm.chapters.kinematics.given import frame_sizes
from graphic_tmm.chapters.kinematics.ink_numbers import guide_names, link_numbers
from graphic_tmm.chapters.kinematics.ink_positions import PositionsInk
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN, KinematicPlans
from graphic_tmm.chapters.kinematics.scales import reaches_at
from graphic_tmm.chapters.kinematics.survey import transmission
from graphic_tmm.chapters.kinematics.task import POSITIONS
from graphic_tmm.errors import StructureError
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.guides import direction, turn
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.mechanism.structure import dissect
from graphic_tmm.paper.drawing import Drawing, Ink
from graphic_tmm.paper.formats import HEIGHTS
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.packing import bounds
from graphic_tmm.project import Project, record
from graphic_tmm.readers.task_sheet import Posed, Scheme, TaskSheet
from graphic_tmm.scene.chapter import chapters
from graphic_tmm.scene.records import Scales, Scene, SheetOrder

FORMAT = "A4"
SIZES = HEIGHTS[FORMAT]
"""How high its letters are: it is held in the hand."""
NEAR = 0.5
"""A moment later the crank has turned by so many degrees: which way points go is seen then."""
SOON = 1e-3
"""A moment later what slides has gone by this share of its stroke."""
ASIDE = 2.0
"""So many degrees it keeps off every position that is drawn, at least."""
CLEAR, TOGETHER = 0.09, 1e-6
"""Points farther apart than this share of the mechanism are told apart well; nearer than that they are one."""
TRIED = 48
"""So many places between positions are tried."""
FOOT, SHARE = -0.35, 0.6
"""A crank below this height, of its length, lies upon the foot of its pivot: then it is shown only where it
passes its motion on so much better."""
ALONE = 37.0
"""So many degrees behind the only position of a row it stands."""
ANYWHERE = 5.0
"""Where it assembles between no positions, the turn is tried in such steps, degrees."""


class Pose(NamedTuple):
    """A mechanism that stands as it is shown, recorded: nothing else is drawn of it."""

    scene: Scene
    project: Project

    @property
    def plans(self) -> KinematicPlans:
        """Its plan of positions."""
        return KINEMATICS_PLAN.on(self.project)


def scheme(scene: Scene, room: complex) -> Scheme | None:
    """Return the mechanism in one position within a width and a height (complex, mm), to a standard scale.

    It stands between the positions that are asked for, where it passes its motion on best. None if the scene
    has no mechanism.

    Raises
    ------
    StructureError
        If it cannot be drawn.
    """
    if scene.mechanism is None:
        return None
    pose = posed(scene)
    wide, high = _kept(scene, (POSED, "span"), partial(_span, pose))
    least = standard_length(max(wide / room.real, high / room.imag, 1e-9), 1.0)
    for mu in (one for one in (*LENGTHS, 10 * least) if one >= least):
        across, up = _kept(scene, (POSED, "inked", mu), partial(_inked, pose, mu))
        if across <= room.real and up <= room.imag:
            break
    view = _kept(scene, (POSED, "drawn", mu), partial(_drawing, pose, mu))
    return Scheme(view, mu, tuple(_notes(scene.mechanism, scene.language)))


def posed(scene: Scene) -> Pose:
    """Return the mechanism in the position in which a task shows it."""
    return _kept(scene, POSED, partial(_posed, scene))


POSED = "posed"
"""What is kept beside a scene: its mechanism in that position, how large that is, and drawn, by μ."""
T = TypeVar("T")


def _kept(scene: Scene, key: Hashable, make: Callable[[], T]) -> T:
    """Return what is kept beside a scene, made once."""
    if key not in scene.cache:
        scene.cache[key] = make()
    found: T = scene.cache[key]
    return found


def _span(pose: Pose) -> tuple[float, float]:
    """Return how far points lie apart, m."""
    unscaled = _reading(pose, 1.0)
    spots = np.concatenate([np.ravel(unscaled[mark])[:1] for mark in _marks(pose.plans)])
    return float(np.ptp(spots.real)), float(np.ptp(spots.imag))


def _inked(pose: Pose, mu: float) -> tuple[float, float]:
    """Return how wide and high the lines are, mm."""
    left, low, right, top = bounds(Drawing("scheme", "", tuple(_strokes(_ink(pose, mu)))))
    return right - left, top - low


def _notes(mechanism: Mechanism, language: str) -> Iterator[str]:
    """Tell from where coordinates of fixed points and distances of fixed guides are counted."""
    _, pivot = speaking(language), dissect(mechanism).origin
    symbols = {name[:2] for name, _ in frame_sizes(mechanism)}
    if "x_" in symbols:
        yield _(_FROM, pivot=pivot)
    if "e_" in symbols:
        yield _(_OFF, pivot=pivot)


_FROM = said("x, y: from pivot {pivot}")
_OFF = said("e: distance of a fixed guide from pivot {pivot}")


def _posed(scene: Scene) -> Pose:
    """Return the mechanism where it is shown, and a moment later."""
    bare = replace(
        scene,
        tasks={},
        trajectories=(),
        scales=Scales(),
        sheets=(SheetOrder(FORMAT, (POSITIONS,)),),
        row=replace(scene.row, accelerations=()),
        main=None,
    )
    whole = record(bare, wanted={POSITIONS})
    made = KINEMATICS_PLAN.on(whole)
    there = np.array([angle for angle in whole.coordinates if angle is not None])
    between = _assembled(scene, made, there)
    passed = np.nan_to_num(transmission(made.tried, between), nan=-1.0)
    passed = passed * _apart(made, between)
    if made.tried.sweep.turns:
        passed = np.where(np.sin(np.radians(between)) < FOOT, SHARE * passed, passed)
    at = float(between[int(np.argmax(np.round(passed, 6)))])
    return Pose(scene, record(_standing(bare, made, at), wanted={POSITIONS}))


def _standing(scene: Scene, made: KinematicPlans, at: float) -> Scene:
    """Return the scene whose drive stands at a coordinate, and a moment later, others where they are then."""
    first, after = made.mechanism.drive, at + _moment(made)
    row = replace(scene.row, accelerations=(), extra=(), ends=None)
    if made.tried.sweep.turns and not made.mechanism.further:
        return replace(scene, row=replace(row, count=1, zero=at, extra=(after,), places=()))
    turns = made.tried.sweep.turns
    gone = np.radians(at - made.tried.zero) if turns else at - made.tried.zero
    further = []
    for one in made.mechanism.further:
        by = one.speed / first.speed * gone if first.speed else 0.0
        further.append(replace(one, start=one.start + (by if one.slides else np.degrees(by))))
    mechanism = replace(made.mechanism, further=tuple(further))
    return replace(
        scene, mechanism=mechanism, row=replace(row, count=2, zero=0.0, places=(at, after))
    )


def _moment(made: KinematicPlans) -> float:
    """Return how far the drive goes in a moment: which way points go is seen then."""
    if made.tried.sweep.turns or made.ends is None:
        return NEAR * made.sense
    return SOON * (made.ends[1] - made.ends[0]) * made.sense


def _assembled(scene: Scene, made: KinematicPlans, there: Reals) -> Reals:
    """Return angles of the crank to choose from, at which it assembles, and a moment later too.

    Half way between positions, if there are such; else anywhere in the turn off them; else those of positions.
    """
    turn = np.arange(there[0], there[0] + 360.0, ANYWHERE)
    beside = turn[_away(turn, there) >= ASIDE]
    for row in (_between(there, made), beside if made.ends is None else there, there):
        marks = [s.it for s in made.tried.construction.steps if s.it.view == POSITIONS]
        stands = np.ones(row.size, dtype=bool)
        for at in (row, row + _moment(made)):
            reading = made.tried.at(at[None, :], marks)
            for mark in marks:
                stands &= ~np.broadcast_to(undefined(reading[mark])[0], row.shape)
        if stands.any():
            found: Reals = row[stands]
            return found
    says = said("{source}: none of the positions can be drawn{over}", source=scene.source, over="")
    raise StructureError(says)


def _away(row: Reals, there: Reals) -> Reals:
    """Return how far angles are from the nearest position, degrees."""
    away = np.abs((row[:, None] - there[None, :] + 180.0) % 360.0 - 180.0)
    return np.asarray(away.min(axis=1))


def _between(there: np.ndarray, made: KinematicPlans) -> np.ndarray:
    """Return angles of the crank half way between positions; of a single one, some way behind it."""
    if made.ends is not None:
        row = there[: made.count]
        return np.asarray((row[1:] + row[:-1]) / 2.0 if row.size > 1 else row)
    if made.in_turn < 2:
        return np.round(there[:1] + ALONE * made.sense, 1)
    step = 360.0 / made.in_turn
    row = there[: made.in_turn : max(1, made.in_turn // TRIED)]
    found = np.asarray(row + made.sense * step / 2.0, dtype=np.float64)
    clear = found[_away(found, there) >= min(ASIDE, step / 4.0)]
    return clear if clear.size else found


def _apart(made: KinematicPlans, angles: Reals) -> Reals:
    """Return how well points are told apart at angles of the crank: 1 where all stand well off one another."""
    marks = _points(made)
    reading = made.tried.at(angles[None, :], marks)
    row = np.empty((len(marks), angles.size), dtype=np.complex128)
    for k, mark in enumerate(marks):
        row[k] = reading[mark][0]
    away = np.abs(row[:, None] - row[None, :])
    span = float(away.max())
    never = np.ptp(away, axis=2) < span * TOGETHER  # of one link, or one point: always as far apart
    nearest = np.where(never[:, :, None], np.inf, away).min(axis=(0, 1))
    return np.asarray(np.clip(np.minimum(nearest, span) / (CLEAR * span), 0.1, 1.0))


def _points(made: KinematicPlans) -> list[Mark]:
    """Return the points of all links where positions are tried."""
    bodies = made.tried.positions.bodies.values()
    return list(dict.fromkeys(mark for one in bodies for mark in one.marks.values()))


def _marks(made: KinematicPlans) -> list[Mark]:
    return [mark for one in made.positions.bodies.values() for mark in one.marks.values()]


def _reading(pose: Pose, mu: float) -> Reading:
    log = pose.project.construction
    given = {**pose.project.given, pose.plans.mu_l: mu}
    return execute(log, given, [*log.given, *(step.it for step in log.steps)])


def _ink(pose: Pose, mu: float) -> PositionsInk:
    log, reading = pose.project.construction, _reading(pose, mu)
    return PositionsInk(log, reading, reaches_at(pose.plans, log, reading, mu), [0])


def _strokes(ink: PositionsInk) -> list[Ink]:
    return [*ink.guides(), *ink.heavy(0)]


def _drawing(pose: Pose, mu: float) -> Drawing:
    """Return the mechanism with its letters, the numbers of its links, the sense of the crank, what acts."""
    made, ink = pose.plans, _ink(pose, mu)
    strokes = _strokes(ink)
    wanted = ink.letters((ink.frame.name, *ink.names), 0, SIZES.point)
    for arrow in ink.arrows(made.pairs, made.positions, 0, SIZES.point):
        strokes += arrow.strokes
        wanted.append(arrow.wanted._replace(of=arrow.wanted.of[:1]))
    posed = Posed(
        lambda letter, link: _spot(made, ink.reading, letter, link),
        SIZES.point,
        lambda link: _turn(made, ink.reading, link),
    )
    found = (
        one for chapter in chapters() for one in TaskSheet.of(chapter).acting(pose.scene, posed)
    )
    for acting in dict.fromkeys(found):
        strokes += acting.strokes
        wanted += acting.wanted
    wanted += guide_names(ink, 0, SIZES.number)
    circled = link_numbers(ink, 0, strokes, wanted, SIZES.number)
    strokes += [stroke for one in circled for stroke in one.strokes]
    view = Drawing(
        "scheme",
        "",
        tuple(strokes),
        tuple(one.label for one in circled),
        wanted=tuple(wanted),
    )
    return finished(view)


def _spot(
    made: KinematicPlans, reading: Reading, letter: str, link: int
) -> tuple[complex, complex]:
    """Return where a point of a link stands, and which way it goes."""
    at = np.ravel(reading[made.positions.bodies[link].marks[letter]])
    by = complex(at[-1] - at[0])
    return complex(at[0]), by / abs(by) if abs(by) > 1e-9 else 0j


def _along(leg: ClosingLeg, line: Mark) -> bool:
    """Whether the line of a leg that turns is this one."""
    return isinstance(leg, PinLeg) and leg.line == line


def _turn(made: KinematicPlans, reading: Reading, link: int) -> complex:
    """Return which way the own x axis of a link points: by its axis, or by its guide."""
    if link == made.mechanism.frame.number:
        return 1 + 0j
    body = made.positions.bodies[link]
    for closing, leg in legs_of(made.positions.closings, POSITIONS):
        if not isinstance(leg, GuideLeg) or body.drawn:
            continue
        if link in (leg.link, leg.on if leg.inner else None):
            along = complex(reading[leg.line].along[0, 0])
            # the line of a rocker runs from its pivot to the stone: its guide may run the other way
            if leg.inner and _along(closing.legs[1], leg.line):
                along *= float(reading[made.positions.sides[closing.group.name]][0, 0])
            return along * turn(-direction(pair_of(closing, leg), link))
    return complex(reading[body.axis].along[0, 0]) * turn(-body.angle)
