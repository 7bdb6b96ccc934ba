"""A cam on a drum, developed: the groove of a roller whose rod moves along the drum's axis; a cam that slides.

Unrolled, the drum's mean circumference is a straight line: a point of the roller's path stands at R·φ along it
and at S across. The rod moves square to that line, so its angle with the normal is that of the tangent with the
line: tan α = (dS/dφ)/R. From the pole O, at the distance R before an axis on which dS/dφ is laid off, a ray to
its end Q is parallel to the tangent; rays at the allowed angles through the farthest Q of either side give the
least R. The groove's flanks touch the roller on either side of its path, at its radius along the normals.

A plate that slides is what such a development is: of its length L instead of R, a share of its travel instead
of an angle. L·dS/ds is laid off on the axis then, and the pole stands at the distance L before it.
"""

from __future__ import annotations

from dataclasses import dataclass

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import in_si, rescaled, to_board
from graphic_tmm.board.operations.instruments import (
    join,
    lay_off,
    measure,
    meet,
    parallel,
    ray,
    square,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Point
from graphic_tmm.chapters.cam import formulas as f
from graphic_tmm.chapters.cam import formulas_drum as g
from graphic_tmm.chapters.cam import formulas_plate as p
from graphic_tmm.chapters.cam import words_drum, words_plate
from graphic_tmm.chapters.cam.centre import (
    Centre,
    Motion,
    choose_radius,
    draw_limits,
    scale_of_lengths,
    scaled_motion,
)
from graphic_tmm.chapters.cam.diagrams import Diagrams
from graphic_tmm.chapters.cam.operations import slant, smooth_stretch
from graphic_tmm.chapters.cam.profile import (
    THEORETICAL,
    WORKING,
    Profile,
    draw_contour,
    draw_flanks,
)
from graphic_tmm.chapters.cam.task import CamTask

VIEW, DEVELOPMENT = "cam drum", "cam development"
PLATE, SLIDING = "cam plate", "cam sliding profile"
"""The same two views of a cam that slides."""


@dataclass(frozen=True)
class Drum:
    """A drum as drawn: ``along`` the base of dS/dφ from its axis, ``rays`` from the pole O to Q.

    ``base``: the line of the developed circumference, of the ``length`` 2πR (Length), or of a travel.
    """

    along: Mark
    rays: Mark
    base: Mark | None = None
    length: Mark | None = None


def draw_drum_centre(draft: Draft, order: CamTask, diagrams: Diagrams) -> tuple[Centre, Drum]:
    """Draw the rays of the tangents, the least mean radius by the allowed pressure angles, the chosen one."""
    why, letter = (words_plate, "L") if order.slides else (words_drum, "R")
    view = PLATE if order.slides else VIEW
    draft.open(view)
    mu = scale_of_lengths(draft, order, diagrams)
    motion = (
        _over_travel(draft, diagrams, mu) if order.slides else scaled_motion(draft, diagrams, mu)
    )
    draft.lay_out(None, mu)
    foot = draft.take(Point, "M", 0j)
    along = draft.draw(ray, "(x)", foot, draft.direction(0.0))
    up = draft.draw(square, "(y)", foot, along, sense=1)
    points = draft.draw(lay_off, "Q", up, motion.V, why=why.RATE_AT)
    curves = tuple(
        draft.draw(smooth_stretch, "(Q–Q)", points, first=first, last=last)
        for _, first, last in diagrams.stretches
    )
    limits = draw_limits(draft, order, diagrams, along, curves, 1)
    back = draft.draw(parallel, "(O)", foot, along, sense=-1)
    ends = tuple(
        draft.draw(meet, f"O_{k}", back, limit, why=words_drum.LIMIT)
        for k, limit in enumerate(limits, 1)
    )
    least, *others = (
        draft.draw(
            in_si,
            f"{letter}_{end.letter}",
            draft.draw(measure, f"{end.letter}M", end, foot),
            unit="m",
        )
        for end in ends
    )
    for other in others:
        least = draft.draw(
            f.greater_radius, f"{letter}_{{min}}", least, other, unit="m", why=words_drum.GREATER
        )
    reach = draft.draw(to_board, f"{letter}_m", least)
    least_centre = draft.draw(lay_off, "O_{min}", back, reach)
    if diagrams.travel is not None:
        r0, radius = diagrams.travel, draft.draw(to_board, "L", diagrams.travel)
    else:
        r0, radius = choose_radius(draft, order, least, letter=letter)
    centre = draft.draw(lay_off, "O", back, radius, why=why.POLE)
    rays = draft.draw(join, "(OQ)", centre, points, why=why.RAY)
    pressure = draft.draw(slant, "α", centre, points, along, sense=1, unit="°", why=why.ANGLE)
    pace = draft.draw(measure, "OQ", centre, points)
    turning = tuple(
        draft.draw(g.turning_of_tangent, "τ", second, radius, pace, why=why.TURNING)
        for second in motion.A
    )
    made = Centre(
        view, mu, points, points, curves, limits, ends, foot, least_centre, centre, least, r0,
        radius, None, None, motion.S, pressure, pace, turning,
    )  # fmt: skip
    return made, Drum(along, rays)


def _over_travel(draft: Draft, diagrams: Diagrams, mu: Mark) -> Motion:
    """Carry the readings of a cam that slides to the scale ``mu``: derivatives by shares of its travel."""
    S, V, A, travel = diagrams.S, diagrams.V, diagrams.A, diagrams.travel
    assert travel is not None
    seconds = [
        draft.draw(p.second_over_travel, "a", one, A.chart.mu, travel, mu) for one in A.readings
    ]
    speed = draft.draw(p.rise_over_travel, "v", V.reading, V.chart.mu, travel, mu)
    high = S.reading if S.chart.mu == mu else draft.draw(rescaled, "s", S.reading, mu)
    return Motion(high, speed, tuple(seconds))


def draw_development(
    draft: Draft, order: CamTask, diagrams: Diagrams, of: Centre, drum: Drum, roller: Mark | None
) -> tuple[Profile, Drum]:
    """Draw the path of the roller, or of the edge, on what is developed, with the flank or both.

    ``roller``: its radius (Number, m).
    """
    why, view = (words_plate, SLIDING) if order.slides else (words_drum, DEVELOPMENT)
    draft.open(view)
    draft.lay_out(None, of.mu)
    origin = draft.take(Point, "M_0", 0j)
    base = draft.draw(ray, "(x)", origin, draft.direction(0.0), why=why.BASE_LINE)
    if order.slides:
        length, x = of.radius, draft.draw(to_board, "x", diagrams.angle)
    else:
        length = draft.draw(g.circumference, "2πR", of.radius)
        x = draft.draw(g.developed, "x", of.radius, diagrams.angle)
    feet = draft.draw(lay_off, "M", base, x, why=why.FOOT)
    guides = draft.draw(square, "(i)", feet, base, sense=1)
    points = draft.draw(lay_off, "B", guides, of.displacement, why=why.PATH_POINT)
    tangents = draft.draw(parallel, "(t)", points, drum.rays, sense=1, why=words_drum.TANGENT)
    normals = draft.draw(square, "(n)", points, tangents, sense=-1, why=words_drum.NORMAL)
    rows = [of.pace] * len(diagrams.stretches)
    name = THEORETICAL if roller is not None else WORKING
    path = draw_contour(draft, name, diagrams, base, (points, normals), rows, 1)
    developed = Drum(drum.along, drum.rays, base, length)
    stands = (view, of.mu, origin, feet, guides, normals)
    if roller is None:
        return Profile(*stands, None, path, path), developed
    radius = draft.draw(to_board, "R_r", roller)
    draft.figure("roller", "", points, radius)
    flanks = draw_flanks(
        draft, diagrams, of, base, (points, normals), radius, 1, groove=order.grooved
    )
    return Profile(*stands, radius, path, *flanks), developed
