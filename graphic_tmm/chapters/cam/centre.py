"""Where the centre of a cam with a translating follower may stand: tangents to S–dS/dφ; a flat face."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import in_si, rescaled, to_board, total
from graphic_tmm.board.operations.instruments import (
    cut,
    lay_off,
    measure,
    measure_along,
    meet,
    parallel,
    ray,
    square,
    strike,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Number, Point, Side
from graphic_tmm.chapters.cam import formulas as f
from graphic_tmm.chapters.cam import words as why
from graphic_tmm.chapters.cam.diagrams import Diagrams
from graphic_tmm.chapters.cam.operations import (
    extreme_of_two,
    outer_parallel,
    phase_end,
    slant,
    smooth_stretch,
    touch_curve,
)
from graphic_tmm.chapters.cam.task import CamTask, FlatFollower

VIEW = "cam centre"


@dataclass(frozen=True)
class Motion:
    """The follower's motion to the scale of the centres: S, dS/dφ, and d²S/dφ² of every stretch (Length)."""

    S: Mark
    V: Mark
    A: tuple[Mark, ...]


@dataclass(frozen=True)
class Centre:
    """The region of allowed centres as drawn, and the centre chosen.

    ``roller``: the roller's centre in its positions; ``points`` Q; ``curves`` through them; ``limits``: lines
    that bound the region, towards the rise and the return; ``ends``: where each cuts the line of the centres (a
    rocker: the circle); ``lowest``: the roller's lowest place; ``centre``
    O. ``least`` and ``r0``: the least radius allowed and the chosen one (Number, m), ``radius`` the chosen
    one on the drawing (Length); ``least_centre``: where the cam's centre stands with the least
    one; ``apex`` and ``apex_radius``: where both limits meet (not with a rocker). ``displacement``
    (Length), ``pressure`` (Angle), ``pace`` (Length) and, for every stretch, ``turning`` of the normal for a
    radian of the cam (Number).
    """

    view: str
    mu: Mark
    roller: Mark
    points: Mark
    curves: tuple[Mark, ...]
    limits: tuple[Mark, ...]
    ends: tuple[Mark, ...]
    lowest: Mark
    least_centre: Mark
    centre: Mark
    least: Mark
    r0: Mark
    radius: Mark
    apex: Mark | None
    apex_radius: Mark | None
    displacement: Mark
    pressure: Mark
    pace: Mark
    turning: tuple[Mark, ...]


@dataclass(frozen=True)
class Path:
    """The path of a translating roller as drawn for its profile: s0 and the offset e (Length)."""

    s0: Mark
    offset: Mark | None


def scale_of_lengths(draft: Draft, order: CamTask, diagrams: Diagrams) -> Mark:
    """Return the scale of centres and profile, that of S unless the order says (m/mm)."""
    if order.mu_l is None:
        return diagrams.S.chart.mu
    return draft.take(Number, "μ_l", order.mu_l, "m/mm")


def scaled_motion(draft: Draft, diagrams: Diagrams, mu: Mark) -> Motion:
    """Carry the readings of the diagrams to the scale ``mu``."""

    def carried(reading: Mark, of: Mark, letter: str) -> Mark:
        if of == mu:
            return reading
        return draft.draw(rescaled, letter, reading, mu)

    seconds = [carried(r, diagrams.A.chart.mu, "a") for r in diagrams.A.readings]
    displacement = carried(diagrams.S.reading, diagrams.S.chart.mu, "s")
    return Motion(
        displacement, carried(diagrams.V.reading, diagrams.V.chart.mu, "v"), tuple(seconds)
    )


def draw_centre(
    draft: Draft, order: CamTask, diagrams: Diagrams, offset: float, sense: int
) -> tuple[Centre, Path]:
    """Draw the S–dS/dφ diagram, the tangents at the allowed pressure angles, the least r0 and the chosen one.

    ``sense``: 1 if the cam turns counter-clockwise, −1 clockwise.
    """
    draft.open(VIEW)
    mu = scale_of_lengths(draft, order, diagrams)
    motion = scaled_motion(draft, diagrams, mu)
    draft.lay_out(None, mu)
    lowest = draft.take(Point, "B_0", 0j)
    up = draft.draw(ray, "(y)", lowest, draft.direction(90.0), why=why.FOLLOWER_LINE)
    roller = draft.draw(lay_off, "B", up, motion.S, why=why.ROLLER_AT)
    outward = draft.draw(square, "(B)", roller, up, sense=sense, why=why.SPEED_LINE)
    points = draft.draw(lay_off, "Q", outward, motion.V, why=why.SPEED_AT)
    curves = tuple(
        draft.draw(smooth_stretch, "(Q–Q)", points, first=first, last=last)
        for _, first, last in diagrams.stretches
    )
    limits = draw_limits(draft, order, diagrams, up, curves, sense)
    down, e = _path(draft, lowest, up, offset, sense)
    ends = tuple(
        draft.draw(meet, f"O_{k}", down, limit, why=why.LIMIT_MET)
        for k, limit in enumerate(limits, 1)
    )
    least_centre = draft.draw(extreme_of_two, "O_{min}", *ends, above=-1)
    least = draft.draw(
        in_si,
        "r_{0min}",
        draft.draw(measure, "OB", least_centre, lowest, why=why.LEAST_READ),
        unit="m",
    )
    apex = draft.draw(meet, "O*", *limits, why=why.APEX)
    small = draft.draw(
        in_si, "r*", draft.draw(measure, "O*B", apex, lowest, why=why.LEAST_READ), unit="m"
    )
    r0, radius = choose_radius(draft, order, least)
    circle = draft.draw(strike, "(R_0)", lowest, radius, why=why.CHOSEN_CIRCLE)
    centre = draft.draw(cut, "O", down, circle, draft.take(Side, "±", 1.0), why=why.CENTRE)
    s0 = draft.draw(measure_along, "s_0", centre, lowest, up, why=why.REACH)
    pressure = draft.draw(slant, "α", centre, points, up, sense=sense, unit="°")
    pace = draft.draw(measure, "OQ", centre, points, why=why.SHARE_OF_CENTRE)
    p = draft.draw(measure_along, "p", centre, points, up, why=why.SHARE_OF_CENTRE)
    out = draft.draw(square, "(B_0)", lowest, up, sense=sense, why=why.SHARE_OF_CENTRE)
    q = draft.draw(measure_along, "q", centre, points, out, why=why.SHARE_OF_CENTRE)
    turning = [draft.draw(f.turning_of_normal, "τ", p, q, motion.V, a) for a in motion.A]
    made = Centre(
        VIEW, mu, roller, points, curves, limits, ends, lowest, least_centre, centre, least, r0,
        radius, apex, small, motion.S, pressure, pace, tuple(turning),
    )  # fmt: skip
    return made, Path(s0, e)


def choose_radius(
    draft: Draft, order: CamTask, least: Mark, *, face: bool = False, letter: str = "r_0"
) -> tuple[Mark, Mark]:
    """Return the radius r0 chosen, or the least one up to whole millimetres: its value and its length drawn."""
    drawn = "R_0" if letter == "r_0" else f"{letter}_l"
    if order.r0 is not None:
        r0 = draft.take(Number, letter, order.r0, "m")
    else:
        if face:
            smallest = draft.take(Number, "r_1", 0.001, "m")
            least = draft.draw(f.greater_radius, "r", least, smallest, unit="m")
        r0 = draft.draw(f.whole_mm_above, letter, least, unit="m")
    return r0, draft.draw(to_board, drawn, r0)


def limit_angles(draft: Draft, order: CamTask) -> tuple[Mark, Mark]:
    """Take the allowed pressure angles, towards the rise and the return; one mark where they are the same."""
    first = draft.take(Angle, "[α]", order.pressure, "°")
    if order.pressure_return is None:
        return first, first
    return first, draft.take(Angle, "[α_f]", order.pressure_return, "°")


def draw_limits(
    draft: Draft,
    order: CamTask,
    diagrams: Diagrams,
    up: Mark,
    curves: Sequence[Mark],
    sense: int,
) -> tuple[Mark, ...]:
    """Draw the tangents at the allowed pressure angles, to the curve of the rise and to that of the return."""
    found = []
    angles = limit_angles(draft, order)
    for k, (phase, angle) in enumerate(zip(diagrams.turn.ways, angles, strict=False), 1):
        left = sense * phase.sign
        rows = zip(curves, diagrams.stretches, strict=True)
        touched = [curve for curve, (of, _, _) in rows if of.sign == phase.sign]
        letters = [f"(τ_{{{k}{n}}})" for n in range(1, len(touched) + 1)]
        letters = letters if len(touched) > 1 else [f"(τ_{k})"]
        own = [
            draft.draw(touch_curve, letter, curve, up, angle, sense=left, left=left)
            for letter, curve in zip(letters, touched, strict=True)
        ]
        line = own[0]
        for n, other in enumerate(own[1:], 2):
            letter = f"(τ_{k})" if other is own[-1] else f"(τ_{{{k}{n}}}′)"
            line = draft.draw(outer_parallel, letter, line, other, left=left)
        found.append(line)
    return tuple(found)


def _path(
    draft: Draft, lowest: Mark, up: Mark, offset: float, sense: int
) -> tuple[Mark, Mark | None]:
    """Draw the line of the centres downward; return it and e as drawn (Length), if there is one."""
    if offset == 0.0:
        return draft.draw(parallel, "(O)", lowest, up, sense=-1, why=why.CENTRE_LINE), None
    e = draft.draw(to_board, "B_0E", draft.take(Number, "e", offset, "m"))
    out = draft.draw(square, "(e)", lowest, up, sense=sense, why=why.CENTRE_LINE)
    foot = draft.draw(lay_off, "E", out, e, why=why.CENTRE_LINE)
    return draft.draw(parallel, "(O)", foot, up, sense=-1, why=why.CENTRE_LINE), e


@dataclass(frozen=True)
class Convexity:
    """The diagram of S over d²S/dφ² as drawn, the least r0 and the chosen one.

    ``points`` and ``curves`` by stretch; ``limit``: the line at 45°; ``cut``: where it cuts the axis of S;
    ``least`` and ``r0`` (Number, m), ``radius`` the chosen one drawn (Length); ``radii``: of curvature, by
    stretch (Length); ``outline``: both ends of every curve; ``lowest``: where S is 0.
    """

    view: str
    mu: Mark
    motion: Motion
    points: tuple[Mark, ...]
    curves: tuple[Mark, ...]
    outline: tuple[Mark, ...]
    limit: Mark
    lowest: Mark
    cut: Mark
    least: Mark
    r0: Mark
    radius: Mark
    radii: tuple[Mark, ...]


def draw_convexity(draft: Draft, order: CamTask, diagrams: Diagrams, of: FlatFollower) -> Convexity:
    """Draw the condition of convexity, the least r0 and the chosen one."""
    draft.open(VIEW)
    mu = scale_of_lengths(draft, order, diagrams)
    motion = scaled_motion(draft, diagrams, mu)
    draft.lay_out(None, mu)
    origin = draft.take(Point, "O", 0j)
    up = draft.draw(ray, "(S)", origin, draft.direction(90.0))
    across = draft.draw(square, "(S″)", origin, up, sense=-1)
    spots = draft.draw(lay_off, "B", up, motion.S)
    lines = draft.draw(parallel, "(B)", spots, across)
    points, curves = [], []
    for second, (_, first, last) in zip(motion.A, diagrams.stretches, strict=True):
        own = draft.draw(lay_off, "E", lines, second, free=True)
        points.append(own)
        curves.append(draft.draw(smooth_stretch, "(E–E)", own, first=first, last=last))
    half = draft.direction(45.0)
    limit = None
    for k, curve in enumerate(curves, 1):
        line = draft.draw(touch_curve, f"(τ_{k})", curve, across, half, sense=-1, left=-1)
        limit = line if limit is None else draft.draw(outer_parallel, "(τ)", limit, line, left=-1)
    assert limit is not None
    cut = draft.draw(meet, "M", up, limit)
    need = draft.draw(measure_along, "MO", cut, origin, up)
    rho = draft.draw(to_board, "ρ_{min}", draft.take(Number, "[ρ]", of.least, "m"))
    low = draft.draw(total, "R_{0min}", need, rho)
    least = draft.draw(in_si, "r_{0min}", low, unit="m")
    r0, radius = choose_radius(draft, order, least, face=True)
    radii = tuple(draft.draw(f.flat_radius, "ρ", radius, motion.S, second) for second in motion.A)
    ends = []
    for own, (_, first, last) in zip(points, diagrams.stretches, strict=True):
        ends += [
            draft.draw(phase_end, "e", own, at=first, free=True),
            draft.draw(phase_end, "e", own, at=last, free=True),
        ]
    for a, b in zip(ends[1::2], ends[2::2], strict=False):
        draft.figure("outline", "between", a, b)
    return Convexity(
        VIEW, mu, motion, tuple(points), tuple(curves), tuple(ends), limit, origin, cut, least, r0,
        radius, radii,
    )  # fmt: skip
