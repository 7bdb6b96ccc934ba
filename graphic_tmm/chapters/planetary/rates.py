"""The picture of linear velocities of a planetary train and, from it, the plan of angular velocities.

At the level of a point stands its velocity; the points of a body on the line of centres end in one straight
line, which passes through the level where the body stands. Rays from a pole parallel to these lines cut off
on a line parallel to the axis segments proportional to the angular velocities.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import in_si, product, scale_of_derivative, to_board
from graphic_tmm.board.operations.instruments import (
    join,
    lay_off,
    measure_along,
    meet,
    parallel,
    square,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Number
from graphic_tmm.chapters.planetary import words as why
from graphic_tmm.chapters.planetary.dimensions import Dimensions
from graphic_tmm.chapters.planetary.formulas import miss_of_ratio, ratio_of_segments
from graphic_tmm.chapters.planetary.pictures import EndView
from graphic_tmm.chapters.planetary.task import PlanetaryTask, Train

VELOCITIES = "planetary-velocities"
RATES = "planetary-rates"


@dataclass(frozen=True)
class VelocityPicture:
    """The picture of linear velocities.

    ``place``: where its zero line stands along the axis (Length, given); ``zeros``: O, A, B, C on it; ``ends``:
    those of the velocities of A and B; ``lines``: of wheel "1", the satellites "2", the carrier "H";
    ``readings``: the velocities by point, one laid off, one measured (Length); ``speeds`` the same in m/s.
    """

    mu: Mark
    place: Mark
    zeros: tuple[Mark, Mark, Mark, Mark]
    ends: tuple[Mark, Mark]
    lines: Mapping[str, Mark]
    readings: Mapping[str, Mark]
    speeds: Mapping[str, Mark]


@dataclass(frozen=True)
class Rates:
    """The plan of angular velocities.

    ``depth``: how far below the axis its line lies (Length, given); ``distance``: H of the pole (Length,
    given); ``foot``: the fixed wheel; ``ends``, ``segments``, ``values`` (1/s): of "1", "2" and "H".
    ``ratio``: driving over driven as measured; ``difference`` from the formula, %.
    """

    mu: Mark
    depth: Mark
    distance: Mark
    pole: Mark
    foot: Mark
    ends: Mapping[str, Mark]
    segments: Mapping[str, Mark]
    values: Mapping[str, Mark]
    ratio: Mark
    difference: Mark


def draw_picture(
    draft: Draft, order: PlanetaryTask, end: EndView, sizes: Dimensions
) -> VelocityPicture:
    """Draw the picture from the velocity of the driving shaft: of A if wheel 1 drives, of B if the carrier."""
    draft.open(VELOCITIES)
    mu = draft.scale("μ_v", "(m/s)/mm")
    draft.lay_out()
    place = draft.ask(Length, "x_v", "mm")
    origin = draft.draw(lay_off, "O", end.axis, place, why=why.ZERO)
    zero = draft.draw(square, "(0)", origin, end.axis, sense=1, why=why.ZERO)
    pairs = zip(end.points, end.levels, strict=True)
    a, b, c = (draft.draw(meet, point.letter, zero, level, why=why.ZERO) for point, level in pairs)
    feet, levels = {"A": a, "B": b}, {"A": end.levels.A, "B": end.levels.B}
    known, sought = ("A", "B") if order.driving == "1" else ("B", "A")
    tip, other = known.lower(), sought.lower()
    omega = draft.take(Number, f"ω_{order.driving}", order.speed, "1/s")
    arm = sizes.radii["1"] if known == "A" else sizes.axes
    speed = draft.draw(product, f"v_{known}", omega, arm, unit="m/s")
    length = draft.draw(to_board, f"{known}{tip}", speed)
    along = draft.draw(
        parallel, f"({known}{tip})", feet[known], levels[known], sense=1, why=why.KNOWN_VELOCITY
    )
    tips = {known: draft.draw(lay_off, tip, along, length, why=why.KNOWN_VELOCITY)}
    satellite = draft.draw(join, f"(C{tip})", c, tips[known], why=why.SATELLITE_LINE)
    tips[sought] = draft.draw(meet, other, satellite, levels[sought], why=why.SOUGHT_VELOCITY)
    lines = {
        "1": draft.draw(join, "(Oa)", origin, tips["A"], why=why.BODY_LINE),
        "2": satellite,
        "H": draft.draw(join, "(Ob)", origin, tips["B"], why=why.BODY_LINE),
    }
    read = draft.draw(
        measure_along,
        f"{sought}{other}",
        feet[sought],
        tips[sought],
        end.axis,
        why=why.VELOCITY_READ,
    )
    found = draft.draw(in_si, f"v_{sought}", read, unit="m/s")
    readings, speeds = {known: length, sought: read}, {known: speed, sought: found}
    ends = (tips["A"], tips["B"])
    return VelocityPicture(mu, place, (origin, a, b, c), ends, lines, readings, speeds)


def draw_rates(
    draft: Draft,
    order: PlanetaryTask,
    train: Train,
    end: EndView,
    sizes: Dimensions,
    picture: VelocityPicture,
) -> Rates:
    """Draw the plan of angular velocities below the picture; measure the ratio and compare it."""
    draft.open(RATES)
    distance = draft.ask(Length, "H_ω", "mm")
    depth = draft.ask(Length, "y_ω", "mm")
    mu = draft.draw(scale_of_derivative, "μ_ω", picture.mu, draft.mu_l, distance, unit="(1/s)/mm")
    fixed = train.scheme.wheels[-1]
    down = draft.draw(square, "(Oy)", picture.zeros[0], end.axis, sense=-1, why=why.RATES_LINE)
    foot = draft.draw(lay_off, fixed, down, depth, why=why.RATES_LINE)
    line = draft.draw(parallel, "(ω)", foot, end.axis, sense=1, why=why.RATES_LINE)
    below = draft.draw(square, f"({fixed}P)", foot, line, sense=-1, why=why.RATES_POLE)
    pole = draft.draw(lay_off, "P", below, distance, why=why.RATES_POLE)
    draft.lay_out(pole, mu)
    ends, segments, values = {}, {}, {}
    for body, drawn in picture.lines.items():
        way = draft.draw(parallel, f"(P{body})", pole, drawn, sense=1, why=why.RATE_RAY)
        ends[body] = draft.draw(meet, body, line, way, why=why.RATE_RAY)
        segments[body] = draft.draw(
            measure_along, f"s_{body}", foot, ends[body], line, why=why.RATE_READ
        )
        values[body] = draft.draw(in_si, f"ω_{body}", segments[body], unit="1/s")
    driving, driven = ("1", "H") if order.driving == "1" else ("H", "1")
    ratio = draft.draw(
        ratio_of_segments, f"U′_{{{driving}{driven}}}", segments[driving], segments[driven]
    )
    difference = draft.draw(miss_of_ratio, "ΔU", ratio, sizes.ratio, unit="%")
    return Rates(mu, depth, distance, pole, foot, ends, segments, values, ratio, difference)
