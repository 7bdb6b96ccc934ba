"""What is given of a cylinder: the gas on both sides of its piston (SI; drawn lengths in mm)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

from graphic_tmm.board.bounds import Bound
from graphic_tmm.language.said import said
from graphic_tmm.scene import quantities
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Flaw, Kind, Names, Said, Section, combined_key, key
from graphic_tmm.scene.misfits import fault_in_list, stands
from graphic_tmm.scene.tables import DeclaredTable, Several

if TYPE_CHECKING:
    from graphic_tmm.scene.sections import Parts


INDICATOR = "indicator"
VIEW = "indicator"
CALCULATED = "indicator-calculation"
"""The view of what is calculated beside."""


def _pressures(value: object, names: Names) -> tuple[float, ...]:
    if not isinstance(value, list) or not value:
        raise ValueError(
            stands(value, said('write the pressure in each position, ["300 kPa", "240 kPa"]'))
        )
    return tuple(quantities.parse(item, "pressure") for item in value)


def _traced(value: object, names: Names) -> tuple[tuple[float, float], ...]:
    if not isinstance(value, list) or len(value) < 2:
        raise ValueError(
            stands(value, said('write points of the stroke, [[0, "300 kPa"], [1, "60 kPa"]]'))
        )
    found = []
    for item in value:
        if not isinstance(item, list) or len(item) != 2:
            raise ValueError(
                fault_in_list(
                    item, said('a point is a share of the stroke and a pressure, [0.4, "2 bar"]')
                )
            )
        found.append((v.within(item[0]), quantities.parse(item[1], "pressure")))
    return tuple(found)


_PRESSURES = Kind(_pressures, v.ROW, unit="pressure")
_PRESSURE = Kind(lambda value, names: quantities.parse(value, "pressure"), v.SCALE, unit="pressure")
_TRACED = Kind(_traced, v.PAIRS)
_WAY = v.choice("out", "back", туда="out", обратно="back")


@dataclass(frozen=True)
class Traced:
    """An indicator diagram by points: shares of the stroke from the cover, and pressures."""

    out: tuple[tuple[float, float], ...] = key(
        _TRACED,
        "points of the stroke from the cover; two at one share are a jump, the second holds there",
        [[0, "300 kPa"], [1, "60 kPa"]],
    )
    back: tuple[tuple[float, float], ...] = key(
        _TRACED, "points of the stroke back", [[1, "30 kPa"], [0, "150 kPa"]]
    )
    out_2: tuple[tuple[float, float], ...] | None = key(
        _TRACED, "of four strokes the third", [[0, "3 MPa"], [1, "300 kPa"]], None
    )
    back_2: tuple[tuple[float, float], ...] | None = key(
        _TRACED, "of four strokes the fourth", [[1, "120 kPa"], [0, "120 kPa"]], None
    )

    def strokes(self) -> Iterator[tuple[str, str, tuple[tuple[float, float], ...]]]:
        """Yield those that are given, in order: their keys, which way they go, their points."""
        for name in ("out", "back", "out_2", "back_2"):
            points = getattr(self, name)
            if points is not None:
                yield name, name.removesuffix("_2"), points


@dataclass(frozen=True)
class Stroke:
    """A polytropic part of an indicator diagram; it begins where the part before it ended."""

    stroke: str = key(_WAY, "out, from the cover, or back", "out")
    to: float = key(v.WITHIN, "the share of the stroke at which it ends", 0.3)
    p: float = key(_PRESSURE, "the pressure at which it begins", "600 kPa")
    n: float = key(
        v.number(Bound(0, 3)), "exponent of p·V^n = const; 0 for a constant pressure", 1.2
    )


@dataclass(frozen=True)
class Stretch:
    """A part of an indicator diagram: on the stroke "out" (from the cover) or "back", between two shares of it.

    Shares are counted from the cover, 0 … 1; equal ones are a jump. From ``pressure`` (Pa) at ``start`` it
    follows p·V^``exponent`` = const, or a straight line to ``last`` (Pa) at ``end``. ``turn``: of the crank,
    from 0, on which it stands.
    """

    stroke: str
    start: float
    end: float
    pressure: float
    exponent: float | None = None
    last: float = 0.0
    turn: int = 0


@dataclass(frozen=True)
class Gas:
    """The pressure on one side of a piston over the diameter ``bore`` (m).

    ``pressures`` (Pa) at every position of the row; or ``stretches`` of the two strokes, all polytropic or all
    straight, with the ``clearance`` as a share of the stroke. ``rod``: the diameter (m) of a rod that passes
    through that side; 0 for none.
    """

    pressures: tuple[float, ...]
    bore: float
    rod: float = 0.0
    stretches: tuple[Stretch, ...] = ()
    clearance: float = 0.0

    @property
    def even(self) -> bool:
        """Whether the pressure is the same all the time, as that of the air."""
        parts = self.stretches
        bent = any(part.exponent for part in parts if part.exponent is not None)
        ends = [p for part in parts if part.exponent is None for p in (part.pressure, part.last)]
        steady = [part.pressure for part in parts if part.exponent is not None]
        return not bent and len({*self.pressures, *ends, *steady}) == 1


def _gas(side: str) -> Callable[[Said], Gas | None]:
    """Return what makes the gas of one side of the piston; None if nothing is said of it."""

    def make(said: Said) -> Gas | None:
        pressures, traced = getattr(said, side), getattr(said, f"{side}_points")
        rod = (said.rod or 0.0) if side == "shaft" else 0.0
        if pressures is not None:
            return Gas(pressures, said.bore, rod)
        found = _polytropic(getattr(said, f"{side}_strokes"), said.strokes // 2)
        found = _straight(traced) if traced is not None else found
        return Gas((), said.bore, rod, found, said.clearance) if found else None

    return make


def _straight(traced: Traced) -> tuple[Stretch, ...]:
    return tuple(
        Stretch(way, a, b, p, None, q, turn=int(name != way))
        for name, way, points in traced.strokes()
        for (a, p), (b, q) in pairwise(points)
    )


def _by_turns(parts: tuple[Stroke, ...], turns: int) -> list[list[Stroke]]:
    """Return parts turn by turn: of four strokes the second turn begins with the second stroke out."""
    found: list[list[Stroke]] = [[]]
    for part in parts:
        before = found[-1][-1].stroke if found[-1] else ""
        if turns > 1 and (before, part.stroke) == ("back", "out"):
            found.append([])
        found[-1].append(part)
    return found


def _polytropic(strokes: tuple[Stroke, ...], turns: int) -> tuple[Stretch, ...]:
    found = []
    for turn, parts in enumerate(_by_turns(strokes, turns)):
        reached = {"out": 0.0, "back": 1.0}
        for part in parts:
            start, reached[part.stroke] = reached[part.stroke], part.to
            found.append(Stretch(part.stroke, start, part.to, part.p, part.n, turn=turn))
    return tuple(found)


_POINTS = "the same by points of both strokes"
_STROKES = "the same by polytropic strokes, in order"


@dataclass(frozen=True)
class IndicatorTask:
    """The indicator diagram of a cylinder: pressures in the positions of the row.

    The piston's ``point`` slides on the frame. ``cover``: the side away from the crank; ``shaft``: the side
    towards it, None for a single-acting piston. ``strokes``: of the working cycle, 2 a turn of the crank.
    ``base`` is the drawn length of the stroke; ``height`` that of the highest pressure, mm, unless ``mu``
    (Pa/mm) says.
    """

    point: str = key(v.TEXT, "the letter of the piston's point", "B")
    cover: Gas = combined_key(
        _gas("cover"),
        bore=key(v.POSITIVE_LENGTH, "diameter of the cylinder", "120 mm"),
        cover=key(
            _PRESSURES, "pressures on the side away from the crank", ["300 kPa", "240 kPa"], None
        ),
        cover_points=key(DeclaredTable(Traced), _POINTS, default=None),
        cover_strokes=key(Several(DeclaredTable(Stroke)), _STROKES, default=()),
    )
    shaft: Gas | None = combined_key(
        _gas("shaft"),
        None,
        shaft=key(_PRESSURES, "pressures on the side towards the crank", default=None),
        shaft_points=key(DeclaredTable(Traced), _POINTS, default=None),
        shaft_strokes=key(Several(DeclaredTable(Stroke)), _STROKES, default=()),
        clearance=key(v.WITHIN, "clearance as a share of the stroke", 0.08, 0.0),
        rod=key(v.POSITIVE_LENGTH, "diameter of the rod on that side", "30 mm", None),
    )
    strokes: int = key(
        v.number(Bound(2, 4, whole=True)),
        "strokes of the working cycle: 4 of an engine that fires every second turn",
        4,
        2,
    )
    base: float = key(v.DRAWN, "drawn length of the stroke", "100 mm", 100.0, fixes="size")
    height: float = key(v.DRAWN, "room for the highest pressure", "100 mm", 100.0, fixes="size")
    mu: float | None = key(
        v.mu("scale of pressures"), "Pa/mm", "1500 Pa/mm", None, written="mu_p", fixes="size"
    )

    @property
    def turns(self) -> int:
        """How many turns of the crank the working cycle takes."""
        return self.strokes // 2

    @property
    def highest(self) -> float:
        """The highest pressure that is given, Pa."""
        sides = [side for side in (self.cover, self.shaft) if side is not None]
        told = [p for side in sides for p in side.pressures]
        parts = [part for side in sides for part in side.stretches]
        return max(told + [max(part.pressure, part.last) for part in parts])


class Wish(NamedTuple):
    """A cylinder that a chapter needs; of several the one of the highest ``rank`` shows its diagram."""

    rank: int
    by: str
    order: IndicatorTask


def check(asked: Said, parts: Parts) -> Iterator[Flaw]:
    """Every contradiction of the section: pressures told twice or not at all, a rod without its side."""
    yield from parts.moves(("indicator", "point"), asked.point)
    turns = asked.strokes // 2
    count = parts.drive.count * turns if parts.drive is not None else None
    yield from _cycle(asked, parts)
    for side in ("cover", "shaft"):
        told = [k for k in (side, f"{side}_points", f"{side}_strokes") if getattr(asked, k)]
        for other in told[1:]:
            says = said(
                "{key} gives the pressures of that side already; leave one of them out", key=told[0]
            )
            yield Flaw(("indicator", other), says)
        if side == "cover" and not told:
            says = said(
                'it is missing; write the pressures, ["300 kPa", ...], or cover_points, or cover_strokes'
            )
            yield Flaw(("indicator", "cover"), says)
        yield from _turns(asked, side)
        yield from _strokes(asked, side)
        given = getattr(asked, side)
        if given is not None and count is not None and len(given) != count:
            says = said(
                "{n} pressures for {count} positions; give one for each, from the first on",
                n=len(given),
                count=count,
            )
            yield Flaw(("indicator", side), says)
    others = asked.shaft or asked.shaft_points or asked.shaft_strokes
    if asked.rod is not None and not others:
        says = said("it matters on the side of the shaft only; write shaft as well")
        yield Flaw(("indicator", "rod"), says)
    if asked.rod is not None and asked.rod >= asked.bore:
        says = said("the rod is as thick as the cylinder; make it thinner")
        yield Flaw(("indicator", "rod"), says)


ONE_TURN = ("diagrams", "engine")
"""Sections whose graphs go over one turn of the crank."""


def _cycle(asked: Said, parts: Parts) -> Iterator[Flaw]:
    """A number of strokes that no cycle has, or that other sections cannot be drawn over."""
    if asked.strokes % 2:
        says = said("a working cycle has 2 strokes or 4; write one of these")
        yield Flaw(("indicator", "strokes"), says)
    for other in ONE_TURN:
        if asked.strokes == 4 and other in parts.doc:
            says = said(
                "four strokes take two turns, and the graphs of [{other}] go over one; give it a scene of "
                "its own",
                other=other,
            )
            yield Flaw(("indicator", "strokes"), says)


def _turns(asked: Said, side: str) -> Iterator[Flaw]:
    """Points that do not go from the cover to the far end and back."""
    traced = getattr(asked, f"{side}_points")
    if traced is None:
        return
    for name in ("out_2", "back_2"):
        if (getattr(traced, name) is not None) != (asked.strokes == 4):
            says = (
                said("four strokes have it, too; write its points")
                if asked.strokes == 4
                else said("only a cycle of four strokes has it; write strokes = 4, or leave it out")
            )
            yield Flaw(("indicator", f"{side}_points", name), says)
    for name, way, points in traced.strokes():
        ends = (0.0, 1.0) if way == "out" else (1.0, 0.0)
        shares = [share for share, _ in points]
        ahead = v.follows(shares if way == "out" else [-share for share in shares])
        if (shares[0], shares[-1]) != ends or not ahead:
            says = said(
                "the shares of the stroke {way} go from {first:g} to {last:g}, one after the other; put them "
                "in order, two at a jump",
                way=way,
                first=ends[0],
                last=ends[1],
            )
            yield Flaw(("indicator", f"{side}_points", name), says)


def _strokes(asked: Said, side: str) -> Iterator[Flaw]:
    """Polytropic parts that do not go from the cover to the far end and back."""
    strokes = getattr(asked, f"{side}_strokes")
    turns, before = _by_turns(strokes, asked.strokes // 2), 0
    for parts in turns:
        yield from _of_turn(parts, side, before)
        before += len(parts)
    if strokes and asked.strokes == 4 and len(turns) != 2:
        says = said(
            "four strokes are wanted, one after the other: out, back, out and back again; there are {n}",
            n=2 * len(turns),
        )
        yield Flaw(("indicator", f"{side}_strokes"), says)
    if any(part.n > 0 for part in strokes) and not asked.clearance > 0:
        says = said(
            "gas that is expanded or compressed needs the clearance; write clearance = 0.08"
        )
        yield Flaw(("indicator", "clearance"), says)


def _of_turn(parts: list[Stroke], side: str, before: int) -> Iterator[Flaw]:
    """The same of the parts of one turn; so many stand ``before`` them."""
    reached = {"out": 0.0, "back": 1.0}
    for i, part in enumerate(parts, before):
        if (part.to - reached[part.stroke]) * (1 if part.stroke == "out" else -1) <= 0:
            says = said(
                "the stroke {way} has come to {share:g} already; go on from there",
                way=part.stroke,
                share=reached[part.stroke],
            )
            yield Flaw(("indicator", f"{side}_strokes", i, "to"), says)
        reached[part.stroke] = part.to
    if parts and reached != {"out": 1.0, "back": 0.0}:
        says = said(
            "the parts of the stroke out have to end at 1, those of the stroke back at 0; add the last part"
        )
        yield Flaw(("indicator", f"{side}_strokes"), says)


def _idle(asked: Said, parts: Parts) -> Iterator[str]:
    effects, doc = parts.said["effects"], parts.doc
    gas = effects is not None and effects.gas and "forces" in doc
    if not (gas or "flywheel" in doc or "engine" in doc):
        yield said(
            "indicator: nothing asks for the gas; add [flywheel] or [engine], or gas = true in [effects] with "
            "[forces], or take [indicator] out"
        )


SECTIONS = (
    Section(
        "indicator", IndicatorTask, "the indicator diagram of a cylinder",
        alone=True, gives=True, check=check, idle=_idle,
    ),
)  # fmt: skip
