"""What may follow a cam: a roller or an edge on a rod, a roller on a lever, a flat face on either; keys."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

from graphic_tmm.board.bounds import Bound
from graphic_tmm.language.said import said
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Flaw, Said, key
from graphic_tmm.scene.quantities import is_a

EDGE, FLAT_ROCKER = "knife edge", "flat rocker"
"""The follower without a roller; the lever with a flat face."""
DISC, DRUM, PLATE = "disc", "drum", "translating"
"""Forms of a cam."""
ROCKING = ("rocker", FLAT_ROCKER)
"""Followers that swing through an angle."""
FLAT_FACED = ("flat", FLAT_ROCKER)
"""Those that touch the cam with a flat face."""


@dataclass(frozen=True)
class RollerFollower:
    """A roller on a translating rod, or its knife ``edge``.

    ``offset`` e (m) of its guide from the centre of the cam, positive to the side that lessens the pressure
    angle of the rise; 0 for a central follower.
    """

    offset: float = 0.0
    edge: bool = False


@dataclass(frozen=True)
class RockerFollower:
    """A roller on a rocking lever: length of the lever and distance of the centres (m).

    ``same_sense``: on the rise the lever turns as the cam does.
    """

    lever: float
    centres: float
    same_sense: bool = False


@dataclass(frozen=True)
class FlatFollower:
    """A flat face square to its translation; ``least``: the least radius of curvature allowed (m)."""

    least: float = 0.0


@dataclass(frozen=True)
class FlatRockerFollower:
    """A flat face on a rocking lever: distance of the centres, and of the ``face`` from the pivot (m).

    ``face``: by so much the face lies nearer to the cam than the pivot; ``least`` as of `FlatFollower`,
    ``same_sense`` as of `RockerFollower`.
    """

    centres: float
    face: float = 0.0
    least: float = 0.0
    same_sense: bool = False


Follower = RollerFollower | RockerFollower | FlatFollower | FlatRockerFollower


def follower_of(said: Said) -> Follower:
    """Return the follower that the keys of a section say."""
    along = said.sense == "along"
    if said.follower == "flat":
        return FlatFollower(said.least_curvature)
    if said.follower == "rocker":
        return RockerFollower(said.lever or 0.0, said.centres or 0.0, along)
    if said.follower == FLAT_ROCKER:
        sizes = (said.centres or 0.0, said.face or 0.0, said.least_curvature)
        return FlatRockerFollower(*sizes, along)
    return RollerFollower(said.offset, said.follower == EDGE or said.roller == 0.0)


_NOT_NEGATIVE = replace(v.LENGTH, bound=Bound(0))
KEYS = {
    "follower": key(
        v.choice("roller", EDGE, "rocker", "flat", FLAT_ROCKER), "what follows the cam", "roller",
        "roller",
    ),
    "offset": key(v.LENGTH, "offset of the roller's guide", "10 mm", 0.0),
    "lever": key(v.POSITIVE_LENGTH, "length of the rocker's lever", "80 mm", None),
    "centres": key(
        v.POSITIVE_LENGTH, "distance of the rocker's pivot and the cam's", "100 mm", None
    ),
    "face": key(
        _NOT_NEGATIVE, "how much nearer to the cam than its pivot the face of a flat rocker lies",
        "12 mm", None,
    ),
    "sense": key(
        v.choice("against", "along"),
        "on the rise the lever turns against the cam, or along",
        "against",
        "against",
    ),
    "least_curvature": key(
        _NOT_NEGATIVE, "least radius of curvature: under a flat face, else of the theoretical profile",
        "5 mm", 0.0,
    ),
}  # fmt: skip
"""The keys that `follower_of` reads."""

EXTENTS = ("rise", "upper_dwell", "dwell", "fall", "lower_dwell")
TABLES = ("law_table", "return_table")
"""Keys of phases, and of tables of lifts."""
_OWN = {"lever": ("rocker",), "centres": ROCKING, "face": (FLAT_ROCKER,)}
"""Followers that have a size."""


def flaws(cam: Said, written: dict[str, Any]) -> Iterator[Flaw]:
    """Yield what contradicts the follower, or the form of its cam; ``written``: the section as it stands."""
    yield from _groove_flaws(cam, written)
    yield from _extent_flaws(cam, written)
    for name, own in _OWN.items():
        given = getattr(cam, name) is not None
        if cam.follower in own and not given and name != "face":
            yield Flaw(("cam", name), said('a rocker needs it; write, for example, "80 mm"'))
        if cam.follower not in own and given:
            says = said('the follower "{follower}" has none; leave it out', follower=cam.follower)
            yield Flaw(("cam", name), says)
    for wrong, says in (
        ((cam.roller or 0.0) < 0.0, said("a radius is not negative; write 0 for a knife edge")),
        (cam.roller == 0.0 and cam.follower == "rocker",
         said('a lever has a roller; write, for example, "10 mm"')),
        (cam.roller and cam.follower == EDGE, said("a knife edge has no roller: leave it out")),
    ):  # fmt: skip
        if wrong:
            yield Flaw(("cam", "roller"), says)


def _extent_flaws(cam: Said, written: dict[str, Any]) -> Iterator[Flaw]:
    """Yield phases, and lines of tables, that are angles of a cam that slides, or lengths of one that turns."""
    slides = cam.form == PLATE
    says = said('of a cam that turns it is an angle; write, for example, "60 deg"')
    if slides:
        says = said('of a cam that slides it is a length; write, for example, "60 mm"')
    phases = enumerate(written.get("phase", ()))
    for path, one in ((("cam",), written), *((("cam", "phase", k), own) for k, own in phases)):
        extents = {name: [one[name]] for name in EXTENTS if name in one}
        # a table may say 0 without its unit
        extents |= {name: [at for at, _ in one[name] if at != 0] for name in TABLES if name in one}
        for name, places in extents.items():
            if any(is_a(at, "length") != slides for at in places):
                yield Flaw((*path, name), says)


def _groove_flaws(cam: Said, written: dict[str, object]) -> Iterator[Flaw]:
    """Yield what contradicts a drum, a plate that slides, or a groove."""
    drum, plate = cam.form == DRUM, cam.form == PLATE
    held = drum or cam.groove
    rods = ("roller",) if drum or plate else ("roller", "rocker")
    none = said("a cam that slides has none; leave it out")
    chosen = said("its scale is chosen here: leave it out")
    for wrong, name, says in (
        (held and cam.follower not in rods, "follower", said("a groove holds a roller: leave it out")),
        (held and cam.roller == 0.0, "roller", said("a groove has a roller; leave it out to have one chosen")),
        (held and (cam.mass or cam.inertia), "mass" if cam.mass else "inertia",
         said("a groove holds the roller without a spring: leave it out")),
        (drum and cam.groove, "groove", said("a drum has its groove anyway: leave it out")),
        (drum and "turns" in written, "turns",
         said("a drum is drawn as it passes its roller: leave it out")),
        (drum and cam.offset, "offset", said("a drum has none; leave it out")),
        (drum and cam.r0 is not None, "r0", said("a drum has its mean radius instead: write radius")),
        (plate and not held and cam.follower not in ("roller", EDGE), "follower",
         said('over a cam that slides a rod is drawn with a "roller" or a "knife edge"')),
        (plate and cam.lower_dwell and cam.fall is None, "lower_dwell",
         said("it follows a fall: write fall, or [[cam.phase]] in the order that you want")),
        *((plate and name in written, name, none)
          for name in ("turns", "offset", "r0", "radius", "share_of_r0")),
        *((plate and name in written, name, chosen) for name in ("mu_dS", "mu_ddS")),
        (plate and cam.speed, "speed",
         said("a cam that slides to and fro has no even speed: leave it out")),
        (plate and (cam.mass or cam.inertia), "mass" if cam.mass else "inertia",
         said("a spring is found over a cam that turns evenly: leave it out")),
        (not (drum or plate) and cam.radius is not None, "radius",
         said("a disc has its least radius instead: write r0")),
    ):  # fmt: skip
        if wrong:
            yield Flaw(("cam", name), says)
