"""μ_l, μ_v, μ_a: what the scene fixes, else standard ones; how large the plans may be, and how μ was chosen."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Construction, Figure, Mark
from graphic_tmm.board.scales import LENGTHS, Scale, scale_by_turning, standard, standard_length
from graphic_tmm.board.values import Curve, Point
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN, KinematicPlans
from graphic_tmm.chapters.kinematics.reaches import Reach, reach_of
from graphic_tmm.chapters.kinematics.task import (
    ACCELERATIONS,
    BY_DRIVE,
    KINEMATICS,
    PLANS,
    POSITIONS,
    VELOCITIES,
)
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.choice import Choice, Ledger, usual_room, value_of
from graphic_tmm.fitting.scales import Fitting, ScaleFactors, extent, unscaled
from graphic_tmm.fitting.sizes import Size, Sizing, usual
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.said import said
from graphic_tmm.language.units import unit_name
from graphic_tmm.project import Project
from graphic_tmm.scene.captions import captions
from graphic_tmm.scene.records import Scales, Scene

PLAN, VELOCITY, ACCELERATION, MANY = 270.0, 100.0, 140.0, 100.0
"""The most that a plan of positions takes on an A1, mm, the longest vector of a plan of velocities, of
accelerations, and of many of these. Half a division of the ruler, 0.25 mm, is 0.5 % of 50 mm."""
FEW = 4
"""So many plans of accelerations are few."""
FLAT = 0.7
"""What a plan's width counts against its height: sheets are so much wider than high."""
CRANK = 20.0
"""A crank is no shorter, mm on an A1, on other formats in proportion, as far as its plan goes on the sheet."""
LARGEST = 360.0
"""The most that a plan of positions takes on an A1 for its crank's sake, mm."""
_POSITIONS = said(
    "The plan of positions takes {room}, and its crank no less than {crank:g} mm there where the sheet allows: "
    "shorter lengths are read to no better than 1 %.",
    room=usual_room(PLAN),
    crank=CRANK,
)
_POSITIONS_WITHOUT_CRANK = said(
    "The plan of positions takes {room}: shorter lengths than 20 mm are read to no better than 1 %.",
    room=usual_room(PLAN),
)
"""The same where nothing driven has an arm."""
_VECTORS = {
    VELOCITIES: said(
        "The longest vector takes {room}: half a division of the ruler is less than 1 % of what is longer than "
        "25 mm.",
        room=usual_room(VELOCITY),
    ),
    ACCELERATIONS: said(
        "The longest vector takes {room}, and no more than {many:g} mm there where there are more than {few} "
        "plans.",
        room=usual_room(ACCELERATION),
        many=MANY,
        few=FEW,
    ),
}
_TOGETHER = said(
    "What each drive causes is drawn to the scale of the plan of velocities: there they add up."
)
_VECTOR_OF = {VELOCITIES: ("v", "m/s"), ACCELERATIONS: ("a", "m/s²")}
KEYS = {POSITIONS: ("mu_l", "OA"), VELOCITIES: ("mu_v", "pa"), ACCELERATIONS: ("mu_a", "pi_a")}
"""The keys of [scales] that fix the size of a plan."""
UNITS = {"mu_l": "m/mm", "mu_v": "(m/s)/mm", "mu_a": "(m/s²)/mm"}
SCALE_KEYS = {plan: keys[0] for plan, keys in KEYS.items()}
"""What the scale factors are called where machines read them."""
RULING, OUTLYING = 0.9, 2.0
"""What share of the positions rules the μ of a plan where the others are so many times longer; by eye."""


class Extents(NamedTuple):
    """What there is to draw (SI): how far the plan of positions reaches, the longest vectors of the others.

    ``outliers``: by plan, the positions (indices) whose vectors are longer, and how many times. ``by_drive``:
    the longest vectors of what single drives could do, by view.
    """

    positions: float
    velocities: float
    accelerations: float
    outliers: Mapping[str, Mapping[int, float]] = MappingProxyType({})
    by_drive: Mapping[str, float] = MappingProxyType({})


def extents(project: Project, doubts: Doubts) -> Extents:
    """Return what the choice of μ goes by, found with the exact hand at 1 SI unit to the millimetre.

    The plan of positions reaches as far as what is inked on it: its points in all positions, the circle of the
    crank pin, the paths of points. What is lost by ``doubts`` has no part in it.
    """
    made = KINEMATICS_PLAN.on(project)
    marks = [m for m in project.marks(POSITIONS) if m.kind in (Point, Curve)]
    ring = made.pairs[0].arm_ends(made.positions)[:1] if made.ends is None else ()
    reading = unscaled(project, doubts, [*marks, *ring])
    arm = made.pairs[0].sizes.length
    spots = [reading[pivot] + arm * np.array([1, 1j, -1, -1j]) for pivot in ring]
    spots += [reading[m].knots if m.kind is Curve else reading[m] for m in marks]
    longest = {POSITIONS: extent(spots, FLAT), VELOCITIES: 0.0, ACCELERATIONS: 0.0}
    outliers = {}
    for plan, motion, at in (
        (VELOCITIES, made.velocities, tuple(range(len(project.names)))),
        (ACCELERATIONS, made.accelerations, acceleration_places(project)),
    ):
        if motion is not None and at:
            longest[plan], outliers[plan] = ruling(at, _longest(project, plan, at, doubts))
    every = tuple(range(len(project.names)))
    by_drive = {
        view: ruling(every, _longest(project, view, every, doubts))[0]
        for view in (one.mu.view for one in made.apart)
    }
    return Extents(
        longest[POSITIONS], longest[VELOCITIES], longest[ACCELERATIONS], outliers, by_drive
    )


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


def acceleration_places(project: Project) -> tuple[int, ...]:
    """Return the positions that get a plan of accelerations, or at which it, or another view, is told."""
    told = project.told.get(ACCELERATIONS, frozenset()) or frozenset().union(*project.told.values())
    return KINEMATICS_PLAN.on(project).accelerated or tuple(sorted(told))


def plan_scales(fitting: Fitting) -> dict[str, Scale]:
    """Return μ of every plan drawn: what the scene fixes, else a standard one that gives it its size.

    A segment fixed in mm (OA, pa, πa) gives its μ.
    """
    made, wanted, sizes = KINEMATICS_PLAN.on(fitting), fitting.scene.scales, fitting.sizes
    many = 1.0 if len(made.accelerated) <= FEW else MANY / ACCELERATION
    reach: Extents = fitting.reach[KINEMATICS]
    arm, pin_speed, pin_acceleration = made.pairs[0].sizes
    mu_l = wanted.mu_l or (
        arm / wanted.OA if wanted.OA else _by_rule(fitting, reach.positions, arm)
    )
    scales = {POSITIONS: Scale("μ_l", mu_l, UNITS["mu_l"])}
    if made.velocities is not None:
        mu_v = wanted.mu_v or (
            pin_speed / wanted.pa if wanted.pa else standard(reach.velocities, sizes[VELOCITIES])
        )
        if wanted.mu_v_is_mu_l_omega:
            mu_v = mu_l * abs(made.pairs[0].speed)
        scales[VELOCITIES] = Scale("μ_v", mu_v, UNITS["mu_v"])
        for view, longest in reach.by_drive.items():
            own = mu_v if made.mechanism.moves else standard(longest, sizes[VELOCITIES])
            scales[view] = Scale("μ_v", own, UNITS["mu_v"])
    if made.accelerations is not None:
        mu_a = wanted.mu_a or (
            pin_acceleration / wanted.pi_a
            if wanted.pi_a
            else standard(reach.accelerations, many * sizes[ACCELERATIONS])
        )
        scales[ACCELERATIONS] = Scale("μ_a", mu_a, UNITS["mu_a"])
    return scales


def _by_rule(fitting: Fitting, reach: float, arm: float) -> float:
    """Return μ_l at which a plan that reaches so far (m) takes its room, or more for its crank's sake."""
    room, crank = fitting.sizes[POSITIONS], CRANK * usual(fitting.scene)[POSITIONS] / PLAN
    own, most = (standard_length(reach, many * room) for many in (1.0, LARGEST / PLAN))
    larger = (mu for mu in reversed(LENGTHS) if most <= mu < own)
    return own if arm / own >= crank else next((mu for mu in larger if arm / mu >= crank), most)


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


REACHES = f"{KINEMATICS} reaches"
"""How far every guide is used is cached with a drawing by this name."""


def reaches(drawn: Drawn) -> dict[Figure, Reach]:
    """Return how far every guide is used over the turn, mm on the sheet; found once for a drawing."""
    if REACHES not in drawn.cache:
        drawn.cache[REACHES] = _reaches(drawn)
    found: dict[Figure, Reach] = drawn.cache[REACHES]
    return found


def _reaches(drawn: Drawn) -> dict[Figure, Reach]:
    made, mu = KINEMATICS_PLAN.on(drawn), drawn.scales[POSITIONS].value
    return reaches_at(made, drawn.construction, drawn.reading, mu)


def reaches_at(
    made: KinematicPlans, log: Construction, reading: Reading, mu: float
) -> dict[Figure, Reach]:
    """Return the same of a reading to a scale, m/mm."""
    circle = 2.0 * made.pairs[0].sizes.length / mu
    found = {}
    for guide, whole in made.reaches.items():
        part = reach_of(log, reading, guide, whole.anchor)
        found[guide] = whole.times(1.0 / mu).near(part, circle)
    return found


SCALES = ScaleFactors(reach=extents, plan_scales=plan_scales, keys=lambda project: SCALE_KEYS)


def _size(plan: str, natural: float, *, first: bool = True) -> Size:
    keys = KEYS[plan]

    def fixed(scene: Scene) -> str:
        return next((f"scales.{key}" for key in keys if getattr(scene.scales, key)), "")

    def freed(scene: Scene) -> Scene:
        left: dict[str, Any] = dict.fromkeys(keys)
        free: Scales = replace(scene.scales, **left)
        return replace(scene, scales=free)

    def remedy(drawn: Drawn, key: str) -> str:
        mu = drawn.scales[plan].value
        crank = KINEMATICS_PLAN.on(drawn).pairs[0].sizes[PLANS.index(plan)] / mu
        return (
            f"{mu:g} {unit_name(UNITS[key], drawn.scene.language)}"
            if key in UNITS
            else f"{math.floor(crank) or crank:g} mm"
        )

    def own(reach: Mapping[str, Any]) -> float:
        return float(getattr(reach[KINEMATICS], plan))

    return Size(
        plan,
        natural,
        in_mm=True,
        first=first,
        plan=True,
        extent=own,
        fixed=fixed,
        freed=freed,
        remedy=remedy,
        keys=keys,
    )


_SIZES = (
    _size(POSITIONS, PLAN, first=False),
    _size(VELOCITIES, VELOCITY),
    _size(ACCELERATIONS, ACCELERATION),
)
"""Room for the plan of positions, and for the longest vectors of the others."""


def _velocities(scene: Scene, role: str) -> tuple[str, ...]:
    return (POSITIONS,) if scene.scales.mu_v_is_mu_l_omega else (VELOCITIES,)


SIZES = Sizing(
    sizes=_SIZES,
    depends={
        POSITIONS: lambda scene, role: (POSITIONS,),
        VELOCITIES: _velocities,
        BY_DRIVE: _velocities,
        ACCELERATIONS: lambda scene, role: (ACCELERATIONS,),
    },
)


def choose(drawn: Drawn, ledger: Ledger) -> None:
    """Record how the scale factors of the three plans were chosen."""
    made, wanted = KINEMATICS_PLAN.on(drawn), drawn.scene.scales
    reach: Extents = drawn.reach[KINEMATICS]
    pair = made.pairs[0]
    segments = pair.segments
    ledger.of(POSITIONS)
    arm = pair.length_known(ledger)
    mu = drawn.project.scale(POSITIONS)
    if wanted.mu_l:
        mu_l = ledger.given(mu, wanted.mu_l)
    elif wanted.OA and arm is not None:
        mu_l = ledger.by_length(mu, arm, segments.length, wanted.OA)
    else:
        most = ledger.quantity("l_{max}", reach.positions, "m")
        because = _POSITIONS if arm is not None else _POSITIONS_WITHOUT_CRANK
        mu_l = ledger.fitting(mu, most, value_of(drawn, mu), lengths=True, why=because)
    if arm is not None and (not wanted.OA or wanted.mu_l):
        ledger.follows(segments.length, arm, mu_l)
    if made.velocities is None:
        return
    ledger.of(VELOCITIES)
    omega = pair.rate_known(ledger)
    ledger.enter(made.velocities.speeds[pair.link], omega)
    speed = pair.speed_known(ledger)
    mu = drawn.project.scale(VELOCITIES)
    if wanted.mu_v_is_mu_l_omega:
        mu_v = ledger.draft.draw(scale_by_turning, mu.letter, mu_l, omega, unit=mu.unit)
        ledger.follows(segments.speed, speed, ledger.enter(mu, mu_v))
    else:
        fixed = wanted.mu_v, wanted.pa
        _plan(drawn, ledger, VELOCITIES, fixed, (segments.speed, speed), reach.velocities)
    for view, longest in reach.by_drive.items():
        ledger.of(view)
        if made.mechanism.moves:
            ledger.same(drawn.project.scale(view), mu, mu.letter, why=_TOGETHER)
        else:
            _plan(drawn, ledger, view, (None, None), ("", None), longest)
    if made.accelerations is None:
        return
    ledger.of(ACCELERATIONS)
    gain = pair.gain_known(ledger)
    fixed = wanted.mu_a, wanted.pi_a
    _plan(drawn, ledger, ACCELERATIONS, fixed, (segments.acceleration, gain), reach.accelerations)


def _plan(
    drawn: Drawn,
    ledger: Ledger,
    plan: str,
    fixed: tuple[float | None, float | None],
    of_pin: tuple[str, Mark | None],
    longest: float,
) -> None:
    """Record the choice for a plan of vectors: as the scene fixes it, or by the longest vector of the plan.

    ``of_pin``: the segment that shows the crank pin's vector, and that vector.
    """
    mu, (told, length), (letter, quantity) = drawn.project.scale(plan), fixed, of_pin
    if told:
        found = ledger.given(mu, told)
    elif length and quantity is not None:
        ledger.by_length(mu, quantity, letter, length)
        return
    else:
        kind, unit = _VECTOR_OF.get(plan, _VECTOR_OF[VELOCITIES])
        most = ledger.quantity(f"{kind}_{{max}}", longest, unit)
        because = _VECTORS.get(plan, _VECTORS[VELOCITIES])
        found = ledger.fitting(mu, most, value_of(drawn, mu), why=because)
    if quantity is not None:
        ledger.follows(letter, quantity, found)


CHOICE = Choice(choose=choose)
