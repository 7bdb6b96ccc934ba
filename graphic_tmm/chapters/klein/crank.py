"""The slider-crank on which the constructions stand: which of a mechanism's, and whether it is one."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from graphic_tmm.board.draft import ROUNDING
from graphic_tmm.chapters.kinematics.closings import (
    Closing,
    GuideLeg,
    PinLeg,
    dyads,
    pair_of,
)
from graphic_tmm.chapters.kinematics.drives.crank import Crank
from graphic_tmm.chapters.kinematics.drives.rack import Rack
from graphic_tmm.chapters.kinematics.plan import KinematicPlans
from graphic_tmm.chapters.klein.task import KLEIN, KleinTask
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import Said, said
from graphic_tmm.mechanism.guides import level


class SliderCrank(NamedTuple):
    """A crank that turns, a rod on it, a slider on the frame; letters of its pivot, pin and slider.

    ``arm``: from pivot to pin in the crank's own axes; ``length``: of the rod, ``offset``: of the guide, which
    passes the pivot on its left (m). ``points``: of the rod, from the pin along it and to its left (m).
    """

    driven: Crank
    rod: PinLeg
    guide: GuideLeg
    pivot: str
    pin: str
    slider: str
    arm: complex
    length: float
    offset: float
    points: dict[str, complex]

    @property
    def crank(self) -> float:
        """The length of the crank, m."""
        return abs(self.arm)

    @property
    def in_line(self) -> bool:
        """Whether the guide goes through the crank's pivot."""
        return abs(self.offset) <= ROUNDING * (self.crank + self.length)


class _Parts(NamedTuple):
    """A group, its rod and its guide; the letter of the crank's pin."""

    closing: Closing
    rod: PinLeg
    guide: GuideLeg
    pin: str


def slider_crank(plans: KinematicPlans, order: KleinTask) -> SliderCrank:
    """Return the slider-crank that is asked for.

    Raises
    ------
    StructureError
        If it is none, if its crank is not driven or stands, or a point is none of its rod.
    """
    crank = _driven_crank(plans)
    there = dict(_there(plans, crank))
    if not there:
        says = said(
            "no rod joins the crank to a slider on the frame, and it is drawn of a slider-crank alone: leave "
            "[klein] out"
        )
        raise StructureError(says, KLEIN, head=KLEIN)
    letter = order.slider or next(iter(there))
    if letter not in there:
        says = said(
            "point {letter} is not the slider of a slider-crank; points that are: {known}",
            letter=letter, known=", ".join(there),
        )  # fmt: skip
        raise StructureError(says, f"{KLEIN}.slider", head=KLEIN)
    closing, rod, guide, pin = there[letter]
    mechanism = plans.mechanism
    own, driven = mechanism.by_number[rod.link].points, mechanism.by_number[crank.link].points
    way, free = own[letter] - own[pin], [k for k in own if k not in (pin, letter)]
    for point in order.points:
        if point not in free:
            says = said(
                "point {letter} is no further point of the rod {rod}; it has {known}",
                letter=point, rod=f"{pin}{letter}", known=", ".join(free) or "—",
            )  # fmt: skip
            raise StructureError(says, f"{KLEIN}.points", head=KLEIN)
    points = {
        k: _settled((own[k] - own[pin]) * way.conjugate() / abs(way), abs(way))
        for k in order.points
    }
    pair = pair_of(closing, guide)
    slider, frame = mechanism.by_number[guide.link], mechanism.frame
    offset = level(pair, guide.link, slider.points[letter]) - level(
        pair, frame.number, frame.points[crank.pivot]
    )
    arm = driven[pin] - driven[crank.pivot]
    return SliderCrank(crank, rod, guide, crank.pivot, pin, letter, arm, abs(way), offset, points)


def _settled(own: complex, size: float) -> complex:
    """Return a point whose coordinates that are nothing but rounding are 0."""
    x, y = (0.0 if abs(part) <= ROUNDING * size else part for part in (own.real, own.imag))
    return complex(x, y)


def _driven_crank(plans: KinematicPlans) -> Crank:
    pair = plans.pairs[0]
    says: Said | None = None
    if not isinstance(pair, Crank) or isinstance(pair, Rack):
        says = said(
            "it wants a crank that is driven as it turns; link {link} is driven otherwise: leave "
            "[klein] out",
            link=pair.link,
        )
    elif plans.mechanism.at_rest:
        says = said("the crank stands: there is no velocity to draw; give it a speed")
    if says is not None:
        raise StructureError(says, KLEIN, "drive.link", head=KLEIN)
    assert isinstance(pair, Crank)
    return pair


def _there(plans: KinematicPlans, crank: Crank) -> Iterator[tuple[str, _Parts]]:
    """Yield the groups of a rod on the crank and a slider on the frame, by the letter of the slider."""
    frame = plans.mechanism.frame.number
    for closing in dyads(plans.positions.closings, KLEIN):
        match sorted(closing.legs, key=lambda leg: isinstance(leg, GuideLeg)):
            case [PinLeg() as rod, GuideLeg(inner=False) as guide]:
                if rod.body == crank.link and guide.body == frame and not rod.rod:
                    yield closing.letter, _Parts(closing, rod, guide, rod.letter)
            case _:
                continue
