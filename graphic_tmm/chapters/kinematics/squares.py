"""Two plates that two links join (class IV) on the plan of positions, laid by two sheets of tracing paper."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping

from graphic_tmm.board.operations.instruments import join, lay_off
from graphic_tmm.board.operations.joined import trace_joined
from graphic_tmm.board.operations.tracing import prick
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle
from graphic_tmm.chapters.kinematics import words as why
from graphic_tmm.chapters.kinematics.bodies import Body, draw_points, off_axis, stand
from graphic_tmm.chapters.kinematics.closings import PinLeg, SquareClosing
from graphic_tmm.chapters.kinematics.dyads import Ground
from graphic_tmm.chapters.kinematics.plates import Followed
from graphic_tmm.chapters.kinematics.tracings import SquareTracing
from graphic_tmm.mechanism.groups import Leg, SquareGroup, laid
from graphic_tmm.mechanism.records import Link


def close_square(
    ground: Ground, group: SquareGroup, links: Mapping[int, Link], follow: Followed
) -> SquareClosing:
    """Lay both plates about their pivots so that the links join them; draw these."""
    draft, told = ground.draft, laid(group, links)
    axes = list[Mark]()

    def drawn(k: int) -> Body:
        link, outer = links[group.legs[k].link], group.legs[k].pair.name
        arm = link.points[pins[k][0]] - link.points[outer]
        return Body(link, link.points[outer], math.degrees(cmath.phase(arm)), lambda: axes[k])

    # of each plate its pins on the first link and on the second
    pins = [tuple(pair[k].name for pair in group.inner) for k in (0, 1)]
    bodies = [drawn(k) for k in (0, 1)]
    pivots = [ground.pivot(leg) for leg in group.legs]
    own = [
        [complex(*off_axis(body, body.link.points[pin])) for pin in pins[k]]
        for k, body in enumerate(bodies)
    ]
    rods = [
        abs(links[number].points[second.name] - links[number].points[first.name])
        for number, (first, second) in zip(group.joining, group.inner, strict=True)
    ]
    last = group.plates.index(told)
    order = (1 - last, last)
    tracing = SquareTracing(
        group,
        links[told],
        (pivots[order[0]], pivots[order[1]]),
        bodies[last].angle,
        (*own[order[0]], *own[order[1]]),
        (rods[0], rods[1]),
    )
    branch = follow(tracing)
    lines = [f"{leg.pair.name}{pins[k][0]}" for k, leg in enumerate(group.legs)]
    angles = {k: draft.take(Angle, f"≈{lines[k]}", 0.0, "°") for k in order}
    sizes = [
        (
            draft.length(lines[k], own[k][0].real),
            draft.length(f"x_{{{pins[k][1]}}}", own[k][1].real),
            draft.length(f"y_{{{pins[k][1]}}}", own[k][1].imag),
        )
        for k in (0, 1)
    ]
    lengths = [
        draft.length(f"{first.name}{second.name}", rod)
        for (first, second), rod in zip(group.inner, rods, strict=True)
    ]
    letters = pins[0][0], pins[1][0]
    name, uses = "({}{})".format(*letters), (*pivots, *sizes[0], *sizes[1], *lengths)
    root = draft.draw(trace_joined, name, *uses, angles[0], angles[1])
    ends = (
        draft.draw(prick, letters[0], root, why=why.PRICKED_WITH_LINK),
        draft.draw(lay_off, letters[1], root, lengths[0], why=why.POINT),
    )
    legs = list[PinLeg]()
    for k, (leg, body) in enumerate(zip(group.legs, bodies, strict=True)):
        outer, pin, at = leg.pair.name, letters[k], pivots[k]
        axes.append(draft.draw(join, f"({lines[k]})", at, ends[k], why=why.LINK_AXIS))
        stand(body, outer, at, body.at)
        stand(body, pin, ends[k], body.link.points[pin])
        draw_points(draft, body, outer)
        ground.bodies[leg.link] = body
        legs.append(PinLeg(leg.link, leg.body, outer, at, axes[k], sizes[k][0]))
    joining = [
        ground.pinned(
            links[number],
            Leg(number, group.plates[0], first),
            second.name,
            bodies[1].marks[second.name],
            length,
            line,
        )
        for number, (first, second), length, line in zip(
            group.joining, group.inner, lengths, (root, None), strict=True
        )
    ]
    last_pin = pins[1][1]
    return SquareClosing(
        group,
        told,
        root,
        (legs[0], legs[1]),
        (joining[0], joining[1]),
        (*letters, letters[1], last_pin),
        (*ends, ends[1], bodies[1].marks[last_pin]),
        (angles[order[0]], angles[order[1]]),
        branch,
    )
