"""μ of the three plans as a page chooses them anew, see `scales`."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Point
from graphic_tmm.chapters.kinematics.motion import Motion
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.scales import (
    ACCELERATION,
    CRANK,
    FEW,
    FLAT,
    LARGEST,
    MANY,
    OUTLYING,
    PLAN,
    RULING,
    acceleration_places,
)
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, POSITIONS, VELOCITIES
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.sizes import usual
from graphic_tmm.page.live.scales import LiveScale, LiveScales

LONGEST = (RULING, OUTLYING)
"""By which positions the longest vector is found."""


def free(drawn: Drawn) -> Iterator[LiveScale]:
    """Yield the plans whose μ the scene does not say; one that it tells by a length follows that."""
    made = KINEMATICS_PLAN.on(drawn)
    yield from _lengths(drawn)
    if made.velocities is not None:
        yield from _velocities(drawn, made.velocities)
    if made.accelerations is not None and not drawn.scene.scales.mu_a:
        yield _accelerations(drawn, made.accelerations)


def _lengths(drawn: Drawn) -> Iterator[LiveScale]:
    made, wanted, room = KINEMATICS_PLAN.on(drawn), drawn.scene.scales, drawn.sizes[POSITIONS]
    pair = made.pairs[0]
    ends = pair.arm_ends(made.positions)
    if wanted.OA and ends and not wanted.mu_l:
        yield LiveScale(made.mu_l, "segment", ends, _every(drawn), (wanted.OA,))
    elif not wanted.mu_l:
        crank = CRANK * usual(drawn.scene)[POSITIONS] / PLAN
        arm, ring = pair.sizes.length, float(made.ends is None)
        rooms = (room, LARGEST / PLAN * room, crank, arm, FLAT, ring)
        yield LiveScale(made.mu_l, "plan", _points(drawn, POSITIONS), _every(drawn), rooms, ends)


def _velocities(drawn: Drawn, plan: Motion) -> Iterator[LiveScale]:
    made, wanted, room = KINEMATICS_PLAN.on(drawn), drawn.scene.scales, drawn.sizes[VELOCITIES]
    mu, link, rooms = plan.mu, made.pairs[0].link, (room, *LONGEST)
    if wanted.mu_v_is_mu_l_omega:
        yield LiveScale(mu, "turning", by=(made.mu_l, plan.speeds[link]))
    elif wanted.pa:
        yield LiveScale(mu, "segment", plan.driven[link], _every(drawn), (wanted.pa,))
    elif not wanted.mu_v:
        yield LiveScale(mu, "vectors", _points(drawn, VELOCITIES), _every(drawn), rooms)
    for one in made.apart:
        if made.mechanism.moves:
            yield LiveScale(one.mu, "same", by=(mu,))
        else:
            points = _points(drawn, one.mu.view)
            yield LiveScale(one.mu, "vectors", points, _every(drawn), rooms)


def _accelerations(drawn: Drawn, plan: Motion) -> LiveScale:
    made, wanted = KINEMATICS_PLAN.on(drawn), drawn.scene.scales
    if wanted.pi_a:
        driven = made.pairs[0].driven
        of = plan.images.pole, plan.images.by_letter[driven.link][driven.pin]
        return LiveScale(plan.mu, "segment", of, _every(drawn), (wanted.pi_a,))
    many = MANY / ACCELERATION if len(made.accelerated) > FEW else 1.0
    at, room = acceleration_places(drawn.project), many * drawn.sizes[ACCELERATIONS]
    return LiveScale(plan.mu, "vectors", _points(drawn, ACCELERATIONS), at, (room, *LONGEST))


def _every(drawn: Drawn) -> tuple[int, ...]:
    return tuple(range(len(drawn.names)))


def _points(drawn: Drawn, view: str) -> list[Mark]:
    """Return the points of a view; what is drawn across positions goes through these, or is one of them."""
    steps = (step for step in drawn.construction.steps if step.it.view == view)
    return [step.it for step in steps if step.it.kind is Point and not step.op.across]


LIVE_SCALES = LiveScales(free)
