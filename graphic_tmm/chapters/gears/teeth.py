"""The teeth of a wheel: how many points are rolled, its flank, thickness, fillet, three teeth."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import abscissa, to_board
from graphic_tmm.board.operations.instruments import incline, join, lay_off, measure, square
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number, Reals
from graphic_tmm.chapters.gears import words as why
from graphic_tmm.chapters.gears.dimensions import GearSizes, RackCut, WheelSizes
from graphic_tmm.chapters.gears.formulas import half_of
from graphic_tmm.chapters.gears.line import ActionLine, Circles
from graphic_tmm.chapters.gears.rack import ray_of_rounding, reach_of_ray, rolled_of_ray
from graphic_tmm.chapters.gears.rolling import (
    along_arc,
    beginning,
    curve_meets_arc,
    curves_cross,
    reflect,
    smooth_through,
    turn_about,
)

STATIONS = 13
"""Stations of a curve of specific sliding."""


@dataclass(frozen=True)
class Roll:
    """A flank: its string to the tip has ``parts`` parts; ``count`` points are rolled, from ``first`` on."""

    parts: int
    first: int
    count: int


@dataclass(frozen=True)
class Rows:
    """The rows of a gear pair along the one axis of positions: its length, both flanks, points of a fillet."""

    axis: int
    flanks: tuple[Roll, ...]
    fillet: int

    def row(self, values: object) -> Reals:
        """Return the values of a row, (1, position); what stands behind them is missing."""
        given = np.asarray(values, dtype=np.float64)
        return np.concatenate([given, np.full(self.axis - given.size, np.nan)])[None, :]


def choose_rows(sizes: GearSizes, value: Callable[[Mark], float]) -> Rows:
    """Choose how the flanks are rolled; ``value``: of a calculated mark."""
    steps, flanks = sizes.order.steps, tuple(_roll(one, sizes, value) for one in sizes.wheels)
    counts = (*(flank.count for flank in flanks), steps + 1, STATIONS, len(sizes.order.stations))
    return Rows(max(counts), flanks, steps + 1)


def _roll(wheel: WheelSizes, sizes: GearSizes, value: Callable[[Mark], float]) -> Roll:
    """Divide the string to the tip so that the steps go from below the fillet to beyond the tip.

    Inside go the pitch circle too, where the thickness is laid off, and the lowest working point. A ring's goes
    to its root.
    """
    tip = value(wheel.r_b) * math.tan(math.radians(value(wheel.alpha_a)))
    whole = tip if wheel.cut else math.sqrt(value(wheel.r_f) ** 2 - value(wheel.r_b) ** 2)
    pitch = value(wheel.r) * math.sin(math.radians(value(sizes.alpha)))
    limit = value(wheel.cut.limit) if wheel.cut else 0.0
    inside = (tip, pitch, max(value(wheel.lowest), 0.0), max(limit, 0.0))
    low, high = min(inside), max(*inside, whole)
    parts = max(1, math.floor(sizes.order.steps * whole / (high - low)))
    first = max(0, math.floor(low / whole * parts) - 1)
    last = math.ceil(high / whole * parts) + 1
    return Roll(parts, first, last - first + 1)


UNDERCUT = 0.01
"""The depth of an undercut goes with |ρ_l|³/r², about an eighth of it; below so many modules none is seen."""


@dataclass(frozen=True)
class Flank:
    """One side of a tooth: the flank and its fillet (Curve), where the flank begins, and ends.

    A ring's has no fillet: it begins at the root.
    """

    flank: Mark
    fillet: Mark | None
    start: Mark
    tip: Mark


@dataclass(frozen=True)
class Tooth:
    """A tooth: its sides as seen from the wheel's centre; the right one drives, or is driven.

    Of a ring all is mirrored: its right side is that which a wheel's right side drives.
    """

    right: Flank
    left: Flank

    @property
    def marks(self) -> tuple[Mark, ...]:
        """What its outline stands on."""
        sides = (self.right, self.left)
        marks = (mark for s in sides for mark in (s.flank, s.fillet, s.start, s.tip))
        return tuple(mark for mark in marks if mark)


@dataclass(frozen=True)
class Wheel:
    """A wheel as drawn: the rolling of its flank (rows), thickness laid off, three teeth.

    ``origin``: where the involute through the pitch point begins on the base circle; ``feet``: of the
    tangents, ``points``: of the involute. ``at_pitch``: where the flank crosses the pitch circle, ``middle`` of
    the tooth there, ``axis`` of the tooth (Line). ``corner``: of the flank with the tip circle. ``teeth``: from
    left to right, of a ring from right to left; the flank of the middle one passes through the pitch point.
    """

    sizes: WheelSizes
    circles: Circles
    roll: Roll
    origin: Mark
    feet: Mark
    points: Mark
    flank: Mark
    at_pitch: Mark
    middle: Mark
    axis: Mark
    corner: Mark
    teeth: tuple[Tooth, Tooth, Tooth]


class _Spots(NamedTuple):
    """What a side of a tooth is drawn by: points of its flank and of its fillet (rows), beginning, end."""

    flank: Mark
    fillet: Mark | None
    start: Mark
    tip: Mark


def draw_wheel(
    draft: Draft,
    k: int,
    sizes: GearSizes,
    line: ActionLine,
    rows: Rows,
    value: Callable[[Mark], float],
) -> Wheel:
    """Draw three teeth of wheel ``k`` (0 or 1).

    ``value``: of a calculated mark; by it a tooth is known to be undercut, or pointed.
    """
    wheel, circles = sizes.wheels[k], line.circles[k]
    i, roll, left_ = wheel.number, rows.flanks[k], 1 if wheel.cut else -1
    origin, feet, points = _involute(draft, k, line, rows)
    curve = draft.draw(smooth_through, f"(E_{i})", points, row=roll.count, why=why.INVOLUTE)
    at_pitch = draft.draw(curve_meets_arc, f"D_{{{i}}}", curve, circles.pitch)
    thickness = draft.draw(to_board, f"[s_{i}]", wheel.s)
    half = draft.draw(half_of, f"[s_{i}]/2", thickness)
    middle = draft.draw(
        along_arc, f"M_{{{i}}}", at_pitch, circles.pitch, half, sense=left_, why=why.TOOTH_AXIS
    )
    axis = draft.draw(join, f"(O_{i}M_{i})", circles.centre, middle, why=why.TOOTH_AXIS)
    fillet = bends = None
    if wheel.cut is None:
        start = draft.draw(curve_meets_arc, f"L_{{{i}}}", curve, circles.root)
    else:
        bends = _fillet(draft, k, sizes, wheel.cut, line, rows, middle)
        fillet = draft.draw(smooth_through, f"(K_{i})", bends, row=rows.fillet, why=why.FILLET)
        limit = value(wheel.cut.limit)
        start = _start(draft, wheel, (curve, fillet, origin), (limit, value(wheel.r)), sizes)
    corner = origin
    if wheel.top is not wheel.r_b:
        corner = draft.draw(curve_meets_arc, f"A_{{{i}}}", curve, circles.tip)
    right = _Spots(points, bends, start, corner)
    left = _reflected(draft, right, axis)
    mirrored = _curves(draft, left, i, (roll.count, rows.fillet))
    if value(wheel.s_a) < 0.0:
        apex = draft.draw(curves_cross, f"V_{{{i}}}", curve, mirrored[0])
        right, left = right._replace(tip=apex), left._replace(tip=apex)
    sides = (
        Flank(curve, fillet, right.start, right.tip),
        Flank(*mirrored, left.start, left.tip),
    )
    counts = (roll.count, rows.fillet)
    teeth = (
        _next_tooth(draft, (right, left), wheel, circles, counts, sense=left_),
        Tooth(*sides),
        _next_tooth(draft, (right, left), wheel, circles, counts, sense=-left_),
    )
    for tooth in teeth:
        draft.figure("tooth", str(i), *tooth.marks)
    return Wheel(
        wheel, circles, roll, origin, feet, points, curve, at_pitch, middle, axis, corner, teeth
    )


def _reflected(draft: Draft, side: _Spots, axis: Mark) -> _Spots:
    """Mirror a side of a tooth."""
    marks = (mark and draft.draw(reflect, f"{mark.name}′", mark, axis, free=True) for mark in side)
    return _Spots(*marks)  # type: ignore[arg-type]


def _start(
    draft: Draft,
    wheel: WheelSizes,
    drawn: tuple[Mark, Mark, Mark],
    at: tuple[float, float],
    sizes: GearSizes,
) -> Mark:
    """Mark where the flank begins: at the fillet's beginning, or, undercut, where the fillet crosses it.

    ``drawn``: the flank, the fillet, the beginning of the involute, where a flank begins whose cut is not seen.
    ``at``: the radius of curvature where the flank begins, and the pitch radius.
    """
    (curve, fillet, origin), (limit, r) = drawn, at
    letter = f"L_{{{wheel.number}}}"
    if limit >= 0.0:
        return draft.draw(beginning, letter, fillet)
    if -(limit**3) > UNDERCUT * sizes.order.m * r**2:
        return draft.draw(curves_cross, letter, fillet, curve)
    return origin


def _next_tooth(
    draft: Draft,
    sides: tuple[_Spots, _Spots],
    wheel: WheelSizes,
    circles: Circles,
    counts: tuple[int, int],
    *,
    sense: int,
) -> Tooth:
    """Draw the tooth one pitch to the left (``sense`` 1) of the middle one, or to its right (−1)."""
    name, flanks = "^{+}" if sense > 0 else "^{−}", []
    for side in sides:
        turn = (circles.centre, wheel.angular_pitch)
        turned = (
            mark
            and draft.draw(turn_about, f"{mark.letter}{name}", mark, *turn, sense=sense, free=True)
            for mark in side
        )
        spots = _Spots(*turned)  # type: ignore[arg-type]
        flanks.append(Flank(*_curves(draft, spots, wheel.number, counts), spots.start, spots.tip))
    return Tooth(flanks[0], flanks[1])


def _involute(draft: Draft, k: int, line: ActionLine, rows: Rows) -> tuple[Mark, Mark, Mark]:
    """Roll the tangent N-P on the base circle: arcs of the circle laid off on its tangents.

    Returns where the involute begins, the feet of the tangents and the points of the involute (rows). The
    string from N to the tip circle is divided evenly, so that one of the points stands on it.
    """
    circles, roll = line.circles[k], rows.flanks[k]
    i, limit, end = k + 1, line.limits[k], line.tips[1 - k]
    string = (
        line.to_pole
        if k == 0
        else draft.draw(measure, f"N_{i}P", limit, line.pole, why=why.UNROLLED)
    )
    origin = draft.draw(
        along_arc, f"B_{{0{i}}}", limit, circles.base, string, sense=-1, why=why.UNROLLED
    )
    whole = line.to_ends.get(end) if k == 0 else None
    if whole is None:
        whole = draft.draw(measure, f"N_{{{i}}}{end.letter}", limit, end, why=why.UNROLLED)
    parts = draft.take(Number, f"k_{i}", float(roll.parts))
    n = draft.take(Number, f"n_{i}", rows.row(np.arange(roll.first, roll.first + roll.count)))
    unrolled = draft.draw(abscissa, f"u_{i}", n, whole, parts, why=why.ROLLED)
    feet = draft.draw(along_arc, f"B_{{{i}}}", origin, circles.base, unrolled, sense=1)
    radii = draft.draw(join, f"(O_{i}B_{i})", circles.centre, feet, why=why.TANGENT)
    tangents = draft.draw(square, f"(B_{i}E_{i})", feet, radii, sense=-1, why=why.TANGENT)
    return (
        origin,
        feet,
        draft.draw(lay_off, f"E_{{{i}}}", tangents, unrolled, why=why.INVOLUTE_POINT),
    )


def _fillet(
    draft: Draft,
    k: int,
    sizes: GearSizes,
    cut: RackCut,
    line: ActionLine,
    rows: Rows,
    middle: Mark,
) -> Mark:
    """Find points of the fillet that the rounding of the rack leaves beside the middle tooth (a row).

    The rack's pitch line rolls on the pitch circle; where it touches, the normal of the contact passes.
    """
    circles, i = line.circles[k], k + 1
    pitch = draft.draw(to_board, f"[p]_{i}", sizes.p)
    half = draft.draw(half_of, f"[p]_{i}/2", pitch)
    space = draft.draw(along_arc, f"W_{{{i}}}", middle, circles.pitch, half, sense=-1)
    n = draft.take(Number, f"j_{i}", rows.row(np.arange(rows.fillet)))
    parts = draft.take(Number, f"k_{{F{i}}}", float(rows.fillet - 1))
    phi = draft.draw(ray_of_rounding, f"φ_{i}", sizes.alpha, n, parts)
    reals = ((cut.rack.offset, "e_{F}"), (cut.depth, "d_{F}"), (cut.rack.rounding, "ρ_{f}"))
    offset, depth, rho = (draft.draw(to_board, f"[{name}]_{i}", m) for m, name in reals)
    rolled = draft.draw(rolled_of_ray, f"t_{i}", offset, depth, phi)
    reach = draft.draw(reach_of_ray, f"l_{i}", depth, phi, rho)
    touching = draft.draw(along_arc, f"T_{{{i}}}", space, circles.pitch, rolled, sense=1)
    radii = draft.draw(join, f"(O_{i}T_{i})", circles.centre, touching, why=why.FILLET_POINT)
    tangents = draft.draw(square, f"(T_{i})", touching, radii, sense=1, why=why.FILLET_POINT)
    normals = draft.draw(incline, f"(T_{i}K_{i})", touching, tangents, phi, why=why.FILLET_POINT)
    return draft.draw(lay_off, f"K_{{{i}}}", normals, reach, why=why.FILLET_POINT)


def _curves(
    draft: Draft, spots: _Spots, i: int, counts: tuple[int, int]
) -> tuple[Mark, Mark | None]:
    """Draw the flank and the fillet through their points."""
    flank = draft.draw(smooth_through, f"(E_{i})", spots.flank, row=counts[0])
    if spots.fillet is None:
        return flank, None
    return flank, draft.draw(smooth_through, f"(K_{i})", spots.fillet, row=counts[1])
