"""What is asked of a cam given by arcs: its circles, its flanks, what follows it, sizes of the drawing."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from graphic_tmm.board.bounds import Bound
from graphic_tmm.language.said import joined, said
from graphic_tmm.scene import quantities
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Flaw, Kind, Names, Said, Section, combined_key, key
from graphic_tmm.scene.misfits import stands
from graphic_tmm.scene.tasks import SectionKey

if TYPE_CHECKING:
    from graphic_tmm.scene.sections import Parts


ARC_CAM = "arc_cam"


STRAIGHT = "straight"
"""The flank of infinite radius: a tangent to both circles."""
CHANGES = ("I", "II")
"""What positions are called at which the follower goes onto the nose and off it."""
ROLLER, FLAT, ROCKER, FLAT_ROCKER = "roller", "flat", "rocker", "flat rocker"


@dataclass(frozen=True)
class Flank:
    """A flank: the radius of its arc (m), None for a straight one; ``hollow``: its centre lies outside."""

    radius: float | None
    hollow: bool = False


def _flank(value: object, names: Names) -> float:
    """Return the radius of a flank, infinite for a straight one."""
    if value == STRAIGHT:
        return math.inf
    try:
        quantities.parse(value, "length")
    except ValueError:
        says = said('write the radius of its arc, "60 mm", or "straight"')
        raise ValueError(stands(value, says)) from None
    return float(v.POSITIVE_LENGTH.read(value, names))


def _plans(value: object, names: Names) -> tuple[str, ...]:
    """Return positions by name, the changes of arcs among them."""
    if not isinstance(value, list):
        return tuple(v.POSITIONS.read(value, names))
    return tuple(one if one in CHANGES else v.POSITION.read(one, names) for one in value)


_PLANS = Kind(_plans, v.POSITIONS.told)
_FLANK = Kind(_flank, v.SCALE, unit="length, or straight")
_LEAST = v.quantity("length", Bound(0))


def _rise(said: Said) -> Flank:
    return _side(said.flank, said)


def _return(said: Said) -> Flank:
    return _side(said.flank if said.return_flank is None else said.return_flank, said)


def _side(radius: float | None, said: Said) -> Flank:
    return Flank(radius if radius is not None and math.isfinite(radius) else None, said.hollow)


def _eccentric(said: Said) -> bool:
    return said.radius is not None and said.eccentricity is not None


@dataclass(frozen=True)
class ArcTask:
    """A disc cam whose contour consists of arcs: base circle, two flanks, nose.

    Lengths in m, drawn ones in mm. ``base`` r1; ``nose`` r2, 0 for a sharp one; ``distance`` d of the nose's
    centre from the cam's. An ``eccentric`` is a nose all round: one circle about its centre, which the base
    circle touches from inside. ``follower``: "roller" on a rod (``offset`` e, positive to the side that lessens
    the pressure angle of the rise), "flat" face square to its rod, a "rocker" with a roller (``lever`` l,
    ``centres`` a; ``same_sense``: on the rise it turns as the cam does), or a "flat rocker": a lever with a
    flat face. ``roller`` r: 0 for an edge; of a flat rocker how far its face stands from the line through its
    pivot, which goes round the contour at that distance. The angle of the cam is counted from where the
    follower begins to rise; that over which it moves is divided into ``parts``. ``accelerations``: positions
    whose plans of the replacing linkage are drawn. ``length``: of the diagrams' base; ``mu_l`` of the contour
    (m/mm), if not a standard one. ``speed``: of the cam (1/s), if velocities and accelerations are wanted.
    """

    base: float = combined_key(
        lambda said: said.radius - said.eccentricity if _eccentric(said) else said.base,
        base=key(v.POSITIVE_LENGTH, "the radius of the base circle", "20 mm", None),
        radius=key(v.POSITIVE_LENGTH, "of an eccentric, one circle: its radius", "30 mm", None),
    )
    distance: float = combined_key(
        lambda said: said.eccentricity if _eccentric(said) else said.distance,
        distance=key(
            v.POSITIVE_LENGTH, "how far the nose's centre stands from the cam's", "22 mm", None
        ),
        eccentricity=key(
            v.POSITIVE_LENGTH,
            "of an eccentric: how far its centre stands from the shaft's",
            "8 mm",
            None,
        ),
    )
    nose: float = combined_key(
        lambda said: said.radius if _eccentric(said) else said.nose,
        0.0,
        nose=key(_LEAST, "the radius of the nose; 0 for a sharp one", "6 mm", 0.0),
    )
    rise: Flank = combined_key(
        _rise,
        Flank(None),
        flank=key(_FLANK, 'the radius of the flanks, or "straight"', "60 mm", None),
        hollow=key(v.SWITCH, "whether the flanks are hollow: for rollers only", True, False),
    )
    fall: Flank = combined_key(
        _return,
        Flank(None),
        return_flank=key(
            _FLANK, "the radius of the flank of the return, if it is another", "80 mm", None
        ),
    )
    follower: str = key(
        v.choice(ROLLER, FLAT, ROCKER, FLAT_ROCKER), "what follows the cam", ROLLER, ROLLER
    )
    roller: float = combined_key(
        lambda said: said.face if said.follower == FLAT_ROCKER else said.roller,
        0.0,
        roller=key(_LEAST, "the radius of the roller; 0 for an edge", "10 mm", 0.0),
        face=key(
            _LEAST,
            "how far the face of a flat rocker stands from its pivot, to the cam",
            "5 mm",
            0.0,
        ),
    )
    offset: float = key(v.LENGTH, "offset of the roller's guide", "5 mm", 0.0)
    lever: float | None = key(v.POSITIVE_LENGTH, "length of the rocker's lever", "60 mm", None)
    centres: float | None = key(
        v.POSITIVE_LENGTH, "distance of the rocker's pivot and the cam's", "70 mm", None
    )
    same_sense: bool = combined_key(
        lambda said: said.sense == "along",
        False,
        sense=key(
            v.choice("against", "along"),
            "on the rise the lever turns against the cam, or along",
            "against",
            "against",
        ),
    )
    turns: str = key(v.TURNS, "which way the cam turns", "counterclockwise", v.COUNTERCLOCKWISE)
    parts: int = key(
        v.number(Bound(8, 360, whole=True)),
        "parts into which the angle is divided over which the follower moves",
        16,
        16,
    )
    accelerations: tuple[str, ...] = key(
        _PLANS,
        "positions whose plans of velocities and accelerations are drawn, by the linkage that replaces the "
        "cam; I and II are the changes of arcs",
        [3, "I"],
        (),
    )
    length: float = key(v.DRAWN, "length of the diagrams' base", "240 mm", 240.0, fixes="size")
    mu_l: float | None = key(
        v.MU_L, 'm/mm of the contour, or "1:1"', "0.0005 m/mm", None, fixes="size"
    )
    speed: float | None = key(
        v.SPEED_OF_CAM,
        "how fast the cam turns, if the follower's speeds are wanted",
        "600 rpm",
        None,
    )
    eccentric: bool = combined_key(_eccentric, False)

    @property
    def rocks(self) -> bool:
        """Whether the follower is a lever."""
        return self.follower in (ROCKER, FLAT_ROCKER)

    @property
    def flat(self) -> bool:
        """Whether the follower has a flat face."""
        return self.follower in (FLAT, FLAT_ROCKER)


ASKED: SectionKey[ArcTask] = SectionKey("arc_cam")


def check(cam: Said, parts: Parts) -> Iterator[Flaw]:
    """Every contradiction of the section: keys of another cam or follower, what is missing, positions."""
    at, told = ASKED.section, parts.doc[ASKED.section]
    yield from _sizes(cam, told)
    rocks = {"lever": {ROCKER}, "centres": {ROCKER, FLAT_ROCKER}}
    for name, own in rocks.items():
        if cam.follower in own and getattr(cam, name) is None:
            yield Flaw((at, name), said('a rocker needs it; write, for example, "80 mm"'))
    others = {
        **rocks,
        "sense": rocks["centres"],
        "offset": {ROLLER},
        "roller": {ROLLER, ROCKER},
        "face": {FLAT_ROCKER},
    }
    foreign = [name for name, own in others.items() if name in told and cam.follower not in own]
    for name in foreign:
        says = said('the follower "{follower}" has none; leave it out', follower=cam.follower)
        yield Flaw((at, name), says)
    named = ("all",) if _eccentric(cam) else (*CHANGES, "all")
    for i, name in enumerate(cam.accelerations):
        if name not in named and not (name.isdigit() and int(name) <= cam.parts):
            says = said(
                "there is no position {name}; the row goes from {first} to {last}",
                name=name,
                first=0,
                last=cam.parts,
            )
            if not _eccentric(cam):
                says = joined(", ", (says, said("I and II are the changes of arcs")))
            yield Flaw((at, "accelerations", i), says)


def _sizes(cam: Said, told: Mapping[str, object]) -> Iterator[Flaw]:
    """What is missing of a cam of arcs, or of an eccentric, and what an eccentric does not have."""
    of_arcs, needed = ["base", "distance", "flank"], ["radius", "eccentricity"]
    if not told.keys() & {*needed}:
        needed = of_arcs
    else:
        for name in (*of_arcs, "nose", "return_flank", "hollow"):
            if name in told:
                says = said("an eccentric is one circle and has none; leave it out")
                yield Flaw((ASKED.section, name), says)
    for name in needed:
        if name not in told:
            says = said(
                "it is missing: a cam of arcs needs base, distance and flank, an eccentric radius and "
                "eccentricity"
            )
            yield Flaw((ASKED.section, name), says)


SECTIONS = (
    Section(
        ASKED.section, ArcTask, "a cam given by arcs", alone=True, metric=True,
        begin='base = "20 mm", distance = "22 mm", flank = "60 mm"', check=check,
        refuse="graphic_tmm.chapters.arc_cam.geometry:lie",
    ),
)  # fmt: skip
