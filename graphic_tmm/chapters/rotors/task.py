"""What is asked of a rotor: its unbalances, the planes of its counterweights, its bearings (SI, degrees)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from graphic_tmm.board.bounds import POSITIVE, Bound
from graphic_tmm.language.said import Said as Sentence
from graphic_tmm.language.said import said
from graphic_tmm.scene import quantities
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Flaw, Kind, Names, Said, Section, key
from graphic_tmm.scene.misfits import fault_in_list, stands
from graphic_tmm.scene.tasks import SectionKey
from graphic_tmm.scene.units import Dimension

if TYPE_CHECKING:
    from graphic_tmm.scene.sections import Parts

ROTOR = "rotor"
UNBALANCE = "unbalance"
MOST = 12
"""So many unbalances are drawn at most: a polygon of more sides nobody reads."""
APART = 1e-6
"""Planes that are no farther apart coincide, m."""


def _row(dimension: Dimension, remedy: Sentence, *, positive: bool) -> Kind:
    """Return the kind of one quantity, or of a list of two."""

    def read(value: object, names: Names) -> tuple[float, ...]:
        items = value if isinstance(value, list) else [value]
        if len(items) > 2:
            raise ValueError(stands(value, remedy))
        found = tuple(quantities.parse(item, dimension) for item in items)
        for item, one in zip(items, found, strict=True):
            if positive and not one > 0.0:
                raise ValueError(fault_in_list(item, remedy))
        return found

    told = v.quantity_schema(dimension)
    several = {"type": "array", "items": told, "maxItems": 2}
    return Kind(read, {"anyOf": [*told["anyOf"], several]}, each=dimension)


_PLANES = _row("length", said('one plane or two are wanted, ["0 mm", "300 mm"]'), positive=False)
_BEARINGS = _row("length", said('both bearings are wanted, ["0 mm", "300 mm"]'), positive=False)
_RADII = _row(
    "length", said('a radius is wanted, or one for each plane, ["60 mm", "80 mm"]'), positive=True
)
_MASSES = _row(
    "mass", said('a mass is wanted, or one for each plane, ["0.5 kg", "0.8 kg"]'), positive=True
)
_SCALE = v.number(Bound(1e-12, 1e9))


@dataclass(frozen=True)
class Unbalance:
    """A mass that stands off the axis of its rotor.

    ``angle``: where, seen along the axis (degrees); ``mass`` (kg) at a ``radius`` (m), or both as their product
    ``D`` (kg·m). ``at``: its place along the axis, m; None where nobody asks.
    """

    angle: float = key(v.ANGLE, "where it stands, seen along the axis", "30 deg")
    mass: float | None = key(v.quantity("mass", POSITIVE), "the mass", "2 kg", None)
    radius: float | None = key(
        v.POSITIVE_LENGTH, "how far its centre is from the axis", "40 mm", None
    )
    D: float | None = key(
        v.quantity("unbalance", POSITIVE),
        "or both as one product, mass times radius",
        "250 g*mm",
        None,
    )
    at: float | None = key(v.PLAIN_LENGTH, "its place along the axis", "100 mm", None)


@dataclass(frozen=True)
class RotorTask:
    """A rotor that is balanced by counterweights.

    ``planes``: in which they stand, from left to right (m along the axis): two for balance in motion; one, or
    none where the rotor is thin, for balance at rest. ``radius`` (m) or ``mass`` (kg): of the counterweight, of
    each of two; the other of both is sought. ``speed`` (1/s) and ``bearings`` (m along the axis) ask for the
    reactions of the bearings before there are counterweights. ``mu_D`` (kg·m/mm), ``mu_M`` (kg·m²/mm): scales
    of the polygons.
    """

    planes: tuple[float, ...] = key(
        _PLANES,
        "the planes of both counterweights, from left to right; of one alone that is balanced at rest",
        ["0 mm", "300 mm"],
        (),
    )
    radius: tuple[float, ...] = key(
        _RADII, "the radius of the counterweight, or of each", "60 mm", ()
    )
    mass: tuple[float, ...] = key(
        _MASSES, "or its mass, if the radius is sought", ["0.5 kg", "0.8 kg"], ()
    )
    speed: float | None = key(v.SPEED, "angular velocity of the rotor", "1500 rpm", None)
    bearings: tuple[float, ...] = key(
        _BEARINGS,
        "places of both bearings along the axis, if their reactions are wanted",
        ["-50 mm", "350 mm"],
        (),
    )
    mu_D: float | None = key(
        _SCALE, "unbalance that 1 mm of the polygon stands for, kg·m/mm", 0.001, None
    )
    mu_M: float | None = key(
        _SCALE, "moment of unbalances that 1 mm stands for, kg·m²/mm", 0.0005, None
    )
    unbalances: tuple[Unbalance, ...] = ()

    @property
    def dynamic(self) -> bool:
        """Whether there are two planes."""
        return len(self.planes) > 1


ASKED: SectionKey[RotorTask] = SectionKey(ROTOR)


def _check(asked: Said, parts: Parts) -> Iterator[Flaw]:
    if UNBALANCE not in parts.doc:
        says = said(
            "nothing is out of balance; write [[unbalance]] with mass, radius and angle, once for each"
        )
        yield Flaw((ROTOR,), says)
    if asked.mass and asked.radius:
        says = said("radius and mass are both given; leave the one out that is sought")
        yield Flaw((ROTOR, "mass"), says)
    elif not (asked.mass or asked.radius):
        says = said('neither radius nor mass of a counterweight is given; write radius = "60 mm"')
        yield Flaw((ROTOR,), says)
    count = max(1, len(asked.planes))
    for name in ("mass", "radius"):
        if len(getattr(asked, name)) > count:
            says = said("there is one plane for counterweights; write one value, or two planes")
            yield Flaw((ROTOR, name), says)
    yield from _places(asked)


def _places(asked: Said) -> Iterator[Flaw]:
    """What is wrong with the places of planes and bearings along the axis."""
    if len(asked.planes) > 1 and not asked.planes[1] - asked.planes[0] > APART:
        says = (
            said(
                "both planes coincide: no pair of forces in them is a couple; move one of them, or give one "
                "plane alone, for balance at rest"
            )
            if abs(asked.planes[1] - asked.planes[0]) <= APART
            else said("the planes stand from left to right; put the smaller place first")
        )
        yield Flaw((ROTOR, "planes"), says)
    if not asked.bearings:
        return
    if len(asked.bearings) < 2:
        says = said('both bearings are wanted, ["0 mm", "300 mm"]')
        yield Flaw((ROTOR, "bearings"), says)
    elif not asked.bearings[1] - asked.bearings[0] > APART:
        says = said(
            "the bearings stand apart, from left to right; put the smaller place first, or move one of them"
        )
        yield Flaw((ROTOR, "bearings"), says)
    if asked.speed is None:
        says = said(
            'the reactions of bearings want the speed of the rotor; write speed = "1500 rpm"'
        )
        yield Flaw((ROTOR, "speed"), says)


def _check_unbalances(
    all_of_them: list[tuple[tuple[str, int], Said]], parts: Parts
) -> Iterator[Flaw]:
    asked = parts.said.get(ROTOR)
    along = asked is not None and (len(asked.planes) > 1 or bool(asked.bearings))
    for path, _ in all_of_them[MOST:]:
        says = said(
            "no more than {most} unbalances are drawn; put those of one plane together", most=MOST
        )
        yield Flaw(path, says)
    for path, one in all_of_them:
        whole = one.mass is not None and one.radius is not None
        some = one.mass is not None or one.radius is not None
        if (one.D is None and not whole) or (one.D is not None and some):
            yield Flaw(path, said("write mass and radius, or D alone, their product"))
        if along and one.at is None:
            says = said('its place along the axis is wanted; write at = "100 mm"')
            yield Flaw((*path, "at"), says)


def _idle(asked: object, parts: Parts) -> Iterator[str]:
    if ROTOR not in parts.doc:
        yield said("unbalance: nothing asks for it; add [rotor], or take [[unbalance]] out")


SECTIONS = (
    Section(
        ROTOR, RotorTask, "a rotor that is balanced by counterweights", alone=True,
        begin='radius = "60 mm"', check=_check,
        joined=lambda others: {"unbalances": others[UNBALANCE] or ()},
    ),
    Section(
        UNBALANCE, Unbalance, "masses of a rotor off its axis", several=True, alone=True, gives=True,
        check=_check_unbalances, idle=_idle,
    ),
)  # fmt: skip
