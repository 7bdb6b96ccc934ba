"""The second derivative of the follower's motion without differentiation, on both sides of a change of arcs.

On an arc the cam OK and a rod KB move the follower as crank and rod of a linkage do. Let the cam turn by a
radian a second. The line through O square to the follower's velocity meets the normal KB in V, and O K V is the
triangle of velocities turned by a right angle; so KV²/KB is the normal acceleration of the rod. It is laid off
from K along KB to N, and the square to KB in N meets the line through O along the follower's way in Q: the
polygon of accelerations, turned round (Klein's construction). OQ is the size of d²S/dφ². A straight flank is a
rod without end: 2·BV is laid off from B. A flat face moves with the projection of K. A lever has a normal
acceleration of its own, (dψ/dφ)²·O₁B, laid off from O to M: the square to the lever in M takes the place of the
way, and d²ψ/dφ² is MQ/O₁B.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.instruments import (
    join,
    lay_off,
    measure,
    measure_along,
    meet,
    parallel,
    square,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number, Reals
from graphic_tmm.chapters.arc_cam import formulas as f
from graphic_tmm.chapters.arc_cam import words as why
from graphic_tmm.chapters.arc_cam.contour import Arc
from graphic_tmm.chapters.arc_cam.formulas import on_arc, while_on
from graphic_tmm.chapters.arc_cam.geometry import ARCS, SAME
from graphic_tmm.chapters.arc_cam.plan import ArcCam
from graphic_tmm.chapters.arc_cam.task import FLAT


class _Way(NamedTuple):
    """Lines through O: along the follower's way (of a lever, along it), and square to its velocity.

    ``arm``: the length O₁B of a lever.
    """

    line: Mark
    turned: Mark
    arm: Mark | None = None


class _Closed(NamedTuple):
    """Where OQ (MQ) begins and ends: on one arc, or put together."""

    start: Mark
    end: Mark


def second_derivatives(draft: Draft, made: ArcCam) -> tuple[Mark, Mark]:
    """Find d²S/dφ² (m; of a lever 1) in every position: on the arc before a change, and on that behind it.

    The base circle stands before the first change and behind the last: there it is 0.
    """
    changes = (np.array(made.lie.changes) - made.lie.changes[0]) / made.lie.work
    shares = np.array(made.angles) / made.lie.work
    way, found = _way(draft, made), []
    for k, name in enumerate(ARCS):
        start, end = changes[k : k + 2]
        on = (shares > start - SAME) & (shares < end + SAME)
        if end - start > SAME and on.any():
            at = draft.take(Number, "σ", np.where(on, 1.0, np.nan)[None, :])
            closed = _closed(draft, made, way, made.contour.arcs[name], at, f"_{k + 1}")
            found.append((closed, start, end))
    before, behind = (
        _read(
            draft, made, way, [(one, _between(shares + by, *ends)) for one, *ends in found], letter
        )
        for by, letter in ((-SAME, "S″_{K}"), (SAME, "S″_{K+}"))
    )
    return before, behind


def _between(shares: Reals, start: float, end: float) -> Reals:
    return np.where((shares > start) & (shares < end), 1.0, 0.0)[None, :]


def _way(draft: Draft, made: ArcCam) -> _Way:
    """Draw the lines through O."""
    draw, origin, follower = draft.draw, made.contour.origin, made.follower
    if follower.pivots is None:
        line = draw(parallel, "(OQ)", origin, follower.guides, why=why.WAY)
        return _Way(line, draw(square, "(OV)", origin, line, sense=1, why=why.TRIANGLE))
    lever = draw(join, "(O_1B)", follower.pivots, follower.points)
    line = draw(parallel, "(OM)", origin, lever, why=why.WAY_OF_LEVER)
    return _Way(line, line, draw(measure, "O_1B", follower.pivots, follower.points))


def _closed(draft: Draft, made: ArcCam, way: _Way, arc: Arc, at: Mark, number: str) -> _Closed:
    """Close the polygon of accelerations for the positions on an arc.

    ``at``: 1 there, missing elsewhere; ``number``: behind the letters of its ends, put together later.
    """
    draw, origin = draft.draw, made.contour.origin
    if made.order.follower == FLAT:
        assert arc.centre is not None
        corner = draw(while_on, f"{arc.centre.name}′", arc.centre, at, free=True)
        across = draw(square, "(NQ)", corner, way.line, sense=1, why=why.CLOSES)
        return _Closed(
            origin, draw(meet, f"Q{number}", across, way.line, free=True, why=why.CLOSES)
        )
    point = draw(while_on, "B′", made.follower.points, at, free=True)
    if arc.centre is None:
        assert arc.way is not None
        begins, normal = point, draw(square, "(n)", point, arc.way, why=why.NORMAL)
    else:
        begins = arc.centre
        normal = draw(join, f"({begins.name}B)", begins, point, why=why.NORMAL)
    turned = draw(meet, "V", way.turned, normal, free=True, why=why.TRIANGLE)
    part = draw(measure_along, "KV", begins, turned, normal, why=why.TRIANGLE)
    uses = (part,) if arc.reach is None else (part, arc.reach)
    rod = draw(f.twice if arc.reach is None else f.normal_part, "n", *uses)
    corner = draw(lay_off, "N", normal, rod, free=True, why=why.NORMAL_PART)
    across = draw(square, "(NQ)", corner, normal, sense=1, why=why.CLOSES)
    start, line = origin, way.line
    if way.arm is not None:
        own = draw(measure_along, "OV", origin, turned, way.line, why=why.TRIANGLE)
        lever = draw(f.normal_part, "n_1", own, way.arm)
        start = draw(lay_off, f"M{number}", way.line, lever, free=True, why=why.WAY_OF_LEVER)
        line = draw(square, f"(M{number}Q{number})", start, way.line, sense=1, why=why.WAY_OF_LEVER)
    return _Closed(start, draw(meet, f"Q{number}", across, line, free=True, why=why.CLOSES))


def _read(
    draft: Draft, made: ArcCam, way: _Way, arcs: list[tuple[_Closed, Reals]], letter: str
) -> Mark:
    """Put the polygons of the arcs together, and read what they tell; on the base circle both ends are O."""
    draw, start, end = draft.draw, made.contour.origin, made.contour.origin
    for k, (one, there) in enumerate(arcs, start=1):
        at = draft.take(Number, "σ", there)
        until = "" if k == len(arcs) else f"_{{1–{k}}}"
        end = draw(on_arc, f"Q{until}", one.end, end, at, free=True)
        if way.arm is not None:
            start = draw(on_arc, f"M{until}", one.start, start, at, free=True)
    if way.arm is None:
        part = draw(measure_along, "OQ", start, end, way.line)
        return draw(f.second_derivative, letter, part, made.contour.mu, unit="m")
    left = made.sense * (-1 if made.order.same_sense else 1)
    line = draw(square, "(MQ)", start, way.line, sense=left)
    part = draw(measure_along, "MQ", start, end, line)
    return draw(f.second_of_lever, letter.replace("S", "ψ"), part, way.arm, unit="rad")
