"""μ_l, μ_v, μ_a: what the scene fixes, else standard ones that give the plans their size."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Construction, Figure
from graphic_tmm.board.scales import Scale, standard, standard_length
from graphic_tmm.board.values import Curve, Point
from graphic_tmm.chapters.kinematics.names import ACCELERATIONS, KINEMATICS, POSITIONS, VELOCITIES
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN, KinematicPlans
from graphic_tmm.chapters.kinematics.reaches import Reach, reach_of
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.scales import Fitting, ScaleFactors, extent, unscaled
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.project import Project
from graphic_tmm.scene.captions import captions

SMALL, VECTORS, UNSEEN = 50.0, 80.0, 150.0
"""Room for the longest vector of a plan, mm, to begin with, and where no sheet shows it. Below 50 mm the half
division of a ruler, 0.25 mm, is more than 0.5 %."""
KEYS = {POSITIONS: ("mu_l", "OA"), VELOCITIES: ("mu_v", "pa"), ACCELERATIONS: ("mu_a", "pi_a")}
"""The keys of [scales] that fix the size of a plan."""
UNITS = {"mu_l": "m/mm", "mu_v": "(m/s)/mm", "mu_a": "(m/s²)/mm"}
SCALE_KEYS = {plan: keys[0] for plan, keys in KEYS.items()}
"""What the scale factors are called where machines read them."""
RULING, OUTLYING = 0.9, 2.0
"""What share of the positions rules the μ of a plan where the others are so many times longer; by eye."""


class Extents(NamedTuple):
    """What there is to draw (SI): how far the plan of positions reaches, the longest vectors of the others.

    ``outliers``: by plan, the positions (indices) whose vectors are longer, and how many times.
    """

    positions: float
    velocities: float
    accelerations: float
    outliers: Mapping[str, Mapping[int, float]] = MappingProxyType({})


def extents(project: Project, doubts: Doubts) -> Extents:
    """Return what the choice of μ goes by, found with the exact hand at 1 SI unit to the millimetre.

    The plan of positions reaches as far as what is inked on it: its points in all positions, the circle of the
    crank pin, the paths of points. What is lost by ``doubts`` has no part in it.
    """
    made = KINEMATICS_PLAN.on(project)
    marks = [m for m in project.marks(POSITIONS) if m.kind in (Point, Curve)]
    pivot, _ = made.crank
    reading = unscaled(project, doubts, [*marks, pivot])
    arm = crank_sizes(made)[0]
    spots = [reading[pivot] + arm * np.array([1, 1j, -1, -1j])]
    spots += [reading[m].knots if m.kind is Curve else reading[m] for m in marks]
    told = project.told.get(ACCELERATIONS, frozenset())
    places = made.accelerated or tuple(sorted(told)) or _shown(project)
    longest = {POSITIONS: extent(spots), VELOCITIES: 0.0, ACCELERATIONS: 0.0}
    outliers = {}
    for plan, motion, at in (
        (VELOCITIES, made.velocities, tuple(range(len(project.names)))),
        (ACCELERATIONS, made.accelerations, places),
    ):
        if motion is not None and at:
            longest[plan], outliers[plan] = ruling(at, _longest(project, plan, at, doubts))
    return Extents(longest[POSITIONS], longest[VELOCITIES], longest[ACCELERATIONS], outliers)


def ruling(at: Sequence[int], lengths: np.ndarray) -> tuple[float, dict[int, float]]:
    """Return the length that rules the μ of a plan, and the positions that it leaves out.

    That is the longest of all positions ``at``; but where one position in ten is more than `OUTLYING` times as
    long as the others (a mechanism near locking), it is the longest of these. All positions of a plan keep one
    μ, as a student's do, so the outlier is drawn larger than they are, as far as a sheet holds it: with a μ of
    its own it could not be compared with its neighbours, which is what it is drawn for.
    """
    there = np.isfinite(lengths)
    known = np.sort(lengths[there])
    if not known.size:
        return 0.0, {}
    most = float(known[math.ceil(RULING * known.size) - 1])
    if not 0.0 < OUTLYING * most < known[-1]:
        return float(known[-1]), {}
    over = there & (lengths > OUTLYING * most)
    return most, {at[int(k)]: float(lengths[k]) / most for k in np.flatnonzero(over)}


def _shown(project: Project) -> tuple[int, ...]:
    """Return the positions at which what becomes of other views is told, if not of all."""
    return tuple(sorted(frozenset().union(*project.told.values())))


def crank_sizes(made: KinematicPlans) -> tuple[float, float, float]:
    """Return the length of the crank, the speed and the acceleration of its pin (SI)."""
    drive, structure = made.mechanism.drive, made.structure
    crank = made.mechanism.by_number[structure.driver]
    arm = abs(crank.points[structure.pin] - crank.points[structure.pivot])
    return arm, abs(drive.speed) * arm, abs(drive.speed**2 + 1j * drive.acceleration) * arm


def plan_scales(fitting: Fitting) -> dict[str, Scale]:
    """Return μ of every plan drawn: what the scene fixes, else a standard one that gives it its size.

    A segment fixed in mm (OA, pa, πa) gives its μ.
    """
    made, wanted, sizes = KINEMATICS_PLAN.on(fitting), fitting.scene.scales, fitting.sizes
    reach: Extents = fitting.reach[KINEMATICS]
    arm, pin_speed, pin_acceleration = crank_sizes(made)
    mu_l = wanted.mu_l or (
        arm / wanted.OA if wanted.OA else standard_length(reach.positions, sizes[POSITIONS])
    )
    scales = {POSITIONS: Scale("μ_l", mu_l, UNITS["mu_l"])}
    if made.velocities is not None:
        mu_v = wanted.mu_v or (
            pin_speed / wanted.pa if wanted.pa else standard(reach.velocities, sizes[VELOCITIES])
        )
        if wanted.mu_v_is_mu_l_omega:
            mu_v = mu_l * abs(made.mechanism.drive.speed)
        scales[VELOCITIES] = Scale("μ_v", mu_v, UNITS["mu_v"])
    if made.accelerations is not None:
        mu_a = wanted.mu_a or (
            pin_acceleration / wanted.pi_a
            if wanted.pi_a
            else standard(reach.accelerations, sizes[ACCELERATIONS])
        )
        scales[ACCELERATIONS] = Scale("μ_a", mu_a, UNITS["mu_a"])
    return scales


def _longest(project: Project, plan: str, at: Sequence[int], doubts: Doubts) -> np.ndarray:
    """Return the longest vector of a plan at some positions (SI), NaN where there is none."""
    points = [m for m in project.marks(plan) if m.kind is Point]
    reading = unscaled(project, doubts, points).cut(tuple(at))
    lengths = [np.broadcast_to(np.abs(reading[m][0]), (len(at),)) for m in points]
    found = np.fmax.reduce(lengths) if lengths else np.full(len(at), np.nan)
    return np.asarray(found)


def outlying(drawn: Drawn, language: str) -> Iterator[str]:
    """Yield, as sentences, the positions whose vectors are much longer than those of the others."""
    _ = speaking(language)
    reach: Extents = drawn.reach[KINEMATICS]
    for plan, found in reach.outliers.items():
        shown = {k: times for k, times in found.items() if k in drawn.row(plan)}
        if shown and plan in drawn.scales:
            yield _(
                "{plan}, positions {places}: the vectors are {times} times as long as those of 9 in 10 "
                "positions, which rule the scale factor",
                plan=captions(language)[plan],
                places=", ".join(drawn.names[k] for k in shown),
                times=number(max(shown.values()), language, 2),
            )


def reaches(drawn: Drawn) -> dict[Figure, Reach]:
    """Return how far every guide is used over the turn, mm on the sheet; found once for a drawing."""
    key = f"{KINEMATICS} reaches"
    if key not in drawn.cache:
        drawn.cache[key] = _reaches(drawn)
    found: dict[Figure, Reach] = drawn.cache[key]
    return found


def _reaches(drawn: Drawn) -> dict[Figure, Reach]:
    made, mu = KINEMATICS_PLAN.on(drawn), drawn.scales[POSITIONS].value
    return reaches_at(made, drawn.construction, drawn.reading, mu)


def reaches_at(
    made: KinematicPlans, log: Construction, reading: Reading, mu: float
) -> dict[Figure, Reach]:
    """Return the same of a reading to a scale, m/mm."""
    circle = 2.0 * crank_sizes(made)[0] / mu
    found = {}
    for guide, whole in made.reaches.items():
        part = reach_of(log, reading, guide, whole.anchor)
        found[guide] = whole.times(1.0 / mu).near(part, circle)
    return found


SCALES = ScaleFactors(
    reach=extents, plan_scales=plan_scales, key=lambda view: SCALE_KEYS.get(view, "")
)
