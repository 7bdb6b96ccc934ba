"""What is given: links, guides, sliding pairs, the drive. SI units, degrees for angles, frozen.

A point of a link is a complex number x + iy in the link's own axes (metres). A letter that stands on
several links is a turning pair there. The frame is a link too, its own axes are those of the sheet.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property


@dataclass(frozen=True)
class Side:
    """Which of two assemblies a dyad keeps: a sign held for the whole turn, or flipped at stated angles.

    For a dyad of three turning pairs ``left_of = ("A", "C")`` and ``sign = +1`` mean that the inner pin
    lies to the left when one goes from A to C (-1: to the right). For a sliding pair ``left_of`` is None
    and ``sign`` is the sense along the guide.

    ``flips_at``: crank angles in degrees at which the sign changes; None if the scene does not speak of it.
    """

    sign: int
    left_of: tuple[str, str] | None = None
    flips_at: tuple[float, ...] | None = None


@dataclass(frozen=True)
class Guide:
    """A straight guide on a link: a point of it (m, own axes), its direction (degrees, own axes)."""

    name: str
    through: complex
    angle: float


@dataclass(frozen=True)
class Slide:
    """A sliding pair: this link slides along a guide of link ``on``.

    The slider's own x axis is parallel to the guide turned by ``angle`` (degrees) and lies ``offset``
    metres to its left (its origin does); the slider's own points are laid off from there.

    ``cylinder``: what presses on the piston, "oil" or "gas", where the slider is a piston with its rod and
    ``on`` its cylinder; "" where it is a block on a guide.
    """

    on: int
    guide: Guide
    offset: float = 0.0
    angle: float = 0.0
    side: Side | None = None
    cylinder: str = ""


@dataclass(frozen=True)
class Near:
    """Which of its places a plate keeps that is laid: near this direction of its own x axis, degrees.

    ``at``: the coordinate of the first drive there (degrees, or m of what slides); None: the first of even ones
    at which it can be laid.
    """

    angle: float
    at: float | None = None


@dataclass(frozen=True)
class Arm:
    """An arm of a link: the number it was given by, its letters, the letter it is welded at.

    ``angle``: of its own x axis from that of the link, degrees.
    """

    number: int
    letters: tuple[str, ...]
    at: str
    angle: float


@dataclass(frozen=True)
class Link:
    """One link: its number, its points in its own axes (m), its guides and sliding pairs, mass and J (SI).

    ``rod``: the length (m) of the even rod whose J it has; None if J was given by itself. ``arms``: of a link
    that others are welded to, its own first.
    """

    number: int
    points: Mapping[str, complex]
    guides: tuple[Guide, ...] = ()
    slides: tuple[Slide, ...] = ()
    name: str = ""
    mass: float | None = None
    inertia: float | None = None
    centre: str | None = None
    side: Side | None = None
    rod: float | None = None
    arms: tuple[Arm, ...] = ()
    near: Near | None = None


@dataclass(frozen=True)
class Sweep:
    """What the coordinate of a drive goes through: its letter, unit and bounds; ``closed``: a whole turn is.

    ``name``: what it is called in tables, if that says more than its letter.
    """

    letter: str
    unit: str
    low: float
    high: float
    closed: bool
    name: str = ""

    @property
    def turns(self) -> bool:
        """Whether the coordinate is an angle."""
        return self.unit == "°"

    def within(self, value: float) -> float:
        """Return a coordinate within the bounds: of a turn the same angle from 0 to 360."""
        return value % self.high if self.closed else min(max(value, self.low), self.high)

    def apart(self, one: float, other: float) -> float:
        """Return how far two coordinates are apart, over a whole turn the shorter way."""
        half = self.high / 2.0
        return abs((one - other + half) % self.high - half) if self.closed else abs(one - other)


BELTS = ("belt", "crossed belt", "chain")
"""What joins wheels that stand apart."""


@dataclass(frozen=True)
class Mesh:
    """Two wheels in mesh: their links, the letters of their centres, their teeth or pitch radii.

    ``start``: the angle of the second link's own x axis from that of the link that joins the centres, where the
    first one's lies along that; ``pressure``: the angle of the line of action, both in degrees. Of ``sizes``
    the ratio counts; ``toothed``: they are teeth. ``by``: "teeth", or one of `BELTS`.
    """

    links: tuple[int, int]
    centres: tuple[str, str]
    sizes: tuple[float, float]
    toothed: bool
    internal: bool = False
    start: float = 0.0
    pressure: float = 20.0
    by: str = "teeth"

    @property
    def belted(self) -> bool:
        """Whether a belt or a chain joins the wheels."""
        return self.by in BELTS

    @property
    def alike(self) -> bool:
        """Whether both wheels turn in one sense, seen from the link that joins the centres."""
        return self.internal or self.by in ("belt", "chain")

    def reaches(self, apart: float) -> tuple[float, float]:
        """Return how far the pitch point is from each centre towards the other, m; centres are ``apart``.

        Of a belt the radii, with signs by which the ratio of the wheels is that of teeth.
        """
        first, second = self.sizes
        if self.belted:
            return first, -second if self.alike else second
        if not self.internal:
            return apart * first / (first + second), apart * second / (first + second)
        return apart * first / (first - second), apart * second / (second - first)


TURN = Sweep("φ", "°", 0.0, 360.0, True)
"""A whole turn."""


@dataclass(frozen=True)
class Drive:
    """A pair whose coordinate is given: the link that it drives, its rate and second rate.

    A link that turns: rad/s (counter-clockwise positive) and rad/s². One that ``slides``: m/s along its guide,
    or out of its cylinder, and m/s². ``start``: of a drive besides the first, its coordinate (degrees or m) in
    the zero position. ``rack``: the pitch radius (m) of the wheel on its link, where a rack turns that: the
    coordinate is how far the rack has come then, and its rates are the rack's. ``rates``, ``gains``: the same
    in each position, where they change; then ``speed`` and ``acceleration`` are the largest.
    """

    link: int
    speed: float
    acceleration: float = 0.0
    slides: bool = False
    start: float = 0.0
    rack: float = 0.0
    rates: tuple[float, ...] = ()
    gains: tuple[float, ...] = ()

    @property
    def sense(self) -> int:
        """Which way it goes: 1 counter-clockwise, along its guide or out of its cylinder; −1 the other."""
        return -1 if math.copysign(1.0, self.speed) < 0 else 1


def shared(bodies: Iterable[Mapping[str, complex]]) -> frozenset[str]:
    """Return the letters that stand on more than one body: these are turning pairs, whatever the letter."""
    once: set[str] = set()
    again: set[str] = set()
    for points in bodies:
        again |= once & points.keys()
        once |= points.keys()
    return frozenset(again)


@dataclass(frozen=True)
class Mechanism:
    """The frame, the moving links in the order of the scene, the drive and those that follow it.

    ``passive``: links that move with the others but count for nothing, by which nothing else is held.
    ``meshes``: wheels on links that roll on each other.
    """

    frame: Link
    links: tuple[Link, ...]
    drive: Drive
    passive: tuple[Link, ...] = ()
    further: tuple[Drive, ...] = ()
    meshes: tuple[Mesh, ...] = ()
    by_number: Mapping[int, Link] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        object.__setattr__(
            self, "by_number", {link.number: link for link in (self.frame, *self.links)}
        )

    @property
    def drawn(self) -> tuple[Link, ...]:
        """All links that move, the passive ones last."""
        return (*self.links, *self.passive)

    @property
    def at_rest(self) -> bool:
        """Whether nothing drives: only possible velocities are drawn then."""
        return not any(drive.speed for drive in self.drives)

    @property
    def moves(self) -> bool:
        """Whether a drive has a speed or an acceleration; else nothing has either."""
        return not self.at_rest or any(drive.acceleration for drive in self.drives)

    @property
    def drives(self) -> tuple[Drive, ...]:
        """The drives; the positions are those of the first."""
        return (self.drive, *self.further)

    def driven_by(self, drive: Drive) -> Mechanism:
        """Return the same driven by one of its drives alone and evenly: it comes first, the others are held."""
        alone, *held = (
            replace(one, speed=speed, acceleration=0.0, rates=(), gains=())
            for one, speed in (
                (drive, drive.speed),
                *((one, 0.0) for one in self.drives if one != drive),
            )
        )
        return replace(self, drive=alone, further=tuple(held))

    @cached_property
    def pins(self) -> frozenset[str]:
        """The letters that stand on more than one link: these are its turning pairs, whatever the letter."""
        return shared(link.points for link in (self.frame, *self.drawn))


@dataclass(frozen=True)
class Extreme:
    """The position in which ``point`` is as far as it comes: at "left", "right", "top" or "bottom"."""

    point: str
    at: str

    @property
    def opposite(self) -> Extreme:
        """The position in which the point is as far as it comes the other way."""
        ways = {"left": "right", "right": "left", "top": "bottom", "bottom": "top"}
        return Extreme(self.point, ways[self.at])


@dataclass(frozen=True)
class Row:
    """The row of positions: ``count`` equal steps of the crank over its ``turns``, and extras.

    ``zero`` is the crank's angle (degrees) or an extreme position of a point; the zero position bears the
    number ``first``. ``extra`` holds positions outside the row: coordinates (degrees, or m of what slides), or
    extreme positions of points. ``accelerations`` names the positions that get an acceleration plan ("2",
    "6*", ...). A row with ``ends`` is open: its first position is at the one, its last at the other;
    ``places``: all coordinates of a row whose steps are not equal.
    """

    count: int = 12
    first: int = 0
    zero: float | Extreme = 0.0
    extra: tuple[float | Extreme, ...] = ()
    accelerations: tuple[str, ...] = ()
    turns: int = 1
    ends: tuple[float, float] | None = None
    places: tuple[float, ...] = ()

    @property
    def open(self) -> bool:
        """Whether it does not go on over a whole turn."""
        return self.ends is not None or bool(self.places)

    @property
    def reach(self) -> tuple[float, float] | None:
        """The least and the greatest coordinate of an open row and of what is drawn outside it; else None."""
        if not self.open:
            return None
        known = [
            *(self.ends or self.places),
            *(one for one in self.extra if isinstance(one, float)),
        ]
        return min(known), max(known)
