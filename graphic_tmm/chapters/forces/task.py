"""What is asked of forces: effects, loads, friction, the positions that are drawn. SI, degrees."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from graphic_tmm.chapters.forces import kinds as w
from graphic_tmm.chapters.indicator.task import IndicatorTask
from graphic_tmm.mechanism.records import Drive, Mechanism, Row
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import OtherSections, Said, combined_key, key
from graphic_tmm.scene.drive_checks import time_of_turn
from graphic_tmm.scene.quantities import kept
from graphic_tmm.scene.tables import DeclaredTable, Named
from graphic_tmm.scene.tasks import SectionKey
from graphic_tmm.scene.units import GRAVITY, KGF

if TYPE_CHECKING:
    from graphic_tmm.scene.sections import Parts

FORCES = "forces"
LOADS = "load diagram"
"""The place of the diagrams of loads."""


AGAINST = w.AGAINST
TURN = 360.0
"""A turn of the crank, degrees."""
SAME_TIME = 1e-5
"""A time that is off that of a turn or of a row by less than this share is that one: faults tell six digits."""
Table = tuple[tuple[float, float], ...]
"""Places in order, and the sizes there."""
_BY_SHARES = [[0, "0 N"], [1, "190 N"]]


@dataclass(frozen=True)
class Effects:
    """What acts; an effect that is left out is not simulated, not computed and not on the sheet."""

    gravity: bool = key(v.SWITCH, "weights of the links", True, False)
    g: float | None = key(
        v.ACCELERATION,
        f"what weights are taken with; {GRAVITY} m/s² if it is left out, while kgf is {KGF} N",
        "9.80665 m/s^2",
        None,
    )
    inertia: bool = key(v.SWITCH, "inertia forces and couples of the links", True, False)
    gas: bool = key(v.SWITCH, "the gas of the indicator diagram on the piston", True, False)
    friction: bool = key(v.SWITCH, "friction in the pairs that [friction] names", True, False)


@dataclass(frozen=True)
class Travel:
    """A size by the travel of a point, or by the swing of a link: shares of the stroke 0 … 1, and sizes.

    ``of``: the letter of a point that slides on the frame, or of any with ``along`` (degrees from the x axis);
    or the number of a link. ``out`` is the stroke from where the travel begins, ``back`` the other; an empty
    one has no load. Two at one share are a jump: there the size holds that the motion comes to. It begins at
    the zero position if the stroke does, else where the point is farthest from the crank, or behind along its
    line, or the link farthest clockwise; ``start`` ("left") where that is told.
    """

    of: str | int
    out: tuple[tuple[float, float], ...] = ()
    back: tuple[tuple[float, float], ...] = ()
    start: str = ""
    along: float | None = None

    @property
    def slides(self) -> bool:
        """Whether it is that of a point that slides on the frame."""
        return isinstance(self.of, str) and self.along is None


def _size(said: Said) -> float | tuple[float, ...]:
    told = [one for one in (said.force, said.moment, said.by_position) if one is not None]
    return told[-1] if told else 0.0


def _travel(said: Said) -> Travel | None:
    if said.of is None:
        return None
    return Travel(said.of, said.out or (), said.back or (), said.start or "", said.along)


def _direction(said: Said) -> float | str | w.Along:
    if said.direction is None:
        return AGAINST if said.point is not None else 0.0
    found: float | str | w.Along = said.direction
    return found


@dataclass(frozen=True)
class Load:
    """A force at a point of a link, or a moment on a link.

    A force in N; a moment in N·m on the link where ``point`` is None. ``size``: constant; or at every position
    of the row; ``by_angle``: at turns of the crank from the zero position (degrees, in order), straight between
    them; ``by_time``: at times from the zero position (s), which are turns where the row is one; ``travel``.
    ``direction``: degrees, fixed in the sheet; `Along`, which turns with the links; or
    `AGAINST`. A moment with a direction in degrees is counter-clockwise positive. ``opposite``: the link on
    which the opposite acts, ``opposite_at``: at its point of that letter, else on the same line.
    """

    link: int = key(v.LINK_NUMBER, "the number of the link", 5)
    point: str | None = key(v.LETTER, "the letter of the point where a force acts", "D", None)
    size: float | tuple[float, ...] = combined_key(
        _size,
        0.0,
        force=key(w.FORCE, "its size", "190 N", None),
        moment=key(w.MOMENT, "a moment, counter-clockwise positive", "12 N*m", None),
        by_position=key(w.SIZES, "its size in each position", ["190 N", "0 N"], None),
    )
    direction: float | str | w.Along = combined_key(
        _direction,
        AGAINST,
        direction=key(
            w.DIRECTION,
            "an angle from the x axis; against velocity, or against rotation; or turning with a link: along AC "
            "(from A to C) or a guide z, square to BC (+90°), 30 deg to BC",
            "against velocity",
            None,
        ),
    )
    by_angle: tuple[tuple[float, float], ...] = combined_key(
        lambda said: said.by_angle or (),
        (),
        by_angle=key(
            w.BY_ANGLE,
            "its size by the turn of the crank from the zero position; two sizes at one angle are a jump, the "
            "second holds there",
            [[0, "0 N"], [90, "190 N"]],
            None,
        ),
    )
    by_time: tuple[tuple[float, float], ...] = combined_key(
        lambda said: said.by_time or (),
        (),
        by_time=key(
            w.BY_TIME,
            "its size by the time from the zero position on, where what drives goes at one speed: over a turn "
            "of the crank or two; or over a row with ends, and before and behind these times nothing acts; "
            "two sizes at one time are a jump, the second holds there",
            [[0, "0 N"], ["0.05 s", "190 N"]],
            None,
        ),
    )
    travel: Travel | None = combined_key(
        _travel,
        None,
        of=key(
            w.OF,
            "by whose travel it is told: the letter of a point that slides on the frame, of any other with "
            "along; or the number of a link, by whose swing",
            "D",
            None,
        ),
        along=key(
            w.LINE,
            "of a point that does not slide on the frame: the line along which its travel is told, an angle "
            "from the x axis",
            "90 deg",
            None,
        ),
        out=key(
            w.BY_TRAVEL,
            "its size on the stroke from the zero position, by shares of it; two sizes at one share are a "
            "jump, the second holds there",
            _BY_SHARES,
            None,
        ),
        back=key(
            w.BY_TRAVEL,
            "its size on the stroke back, by shares from the same end; at a jump the first holds, since the "
            "point comes from the other side",
            _BY_SHARES,
            None,
        ),
        start=key(
            w.START,
            "at which end of its travel the stroke out begins: left, right, top or bottom, of a link clockwise "
            "or counterclockwise; left out: at the zero position if it turns back there, else away from the "
            "crank, of a point with along behind on its line, of a link clockwise",
            "left",
            None,
        ),
    )
    opposite: int | None = key(
        v.LINK_NUMBER,
        "the number of the link that it comes from, where the opposite acts: a pair of forces or of moments",
        4,
        None,
        written="from",
    )
    opposite_at: str | None = key(
        v.LETTER,
        "the letter of the point of that link where the opposite force acts; left out, on the same line",
        "C",
        None,
        written="from_point",
    )


def timed(load: Load, drive: Drive, row: Row) -> Load:
    """Return a load with sizes by time at the turns of a crank that goes round evenly, φ = ω·t."""
    if not load.by_time or row.open:
        return load
    return replace(load, by_angle=scaled(load.by_time, math.tau / abs(drive.speed), TURN))


def scaled(by_time: Table, time: float, whole: float) -> Table:
    """Return sizes by time at places that an even motion comes to; it comes a ``whole`` way in a time."""
    shares = [at / time for at, _ in by_time]
    near = [round(one) if abs(one - max(round(one), 1)) < SAME_TIME else one for one in shares]
    return tuple((whole * share, size) for share, (_, size) in zip(near, by_time, strict=True))


def turns_of(points: Table) -> int:
    """Return over how many turns of the crank sizes by its turn are given; 1 where there are none."""
    return 2 if points and points[-1][0] > TURN else 1


def turns_written(load: Said, parts: Parts) -> int:
    """Return over how many turns of the crank the sizes of a load of a scene are given."""
    time = time_of_turn(parts) if load.by_time else None
    return turns_of(load.by_angle or (scaled(load.by_time, time, TURN) if time else ()))


@dataclass(frozen=True)
class Spring:
    """A spring or a damper between two points: F = c(l − l_0) + F_0 + b·v, where it pulls its ends together.

    ``between``: the letters of its ends; l is how far they are apart on the plan of positions, v how fast they
    part on that of velocities. ``links``: of the ends; left out, the frame's where it has one, else the first.
    """

    between: tuple[str, str] = key(w.ENDS, "the letters of its two ends", ["A", "C"])
    rate: float | None = key(
        w.STIFFNESS, "how stiff it is: the force of each metre by which it is longer", "2 kN/m", None,
        symbol="c",
    )  # fmt: skip
    free: float | None = key(v.POSITIVE_LENGTH, "its free length l_0", "100 mm", None, symbol="l_0")
    force: float = key(
        w.FORCE, "what it pulls its ends together with at the free length, F_0", "50 N", 0.0,
        symbol="F_0",
    )  # fmt: skip
    damping: float | None = key(
        w.DAMPING, "of a damper: the force of each m/s at which its ends part", "150 N*s/m", None,
        symbol="b",
    )  # fmt: skip
    links: tuple[int, ...] = key(
        w.LINKS, "the links of its ends, in their order; left out, the frame if the end is on it, else the "
        "first link that has the letter", [1, 0], (),
    )  # fmt: skip


@dataclass(frozen=True)
class Unknown:
    """An unknown force at a point of a link: with the loads that are given it balances the mechanism.

    ``direction``: degrees from the x axis, or `Along`; the force is positive that way.
    """

    link: int = key(v.LINK_NUMBER, "the number of the link on which it acts", 3)
    point: str = key(v.LETTER, "the letter of its point", "B")
    direction: float | str | w.Along = key(
        w.DIRECTION, "its direction, as that of a load; it is positive that way", "along BC"
    )


@dataclass(frozen=True)
class Rubbed:
    """Coefficients of friction, radii of pins."""

    f: float = key(
        w.COEFFICIENT,
        "the coefficient of every pair that is not named; a rod's own in its cylinder is in the force that "
        "drives it",
        0.1,
        0.0,
    )
    pairs: Mapping[str, float] = key(
        Named(w.COEFFICIENT), "coefficients of pairs by their letter or guide", default={}
    )
    radius: float | None = key(
        v.POSITIVE_LENGTH, "the radius of every pin that is not named", "15 mm", None
    )
    radii: Mapping[str, float] = key(
        Named(v.POSITIVE_LENGTH), "radii of pins by their letter", default={}
    )
    passes: int = key(w.PASSES, "passes with friction", 2, 2)


@dataclass(frozen=True)
class Friction:
    """Coefficients by pair (its letter or guide), pin radii (m) by letter, passes with friction."""

    f: Mapping[str, float]
    radius: Mapping[str, float]
    passes: int = 2


@dataclass(frozen=True)
class ForcesTask:
    """Kinetostatics by groups and Zhukovsky's lever.

    ``positions``: their numbers, or ("all",). ``balance``: a "force" at the crank pin, square to the crank, or
    a "moment". ``couples``: on the lever as "moment" or as a "pair" of forces. ``single``: links whose inertia
    force and couple are replaced by one force. ``limit``: of the difference of both methods, %. ``mu``: N/mm
    of every polygon; None for standard ones. ``g``: of weights, m/s². ``gas``: the
    indicator diagram whose gas pushes the piston. ``unknown``: the force that balances the loads, what drives
    being left with nothing.
    """

    positions: tuple[str, ...] = combined_key(
        lambda said: said.positions,
        positions=key(v.POSITIONS, "the positions whose forces are drawn", [8], ("all",)),
    )
    loads: tuple[Load, ...] = ()
    springs: tuple[Spring, ...] = ()
    gravity: bool = False
    inertia: bool = False
    gas: IndicatorTask | None = None
    friction: Friction | None = None
    balance: str = key(
        w.BALANCE, "what balances the crank: a force at its pin, or a moment", "force", "force"
    )
    couples: str = key(
        w.COUPLES, "couples on the lever: converted moments, or pairs of forces", None, "moment"
    )
    single: tuple[int, ...] = key(
        w.LINKS, "links whose inertia force and couple are replaced by one force", [3], ()
    )
    limit: float = key(w.LIMIT, "how much the two methods may differ", "5 %", 5.0)
    mu: float | None = key(
        v.mu("scale of forces"), "N/mm, of every polygon", "40 N/mm", None,
        written="mu_F", fixes="size",
    )  # fmt: skip
    unknown: Unknown | None = key(
        DeclaredTable(Unknown),
        "a force at a tool that is sought; the loads are given, that of the drive among them",
        default=None,
    )
    g: float = GRAVITY

    @property
    def turns(self) -> int:
        """How many turns of the crank a cycle takes, by the loads and by the gas."""
        gas = self.gas.turns if self.gas is not None else 1
        return max([gas, *(turns_of(load.by_angle) for load in self.loads)])


ASKED: SectionKey[ForcesTask] = SectionKey("forces")


def joined(others: OtherSections) -> Mapping[str, object]:
    """Return what of the other sections acts; an effect that is not named leaves nothing behind."""
    effects, rubbed, mechanism = others["effects"], others["friction"], others.mechanism
    assert mechanism is not None
    return {
        "loads": tuple(timed(load, mechanism.drive, others.row) for load in others["load"] or ()),
        "springs": others["spring"] or (),
        "gravity": effects.gravity,
        "inertia": effects.inertia,
        "gas": others["indicator"] if effects.gas else None,
        "friction": friction(rubbed, mechanism) if effects.friction and rubbed else None,
        "g": kept(GRAVITY, "acceleration") if effects.g is None else effects.g,
    }


def friction(rubbed: Rubbed, mechanism: Mechanism) -> Friction:
    """Return the coefficient and the radius of every pair, its own or the common one."""
    guides = [slide.guide.name for link in mechanism.links for slide in link.slides]
    bodies, joined = (mechanism.frame, *mechanism.links), mechanism.pins
    turning = [k for k in dict.fromkeys(k for link in bodies for k in link.points) if k in joined]
    return Friction(
        {name: rubbed.pairs.get(name, rubbed.f) for name in (*turning, *guides)},
        {name: rubbed.radii.get(name, rubbed.radius or 0.0) for name in turning},
        rubbed.passes,
    )
