"""Wheels on links on the plan of positions: the pitch point on the line of centres, the angle of the wheel.

A wheel's angle goes on from turn to turn, so those of the links that it rolls by are counted without a leap,
too: that of a crank is given, those of others are read next to one which goes round as they do (`Winding`).
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator
from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import angle_by_angle, to_board, total
from graphic_tmm.board.operations.instruments import (
    join,
    lay_off,
    measure,
    parallel,
    ray,
    square,
    tangent,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Side
from graphic_tmm.chapters.kinematics.bodies import (
    Body,
    Meshed,
    Positions,
    anchor,
    draw_points,
    stand,
)
from graphic_tmm.chapters.kinematics.closings import AnyClosing, PinLeg, groups_of
from graphic_tmm.chapters.kinematics.drives.crank import Crank
from graphic_tmm.chapters.kinematics.drives.pair import DrivenPair
from graphic_tmm.chapters.kinematics.drives.rack import Rack
from graphic_tmm.chapters.kinematics.formulas import (
    bearing_near,
    excess,
    external_radius,
    external_ratio,
    internal_radius,
    internal_ratio,
    near_while_tried,
    rolled_between,
    rolled_by,
    rolled_round,
    start_by_axes,
)
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.mechanism.wheels import Rolling, in_order, size_names

CENTRES = said(
    "Both centres stand on one rigid link; the pitch circles touch on the line that joins them."
)
OUTWARDS = said("The smaller wheel lies inside: the pitch circles touch behind its centre.")
PITCH_POINT = said(
    "The pitch circles touch here, as far from the centre as the pitch radius is long."
)
RUN = said(
    "A straight run of the belt or chain is square to the radii at its ends, so it is parallel to this "
    "tangent: to the circle about {centre} whose radius is what the radii differ by, of a crossed belt their "
    "sum."
)
RUN_RADIUS = said("The radius at which the pulling run leaves the wheel is square to it.")
OTHER_RADIUS = said(
    "On the other wheel it is parallel to that, of a crossed belt it points the other way."
)
RUN_END = said("The pulling run of the belt or chain leaves the wheel here.")
BELT = said(
    "Seen from the link that joins the centres both rims are as fast as the belt or chain, so the angles are "
    "as the radii the other way round; an open belt or a chain keeps the sense of turning, a crossed belt "
    "turns it."
)
WHEEL_AXIS = said(
    "The wheel's link turns about {start}; its angle is the one by which the wheel has rolled."
)


class Winding(NamedTuple):
    """How a link's angle goes on: near ``middle`` (degrees) and so many ``times`` what it is counted by.

    ``by``: of `Wheels.counted`. ``within``: so far from 0 the drive's coordinate may be, degrees; 0: anywhere.
    """

    times: float
    middle: float
    by: int = 0
    within: float = 0.0


Wound = Callable[[int, "Wheels"], Winding]
"""How the angle of a link goes on, by its number; the positions drawn so far tell where nothing else does."""


class Wheels:
    """The wheels of a mechanism while its plan of positions is drawn.

    ``angles``: of links whose angle is known by itself, each with the direction in own axes that it is of.
    ``closings``, ``sides``: of the groups drawn so far.
    """

    def __init__(
        self, draft: Draft, mechanism: Mechanism, bodies: dict[int, Body], wound: Wound | None
    ) -> None:
        self.draft = draft
        self.mechanism = mechanism
        self.bodies = bodies
        self.wound = wound
        self.angles: dict[int, tuple[Mark, float]] = {}
        self.senses: dict[int, int] = {}
        self.drawn: list[Meshed] = []
        self.closings: list[AnyClosing] = []
        self.sides: dict[str, Mark] = {}
        self.row: list[Mark] = []
        self.pairs: list[DrivenPair] = []

    @property
    def positions(self) -> Positions:
        """The plan of positions as far as it is drawn."""
        drawn, row = tuple(self.drawn), tuple(self.row)
        return Positions(self.bodies, tuple(self.closings), self.sides, row, (), drawn)

    @property
    def counted(self) -> tuple[Mark, ...]:
        """The angles that go on without a leap: of what is driven, of the wheels drawn so far."""
        angles = (*self.row, *(one.angle for one in self.drawn))
        return tuple(mark for mark in angles if mark.kind is Angle)

    def drive(self, pair: DrivenPair, at: Mark) -> None:
        """Note where a drive stands."""
        self.row.append(at)
        self.pairs.append(pair)
        if isinstance(pair, Crank) and not isinstance(pair, Rack):
            self.angles[pair.link] = at, self.bodies[pair.link].angle
            self.senses[pair.link] = pair.drive.sense

    def stand(self, rolling: Rolling) -> None:
        """Draw a wheel's pitch point, and its link at the angle to which it has rolled."""
        draft, arm = self.draft, self.bodies[rolling.arm]
        link = self.mechanism.by_number[rolling.link]
        centre, other = arm.marks[rolling.pin], arm.marks[rolling.other]
        sizes = self._sizes(rolling)
        draw = self._run if rolling.mesh.belted else self._pitch
        leg, pitch, span = draw(rolling, centre, other, sizes)
        own = link.points[rolling.pin]
        ends = [(letter, z) for letter, z in link.points.items() if letter != rolling.pin]
        bend = math.degrees(cmath.phase(ends[0][1] - own)) if ends else 0.0
        angle = self._angle(rolling, bend, sizes)
        told = f"({rolling.pin}{ends[0][0]})" if ends else f"({link.number})"
        axis = draft.draw(ray, told, centre, angle, why=WHEEL_AXIS)
        body = self.bodies[link.number] = Body(link, own, bend, lambda: axis)
        stand(body, rolling.pin, centre, own)
        draw_points(draft, body, anchor(body))
        drawn = Meshed(rolling, leg, pitch, angle, span)
        for number, at, end in ((rolling.link, centre, pitch), (rolling.on, other, drawn.far)):
            draft.figure("wheel", str(number), at, end)
        if span:
            draft.figure(rolling.mesh.by, str(rolling.link), centre, other, pitch, span.pivot)
        self.angles[link.number] = angle, bend
        self.drawn.append(drawn)

    def _pitch(
        self, rolling: Rolling, centre: Mark, other: Mark, sizes: list[Mark]
    ) -> tuple[PinLeg, Mark, None]:
        """Draw the pitch point on the line of centres; return it, and the leg to it from the wheel's centre."""
        draft, inside = self.draft, rolling.reach < 0.0
        name = f"({rolling.pin}{rolling.letter})"
        lines = [leg.line for closing in self.closings for leg in closing.legs]
        line = next((one for one in lines if draft.uses(one) == (centre, other)), None)
        if line is None:
            line = draft.draw(join, f"({rolling.pin}{rolling.other})", centre, other, why=CENTRES)
        if inside:
            line = draft.draw(parallel, name, centre, line, sense=-1, why=OUTWARDS)
        apart = draft.draw(measure, f"{rolling.pin}{rolling.other}", centre, other)
        share = internal_radius if rolling.mesh.internal else external_radius
        radius = draft.draw(share, f"{rolling.pin}{rolling.letter}", apart, *sizes)
        pitch = draft.draw(lay_off, rolling.letter, line, radius, why=PITCH_POINT)
        leg = PinLeg(rolling.link, rolling.body, rolling.pin, centre, line, radius)
        return leg, pitch, None

    def _run(
        self, rolling: Rolling, centre: Mark, other: Mark, sizes: list[Mark]
    ) -> tuple[PinLeg, Mark, PinLeg]:
        """Draw the run of a belt that pulls the wheel; return its end there, the leg to that, and the run."""
        draft, alike = self.draft, rolling.mesh.alike
        (own, end), (base, far) = (rolling.pin, rolling.letter), (rolling.other, rolling.far)
        names = f"{base}{far}", f"{own}{end}"
        away, radius = (draft.draw(to_board, *one) for one in zip(names, sizes, strict=True))
        apart = draft.draw(excess if alike else total, f"r_{{{far}{end}}}", radius, away)
        side = draft.take(Side, f"±{far}{end}", -float(self._sense(rolling)))
        along = draft.draw(tangent, f"({base})", other, centre, apart, side, why=RUN)
        line = draft.draw(square, f"({own}{end})", centre, along, sense=1, why=RUN_RADIUS)
        pitch = draft.draw(lay_off, end, line, radius, why=RUN_END)
        out = draft.draw(
            parallel, f"({base}{far})", other, line, sense=1 if alike else -1, why=OTHER_RADIUS
        )
        start = draft.draw(lay_off, far, out, away, why=RUN_END)
        run = draft.draw(join, f"({far}{end})", start, pitch)
        length = draft.draw(measure, f"{far}{end}", start, pitch)
        leg = PinLeg(rolling.link, rolling.body, own, centre, line, radius)
        return leg, pitch, PinLeg(rolling.span, rolling.on, far, start, run, length)

    def _sense(self, rolling: Rolling) -> int:
        """Return which way a wheel turns, seen from what joins the centres; 1 if nothing tells beforehand."""
        frame, senses = self.mechanism.frame.number, self.senses
        own = int(math.copysign(1.0, rolling.ratio))
        if rolling.arm == frame:
            own *= senses.get(rolling.on, 1)
            senses[rolling.link] = own
        elif rolling.on == frame:
            own *= -senses.get(rolling.arm, 1)
        return own

    def _angle(self, rolling: Rolling, bend: float, sizes: list[Mark]) -> Mark:
        """Calculate the angle of a wheel's link; ``bend``: of the direction in own axes that it is of."""
        draft, number = self.draft, rolling.link
        arm, on = self._known(rolling.arm), self._known(rolling.on)
        start = draft.angle(f"φ_{{{number}0}}", rolling.start + bend)
        op = internal_ratio if rolling.mesh.alike else external_ratio
        why = BELT if rolling.mesh.belted else ""
        share = draft.draw(op, f"u_{{{number}{rolling.on}}}", *sizes, why=why)
        bends = [one[1] if one else 0.0 for one in (arm, on)]
        if any(bends):
            axes = [
                draft.angle(f"β_{k}", one) if one else draft.direction(0.0)
                for k, one in zip((rolling.arm, rolling.on), bends, strict=True)
            ]
            start = draft.draw(start_by_axes, f"φ′_{{{number}0}}", start, share, *axes, unit="°")
        if arm is None and on is not None:
            uses, op = (start, share, on[0]), rolled_by
        elif arm is not None and on is None:
            uses, op = (start, arm[0], share), rolled_round
        else:
            assert arm is not None
            assert on is not None
            return draft.draw(rolled_between, f"φ_{number}", start, arm[0], share, on[0], unit="°")
        return draft.draw(op, f"φ_{number}", *uses, unit="°")

    def _sizes(self, rolling: Rolling) -> list[Mark]:
        """Take the teeth, or pitch radii, of the other wheel and of this one."""
        draft, mesh = self.draft, rolling.mesh
        names, unit = size_names(self.mechanism, mesh), "" if mesh.toothed else "m"
        sizes = [draft.constant(*one, unit) for one in zip(names, mesh.sizes, strict=True)]
        return sizes if mesh.links[1] == rolling.link else sizes[::-1]

    def _known(self, number: int) -> tuple[Mark, float] | None:
        """Return the angle of a link, and of which direction in its own axes; None of the frame."""
        if number == self.mechanism.frame.number:
            return None
        if number not in self.angles:
            self.angles[number] = self._read(number), self.bodies[number].angle
        return self.angles[number]

    def _read(self, number: int) -> Mark:
        draft, axis = self.draft, self.bodies[number].axis
        assert self.wound is not None, number
        times, middle, by, within = self.wound(number, self)
        near = draft.direction(middle)
        if times:
            zero, share = draft.direction(0.0), draft.constant("", times, "")
            near = draft.draw(
                angle_by_angle, f"φ′_{number}", near, share, self.counted[by], zero, unit="°"
            )
        if within:
            most = draft.angle(f"φ_{{{number}max}}", within)
            near = draft.draw(near_while_tried, f"φ″_{number}", near, self.row[0], most, unit="°")
        return draft.draw(bearing_near, f"φ_{number}", axis, near, unit="°")


def attached(positions: Positions, room: str) -> Iterator[AnyClosing | Meshed]:
    """Yield groups of all classes and wheels in the order of attachment."""
    groups, wheels = tuple(groups_of(positions.closings, room)), positions.wheels
    return in_order(groups, wheels, [one.rolling.after for one in wheels])
