"""μ of forces as a page chooses them anew, see `scales`."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.board.values import Point
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.scales import (
    ALIKE,
    GROUP,
    LARGER,
    LINK_1,
    LONGER,
    READABLE,
    SHORT,
    polygon_scales,
)
from graphic_tmm.chapters.forces.task import FORCES
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.page.live.scales import LiveScale, LiveScales


def free(drawn: Drawn) -> Iterator[LiveScale]:
    """Yield what is detached, polygons unless the scene says their μ, and how much larger levers are."""
    made, known, plans = FORCES_PLAN.on(drawn), drawn.reach[FORCES], KINEMATICS_PLAN.on(drawn)
    at, room, turned = made.places, drawn.sizes["groups"], plans.mu_l
    # link 1 hangs on the last of the groups
    for figure in sorted(made.figures, key=lambda one: len(one.of.links) == 1):
        points, group = list(figure.points.values()), len(figure.of.links) > 1
        if not known.detached[figure.view]:
            yield LiveScale(figure.mu, "same", by=(plans.mu_l,))
        elif group:
            turned = figure.mu
            yield LiveScale(figure.mu, "group", points, at, (room, LONGER * room), (plans.mu_l,))
        else:
            rooms = (LINK_1 * room, SHORT * min(room / GROUP, 1.0))
            yield LiveScale(figure.mu, "link", points, at, rooms, (plans.mu_l, turned))
    high, steps = drawn.sizes["forces"], drawn.construction.steps
    for mu in polygon_scales(drawn.project):
        if not made.order.mu and known.polygons[mu.view]:
            points = [one.it for one in steps if one.it.view == mu.view and one.it.kind is Point]
            rooms = (high, max(min(ALIKE, high / READABLE), 1.0))
            yield LiveScale(mu, "polygon", points, at, rooms)
    for one in made.balanced:
        images = [*dict.fromkeys(mark for own in one.lever.images.values() for mark in own)]
        of = plans.plan_of(one.driven.pair.link).mu
        yield LiveScale(one.lever.times, "lever", images, at, (drawn.sizes["lever"], LARGER), (of,))


LIVE_SCALES = LiveScales(free)
