"""Where the centre of a cam with a rocking roller may stand, the distance of the centres being given.

Along the lever in each of its positions the path's dS/dφ is laid off; a line through its end Q, inclined by
the allowed pressure angle to the path, cuts the circle of the centres where the cam's centre may begin to
stand. The angle of that point from the lowest lever, drawn over the turn as a diagram, has its highest point
on the curve.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import count

from graphic_tmm.board import graphs
from graphic_tmm.board.charts import Chart
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import in_si, to_board
from graphic_tmm.board.operations.graph_curves import graph_of_stretch
from graphic_tmm.board.operations.instruments import (
    cross,
    cut,
    join,
    lay_off,
    measure,
    measure_along,
    parallel,
    ray,
    square,
    strike,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import standard_length
from graphic_tmm.board.values import Angle, Number, Point, Side
from graphic_tmm.chapters.cam import formulas as f
from graphic_tmm.chapters.cam.centre import VIEW, Centre, choose_radius, limit_angles
from graphic_tmm.chapters.cam.diagrams import Diagrams
from graphic_tmm.chapters.cam.operations import (
    crest_of_curve,
    cut_or_foot,
    extreme_of_two,
    slant,
    slew,
    smooth_stretch,
)
from graphic_tmm.chapters.cam.task import CamTask, RockerFollower

LIMITS = "cam limits"
ROOM = 110.0
"""Room for the distance of the centres where the order fixes no scale, mm."""
DEGREES = 1.0
"""Degrees per mm of the diagram of limits."""


@dataclass(frozen=True)
class Lever:
    """The rocker as drawn for the profile: line of centres from O1, their distance and the lever (Length).

    ``start``: the angle of the lever from the line of centres in its lowest place, ``swing`` from there
    (Angle); ``sense`` of its turning on the rise; ``chart``: the diagram of the limits.
    """

    line: Mark
    centres: Mark
    lever: Mark
    start: Mark
    swing: Mark
    sense: int
    chart: Chart


def draw_rocker_centre(
    draft: Draft, order: CamTask, diagrams: Diagrams, of: RockerFollower, sense: int
) -> tuple[Centre, Lever]:
    """Draw the lever's diagram, the limits of the centre, the least r0 and the chosen one.

    ``sense``: 1 if the cam turns counter-clockwise, −1 clockwise.
    """
    draft.open(VIEW)
    alike = 1 if of.same_sense else -1
    rocks = alike * sense
    mu = draft.take(
        Number, "μ_l", order.mu_l or standard_length(max(of.centres, of.lever), ROOM), "m/mm"
    )
    draft.lay_out(None, mu)
    lever = draft.draw(to_board, "O_1B", draft.take(Number, "l", of.lever, "m"))
    centres = draft.draw(to_board, "O_1O", draft.take(Number, "a_w", of.centres, "m"))
    pivot = draft.take(Point, "O_1", 0j)
    begin = draft.draw(ray, "(l_0)", pivot, draft.direction(0.0 if rocks > 0 else 180.0))
    lowest = draft.draw(lay_off, "B_0", begin, lever)
    swing = draft.draw(f.swing_of, "ψ", diagrams.S.reading, unit="°")
    levers = draft.draw(slew, "(l)", pivot, begin, swing, sense=rocks)
    roller = draft.draw(lay_off, "B", levers, lever)
    velocity = draft.draw(f.travel_on_lever, "v", diagrams.V.reading, lever)
    outward = draft.draw(parallel, "(v)", roller, levers, sense=-alike)
    points = draft.draw(lay_off, "Q", outward, velocity)
    curves = tuple(
        draft.draw(smooth_stretch, "(Q–Q)", points, first=first, last=last)
        for _, first, last in diagrams.stretches
    )
    paths = draft.draw(square, "(t)", points, levers, sense=rocks)
    circle = draft.draw(strike, "(O_1O)", pivot, centres)
    limits, ends, angles = _limits(
        draft, order, (points, paths, circle, pivot, begin), alike, sense
    )
    turn = diagrams.turn
    rows = [
        (angle, [ends for one in turn.like(way) for ends in one.stretches])
        for angle, way in zip(angles, turn.ways, strict=True)
    ]
    highest, chart = draw_limit_diagram(draft, diagrams, rows)
    draft.open(VIEW)
    bound = draft.draw(slew, "(O_{min})", pivot, begin, highest, sense=-rocks)
    least_centre = draft.draw(lay_off, "O_{min}", bound, centres)
    least = draft.draw(in_si, "r_{0min}", draft.draw(measure, "OB", least_centre, lowest), unit="m")
    r0, radius = choose_radius(draft, order, least)
    small = draft.draw(strike, "(R_0)", lowest, radius)
    below = draft.take(Side, "±", float(-rocks))
    centre = draft.draw(cross, "O", circle, small, below)
    start = draft.draw(slant, "ψ_0", pivot, centre, begin, sense=-rocks, unit="°")
    pressure = draft.draw(slant, "α", centre, points, paths, sense=sense, unit="°")
    pace = draft.draw(measure, "OQ", centre, points)
    p = draft.draw(measure_along, "p", centre, points, paths)
    q = draft.draw(measure_along, "q", centre, points, outward)
    reach = draft.draw(measure, "O_1Q", pivot, points)
    along = draft.draw(f.along_path, "w", velocity, reach, lever)
    turning = []
    for reading in diagrams.A.readings:
        second = draft.draw(f.travel_on_lever, "a", reading, lever)
        turning.append(draft.draw(f.turning_of_normal, "τ", p, q, along, second))
    made = Centre(
        VIEW, mu, roller, points, curves, limits, ends, lowest, least_centre, centre, least, r0,
        radius, None, None, diagrams.S.reading, pressure, pace, tuple(turning),
    )  # fmt: skip
    line = draft.draw(join, "(O_1O)", pivot, centre)
    return made, Lever(line, centres, lever, start, swing, rocks, chart)


def _limits(
    draft: Draft, order: CamTask, on: tuple[Mark, Mark, Mark, Mark, Mark], alike: int, sense: int
) -> tuple[tuple[Mark, Mark], tuple[Mark, Mark], tuple[Mark, Mark]]:
    """Draw the limit lines through every Q, mark where they cut the circle of the centres; return both.

    And at which angles the centre may begin to stand there (Angle).

    ``on``: the points Q, the directions of the path, the circle of the centres, the pivot, the lowest lever.
    Of the two points of a line on the circle it is the one at which, going from the lowest lever, one comes
    to its allowed side.
    """
    (points, paths, circle, pivot, begin) = on
    lines, ends, angles = [], [], []
    for name, angle, towards in zip("rf", limit_angles(draft, order), (1, -1), strict=True):
        line = draft.draw(slew, f"(α_{name})", points, paths, angle, sense=sense * towards)
        enter = draft.take(Side, f"±_{name}", float(-alike * towards))
        # a line that misses the circle leaves the side of the pivot allowed, or nothing of the circle
        op = cut_or_foot if towards == alike else cut
        spot = draft.draw(op, f"O_{name}", line, circle, enter)
        lines.append(line)
        ends.append(spot)
        angles.append(
            draft.draw(slant, f"β_{name}", pivot, spot, begin, sense=-alike * sense, unit="°")
        )
    return (lines[0], lines[1]), (ends[0], ends[1]), (angles[0], angles[1])


def draw_limit_diagram(
    draft: Draft,
    diagrams: Diagrams,
    rows: Sequence[tuple[Mark, Sequence[tuple[int, int]]]],
    rest: Mark | None = None,
) -> tuple[Mark, Chart]:
    """Draw the least angle of the line of centres over the turn; return its highest value (Angle).

    ``rows``: angles and the stretches over which they hold; ``rest``: the angle that a dwell needs.
    """
    draft.open(LIMITS)
    mu = draft.take(Number, "μ_ψ", DEGREES, "°/mm")
    axes = graphs.draw_axes(draft, LIMITS, diagrams.base, mu)
    lines = draft.draw(square, "(i)", axes.feet, axes.along, sense=1)
    readings: list[Mark] = []
    numbers = count(1)
    top: Mark | None = None
    for angle, stretches in rows:
        high = draft.draw(f.on_protractor, "y", angle)
        spots = draft.draw(lay_off, "β", lines, high, free=True)
        for first, last in stretches:
            curve = draft.draw(graph_of_stretch, "(β–β)", spots, first=first, last=last)
            own = draft.draw(crest_of_curve, f"k_{next(numbers)}", curve, above=1)
            top = (
                own
                if top is None
                else draft.draw(extreme_of_two, "k", top, own, above=1, free=True)
            )
        readings.append(draft.draw(measure_along, f"β_{len(readings)}", axes.feet, spots, axes.up))
    assert top is not None
    if rest is not None:
        over = draft.draw(square, "(i_0)", axes.origin, axes.along, sense=1)
        spot = draft.draw(lay_off, "β_d", over, draft.draw(f.on_protractor, "y_d", rest))
        top = draft.draw(extreme_of_two, "k", top, spot, above=1, free=True)
    high = draft.draw(measure_along, "y_{max}", axes.origin, top, axes.up)
    found = draft.draw(f.off_protractor, "ψ_{0 min}", high, unit="°")
    assert found.kind is Angle
    return found, Chart(LIMITS, "ψ_0", "°", mu, tuple(readings), False, DEGREES, ROOM)
