"""The inertia of several cylinders on the board: cranks, polygons of both orders, what remains of them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import to_board
from graphic_tmm.board.operations.instruments import lay_off, place, ray
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number, Point
from graphic_tmm.chapters.cylinders import formulas as f
from graphic_tmm.chapters.cylinders import words as why
from graphic_tmm.chapters.cylinders.task import ASKED, CYLINDERS, Cylinder, CylindersTask
from graphic_tmm.chapters.cylinders.words import (
    ALONE,
    DIRECT,
    KINDS,
    REVERSE,
    ROMAN,
    SHAFT,
    STAR,
    view_of,
)
from graphic_tmm.chapters.rotors.polygon import Polygon, Vector, draw_polygon, turned
from graphic_tmm.project import Bench
from graphic_tmm.scene.chapter import Recorded

MU_F, MU_M = ("μ_F", "N/mm"), ("μ_M", "N·m/mm")
SIGNS = {ALONE: "", DIRECT: "+", REVERSE: "−"}
REST = "cylinders rest"
"""The view of what is calculated of the polygons."""


class Row(NamedTuple):
    """A cylinder: its number, angle of crank and axis, place; by order and way the angle of its vector.

    ``moments``: by order, of a vector (half the moment where there are banks). ``of``: what was asked.
    """

    number: str
    crank: Mark
    axis: Mark | None
    place: Mark
    angles: dict[str, Mark]
    moments: dict[str, Mark]
    of: Cylinder


class Rest(NamedTuple):
    """What remains: greatest and least (Number), at which turn of the shaft it is greatest (Angle).

    ``size`` None: nothing. Without ``at`` it keeps its size; it ``turns`` as the shaft does, or against it.
    """

    kind: str
    size: Mark | None
    least: Mark | None = None
    at: Mark | None = None
    turns: bool = False


class Inertia(NamedTuple):
    """An engine as drawn: its cylinders, its polygons by view, what remains by kind.

    ``orders``: force of a cylinder of the first order and the second. ``pins``, ``stations``: by the numbers of
    their cylinders, as they stand along the shaft and from the side; ``scales`` of both views.
    """

    order: CylindersTask
    rows: tuple[Row, ...]
    orders: tuple[Mark, Mark]
    polygons: dict[str, Polygon]
    rests: dict[str, Rest]
    pins: dict[str, Mark]
    stations: dict[str, Mark]
    scales: dict[str, Mark]


CYLINDERS_PLAN: Recorded[Inertia] = Recorded(CYLINDERS)


def record(bench: Bench) -> Inertia | None:
    """Draw the inertia of the cylinders."""
    order = ASKED.of(bench.scene)
    if order is None:
        return None
    draft = bench.draft
    draft.open(CYLINDERS)
    orders = _orders(draft, order)
    crank = draft.take(Number, "r", order.crank, "m")
    sizes = [draft.draw(f.half_of_force, f"F_{{{n}}}/2", one, unit="N") for n, one in
             zip(ROMAN.values(), orders, strict=True)] if order.banked else list(orders)  # fmt: skip
    rows = tuple(
        _row(draft, str(k), one, sizes, banked=order.banked) for k, one in enumerate(order.each, 1)
    )
    scales: dict[str, Mark] = {}
    scales[STAR], pins = _draw_star(draft, rows, crank)
    scales[SHAFT], stations = _draw_shaft(draft, rows, crank)
    polygons: dict[str, Polygon] = {}
    exact = order.mass * order.crank * order.speed**2 * (0.5 if order.banked else 1.0)
    ways = (DIRECT, REVERSE) if order.banked else (ALONE,)
    for kind in KINDS:
        size = exact if kind[1] == "1" else exact * order.crank / order.rod
        for way in ways:
            vectors = [_vector(row, kind, way, (sizes, size)) for row in rows]
            letter = f"{kind[0]}_{{{ROMAN[kind[1]]}{SIGNS[way]}}}"
            mu = MU_F if kind[0] == "F" else MU_M
            made = draw_polygon(draft, view_of(kind, way), mu, vectors, letter, total=True)
            if made is not None:
                polygons[made.view] = made
    draft.open(REST)
    rests = {kind: _rest(draft, kind, polygons, banked=order.banked) for kind in KINDS}
    return Inertia(order, rows, orders, polygons, rests, pins, stations, scales)


def _orders(draft: Draft, order: CylindersTask) -> tuple[Mark, Mark]:
    """Calculate the forces of inertia of a cylinder, of the first order and the second."""
    mass = draft.take(Number, "m", order.mass, "kg")
    crank, rod = (draft.constant(*one, "m") for one in (("r", order.crank), ("l", order.rod)))
    omega = draft.take(Number, "ω_1", abs(order.speed), "1/s")
    ratio = draft.draw(f.crank_to_rod, "λ", crank, rod)
    first = draft.draw(f.force_of_first_order, "F_{I}", mass, crank, omega, unit="N")
    return first, draft.draw(f.force_of_second_order, "F_{II}", first, ratio, unit="N")


def _row(draft: Draft, number: str, one: Cylinder, sizes: Sequence[Mark], *, banked: bool) -> Row:
    crank, axis = draft.angle(f"θ_{{{number}}}", one.crank), None
    if banked:
        axis = draft.angle(f"ψ_{{{number}}}", one.axis)
        ops = {
            f"1{DIRECT}": (f.along_crank, (crank,)), f"1{REVERSE}": (f.mirrored_in_axis, (axis, crank)),
            f"2{DIRECT}": (f.direct_at_twice, (axis, crank)),
            f"2{REVERSE}": (f.mirrored_at_twice, (axis, crank)),
        }  # fmt: skip
    else:
        ops = {f"1{ALONE}": (f.along_crank, (crank,)), f"2{ALONE}": (f.at_twice, (crank,))}
    angles = {}
    for name, (op, uses) in ops.items():
        letter = f"α_{{{ROMAN[name[0]]}{number}{SIGNS[name[1:]]}}}"
        angles[name] = draft.draw(op, letter, *uses, unit="°")
    at = draft.take(Number, f"z_{{{number}}}", one.place, "m")
    moments = {
        n: draft.draw(f.moment_about_middle, f"M_{{{ROMAN[n]}{number}}}", size, at, unit="N·m")
        for n, size in zip(ROMAN, sizes, strict=True)
    }
    return Row(number, crank, axis, at, angles, moments, one)


def _vector(row: Row, kind: str, way: str, of: tuple[Sequence[Mark], float]) -> Vector:
    """Return the vector of a cylinder in a polygon; ``of``: sizes of both orders, exactly that of this one."""
    sizes, exact = of
    n = int(kind[1])
    crank, axis, along = row.of
    degrees = n * crank - (n - 1) * axis if way != REVERSE else (n + 1) * axis - n * crank
    if kind[0] == "M":
        size, exact = row.moments[kind[1]], exact * along
    else:
        size = sizes[n - 1]
    return Vector(
        f"{kind[0]}_{{{row.number}}}", size, row.angles[f"{n}{way}"], turned(exact, 90.0 + degrees)
    )


def _draw_star(draft: Draft, rows: Sequence[Row], crank: Mark) -> tuple[Mark, dict[str, Mark]]:
    """Draw the cranks as seen along the shaft."""
    draft.open(STAR)
    mu = draft.scale("μ_l", "m/mm")
    centre = draft.take(Point, "O", 0j)
    draft.lay_out(centre)
    size = draft.draw(to_board, "OA", crank, mu)
    found = {}
    for row in rows:
        angle = row.angles["1"] if row.axis is None else row.angles[f"1{DIRECT}"]
        line = draft.draw(ray, f"(O{row.number})", centre, angle, why=why.PIN)
        found[row.number] = draft.draw(lay_off, row.number, line, size, why=why.PIN)
    return mu, found


def _draw_shaft(draft: Draft, rows: Sequence[Row], crank: Mark) -> tuple[Mark, dict[str, Mark]]:
    """Draw the pins as seen from the side, each as high as its crank reaches up."""
    draft.open(SHAFT)
    mu = draft.scale("μ_l", "m/mm")
    middle = draft.take(Point, "O", 0j)
    draft.lay_out(middle)
    axis = draft.draw(ray, "(z)", middle, draft.direction(0.0), why=why.LINE)
    found = {}
    for row in rows:
        x = draft.draw(to_board, f"z_{row.number}′", row.place, mu)
        up = draft.draw(f.upright_part, f"h_{row.number}", crank, row.crank, unit="m")
        y = draft.draw(to_board, f"h_{row.number}′", up, mu)
        found[row.number] = draft.draw(place, row.number, axis, x, y, why=why.STATION)
    return mu, found


def _rest(draft: Draft, kind: str, polygons: dict[str, Polygon], *, banked: bool) -> Rest:
    """Calculate what remains of a kind, and when it is greatest."""
    index = ROMAN[kind[1]]
    twice = kind[1] == "2"
    there = [polygons.get(view_of(kind, way)) for way in SIGNS]
    left = [one for one in there if one is not None and one.angle is not None]
    if not left:
        return Rest(kind, None)
    at = f"φ_{{{kind[0]}{index}}}"
    first = left[0]
    assert first.angle is not None
    if not banked:
        op = f.half_turn_to_axis if twice else f.turn_to_axis
        return Rest(kind, first.size, None, draft.draw(op, at, first.angle, unit="°"))
    if len(left) < 2:
        return Rest(kind, first.size, first.size, turns=first.view == view_of(kind, DIRECT))
    both = [one.size for one in left]
    unit = first.size.unit
    letter = f"{kind[0]}_{{{index}"
    most = draft.draw(f.greatest_of_both, f"{letter}max}}", *both, unit=unit)
    small = draft.draw(f.least_of_both, f"{letter}min}}", *both, unit=unit)
    angles = [one.angle for one in left if one.angle is not None]
    op = f.half_turn_to_meet if twice else f.turn_to_meet
    return Rest(kind, most, small, draft.draw(op, at, *angles, unit="°"))
