"""A planetary train to scale in two views: its pitch circles, and the kinematic scheme along the axis.

The positions of the log are the satellites, evenly about the main axis, the first one above it. The scheme
stands to the right of the circles on the same axis, so that the levels of the pitch points A (wheel 1 with the
satellites) and C (the satellites with the fixed wheel) and of a satellite's axis B are carried across.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import to_board
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
from graphic_tmm.board.values import Angle, Length, Point
from graphic_tmm.chapters.trains import words as why
from graphic_tmm.chapters.trains.dimensions import Dimensions
from graphic_tmm.chapters.trains.formulas import next_satellite
from graphic_tmm.chapters.trains.task import Train

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
