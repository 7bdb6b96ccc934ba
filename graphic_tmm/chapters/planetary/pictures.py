"""A planetary train to scale in two views: its pitch circles, and the kinematic scheme along the axis.

The positions of the log are the satellites, evenly about the main axis, the first one above it. The scheme
stands to the right of the circles on the same axis, so that the levels of the pitch points A (wheel 1 with the
satellites) and C (the satellites with the fixed wheel) and of a satellite's axis B are carried across. A pair
of wheels behind the train stands on the driven shaft, its second wheel below the main axis.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import pitch_radius, to_board
from graphic_tmm.board.operations.instruments import (
    lay_off,
    measure,
    meet,
    parallel,
    ray,
    square,
    strike,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Length, Number, Point
from graphic_tmm.chapters.planetary import words as why
from graphic_tmm.chapters.planetary.dimensions import Dimensions
from graphic_tmm.chapters.planetary.formulas import next_satellite, overall_ratio
from graphic_tmm.chapters.planetary.task import PlanetaryTask, Train
from graphic_tmm.scene.declare import bound_of

VIEW = "planetary"


@dataclass(frozen=True)
class EndView:
    """The train seen along its axis.

    ``lengths``: the radii of the wheels on the board, by wheel, and that of the axes as "H" (Length).
    ``circles``: pitch circles by wheel (Arc). ``satellites``: axes of the satellites (Point, a position each).
    ``levels``: the lines parallel to the axis through the ``points`` A, B, C of the line of centres, by letter.
    ``between``: from axis to axis of neighbours as measured, None for one satellite.
    """

    origin: Mark
    axis: Mark
    up: Mark
    lengths: Mapping[str, Mark]
    circles: Mapping[str, Mark]
    satellites: Mark
    levels: Mapping[str, Mark]
    points: Mapping[str, Mark]
    between: Mark | None


class Disc(NamedTuple):
    """A wheel seen from its side: two opposite points of its pitch circle, and its centre (Point)."""

    near: Mark
    far: Mark
    centre: Mark


@dataclass(frozen=True)
class AxialView:
    """The kinematic scheme along the axis: the wheels, a satellite's axis and the main axis at the arm of H.

    ``stations``: where the rows and the arm stand along the axis (Length, given): "I", "II" if there is a
    second row, "H".
    """

    stations: Mapping[str, Mark]
    discs: Mapping[str, Disc]
    arm: tuple[Mark, Mark]


@dataclass(frozen=True)
class PairView:
    """The pair of wheels behind the train in the kinematic scheme, with the module of the train.

    ``station``: where it stands along the axis (Length, given); ``discs``: its wheels by their numbers, that on
    the driven shaft first. ``ratio``: of the train and the pair together (Number, without sign).
    """

    station: Mark
    discs: Mapping[str, Disc]
    ratio: Mark


def draw_end_view(draft: Draft, train: Train, sizes: Dimensions) -> EndView:
    """Draw the pitch circles."""
    scheme = train.scheme
    central = {member: letter for letter, member in scheme.spots.items()}
    names = dict[str, str]()
    for mesh in scheme.meshes:
        letter = central[mesh.wheel]
        names |= {mesh.wheel: f"O{letter}", mesh.rim: names.get(mesh.rim, f"B{letter}")}
    lengths = {
        wheel: draft.draw(to_board, names[wheel], radius) for wheel, radius in sizes.radii.items()
    }
    lengths["H"] = draft.draw(to_board, "OB", sizes.axes)
    origin = draft.take(Point, "O", 0j)
    axis = draft.draw(ray, "(Ox)", origin, draft.direction(0.0), why=why.AXIS)
    up = draft.draw(square, "(Oy)", origin, axis, sense=1, why=why.AXIS)
    points = {
        letter: draft.draw(lay_off, letter, up, lengths[member], why=why.MESH)
        for letter, member in scheme.spots.items()
    }
    turns = 90.0 + 360.0 * np.arange(train.satellites) / train.satellites
    places = draft.take(Angle, "φ", turns[None, :], "°")
    ways = draft.draw(ray, "(OO_2)", origin, places, why=why.SATELLITES)
    satellites = draft.draw(lay_off, "O_2", ways, lengths["H"], why=why.SATELLITES)
    circles = {
        wheel: draft.draw(
            strike, f"({wheel})", origin if wheel in central else satellites, lengths[wheel]
        )
        for wheel in scheme.wheels
    }
    between = None
    if train.satellites > 1:
        after = draft.draw(next_satellite, "O′_2", satellites, row=train.satellites)
        between = draft.draw(measure, "O_2O′_2", satellites, after)
    draft.figure("carrier", "H", origin, satellites)
    for mesh in scheme.meshes:
        if mesh.sense < 0:
            draft.figure("ring", mesh.wheel, circles[mesh.wheel])
    levels = {
        letter: draft.draw(parallel, f"({letter})", point, axis, sense=1, why=why.LEVEL)
        for letter, point in points.items()
    }
    return EndView(origin, axis, up, lengths, circles, satellites, levels, points, between)


def draw_axial_view(draft: Draft, train: Train, end: EndView) -> AxialView:
    """Draw the scheme along the axis; the values of its stations are chosen with the scales."""
    scheme = train.scheme
    names = ("I", "H") if scheme.rows == 1 else ("I", "II", "H")
    stations = {name: draft.ask(Length, f"x_{{{name}}}", "mm") for name in names}
    feet = {
        name: draft.draw(lay_off, f"O_{{{name}}}", end.axis, stations[name], why=why.DISC)
        for name in names
    }
    lines = {
        name: draft.draw(square, f"({name})", feet[name], end.axis, sense=1, why=why.DISC)
        for name in names
    }
    downs = {
        name: draft.draw(square, f"(−{name})", feet[name], end.axis, sense=-1, why=why.DISC)
        for name in names[:-1]
    }
    row = dict(zip(scheme.rims, names, strict=False))
    discs = {}
    for letter, member in scheme.spots.items():
        if member == "H":
            continue
        at = row[scheme.mesh(member).rim]
        near = draft.draw(meet, f"{letter}_{{{at}}}", lines[at], end.levels[letter], why=why.DISC)
        far = draft.draw(lay_off, f"{near.letter}′", downs[at], end.lengths[member], why=why.DISC)
        discs[member] = Disc(near, far, feet[at])
    axes = {
        name: draft.draw(meet, f"B_{{{name}}}", lines[name], end.levels["B"], why=why.DISC)
        for name in names
    }
    across = "E" if "D" in scheme.spots else "D"
    for rim, at in row.items():
        mesh = scheme.mesh(rim)
        away = draft.draw(
            square, f"(B_{{{at}}})", axes[at], end.axis, sense=mesh.sense, why=why.DISC
        )
        far = draft.draw(lay_off, f"{across}_{{{at}}}", away, end.lengths[rim], why=why.DISC)
        discs[rim] = Disc(discs[mesh.wheel].near, far, axes[at])
    for wheel, disc in discs.items():
        draft.figure("disc", wheel, *disc)
    draft.figure("arm", "H", axes["H"], feet["H"])
    return AxialView(stations, discs, (axes["H"], feet["H"]))


def draw_pair(
    draft: Draft, order: PlanetaryTask, train: Train, sizes: Dimensions, end: EndView
) -> PairView | None:
    """Draw the pair of wheels behind the train and calculate the ratio of both; None where there is none.

    Raises
    ------
    StructureError
        If a tooth number is none.
    """
    if not order.behind:
        return None
    first = len(train.scheme.wheels) + 1
    names = (str(first), str(first + 1))
    module, teeth = draft.uses(sizes.radii["1"])[0], []
    for name, count in zip(names, order.behind, strict=True):
        bound_of(PlanetaryTask, "behind").refuse("planetary", "behind", count)
        teeth.append(draft.take(Number, f"z_{name}", float(count)))
    assert sizes.ratio is not None
    ratio = draft.draw(overall_ratio, "U_0", sizes.ratio, teeth[1], teeth[0])
    radii = []
    for name, z in zip(names, teeth, strict=True):
        real = draft.draw(pitch_radius, f"r_{name}", module, z, unit="m")
        radii.append(draft.draw(to_board, f"O_{name}E", real))
    station = draft.ask(Length, f"x_{names[0]}", "mm")
    own = draft.draw(lay_off, f"O_{names[0]}", end.axis, station)
    down = draft.draw(square, f"(O_{names[0]}E)", own, end.axis, sense=-1)
    contact = draft.draw(lay_off, "E", down, radii[0])
    up = draft.draw(square, f"(O_{names[0]}E_{names[0]})", own, end.axis, sense=1)
    above = draft.draw(lay_off, f"E_{names[0]}", up, radii[0])
    onward = draft.draw(square, f"(EO_{names[1]})", contact, end.axis, sense=-1)
    other = draft.draw(lay_off, f"O_{names[1]}", onward, radii[1])
    again = draft.draw(square, f"(O_{names[1]}E_{names[1]})", other, end.axis, sense=-1)
    below = draft.draw(lay_off, f"E_{names[1]}", again, radii[1])
    discs = {names[0]: Disc(contact, above, own), names[1]: Disc(contact, below, other)}
    for wheel, disc in discs.items():
        draft.figure("pair", wheel, *disc)
    return PairView(station, discs, ratio)
