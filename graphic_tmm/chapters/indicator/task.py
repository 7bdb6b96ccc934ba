"""What is given of a cylinder: the gas on both sides of its piston (SI; drawn lengths in mm)."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import NamedTuple

from graphic_tmm.board.bounds import Bound
from graphic_tmm.language.said import said
from graphic_tmm.scene import quantities
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Kind, Names, Said, combined_key, key
from graphic_tmm.scene.misfits import fault_in_list, stands
from graphic_tmm.scene.tables import DeclaredTable, Several

INDICATOR = "indicator"
VIEW = "indicator"
SIDES = ("cover", "shaft")
TURN = 360.0
"""A turn of the crank, degrees."""
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
        if said.same_as is not None:
            return Gas((), said.bore or 0.0) if side == "cover" else None
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


def by_turns(parts: tuple[Stroke, ...], turns: int) -> list[list[Stroke]]:
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
    for turn, parts in enumerate(by_turns(strokes, turns)):
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
    towards it, None for a single-acting piston. ``strokes``: of the working cycle, 2 a turn of the crank;
    ``phase``: how much later than at the piston's own first dead centre the cycle begins, degrees.
    ``base`` is the drawn length of the stroke; ``height`` that of the highest pressure, mm, unless ``mu``
    (Pa/mm) says. ``same_as``: the piston whose pressures these are. ``further``: the other cylinders.
    """

    point: str = key(v.LETTER, "the letter of the piston's point", "B")
    cover: Gas = combined_key(
        _gas("cover"),
        bore=key(
            v.POSITIVE_LENGTH,
            "diameter of the cylinder; left out only where same_as gives it",
            "120 mm",
            None,
        ),
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
    phase: float = key(
        v.ANGLE,
        "of several cylinders: how much later its cycle begins than at its own first dead centre",
        "360 deg",
        0.0,
    )
    same_as: str = combined_key(
        lambda said: said.same_as or "",
        "",
        same_as=key(
            v.LETTER,
            "of several cylinders: the point of the piston whose pressures it has",
            "B",
            None,
        ),
    )
    base: float = key(
        v.DRAWN, "drawn length of the stroke; same_as gives it, too", "100 mm", 100.0, fixes="size"
    )
    height: float = key(
        v.DRAWN,
        "room for the highest pressure; same_as gives it, too",
        "100 mm",
        100.0,
        fixes="size",
    )
    mu: float | None = key(
        v.mu("scale of pressures"), "Pa/mm", "1500 Pa/mm", None, written="mu_p", fixes="size"
    )

    further: tuple[IndicatorTask, ...] = ()

    @property
    def every(self) -> tuple[IndicatorTask, ...]:
        """All cylinders in the order of the scene, each by itself."""
        return (replace(self, further=()), *self.further)

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


def together(orders: tuple[IndicatorTask, ...]) -> IndicatorTask:
    """Return the first cylinder with the others; one that has the pressures of another is given them."""
    by_point = {order.point: order for order in reversed(orders)}
    first, *others = (_filled(order, by_point) for order in orders)
    return replace(first, further=tuple(others))


def mapped(order: IndicatorTask, change: Callable[[IndicatorTask], IndicatorTask]) -> IndicatorTask:
    """Return all cylinders changed alike."""
    first, *others = map(change, order.every)
    return replace(first, further=tuple(others))


def _filled(order: IndicatorTask, by_point: Mapping[str, IndicatorTask]) -> IndicatorTask:
    if not order.same_as:
        return order
    of = by_point[order.same_as]
    unsaid = {
        name: getattr(of, name)
        for name in ("base", "height", "mu")
        if getattr(order, name) == getattr(IndicatorTask, name)
    }
    bore, shaft = order.cover.bore or of.cover.bore, of.shaft
    if shaft is not None:
        shaft = replace(shaft, bore=bore)
    cover = replace(of.cover, bore=bore)
    return replace(order, cover=cover, shaft=shaft, strokes=of.strokes, **unsaid)


ONE_TURN = ("diagrams", "engine")
"""Sections whose graphs go over one turn of the crank."""
