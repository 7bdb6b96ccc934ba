"""Two plates that two links join (class IV) on the plan of positions, laid by two sheets of tracing paper."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping

from graphic_tmm.board.operations.tracing import trace_joined
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle
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
    roots = list[Mark]()

    def drawn(k: int) -> Body:
        link, outer = links[group.legs[k].link], group.legs[k].pair.name
        arm = link.points[pins[k][0]] - link.points[outer]
        return Body(link, link.points[outer], math.degrees(cmath.phase(arm)), lambda: roots[k])

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
    for k in (0, 1):
        uses = (pivots[1 - k], pivots[k], *sizes[1 - k], *sizes[k])
        near = angles[1 - k], angles[k]
        roots.append(draft.draw(trace_joined, f"({lines[k]})", *uses, *lengths, *near))
    for leg, body, pivot in zip(group.legs, bodies, pivots, strict=True):
        stand(body, leg.pair.name, pivot, body.at)
        draw_points(draft, body, leg.pair.name)
        ground.bodies[leg.link] = body
    legs = [
        PinLeg(leg.link, leg.body, leg.pair.name, pivots[k], roots[k], sizes[k][0])
        for k, leg in enumerate(group.legs)
    ]
    joining = list[PinLeg]()
    for number, (first, second), length in zip(group.joining, group.inner, lengths, strict=True):
        leg, end = Leg(number, group.plates[0], first), bodies[1].marks[second.name]
        joining.append(ground.pinned(links[number], leg, second.name, end, length))
    letters = pins[0][0], pins[1][0], pins[1][0], pins[1][1]
    marks = [bodies[k].marks[letter] for k, letter in zip((0, 1, 1, 1), letters, strict=True)]
    return SquareClosing(
        group,
        told,
        roots[last],
        (legs[0], legs[1]),
        (joining[0], joining[1]),
        letters,
        (marks[0], marks[1], marks[2], marks[3]),
        (angles[order[0]], angles[order[1]]),
        branch,
    )
