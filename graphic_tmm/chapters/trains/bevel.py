"""A train of bevel wheels from its side, to scale by mean radii; the triangle of angular velocities.

The axis of the satellites crosses the main one in O, where all pitch cones have their tips. The satellite
touches the central wheels in A and C; its points there and B of its axis stand on one line, so their
velocities, square to the drawing, end on a straight line when they are laid off square to it. Angular
velocities are vectors along the axes: ω_2 = ω_H + ω_2H, and seen from a wheel the satellite turns about the
line in which their cones touch.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.operations.formulas import in_si, to_board
from graphic_tmm.board.operations.instruments import (
    join,
    lay_off,
    measure,
    measure_along,
    meet,
    parallel,
    ray,
    square,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import standard
from graphic_tmm.board.values import Length, Point
from graphic_tmm.chapters.trains import bevel_formulas as f
from graphic_tmm.chapters.trains import words as why
from graphic_tmm.chapters.trains.dimensions import Dimensions
from graphic_tmm.chapters.trains.motion import Motion
from graphic_tmm.chapters.trains.pictures import AxialView, Disc, EndView
from graphic_tmm.chapters.trains.rates import RATES, Rates, VelocityPicture, compare
from graphic_tmm.chapters.trains.task import Train

RELATIVE = "2H"
"""The satellites as they turn about their axis, among what turns."""
RATE = 90.0
"""Room for the longest angular velocity, mm."""
ABOVE, BEHIND, REACH = 16.0, 24.0, 45.0
"""From the satellite up to the picture; from the shafts to the triangle; how far shafts reach, mm."""


@dataclass(frozen=True)
class BevelView(EndView):
    """The train seen square to both axes: ``origin`` O, ``up`` the axis of the satellites, ``satellites`` B.

    ``main``: the main axis. ``lines``: from O, in which the satellite touches a central wheel, by the wheel.
    ``levels``: square to the line AC, from A, B, C.
    """

    main: Mark
    lines: Mapping[str, Mark]


def draw_side_view(draft: Draft, train: Train, sizes: Dimensions) -> tuple[BevelView, AxialView]:
    """Draw the axes, A, B, C and the mean diameters of all wheels."""
    scheme, radii = train.scheme, sizes.radii
    first, last = scheme.meshes[0], scheme.meshes[-1]
    contacts, single = (("A", first, 1), ("C", last, -1)), scheme.rows == 1
    names = dict[str, str]()
    for at, mesh, _ in contacts:
        names[mesh.wheel] = f"O_{mesh.wheel}{at}"
        names.setdefault(mesh.rim, f"B{at}" if single else f"B_{mesh.rim}{at}")
    lengths = {wheel: draft.draw(to_board, names[wheel], own) for wheel, own in radii.items()}
    origin = draft.take(Point, "O", 0j)
    main = draft.draw(ray, "(Ox)", origin, draft.direction(0.0), why=why.AXIS)
    lean, far = draft.direction(90.0), sizes.axes
    if single:
        lean = draft.draw(f.lean, "φ", radii[first.wheel], radii[last.wheel], radii[first.rim])
        far = draft.draw(f.from_apex, "l_{OB}", sizes.axes, lean, unit="m")
    lengths["H"] = draft.draw(to_board, "OB", far)
    up = draft.draw(ray, "(OB)", origin, lean, why=why.AXIS_OF_BEVEL)
    b = draft.draw(lay_off, "B", up, lengths["H"], why=why.BETWEEN_CONTACTS)
    points, discs = {"B": b}, dict[str, Disc]()
    for at, mesh, sense in contacts:
        rim, centre = mesh.rim, b
        if not single:
            own = lengths[mesh.wheel]
            centre = draft.draw(lay_off, f"B_{rim}", up, own, why=why.MEAN_DIAMETER)
        name = centre.letter
        across = draft.draw(square, f"({name}{at})", centre, up, sense=sense, why=why.MEAN_DIAMETER)
        points[at] = draft.draw(lay_off, at, across, lengths[rim], why=why.MEAN_DIAMETER)
        if not single:
            back = draft.draw(square, f"({name}{at}′)", centre, up, sense=-sense)
            end = draft.draw(lay_off, f"{at}_{rim}", back, lengths[rim], why=why.MEAN_DIAMETER)
            discs[rim] = Disc(points[at], end, centre)
    if single:
        discs[first.rim] = Disc(points["A"], points["C"], b)
    points = {at: points[at] for at in "ABC"}
    between = draft.draw(join, "(AC)", points["A"], points["C"], why=why.BETWEEN_CONTACTS)
    lines = {}
    for at, mesh, _ in contacts:
        lines[mesh.wheel] = draft.draw(join, f"(O{at})", origin, points[at], why=why.CONES_TOUCH)
        down = draft.draw(square, f"({at}O)", points[at], main, sense=-1, why=why.DISC)
        foot = draft.draw(meet, f"O_{mesh.wheel}", main, down, why=why.DISC)
        below = draft.draw(square, f"(O_{mesh.wheel}{at}′)", foot, main, sense=-1, why=why.DISC)
        end = draft.draw(lay_off, f"{at}′", below, lengths[mesh.wheel], why=why.DISC)
        discs[mesh.wheel] = Disc(points[at], end, foot)
    base = draft.draw(square, "(By)", b, between, sense=1, why=why.ZERO_OF_BEVEL)
    levels = {
        at: base if at == "B" else draft.draw(parallel, f"({at})", point, base, why=why.LEVEL)
        for at, point in points.items()
    }
    for wheel, disc in discs.items():
        draft.figure("disc", wheel, *disc)
    draft.figure("arm", "H", b, origin)
    view = BevelView(origin, base, up, lengths, {}, b, levels, points, None, main, lines)
    return view, AxialView({}, discs, (b, origin))


def draw_triangle(
    draft: Draft,
    motion: Motion,
    train: Train,
    view: BevelView,
    sizes: Dimensions,
    picture: VelocityPicture,
) -> Rates:
    """Draw angular velocities as vectors along the axes; measure those of the satellite."""
    draft.open(RATES)
    scheme = train.scheme
    mu = draft.scale("μ_ω", "(1/s)/mm")
    along, above = draft.ask(Length, "x_ω", "mm"), draft.ask(Length, "y_ω", "mm")
    foot = draft.draw(lay_off, "(x)", view.main, along, why=why.POLE_OF_VECTORS)
    over = draft.draw(square, "(xP)", foot, view.main, sense=1, why=why.POLE_OF_VECTORS)
    pole = draft.draw(lay_off, "P", over, above, why=why.POLE_OF_VECTORS)
    draft.lay_out(pole, mu)
    line = draft.draw(parallel, "(ω)", pole, view.main, why=why.POLE_OF_VECTORS)
    ends, segments, values = dict[str, Mark](), dict[str, Mark](), dict[str, Mark]()
    for at, member in scheme.spots.items():
        if member == motion.fixed:
            continue
        if member in picture.omegas:
            values[member] = picture.omegas[member]
        else:
            arm = sizes.radii.get(member, sizes.axes)
            own = picture.speeds[at]
            values[member] = draft.draw(f.rate_about_axis, f"ω_{member}", own, arm, unit="1/s")
        segments[member] = draft.draw(to_board, f"P{member}", values[member])
        ends[member] = draft.draw(lay_off, member, line, segments[member], why=why.ALONG_AXIS)
    hub = ends.get("H", pole)
    about = draft.draw(parallel, "(2H)", hub, view.up, why=why.RELATIVE_ALONG_AXIS)
    rays = [
        draft.draw(parallel, f"(2{wheel})", ends.get(wheel, pole), own, why=why.ABOUT_CONTACT)
        for wheel, own in view.lines.items()
    ]
    ends["2"] = draft.draw(meet, "2", about, rays[0], why=why.ABOUT_CONTACT)
    for body, segment in (
        ("2", draft.draw(measure, "P2", pole, ends["2"], why=why.RATE_READ)),
        (RELATIVE, draft.draw(measure_along, "H2", hub, ends["2"], about, why=why.RATE_READ)),
    ):
        segments[body] = segment
        values[body] = draft.draw(
            in_si, f"ω_{{{body}}}" if body != "2" else "ω_2", segment, unit="1/s"
        )
    compared = compare(draft, motion, train, sizes, picture.omegas, segments, values)
    return Rates(mu, above, along, pole, pole, ends, segments, values, *compared)


def choose_room(
    draft: Draft, picture: VelocityPicture, rates: Rates, axial: AxialView, size: float
) -> None:
    """Choose the scale of angular velocities and the places of picture and triangle; scales else are chosen."""
    draft.given |= {rates.mu: 1.0, rates.distance: 0.0, rates.depth: 0.0, picture.place: 0.0}

    def run(*marks: Mark) -> list[complex]:
        reading = execute(draft.board.construction(), draft.given, marks)
        return [complex(reading[mark][0, 0]) for mark in marks]

    longest = max(map(abs, run(*rates.segments.values())))
    draft.given[rates.mu] = standard(longest, RATE * size)
    sides = run(*(mark for disc in axial.discs.values() for mark in disc))
    (b,), tips = run(axial.arm[0]), run(*picture.ends.values())
    top = max(z.imag for z in sides)
    draft.given[rates.depth] = top
    low = min([0.0, *((z - b).imag for z in tips)])
    draft.given[picture.place] = top - b.imag - low + ABOVE
    right = max(z.real for z in sides) + REACH
    left = min([0.0, *(z.real for z in run(rates.pole, *rates.ends.values()))])
    draft.given[rates.distance] = right + BEHIND - left
