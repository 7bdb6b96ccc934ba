"""The sections of a scene that give the mechanism: frame, links, drive; directions and sides."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from graphic_tmm.board.bounds import Bound
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import BELTS
from graphic_tmm.scene import coordinates as c
from graphic_tmm.scene import misfits
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import FAULTY, Flaw, Names, Path, Schema, Sort, combined_key, key
from graphic_tmm.scene.quantities import si
from graphic_tmm.scene.tables import ByShape, DeclaredTable, Named, Several


@dataclass(frozen=True)
class Guide:
    """A straight guide of a link or of the frame."""

    through: complex = key(v.POINT, "a point of the guide", [0, 0])
    angle: float = key(v.ANGLE, "its direction from the x axis", "0 deg")


DIGITS = 15
"""Figures of a length that is worked out: as many as a number of the machine has for certain."""


@dataclass(frozen=True)
class Joints:
    """Places of joints in one position, by letter, in the axes of the frame."""

    OTHERS: ClassVar[Sort] = v.POINT

    to: float = key(
        v.LENGTH,
        "lengths are rounded to a multiple of it; 0: they are left as they are",
        "1 mm",
        0.0,
    )
    near: float = key(v.LENGTH, "what lies nearer to a line was meant to lie on it", "1 mm", 0.0)
    others: Mapping[str, complex] = combined_key(lambda said: said.others, ())

    def length(self, metres: float) -> str:
        """Return a length as a scene says it; "" of one that is nothing."""
        return "" if abs(metres) < self.near else self.rounded(metres)

    def rounded(self, metres: float) -> str:
        """Return a length of a link as a scene says it, however short; "" of one that is nothing."""
        rounded = round(metres / self.to) * self.to if self.to else metres
        return f"{1000.0 * si(rounded, 'length'):.{DIGITS}g} mm" if rounded else ""

    def point(self, place: complex) -> list[Any]:
        """Return a point as a scene says it; one that is nearly on the x axis on it."""
        return [self.rounded(place.real) or 0, self.length(place.imag) or 0]

    def angle(self, degrees: float, reach: float) -> str:
        """Return the angle of a slider whose own x axis is so long, m; "" of one that is nothing."""
        line = 180.0 * round(degrees / 180.0)
        off = reach * abs(math.sin(math.radians(degrees - line)))
        shown = line if off < self.near else degrees
        return f"{shown:.{DIGITS}g} deg" if shown else ""


class _Place:
    """A point of the frame, by its letter; something else there may be a misspelt number."""

    def understood(self, value: object, at: Path, names: Names, found: list[Flaw]) -> Any:
        """Return the place, or FAULTY."""
        if isinstance(value, list):
            return v.POINT.understood(value, at, names, found)
        meant = misfits.meant(str(at[-1]), ["number"], 0.6)
        keys = said(
            "a key of the frame is number, a point, O = [0, 0], or a guide, "
            'y = { through = [0, 0], angle = "0 deg" }'
        )
        found.append(Flaw(at, misfits.stands(value, meant, keys)))
        return FAULTY

    def schema(self, tables: dict[str, Schema]) -> Schema:
        """Return that of a point."""
        return v.POINT.schema(tables)


@dataclass(frozen=True)
class Frame:
    """The fixed link: every key but number is a guide's name or a fixed point's letter (not P, p, Π, π)."""

    OTHERS: ClassVar[Sort] = ByShape(dict, DeclaredTable(Guide), _Place())

    number: int = key(v.LINK_NUMBER, "the number of the fixed link", 6, 0)
    others: Mapping[str, complex | Guide] = combined_key(lambda said: said.others, ())

    @property
    def points(self) -> dict[str, complex]:
        """The fixed points, m."""
        return {name: p for name, p in self.others.items() if not isinstance(p, Guide)}

    @property
    def guides(self) -> dict[str, Guide]:
        """The fixed guides."""
        return {name: g for name, g in self.others.items() if isinstance(g, Guide)}


@dataclass(frozen=True)
class Slide:
    """A sliding pair: on which link, along which guide, and which way the pin lies along it."""

    on: int | str = key(v.TARGET, 'the number of the link it slides on, or "frame"', 3)
    along: str = key(
        v.LETTER, "two letters of that link, from the first to the second, or a guide", "BC"
    )
    offset: float = key(
        v.LENGTH, "how far the slider's own x axis lies to the left of the guide", None, 0.0
    )
    angle: float = key(
        v.ANGLE, "by how much the slider's own x axis is turned from the guide", None, 0.0
    )
    side: str | None = key(v.SENSE, "which way the pin lies along the guide", "+", None)
    flips_at: tuple[float, ...] | None = key(
        v.ANGLES, "crank angles at which the side changes", ["90 deg"], None
    )
    cylinder: str | None = key(
        v.choice("oil", "gas", масло="oil", газ="gas"),
        "this link is a piston with its rod, the one it slides on their cylinder: what presses on the piston",
        "oil",
        None,
    )


@dataclass(frozen=True)
class Weld:
    """A link as an arm of another: one body, at an angle that stays."""

    to: int = key(v.LINK_NUMBER, "the number of the link with which it is one body", 1)
    angle: float = key(
        v.ANGLE, "by how much its own x axis is turned from that of the other link", "90 deg"
    )


@dataclass(frozen=True)
class Link:
    """A moving link."""

    number: int = key(v.LINK_NUMBER, "the number of the link", 1)
    name: str = key(v.TEXT, "what the link is called", "crank", "")
    points: Mapping[str, complex] = key(
        Named(v.POINT),
        "letters and their places in the link's own axes, or a list of letters that have places in [joints]; "
        "P, p, Π, π are kept for poles",
        default={},
    )
    guides: Mapping[str, Guide] = key(
        Named(DeclaredTable(Guide)), "guides that move with the link", default={}
    )
    slides: Slide | tuple[Slide, ...] = key(
        ByShape(list, Several(DeclaredTable(Slide)), DeclaredTable(Slide)),
        "its sliding pairs: a table, or a list of tables",
        default=(),
    )
    side: tuple[int, tuple[str, str]] | None = key(
        v.LINK_SIDE, "where the inner pin of a dyad of turning pairs lies", "left of AC", None
    )
    flips_at: tuple[float, ...] | None = key(
        v.ANGLES, "crank angles at which the side changes", ["90 deg"], None
    )
    near: float | None = key(
        v.ANGLE,
        "of a plate on three links, or one that two join to another, which of its places is meant: "
        "the direction of its own x axis there",
        "-114 deg",
        None,
    )
    near_at: float | None = key(
        c.COORDINATE,
        "where the first drive stands then, if not where its row begins",
        "40 deg",
        None,
    )
    weld: Weld | None = key(
        DeclaredTable(Weld),
        "it is an arm of another link, welded to it at the letter that both have",
        default=None,
    )
    passive: bool = key(
        v.SWITCH,
        "it doubles what other links hold already: left out of W, drawn where its letters on them stand",
        True,
        False,
    )
    mass: float | None = key(v.MASS, "its mass", "25 kg", None)
    J: float | None = key(
        v.INERTIA, "its moment of inertia about the mass centre", "0.02 kg*m^2", None
    )
    rod: float | None = key(
        v.POSITIVE_LENGTH,
        "in place of J: the length l of an even rod that has its mass and its J = m·l²/12",
        "0.4 m",
        None,
    )
    centre: str | None = key(
        v.LETTER,
        "the letter of its mass centre; left out, its only point that is no turning pair",
        "S2",
        None,
    )

    @property
    def pairs(self) -> tuple[Slide, ...]:
        """The sliding pairs, one or several."""
        return (self.slides,) if isinstance(self.slides, Slide) else self.slides


@dataclass(frozen=True)
class Mesh:
    """Two wheels in mesh; each belongs to a link and turns about one of its letters."""

    links: tuple[int, ...] = key(
        Several(v.LINK_NUMBER, said("write both links, [1, 4]")),
        "the numbers of the two links that bear the wheels; the frame may be one",
        [1, 4],
    )
    centres: tuple[str, ...] = key(
        v.LETTERS,
        "the letters about which they turn, in the same order: one link (the frame, an arm) has both",
        ["O", "D"],
    )
    teeth: tuple[int, ...] = key(
        Several(v.number(Bound(3, 10_000, whole=True)), said("write both numbers, [20, 40]")),
        "their teeth, in the same order",
        [20, 40],
        (),
    )
    radii: tuple[float, ...] = key(
        Several(v.POSITIVE_LENGTH, said('write both radii, ["50 mm", "100 mm"]')),
        "in place of teeth: their pitch radii",
        ["50 mm", "100 mm"],
        (),
    )
    internal: bool = key(v.SWITCH, "one wheel, the larger, has its teeth inside", True, False)
    by: str = key(
        v.choice(
            "teeth",
            *BELTS,
            зубья="teeth",
            ремень=BELTS[0],
            перекрёстный_ремень=BELTS[1],
            цепь=BELTS[2],
        ),
        "what joins the wheels: teeth, or a belt or chain about wheels that stand apart, their radii given",
        "belt",
        "teeth",
    )
    phase: float = key(
        v.ANGLE,
        "the angle of the second link's own x axis from that of the link with both centres, where the first "
        "one's lies along that",
        "60 deg",
        0.0,
    )
    alpha: float = key(v.RACK, "the pressure angle, at which the teeth press", "20 deg", 20.0)

    @property
    def sizes(self) -> tuple[float, ...]:
        """Teeth, or else pitch radii, m."""
        return self.teeth or self.radii


@dataclass(frozen=True)
class Extreme:
    """The position in which a point is as far as it comes."""

    point: str = key(v.LETTER, "the letter of the point", "D")
    at: str = key(v.AT, "where it is then", "left")


@dataclass(frozen=True)
class Drive:
    """The driving link, its motion, and the row of positions."""

    link: int = key(v.LINK_NUMBER, "the number of the driving link", 1)
    speed: float | tuple[float, ...] = key(
        ByShape(list, c.SPEEDS, c.SPEED),
        "its angular speed, positive; of what slides, on the frame or out of its cylinder, its speed, "
        '"0.05 m/s"; 0 where it stands; or a list, one for each position; "motion law": as the motion is found',
        "380 rpm",
    )
    acceleration: float | tuple[float, ...] = key(
        ByShape(list, c.GAINS, c.GAIN),
        "its angular acceleration in the sense of turning: positive when it speeds up, negative when it slows; "
        "of what slides its acceleration; or a list, one for each position",
        "20 rad/s^2",
        0.0,
    )
    rack: float | None = key(
        v.POSITIVE_LENGTH,
        "of a link that a rack turns: the pitch radius of its wheel; speed and places are the rack's",
        "40 mm",
        None,
    )
    turns: str = key(v.TURNS, "which way it turns", "clockwise", v.COUNTERCLOCKWISE)
    begin: float | None = key(
        c.COORDINATE,
        "where the row begins if it is no whole turn: an angle; of what slides how far it has come along its "
        "guide, or how far apart the pins of rod and cylinder are",
        "20 deg",
        None,
        written="from",
    )
    end: float | None = key(c.COORDINATE, "where that row ends", "75 deg", None, written="to")
    positions: int | tuple[float, ...] = key(
        ByShape(list, c.COORDINATES, v.number(Bound(1, 100_000, whole=True))),
        "how many positions there are, in a turn or from the one end to the other; or a list of all places",
        12,
        12,
    )
    first: int = key(v.number(Bound(0, 1, whole=True)), "the number of the zero position", 1, 0)
    extra: tuple[float | str | Extreme, ...] = key(
        Several(
            ByShape(dict, DeclaredTable(Extreme), c.EXTRA),
            said('a list is wanted, ["other extreme", "105 deg"]'),
        ),
        'positions beside the row: "other extreme", crank angles, lengths, or extremes of points',
        [c.OTHER_EXTREME],
        (),
    )
    accelerations: tuple[str, ...] = key(
        v.POSITIONS, "the positions with an acceleration plan", [2, 6], ()
    )
    zero: float | Extreme = key(
        ByShape(dict, DeclaredTable(Extreme), v.ANGLE),
        "the zero position: a crank angle, or an extreme of a point",
        default=0.0,
    )

    @property
    def count(self) -> int:
        """How many positions the row has."""
        return self.positions if isinstance(self.positions, int) else len(self.positions)

    @property
    def open(self) -> bool:
        """Whether its row goes from one end to another."""
        return self.begin is not None or isinstance(self.positions, tuple)


@dataclass(frozen=True)
class FurtherDrive:
    """Another drive of a mechanism with several: its link and motion; it follows the row of the first."""

    link: int = key(v.LINK_NUMBER, "the number of the driving link", 4)
    speed: float = key(c.SPEED, "its speed, positive, as of the first", "10 rad/s")
    acceleration: float = key(c.GAIN, "its acceleration in the sense of its motion", None, 0.0)
    turns: str = key(v.TURNS, "which way it turns", "clockwise", v.COUNTERCLOCKWISE)
    at: float = key(c.COORDINATE, "where it stands in the zero position", "240 deg", 0.0)


def as_row(value: float | tuple[float, ...]) -> tuple[float, ...]:
    """Return one number, or one for each position, as a row."""
    return value if isinstance(value, tuple) else (value,)


def slides(drive: Drive | FurtherDrive, link: Link | None, frame: Frame) -> bool:
    """Whether a drive slides: its speed says so; of a bare number, its link turns about nothing fixed."""
    speed = as_row(drive.speed)[0]
    if not isinstance(speed, c.Bare) or link is None:
        return isinstance(speed, c.Metres)
    return bool(link.pairs) and not frame.points.keys() & link.points.keys()


SAME_PLACE = 1e-9
"""Points of a link nearer than this, m, are one point: nothing so small is made or drawn."""
