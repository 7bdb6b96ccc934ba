"""The least radius of a cam with a flat face: its profile is convex everywhere.

The radius of curvature is r0 + S + d²S/dφ². In the diagram of S over d²S/dφ² the sum is constant on lines
that fall at 45°; the one that touches the curve from below cuts off on the axis of S how much r0 has to make
up for.
"""

from __future__ import annotations

from dataclasses import dataclass

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import in_si, to_board, total
from graphic_tmm.board.operations.instruments import (
    lay_off,
    measure_along,
    meet,
    parallel,
    ray,
    square,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number, Point
from graphic_tmm.chapters.cam import formulas as f
from graphic_tmm.chapters.cam.centre import (
    VIEW,
    Motion,
    choose_radius,
    scale_of_lengths,
    scaled_motion,
)
from graphic_tmm.chapters.cam.diagrams import Diagrams
from graphic_tmm.chapters.cam.operations import (
    outer_parallel,
    phase_end,
    smooth_stretch,
    touch_curve,
)
from graphic_tmm.chapters.cam.task import CamTask, FlatFollower


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
    low = draft.draw(total, "R_{min}", need, rho)
    least = draft.draw(in_si, "r_{min}", low, unit="m")
    r0, radius = choose_radius(draft, order, least)
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
