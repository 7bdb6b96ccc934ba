"""A plate on three legs on the plan of positions (class III), laid on the loci of its pins by tracing paper."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Mapping

from graphic_tmm.board.operations.tracing import prick, trace, trace_on_guide, trace_on_guides
from graphic_tmm.board.values import Angle, Arc
from graphic_tmm.chapters.kinematics import words as why
from graphic_tmm.chapters.kinematics.bodies import (
    Body,
    draw_points,
    off_axis,
    stand,
)
from graphic_tmm.chapters.kinematics.closings import (
    Branch,
    ClosingLeg,
    GuideLeg,
    PlateClosing,
)
from graphic_tmm.chapters.kinematics.dyads import Ground
from graphic_tmm.chapters.kinematics.tracings import PlateTracing, Tracing
from graphic_tmm.mechanism.groups import PlateGroup
from graphic_tmm.mechanism.records import Link

TRACINGS = (trace, trace_on_guide, trace_on_guides)
"""How a plate is laid, by how many of its legs slide along guides."""


Followed = Callable[[Tracing], Branch]
"""Which of its places a plate keeps at coordinates of the drive."""


def close_plate(
    ground: Ground, group: PlateGroup, links: Mapping[int, Link], follow: Followed
) -> PlateClosing:
    """Lay a plate on its three legs; draw these."""
    draft, link = ground.draft, links[group.plate]
    pins = tuple(pair.name for pair in group.inner)
    own = [link.points[pin] for pin in pins]
    along = own[1] - own[0]
    loci = [
        ground.swung(links[leg.link], leg, pin)[0]
        if leg.pair.kind == "R"
        else ground.path(leg, links[leg.link].points[pin], leg.pair.name)
        for leg, pin in zip(group.legs, pins, strict=True)
    ]
    axis = Body(link, own[0], math.degrees(cmath.phase(along)), lambda: root)
    apart, _ = off_axis(axis, own[1])
    x, y = off_axis(axis, own[2])
    branch = follow(PlateTracing(group, link, tuple(loci), axis.angle, apart, complex(x, y)))
    first, line = f"{group.legs[0].pair.name}{pins[0]}", "".join(pins[:2])
    near = draft.take(Angle, f"≈{first}", 0.0, "°"), draft.take(Angle, f"≈{line}", 0.0, "°")
    lengths = (
        draft.length(line, apart),
        draft.length(f"x_{{{pins[2]}}}", x),
        draft.length(f"y_{{{pins[2]}}}", y),
    )
    tracing = TRACINGS[sum(locus.kind is not Arc for locus in loci)]
    root = draft.draw(tracing, f"({line})", *loci, *lengths, *near, why=why.TRACING)
    stand(axis, pins[0], draft.draw(prick, pins[0], root, why=why.PRICKED), own[0])
    draw_points(draft, axis, pins[0])
    ground.bodies[group.plate] = axis
    points = [axis.marks[pin] for pin in pins]
    legs = list[ClosingLeg]()
    for leg, locus, pin, mark in zip(group.legs, loci, pins, points, strict=True):
        held = links[leg.link]
        if locus.kind is Arc:
            opening = draft.uses(locus)[1]
            legs.append(ground.pinned(held, leg, pin, mark, opening))
        else:
            ground.sliding(held, leg.pair, (pin, held.points[pin], mark), locus)
            legs.append(GuideLeg(leg.link, leg.body, locus, False, leg.body))
    return PlateClosing(
        group,
        root,
        (legs[0], legs[1], legs[2]),
        (pins[0], pins[1], pins[2]),
        (points[0], points[1], points[2]),
        near,
        branch,
    )
