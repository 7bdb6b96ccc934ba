"""A flat face on a rocking lever: the least r0 by convexity, the profile as the inner envelope of the face.

Cam and lever turn about each other in the instant centre I, on the line of the centres O1O at the distance
a_w/τ from the pivot O1, where τ tells how much the face turns against the cam while the cam turns by a radian:
1 + dψ/dφ, or 1 − dψ/dφ where on the rise the lever turns along. The normal of the contact passes I: so a
perpendicular from I on the face has its foot in the contact K.

In each position a_w·(2τ − 1)/τ² is laid off from the pivot square to the face, towards the cam, and
a_w·d²ψ/dφ²/τ³ from there along it; the end is E. The projection of O1E on the line of the centres is the radius
of curvature of the profile and the distance of the face from the pivot together. So a line of centres will do
for a position as long as that projection is not too short: the limit stands square to the tangent that goes
from E to the circle about the pivot whose radius is the least projection. The angles of the limits are drawn
over the turn, as for a roller on a lever (`rocker`); the highest one gives the least r0.
"""

from __future__ import annotations

from dataclasses import dataclass

from graphic_tmm.board.charts import Chart
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import advance, in_si, to_board, total
from graphic_tmm.board.operations.instruments import (
    cut,
    join,
    lay_off,
    measure_along,
    meet,
    parallel,
    ray,
    square,
    strike,
    tangent,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import standard_length
from graphic_tmm.board.values import Number, Point, Side
from graphic_tmm.chapters.cam import formulas as f
from graphic_tmm.chapters.cam import words as why
from graphic_tmm.chapters.cam.centre import VIEW, choose_radius
from graphic_tmm.chapters.cam.diagrams import Diagrams
from graphic_tmm.chapters.cam.kinds import FlatRockerFollower
from graphic_tmm.chapters.cam.operations import slant, slew, smooth_stretch
from graphic_tmm.chapters.cam.profile import VIEW as PROFILE
from graphic_tmm.chapters.cam.profile import WORKING, Profile, begin_profile, draw_contour
from graphic_tmm.chapters.cam.rocker import ROOM, draw_limit_diagram
from graphic_tmm.chapters.cam.task import CamTask


@dataclass(frozen=True)
class FaceRegion:
    """Where the cam's centre may stand for a face on a lever, as drawn: by stretch points E, their curves.

    ``limits``: rays from the pivot, ``ends`` of them on the circle of the centres; ``begin``: the lowest
    place of the lever; ``least_centre`` and ``centre`` O; ``least`` and ``r0`` (Number, m), ``radius`` the
    chosen one drawn (Length); ``radii`` of curvature by stretch, ``rest``: those of dwells (Length).
    """

    view: str
    mu: Mark
    points: tuple[Mark, ...]
    curves: tuple[Mark, ...]
    limits: tuple[Mark, ...]
    ends: tuple[Mark, ...]
    begin: Mark
    circle: Mark
    least_centre: Mark
    centre: Mark
    least: Mark
    r0: Mark
    radius: Mark
    radii: tuple[Mark, ...]
    rest: Mark


@dataclass(frozen=True)
class FaceLever:
    """The lever as drawn for the profile: line of centres from O1, their distance, that of the face (Length).

    ``start``, ``swing``, ``sense`` as of `Lever`; ``turning`` τ (Number); ``arm``: of the instant centre
    (Length); ``chart``: the diagram of the limits.
    """

    line: Mark
    centres: Mark
    face: Mark | None
    start: Mark
    swing: Mark
    sense: int
    turning: Mark
    arm: Mark
    chart: Chart


def draw_face_region(
    draft: Draft, order: CamTask, diagrams: Diagrams, of: FlatRockerFollower, sense: int
) -> tuple[FaceRegion, FaceLever]:
    """Draw the limits of the centre, the least r0 and the chosen one.

    ``sense``: 1 if the cam turns counter-clockwise, −1 clockwise.
    """
    draft.open(VIEW)
    rocks = sense if of.same_sense else -sense
    mu = draft.take(Number, "μ_l", order.mu_l or standard_length(of.centres, ROOM), "m/mm")
    draft.lay_out(None, mu)
    centres = draft.draw(to_board, "O_1O", draft.take(Number, "a_w", of.centres, "m"))
    face, need = _least_projection(draft, of)
    pivot = draft.take(Point, "O_1", 0j)
    begin = draft.draw(ray, "(l_0)", pivot, draft.direction(0.0 if rocks > 0 else 180.0))
    circle = draft.draw(strike, "(O_1O)", pivot, centres)
    swing = draft.draw(f.swing_of, "ψ", diagrams.S.reading, unit="°")
    levers = draft.draw(slew, "(l)", pivot, begin, swing, sense=rocks)
    turning_of = f.turning_along if of.same_sense else f.turning_against
    turning = draft.draw(turning_of, "τ", diagrams.V.reading)
    across = draft.draw(square, "(m)", pivot, levers, sense=-rocks)
    points, curves = _ends_of_arms(draft, diagrams, (centres, turning, levers, across))
    way = draft.take(Side, "±", float(rocks))
    limits, ends, angles = [], [], []
    for spots in points:
        touching = draft.draw(tangent, "(t)", spots, pivot, need, way, why=why.FACE_TANGENT)
        limit = draft.draw(square, "(n)", pivot, touching, sense=1, why=why.FACE_LIMIT)
        ends.append(draft.draw(lay_off, "O_l", limit, centres, free=True))
        limits.append(limit)
        angles.append(draft.draw(slant, "β", pivot, ends[-1], begin, sense=-rocks, unit="°"))
    at_rest = draft.draw(f.rest_angle, "β_d", need, centres, unit="°")
    rows = [(angle, [row[1:]]) for angle, row in zip(angles, diagrams.stretches, strict=True)]
    highest, chart = draw_limit_diagram(draft, diagrams, rows, at_rest)
    draft.open(VIEW)
    bound = draft.draw(slew, "(O_{min})", pivot, begin, highest, sense=-rocks)
    least_centre = draft.draw(lay_off, "O_{min}", bound, centres)
    down = draft.draw(square, "(d)", pivot, begin, sense=-rocks)
    low = draft.draw(measure_along, "y_{min}", pivot, least_centre, down)
    if face is not None:
        low = draft.draw(f.below_face, "R_{0min}", low, face)
    least = draft.draw(in_si, "r_{0min}", low, unit="m")
    r0, radius = choose_radius(draft, order, least, face=True)
    reach = radius if face is None else draft.draw(total, "R_0+d", radius, face)
    foot = draft.draw(lay_off, "F", down, reach)
    level = draft.draw(parallel, "(O)", foot, begin)
    centre = draft.draw(cut, "O", level, circle, draft.take(Side, "±", 1.0), why=why.FACE_CENTRE)
    start = draft.draw(slant, "ψ_0", pivot, centre, begin, sense=-rocks, unit="°")
    line = draft.draw(join, "(O_1O)", pivot, centre)
    straight = draft.draw(lay_off, "D", across, centres)
    radii = [_radius_of(draft, (pivot, spots, line), face) for spots in points]
    rest = _radius_of(draft, (pivot, straight, line), face)
    arm = draft.draw(f.instant_arm, "O_1I", centres, turning, why=why.INSTANT_CENTRE)
    region = FaceRegion(
        VIEW, mu, points, curves, tuple(limits), tuple(ends), begin, circle, least_centre, centre,
        least, r0, radius, tuple(radii), rest,
    )  # fmt: skip
    return region, FaceLever(line, centres, face, start, swing, rocks, turning, arm, chart)


def _least_projection(draft: Draft, of: FlatRockerFollower) -> tuple[Mark | None, Mark]:
    """Return the distance of the face from the pivot, if any, and the least projection of O1E (Length)."""
    rho = draft.draw(to_board, "ρ_{min}", draft.take(Number, "[ρ]", of.least, "m"))
    if not of.face:
        return None, rho
    face = draft.draw(to_board, "O_1F", draft.take(Number, "d", of.face, "m"))
    return face, draft.draw(total, "d+ρ_{min}", face, rho)


def _ends_of_arms(
    draft: Draft, diagrams: Diagrams, on: tuple[Mark, Mark, Mark, Mark]
) -> tuple[tuple[Mark, ...], tuple[Mark, ...]]:
    """Mark E for every stretch and draw its curve.

    ``on``: distance of the centres, τ, the lever and the line square to it in every position.
    """
    centres, turning, levers, across = on
    deep = draft.draw(f.arm_across, "m", centres, turning)
    corner = draft.draw(lay_off, "N", across, deep, why=why.FACE_ARM)
    along = draft.draw(parallel, "(e)", corner, levers)
    points, curves = [], []
    for second, (_, first, last) in zip(diagrams.A.readings, diagrams.stretches, strict=True):
        far = draft.draw(f.arm_along, "e", second, centres, turning)
        spots = draft.draw(lay_off, "E", along, far, free=True, why=why.FACE_ARM)
        points.append(spots)
        curves.append(draft.draw(smooth_stretch, "(E–E)", spots, first=first, last=last))
    return tuple(points), tuple(curves)


def _radius_of(draft: Draft, on: tuple[Mark, Mark, Mark], face: Mark | None) -> Mark:
    """Read the radius of curvature: the projection on the line of the centres, less the face's distance."""
    letter = "ρ" if face is None else "ρ+d"
    reach = draft.draw(measure_along, letter, *on, why=why.FACE_RADIUS)
    return reach if face is None else draft.draw(f.below_face, "ρ", reach, face)


def draw_face_profile(
    draft: Draft, diagrams: Diagrams, of: FaceRegion, lever: FaceLever, sense: int
) -> tuple[Profile, Mark]:
    """Draw the profile that the face envelops; return it, and how far contacts are from the feet (Length)."""
    origin = begin_profile(draft, of.mu)
    begin = draft.draw(parallel, "(OO_1)", origin, lever.line, sense=-1)
    centres = draft.draw(
        slew, "(O_1)", origin, begin, diagrams.angle, sense=-sense, why=why.INVERTED
    )
    pivots = draft.draw(lay_off, "O_1", centres, lever.centres)
    back = draft.draw(parallel, "(O)", pivots, centres, sense=-1)
    angle = draft.draw(advance, "ψ_0+ψ", lever.start, lever.swing)
    faces = draft.draw(slew, "(l)", pivots, back, angle, sense=lever.sense)
    feet = pivots
    if lever.face is not None:
        down = draft.draw(square, "(F)", pivots, faces, sense=-lever.sense)
        feet = draft.draw(lay_off, "F", down, lever.face)
        faces = draft.draw(parallel, "(f)", feet, faces)
    instant = draft.draw(lay_off, "I", back, lever.arm, why=why.INSTANT_CENTRE)
    normals = draft.draw(square, "(n)", instant, faces, sense=-lever.sense)
    contacts = draft.draw(meet, "K", faces, normals, why=why.FACE_CONTACT)
    inward = draft.draw(parallel, "(n)", contacts, normals)
    paces = [draft.draw(f.face_pace, "p", radius, lever.turning) for radius in of.radii]
    draft.figure("face lever", "", pivots, feet, contacts)
    working = draw_contour(draft, WORKING, diagrams, origin, (contacts, inward), paces, sense)
    distance = draft.draw(measure_along, "x", feet, contacts, faces, why=why.FACE_LENGTH)
    drawn = Profile(PROFILE, of.mu, origin, pivots, faces, inward, None, None, working)
    return drawn, distance
