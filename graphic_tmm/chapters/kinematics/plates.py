"""A plate on three legs on the plan of positions (class III), laid on the loci of its pins by tracing paper."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Mapping
from typing import NamedTuple

from graphic_tmm.board.draft import ROUNDING
from graphic_tmm.board.operations.slots import trace_on_guide_past, trace_past, trace_past_both
from graphic_tmm.board.operations.tracing import prick, trace, trace_on_guide, trace_on_guides
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Arc, Line, Point
from graphic_tmm.chapters.kinematics import words as why
from graphic_tmm.chapters.kinematics.bodies import (
    Body,
    draw_points,
    incline_by,
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
from graphic_tmm.chapters.kinematics.tracings import Groove, PlateTracing, Tracing
from graphic_tmm.mechanism.groups import Leg, Pair, PlateGroup
from graphic_tmm.mechanism.guides import direction, level
from graphic_tmm.mechanism.records import Link

TRACINGS = {
    (Arc, Arc): trace,
    (Arc, Line): trace_on_guide,
    (Line, Line): trace_on_guides,
    (Arc, Point): trace_past,
    (Line, Point): trace_on_guide_past,
    (Point, Point): trace_past_both,
}
"""How a plate is laid, by what holds its second and its third leg: arcs, guides, pivots that its own pass."""


Followed = Callable[[Tracing], Branch]
"""Which of its places a plate keeps at coordinates of the drive."""


class _Held(NamedTuple):
    """A leg of a plate: its link, how that holds on to what is there, and its pair with the plate."""

    link: Link
    leg: Leg
    inner: Pair

    @property
    def slid(self) -> bool:
        """Whether it slides along the plate."""
        return self.inner.kind == "P"

    @property
    def pin(self) -> str:
        """The letter of its pin on the plate; of its pivot, where it slides along that."""
        return self.leg.pair.name if self.slid else self.inner.name

    def locus(self, ground: Ground) -> Mark:
        """Draw what its pin keeps to, an arc or a guide; return its pivot, where it slides along the plate."""
        if self.slid:
            return ground.pivot(self.leg)
        if self.leg.pair.kind == "R":
            return ground.swung(self.link, self.leg, self.pin)[0]
        return ground.path(self.leg, self.link.points[self.pin], self.leg.pair.name)

    def own(self, plate: Body) -> complex | Groove:
        """Return where its pin is from the beginning of the plate's line, m; or the guide of the plate."""
        if not self.slid:
            return complex(*off_axis(plate, plate.link.points[self.pin]))
        pivot = self.link.points[self.pin]
        height = level(self.inner, self.link.number, pivot) - level(
            self.inner, plate.link.number, plate.at
        )
        least = ROUNDING * max(abs(pivot), abs(plate.at), abs(height))
        bend = direction(self.inner, plate.link.number) - plate.angle
        return Groove(bend, 0.0 if abs(height) <= least else height)

    def stand(
        self, ground: Ground, plate: Body, own: complex | Groove, locus: Mark, mark: Mark
    ) -> ClosingLeg:
        """Enter its link, where the plate is laid; ``mark``: its pin, or its pivot."""
        leg, link = self.leg, self.link
        if isinstance(own, Groove):
            guide = incline_by(ground.draft, self.inner.name, mark, plate.axis, own.bend)
            ground.sliding(link, self.inner, (self.pin, link.points[self.pin], mark), guide)
            return GuideLeg(leg.link, leg.body, guide, True, plate.link.number)
        if locus.kind is Arc:
            opening = ground.draft.uses(locus)[1]
            return ground.pinned(link, leg, self.pin, mark, opening)
        ground.sliding(link, leg.pair, (self.pin, link.points[self.pin], mark), locus)
        return GuideLeg(leg.link, leg.body, locus, False, leg.body)


def close_plate(
    ground: Ground, group: PlateGroup, links: Mapping[int, Link], follow: Followed
) -> PlateClosing:
    """Lay a plate on its three legs; draw these."""
    draft, link = ground.draft, links[group.plate]
    held = [
        _Held(links[leg.link], leg, inner)
        for leg, inner in zip(group.legs, group.inner, strict=True)
    ]
    pins = tuple(one.pin for one in held)
    loci = [one.locus(ground) for one in held]
    _, second, third = held
    # the line of a plate is that of its first two pins, or goes along the guide of its second leg
    chord = [link.points[pin] for pin in pins[:2] if pin in link.points]
    way = (
        direction(second.inner, link.number)
        if second.slid
        else math.degrees(cmath.phase(chord[1] - chord[0]))
    )
    axis = Body(link, link.points[pins[0]], way, lambda: root)
    own = [one.own(axis) for one in held]
    branch = follow(PlateTracing(group, link, tuple(loci), way, (own[1], own[2])))
    arm = f"{group.legs[0].pair.name}{pins[0]}"
    line = second.inner.name if second.slid else "".join(pins[:2])
    near = draft.take(Angle, f"≈{arm}", 0.0, "°"), draft.take(Angle, f"≈{line}", 0.0, "°")
    sizes = [
        draft.length(f"h_{{{line}}}", own[1].height)
        if isinstance(own[1], Groove)
        else draft.length(line, own[1].real)
    ]
    if isinstance(own[2], Groove):
        sizes += [
            draft.length(f"h_{{{third.inner.name}}}", own[2].height),
            draft.direction(own[2].bend),
        ]
    else:
        sizes += [
            draft.length(f"x_{{{pins[2]}}}", own[2].real),
            draft.length(f"y_{{{pins[2]}}}", own[2].imag),
        ]
    tracing = TRACINGS[loci[1].kind, loci[2].kind]
    because = why.TRACING_PAST if third.slid else why.TRACING
    root = draft.draw(tracing, f"({line})", *loci, *sizes, *near, why=because)
    stand(axis, pins[0], draft.draw(prick, pins[0], root, why=why.PRICKED), axis.at)
    draw_points(draft, axis, pins[0])
    ground.bodies[group.plate] = axis
    points = [
        locus if one.slid else axis.marks[one.pin] for one, locus in zip(held, loci, strict=True)
    ]
    legs = [
        one.stand(ground, axis, of, locus, mark)
        for one, of, locus, mark in zip(held, own, loci, points, strict=True)
    ]
    return PlateClosing(
        group,
        root,
        (legs[0], legs[1], legs[2]),
        (pins[0], pins[1], pins[2]),
        (points[0], points[1], points[2]),
        line,
        near,
        branch,
    )
