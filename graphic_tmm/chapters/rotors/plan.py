"""A rotor on the board: its unbalances, the polygons in each plane, counterweights, reactions of bearings."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import to_board
from graphic_tmm.board.operations.instruments import lay_off, ray
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Number, Point
from graphic_tmm.chapters.rotors import formulas as f
from graphic_tmm.chapters.rotors import words as why
from graphic_tmm.chapters.rotors.polygon import Polygon, Vector, draw_polygon, turned
from graphic_tmm.chapters.rotors.task import ASKED, ROTOR, RotorTask, Unbalance
from graphic_tmm.project import Bench
from graphic_tmm.scene.chapter import Recorded

END, SIDE = "rotor-end", "rotor-side"
"""The views along the axis and across it."""
MOMENTS, FORCES = "rotor-moments", "rotor-forces"
BEARING_MOMENTS, BEARING_FORCES = "rotor-bearing-moments", "rotor-bearing-forces"
"""The polygons of m·r·z and of m·r: of the counterweights, of the bearings."""
MU_D, MU_M = ("μ_D", "kg·m/mm"), ("μ_M", "kg·m²/mm")
ARM = 35.0
"""How far from the axis an unbalance is drawn of which no radius is known, mm."""


class Row(NamedTuple):
    """An unbalance: its number; mass and radius where both are given, m·r, its angle, its place (Number).

    ``distance``, ``moment``: from the first plane of counterweights, where there are two. ``exact``: m·r, SI,
    as a vector; ``place``: along the axis, m.
    """

    number: str
    mass: Mark | None
    radius: Mark | None
    size: Mark
    angle: Mark
    at: Mark | None
    exact: complex
    place: float
    distance: Mark | None = None
    moment: Mark | None = None

    @property
    def vector(self) -> Vector:
        """Its m·r."""
        return Vector(self.size.letter, self.size, self.angle, self.exact)


class Held(NamedTuple):
    """What a plane wants: its name, m·r and its angle as read off; None where it wants nothing.

    ``mass``, ``radius`` of a counterweight there; ``force``: the reaction of a bearing.
    """

    name: str
    size: Mark | None
    angle: Mark | None
    mass: Mark | None = None
    radius: Mark | None = None
    force: Mark | None = None


class Rotor(NamedTuple):
    """A rotor as drawn.

    ``rows``: its unbalances; ``planes`` of counterweights and ``bearings`` along the axis (Number) by name.
    ``polygons`` by view; ``weights``: the counterweights, ``reactions`` of bearings. ``spots``: in the view
    along the axis masses by name, ``stations``: places in the view across it. ``scales``: of both views.
    ``reach``: the largest radius and the length along the axis, m; ``apart``: z of plane II.
    """

    order: RotorTask
    rows: tuple[Row, ...]
    planes: dict[str, Mark]
    bearings: dict[str, Mark]
    polygons: dict[str, Polygon]
    weights: tuple[Held, ...]
    reactions: tuple[Held, ...]
    spots: dict[str, Mark]
    stations: dict[str, Mark]
    scales: dict[str, Mark]
    reach: tuple[float, float]
    apart: Mark | None = None

    @property
    def views(self) -> tuple[str, ...]:
        """The views that have a scale factor, in the order in which they are begun."""
        return (*self.scales, *self.polygons)


ROTOR_PLAN: Recorded[Rotor] = Recorded("rotors")


def record(bench: Bench) -> Rotor | None:
    """Draw a rotor and balance it."""
    order = ASKED.of(bench.scene)
    if order is None:
        return None
    draft = bench.draft
    draft.open(ROTOR)
    rows = tuple(_row(draft, k, one) for k, one in enumerate(order.unbalances, 1))
    names = ("I", "II") if order.dynamic else ("k",)
    planes = {
        name: draft.take(Number, f"x_{{{name}}}", place, "m")
        for name, place in zip(names, order.planes, strict=False)
    }
    bearings = {
        name: draft.take(Number, f"x_{name}", place, "m")
        for name, place in zip("AB", order.bearings, strict=False)
    }
    scales: dict[str, Mark] = {}
    stations: dict[str, Mark] = {}
    if _along(order):
        scales[SIDE], stations = _draw_side(draft, rows, planes | bearings)
    polygons: dict[str, Polygon] = {}
    apart = None
    if order.dynamic:
        views = MOMENTS, FORCES
        rows, held, apart = _two_planes(draft, rows, (planes, order.planes), views, polygons)
    else:
        held = _one_plane(draft, rows, polygons)
    weights = tuple(_weigh(draft, one, order, k) for k, one in enumerate(held))
    scales[END], spots = _draw_end(draft, rows, weights)
    reactions: tuple[Held, ...] = ()
    if order.bearings and order.speed:
        views = BEARING_MOMENTS, BEARING_FORCES
        _, found, _ = _two_planes(draft, rows, (bearings, order.bearings), views, polygons)
        reactions = _reactions(draft, found, order.speed)
    reach = (_largest_radius(order, weights, polygons), _length(order))
    return Rotor(
        order, rows, planes, bearings, polygons, weights, reactions, spots, stations, scales, reach,
        apart,
    )  # fmt: skip


def _row(draft: Draft, number: int, one: Unbalance) -> Row:
    mass = radius = None
    if one.D is None:
        assert one.mass is not None
        assert one.radius is not None
        mass = draft.take(Number, f"m_{number}", one.mass, "kg")
        radius = draft.take(Number, f"r_{number}", one.radius, "m")
        size = draft.draw(f.unbalance, f"D_{number}", mass, radius, unit="kg·m")
        exact = one.mass * one.radius
    else:
        size, exact = draft.take(Number, f"D_{number}", one.D, "kg·m"), one.D
    angle = draft.angle(f"α_{number}", one.angle)
    at = None if one.at is None else draft.take(Number, f"x_{number}", one.at, "m")
    vector = turned(exact, one.angle)
    return Row(str(number), mass, radius, size, angle, at, vector, one.at or 0.0)


def _along(order: RotorTask) -> bool:
    """Whether all places along the axis are given: then the rotor is drawn from the side."""
    whole = all(one.at is not None for one in order.unbalances)
    return whole and _length(order) > 0.0


def _length(order: RotorTask) -> float:
    there = (one.at for one in order.unbalances if one.at is not None)
    places = [*there, *order.planes, *order.bearings]
    return max(places) - min(places) if places else 0.0


def _draw_side(
    draft: Draft, rows: Sequence[Row], others: dict[str, Mark]
) -> tuple[Mark, dict[str, Mark]]:
    """Draw the places of all masses, planes and bearings along the axis."""
    draft.open(SIDE)
    mu = draft.scale("μ_l", "m/mm")
    zero = draft.take(Point, "O", 0j)
    draft.lay_out(zero)
    axis = draft.draw(ray, "(x)", zero, draft.direction(0.0), why=why.AXIS)
    places = {row.number: row.at for row in rows if row.at is not None} | others
    found = {}
    for name, place in places.items():
        size = draft.draw(to_board, f"O{name}", place, mu)
        found[name] = draft.draw(lay_off, name, axis, size, why=why.STATION)
    return mu, found


def _draw_end(
    draft: Draft, rows: Sequence[Row], weights: Sequence[Held]
) -> tuple[Mark, dict[str, Mark]]:
    """Draw all masses and counterweights at their angles and radii, seen along the axis."""
    draft.open(END)
    mu = draft.scale("μ_l", "m/mm")
    axis = draft.take(Point, "O", 0j)
    draft.lay_out(axis)
    there = [(row.number, row.angle, row.radius) for row in rows]
    there += [(one.name, one.angle, one.radius) for one in weights if one.angle is not None]
    found = {}
    for name, angle, radius in there:
        line = draft.draw(ray, f"(O{name})", axis, angle, why=why.DIRECTION)
        if radius is None:
            size = draft.take(Length, f"O{name}", ARM, "mm")
        else:
            size = draft.draw(to_board, f"O{name}", radius, mu)
        found[name] = draft.draw(lay_off, name, line, size, why=why.MASS)
    return mu, found


def _one_plane(draft: Draft, rows: Sequence[Row], polygons: dict[str, Polygon]) -> tuple[Held, ...]:
    """Balance at rest: the polygon of m·r, which the counterweight closes."""
    draft.say(why.AT_REST)
    polygon = draw_polygon(draft, FORCES, MU_D, [row.vector for row in rows], "D_{k}")
    assert polygon is not None
    polygons[FORCES] = polygon
    return (_held("k", polygon),)


def _held(name: str, polygon: Polygon) -> Held:
    if polygon.angle is None:
        return Held(name, None, None)
    return Held(name, polygon.size, polygon.angle)


def _two_planes(
    draft: Draft,
    rows: Sequence[Row],
    planes: tuple[dict[str, Mark], Sequence[float]],
    views: tuple[str, str],
    polygons: dict[str, Polygon],
) -> tuple[tuple[Row, ...], tuple[Held, ...], Mark]:
    """Balance in two planes: moments about the first give what the second wants, then m·r the first."""
    (marks, (zero, end)), (of_moments, of_forces) = planes, views
    one, other = marks
    draft.open(f"{of_moments} table")
    apart = draft.draw(f.from_plane, f"z_{{{other}}}", marks[other], marks[one], unit="m")
    measured = []
    for row in rows:
        assert row.at is not None
        distance = draft.draw(f.from_plane, f"z_{row.number}", row.at, marks[one], unit="m")
        size = draft.draw(
            f.moment_of_unbalance, f"M_{row.number}", row.size, distance, unit="kg·m²"
        )
        measured.append(row._replace(distance=distance, moment=size))
    arms = [row.place - zero for row in rows]
    vectors = [
        Vector(row.moment.letter, row.moment, row.angle, row.exact * arm)
        for row, arm in zip(measured, arms, strict=True)
        if row.moment is not None
    ]
    sides = [row.vector for row in rows]
    second = Held(other, None, None)
    moments = draw_polygon(draft, of_moments, MU_M, vectors, f"M_{{{other}}}")
    if moments is not None:
        polygons[of_moments] = moments
        if moments.angle is not None:
            letter = f"D_{{{other}}}"
            size = draft.draw(f.unbalance_of_moment, letter, moments.size, apart, unit="kg·m")
            second = Held(other, size, moments.angle)
            sides.append(Vector(letter, size, moments.angle, moments.exact / (end - zero)))
    forces = draw_polygon(draft, of_forces, MU_D, sides, f"D_{{{one}}}")
    assert forces is not None
    polygons[of_forces] = forces
    return tuple(measured), (_held(one, forces), second), apart


def _weigh(draft: Draft, held: Held, order: RotorTask, k: int) -> Held:
    """Calculate mass or radius of a counterweight, whichever is sought."""
    if held.size is None:
        return held
    draft.open(held.size.view)
    name = held.name
    given = order.radius or order.mass
    value = given[min(k, len(given) - 1)]
    if order.radius:
        radius = draft.take(Number, f"r_{{{name}}}", value, "m")
        mass = draft.draw(f.mass_of_counterweight, f"m_{{{name}}}", held.size, radius, unit="kg")
    else:
        mass = draft.take(Number, f"m_{{{name}}}", value, "kg")
        radius = draft.draw(f.radius_of_counterweight, f"r_{{{name}}}", held.size, mass, unit="m")
    return held._replace(mass=mass, radius=radius)


def _reactions(draft: Draft, found: Sequence[Held], speed: float) -> tuple[Held, ...]:
    draft.open(f"{BEARING_FORCES} table")
    omega = draft.take(Number, "ω_1", abs(speed), "1/s")
    held = []
    for one in found:
        force = None
        if one.size is not None:
            force = draft.draw(f.reaction_of_bearing, f"R_{one.name}", one.size, omega, unit="N")
        held.append(one._replace(force=force))
    return tuple(held)


def _largest_radius(
    order: RotorTask, weights: Sequence[Held], polygons: dict[str, Polygon]
) -> float:
    """Return the largest radius at which a mass stands, m."""
    found = [one.radius for one in order.unbalances if one.radius is not None]
    if order.radius:
        return max(*found, *order.radius, 0.0)
    exact = {FORCES: abs(polygons[FORCES].exact)}
    if MOMENTS in polygons:
        apart = order.planes[1] - order.planes[0]
        exact[MOMENTS] = abs(polygons[MOMENTS].exact) / apart
    least = min(order.mass)
    return max(*found, *(size / least for size in exact.values()), 0.0)
