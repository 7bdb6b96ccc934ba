"""What is asked of an engine with several cylinders: how they stand, cranks, masses (SI, degrees)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

from graphic_tmm.board.bounds import POSITIVE, Bound
from graphic_tmm.language.said import said
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Flaw, Kind, Names, Said, Section, key
from graphic_tmm.scene.misfits import stands
from graphic_tmm.scene.tasks import SectionKey

if TYPE_CHECKING:
    from graphic_tmm.scene.sections import Parts

CYLINDERS = "cylinders"
IN_LINE, VEE, OPPOSED = "in line", "V", "opposed"
MOST = 12
ONE_PIN = 1e-6
"""Cranks no farther apart, degrees, are one pin."""


def _order(value: object, names: Names) -> tuple[int, ...]:
    whole = isinstance(value, list) and all(type(one) is int for one in value)
    if not isinstance(value, list) or not whole or sorted(value) != list(range(1, len(value) + 1)):
        remedy = said("write every cylinder once, in the order in which they fire, [1, 3, 4, 2]")
        raise ValueError(stands(value, remedy))
    return tuple(value)


_ORDER = Kind(_order, {"type": "array", "items": {"type": "integer", "minimum": 1}})


class Cylinder(NamedTuple):
    """A cylinder: the angle of its crank and of its axis, from the engine's (degrees); its place, m."""

    crank: float
    axis: float
    place: float


@dataclass(frozen=True)
class CylindersTask:
    """The inertia of an engine with ``count`` cylinders that are alike.

    ``layout``: in line; V with the ``angle`` between its banks, two rods on each pin; opposed, a crank for
    each. Left bank first: in a V pin k bears the cylinders k and k + count/2. ``cranks``: angles from the axis
    of the engine (degrees), counter-clockwise, of every pin; of the opposed, of every cylinder, or of those of
    the left bank, the others opposite them. ``firing`` in their stead: the order of even firing, over two
    turns, of two strokes over one. ``spacing``: from pin to pin, ``offset``: from the left bank to the right
    one, along the shaft (m). ``mass`` (kg) goes to and fro in each cylinder; ``crank``, ``rod``: lengths, m;
    ``speed``, 1/s.
    """

    count: int = key(v.number(Bound(1, MOST, whole=True)), "how many cylinders there are", 4)
    mass: float = key(
        v.quantity("mass", POSITIVE), "what goes to and fro in a cylinder", "0.8 kg", symbol="m"
    )
    crank: float = key(v.POSITIVE_LENGTH, "radius of the crank", "40 mm", symbol="r")
    rod: float = key(v.POSITIVE_LENGTH, "length of the connecting rod", "140 mm", symbol="l")
    speed: float = key(v.SPEED, "angular velocity of the crankshaft", "3000 rpm", symbol="ω_1")
    layout: str = key(
        v.choice(
            IN_LINE, VEE, OPPOSED,
            **{"рядный": IN_LINE, "V-образный": VEE, "оппозитный": OPPOSED},
        ),
        "how the cylinders stand",
        "V",
        IN_LINE,
    )  # fmt: skip
    angle: float = key(
        v.number(Bound(0, 180, above=True), "angle"), "between the banks of a V", "90 deg", 90.0,
        symbol="γ",
    )  # fmt: skip
    cranks: tuple[float, ...] = key(
        v.ANGLES,
        "angles of the cranks from the engine's axis, pin by pin; of opposed ones those of one bank will do",
        ["0 deg", "180 deg", "180 deg", "0 deg"],
        (),
    )
    firing: tuple[int, ...] = key(
        _ORDER, "or the order in which the cylinders fire, evenly", [1, 3, 4, 2], ()
    )
    strokes: int = key(
        v.number(Bound(2, 4, whole=True)), "strokes of a cycle: 4 or 2", 4, 4, symbol="τ"
    )
    spacing: float = key(
        v.quantity("length", Bound(0)), "from pin to pin along the shaft", "100 mm", 0.0, symbol="a"
    )
    offset: float = key(
        v.quantity("length", Bound(0)),
        "from the left bank to the right one along the shaft",
        "25 mm",
        0.0,
        symbol="b",
    )

    @property
    def banked(self) -> bool:
        """Whether there are two banks."""
        return self.layout != IN_LINE

    @property
    def pins(self) -> int:
        """How many crank pins stand one behind the other, opposed ones in pairs."""
        return self.count // 2 if self.banked else self.count

    @property
    def each(self) -> tuple[Cylinder, ...]:
        """The cylinders in order, left bank first."""
        half = {IN_LINE: 0.0, VEE: self.angle / 2, OPPOSED: 90.0}[self.layout]
        found = []
        for k in range(self.count):
            right = self.banked and k >= self.pins
            axis = -half if right else half
            along = (k % self.pins - (self.pins - 1) / 2) * self.spacing
            along += (self.offset / 2 if right else -self.offset / 2) if self.banked else 0.0
            found.append(Cylinder(self._crank(k, axis, right=right), axis, along))
        return tuple(found)

    @property
    def apart(self) -> tuple[tuple[int, int, float], ...]:
        """The pairs of a V, by number, whose cranks the firing keeps apart, each with its angle, degrees."""
        if self.layout != VEE:
            return ()
        cranks = [one.crank for one in self.each]
        pairs = ((k, k + self.pins) for k in range(self.pins))
        turns = ((k, n, abs(math.remainder(cranks[n] - cranks[k], 360.0))) for k, n in pairs)
        return tuple((k + 1, n + 1, turn) for k, n, turn in turns if turn > ONE_PIN)

    def _crank(self, k: int, axis: float, *, right: bool) -> float:
        if self.firing:
            turn = 180.0 * self.strokes / self.count * self.firing.index(k + 1)
            return (axis - turn) % 360.0
        if len(self.cranks) == self.count:
            return self.cranks[k]
        opposite = 180.0 if right and self.layout == OPPOSED else 0.0
        return self.cranks[k % self.pins] + opposite


ASKED: SectionKey[CylindersTask] = SectionKey(CYLINDERS)


def _check(asked: Said, parts: Parts) -> Iterator[Flaw]:
    banked = asked.layout != IN_LINE
    if banked and asked.count % 2:
        says = said("two banks have an even number of cylinders; change count, or layout")
        yield Flaw((CYLINDERS, "count"), says)
    if bool(asked.cranks) == bool(asked.firing):
        says = said(
            'write either cranks, the angles of the pins, ["0 deg", "180 deg"], or firing, the order'
        )
        yield Flaw((CYLINDERS,), says)
    elif asked.firing and len(asked.firing) != asked.count:
        says = said("{n} cylinders fire; write each of them once", n=asked.count)
        yield Flaw((CYLINDERS, "firing"), says)
    elif asked.cranks:
        pins = asked.count // 2 if banked else asked.count
        due = {pins} if asked.layout != OPPOSED else {pins, asked.count}
        if len(asked.cranks) not in due:
            says = said(
                "{n} angles are given, {due} are wanted: one for each pin",
                n=len(asked.cranks),
                due=pins,
            )
            yield Flaw((CYLINDERS, "cranks"), says)
    yield from _idle(asked, parts)
    if asked.strokes == 3:
        yield Flaw((CYLINDERS, "strokes"), said("a cycle has 4 strokes, or 2"))
    if not asked.rod > asked.crank:
        says = said("the rod is longer than its crank; change rod")
        yield Flaw((CYLINDERS, "rod"), says)
    if asked.count > (2 if banked else 1) and not asked.spacing > 0.0:
        says = said('the pins stand apart along the shaft; write spacing = "100 mm"')
        yield Flaw((CYLINDERS, "spacing"), says)


def _idle(asked: Said, parts: Parts) -> Iterator[Flaw]:
    """Refuse what says nothing of engines that stand so, or whose cranks are given."""
    told = parts.doc[CYLINDERS]
    if "angle" in told and asked.layout != VEE:
        says = said('only a V has an angle between its banks; write layout = "V", or leave it out')
        yield Flaw((CYLINDERS, "angle"), says)
    if "offset" in told and asked.layout == IN_LINE:
        says = said('only two banks are offset; write layout = "V" or "opposed", or leave it out')
        yield Flaw((CYLINDERS, "offset"), says)
    if "strokes" in told and asked.cranks:
        says = said("cranks that are given do not ask for strokes; leave it out, or write firing")
        yield Flaw((CYLINDERS, "strokes"), says)


SECTIONS = (
    Section(
        CYLINDERS, CylindersTask, "the inertia of an engine with several cylinders", alone=True,
        begin='count = 2, mass = "0.8 kg", crank = "40 mm", rod = "140 mm", speed = "3000 rpm", '
        'cranks = ["0 deg", "180 deg"], spacing = "100 mm"',
        check=_check,
    ),
)  # fmt: skip
