"""A cam on a drum, developed: the groove of a roller whose rod moves along the drum's axis.

Unrolled, the drum's mean circumference is a straight line: a point of the roller's path stands at R·φ along it
and at S across. The rod moves square to that line, so its angle with the normal is that of the tangent with the
line: tan α = (dS/dφ)/R. From the pole O, at the distance R before an axis on which dS/dφ is laid off, a ray to
its end Q is parallel to the tangent; rays at the allowed angles through the farthest Q of either side give the
least R. The groove's flanks touch the roller on either side of its path, at its radius along the normals.
"""

from __future__ import annotations

from dataclasses import dataclass

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import in_si, to_board
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
from graphic_tmm.chapters.cam import words_drum as why
from graphic_tmm.chapters.cam.centre import (
    Centre,
    choose_radius,
    draw_limits,
    scale_of_lengths,
    scaled_motion,
)
from graphic_tmm.chapters.cam.diagrams import Diagrams
from graphic_tmm.chapters.cam.operations import slant, smooth_stretch
from graphic_tmm.chapters.cam.profile import (
    THEORETICAL,
    Profile,
    draw_contour,
    draw_flanks,
)
from graphic_tmm.chapters.cam.task import CamTask

VIEW, DEVELOPMENT = "cam drum", "cam development"


@dataclass(frozen=True)
class Drum:
    """A drum as drawn: ``along`` the base of dS/dφ from its axis, ``rays`` from the pole O to Q.

    ``base``: the line of the developed circumference, of the ``length`` 2πR (Length).
    """

    along: Mark
    rays: Mark
    base: Mark | None = None
    length: Mark | None = None


def draw_drum_centre(draft: Draft, order: CamTask, diagrams: Diagrams) -> tuple[Centre, Drum]:
    """Draw the rays of the tangents, the least mean radius by the allowed pressure angles, the chosen one."""
    draft.open(VIEW)
    mu = scale_of_lengths(draft, order, diagrams)
    motion = scaled_motion(draft, diagrams, mu)
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
        draft.draw(meet, f"O_{k}", back, limit, why=why.LIMIT) for k, limit in enumerate(limits, 1)
    )
    least, *others = (
        draft.draw(
            in_si, f"R_{end.letter}", draft.draw(measure, f"{end.letter}M", end, foot), unit="m"
        )
        for end in ends
    )
    for other in others:
        least = draft.draw(f.greater_radius, "R_{min}", least, other, unit="m", why=why.GREATER)
    reach = draft.draw(to_board, "O_{min}M", least)
    least_centre = draft.draw(lay_off, "O_{min}", back, reach)
    r0, radius = choose_radius(draft, order, least, letter="R")
    centre = draft.draw(lay_off, "O", back, radius, why=why.POLE)
    rays = draft.draw(join, "(OQ)", centre, points, why=why.RAY)
    pressure = draft.draw(slant, "α", centre, points, along, sense=1, unit="°", why=why.ANGLE)
    pace = draft.draw(measure, "OQ", centre, points)
    turning = tuple(
        draft.draw(g.turning_of_tangent, "τ", second, radius, pace) for second in motion.A
    )
    made = Centre(
        VIEW, mu, points, points, curves, limits, ends, foot, least_centre, centre, least, r0,
        radius, None, None, motion.S, pressure, pace, turning,
    )  # fmt: skip
    return made, Drum(along, rays)


def draw_development(
    draft: Draft, diagrams: Diagrams, of: Centre, drum: Drum, roller: Mark
) -> tuple[Profile, Drum]:
    """Draw the roller's path on the developed drum with both flanks of the groove.

    ``roller``: its radius (Number, m).
    """
    draft.open(DEVELOPMENT)
    draft.lay_out(None, of.mu)
    origin = draft.take(Point, "M_0", 0j)
    base = draft.draw(ray, "(x)", origin, draft.direction(0.0), why=why.BASE)
    length = draft.draw(g.circumference, "2πR", of.radius)
    x = draft.draw(g.developed, "x", of.radius, diagrams.angle)
    feet = draft.draw(lay_off, "M", base, x, why=why.FOOT)
    guides = draft.draw(square, "(i)", feet, base, sense=1)
    points = draft.draw(lay_off, "B", guides, of.displacement, why=why.PATH_POINT)
    tangents = draft.draw(parallel, "(t)", points, drum.rays, sense=1, why=why.TANGENT)
    normals = draft.draw(square, "(n)", points, tangents, sense=-1, why=why.NORMAL)
    rows = [of.pace] * len(diagrams.stretches)
    path = draw_contour(draft, THEORETICAL, diagrams, base, (points, normals), rows, 1)
    radius = draft.draw(to_board, "R_r", roller)
    draft.figure("roller", "", points, radius)
    lower, outer = draw_flanks(draft, diagrams, of, base, (points, normals), radius, 1)
    drawn = Profile(DEVELOPMENT, of.mu, origin, feet, guides, normals, radius, path, lower, outer)
    return drawn, Drum(drum.along, drum.rays, base, length)
