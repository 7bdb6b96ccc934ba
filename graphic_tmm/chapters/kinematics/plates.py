"""A plate on three legs on the plan of positions (class III), laid on the loci of its pins by tracing paper."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Mapping
from typing import NamedTuple

from graphic_tmm.board.draft import ROUNDING, Draft
from graphic_tmm.board.operations.on_slides import (
    lay_on_guide_past,
    lay_on_guides,
    lay_on_guides_past,
    lay_past_all,
)
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
    ClosingLeg,
    GuideLeg,
    PlateClosing,
)
from graphic_tmm.chapters.kinematics.dyads import Ground
from graphic_tmm.chapters.kinematics.tracings import (
    Branch,
    Groove,
    PlateTracing,
    SlidesTracing,
    Tracing,
)
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.groups import Leg, Pair, PlateGroup
from graphic_tmm.mechanism.guides import direction, level
from graphic_tmm.mechanism.records import Link

TRACINGS = {
    (Arc, Arc, Arc): trace,
    (Arc, Arc, Line): trace_on_guide,
    (Arc, Line, Line): trace_on_guides,
    (Arc, Arc, Point): trace_past,
    (Arc, Line, Point): trace_on_guide_past,
    (Arc, Point, Point): trace_past_both,
    (Line, Line, Line): lay_on_guides,
    (Line, Line, Point): lay_on_guides_past,
    (Line, Point, Point): lay_on_guide_past,
    (Point, Point, Point): lay_past_all,
}
"""How a plate is laid, by what holds its legs: arcs, guides, pivots that its own pass."""


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

    def own_pin(self, plate: Link) -> str:
        """Return the letter of its pin on the plate, or where it slides along that of any point there.

        Raises
        ------
        StructureError
            If the plate has no point.
        """
        if not self.slid:
            return self.pin
        if not plate.points:
            raise StructureError(
                said(
                    "link {plate} has guides alone: give it a point, from which they are laid out",
                    plate=plate.number,
                ),
                f"link {plate.number}, points",
            )
        return next(iter(plate.points))

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
    first, second, third = held
    start = first.own_pin(link)
    # the line of a plate is that of its first two pins, or goes along the guide of its second leg
    chord = [link.points[pin] for pin in pins[:2] if pin in link.points]
    way = (
        direction(second.inner, link.number)
        if second.slid
        else math.degrees(cmath.phase(chord[1] - chord[0]))
    )
    axis = Body(link, link.points[start], way, lambda: root)
    own = [one.own(axis) for one in held]
    line = second.inner.name if second.slid else "".join(pins[:2])
    turns = loci[0].kind is Arc
    lain = (f"{first.leg.pair.name}{pins[0]}", line) if turns else (line,)
    near = [draft.take(Angle, f"≈{letters}", 0.0, "°") for letters in lain]
    laid: Tracing = SlidesTracing(group, link, tuple(loci), way, tuple(own))
    if turns:
        laid = PlateTracing(group, link, tuple(loci), way, (own[1], own[2]))
    branch = follow(laid)
    sizes = [
        draft.length(f"h_{{{line}}}", own[1].height)
        if isinstance(own[1], Groove)
        else draft.length(line, own[1].real)
    ]
    if isinstance(own[2], Groove):
        sizes += _sizes(draft, third, own[2])
    else:
        sizes += [
            draft.length(f"x_{{{pins[2]}}}", own[2].real),
            draft.length(f"y_{{{pins[2]}}}", own[2].imag),
        ]
    if isinstance(own[0], Groove):
        sizes += _sizes(draft, first, own[0])
    tracing = TRACINGS[loci[0].kind, loci[1].kind, loci[2].kind]
    because = why.TRACING_PAST if third.slid else why.TRACING
    root = draft.draw(tracing, f"({line})", *loci, *sizes, *near, why=because)
    stand(axis, start, draft.draw(prick, start, root, why=why.PRICKED), axis.at)
    draw_points(draft, axis, start)
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
        (near[0], near[-1]),
        branch,
    )


def _sizes(draft: Draft, held: _Held, own: Groove) -> list[Mark]:
    """Enter how far a guide of the plate is off its first point, and at which angle to the plate's line."""
    height = draft.length(f"h_{{{held.inner.name}}}", own.height)
    return [height, draft.direction(own.bend)]
