"""Where two gears mesh: centres, circles, the line of action with its limits, its working part."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import to_board
from graphic_tmm.board.operations.instruments import (
    bearing,
    cut,
    join,
    lay_off,
    measure_along,
    parallel,
    ray,
    strike,
    touch,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Point, Side
from graphic_tmm.chapters.gears import words as why
from graphic_tmm.chapters.gears.dimensions import GearSizes, WheelSizes

VIEW = "gear"


@dataclass(frozen=True)
class Circles:
    """The circles of a wheel (Arc) and its centre: pitch, base, working, root, tip."""

    centre: Mark
    pitch: Mark
    base: Mark
    working: Mark
    root: Mark
    tip: Mark


@dataclass(frozen=True)
class ActionLine:
    """The line of action N1N2 (Line) with its limits N1, N2, the pitch point P, its working part ab.

    ``tips``: where the tip circles cut it, wheel 2's and wheel 1's; of a ring its root circle, where its
    flanks end. ``ends``: a and b, where teeth touch first and last, the same but of pointed teeth and beyond
    the limits.

    ``centres``: the line of centres. ``angle``: that of the line of action with the common tangent in P as
    drawn (Angle). ``length``: N1N2, ``to_ends``: N1a and N1b by a and b where these are no limits,
    ``to_pole``: N1P, ``working``: ab, all as measured (Length).
    """

    mu: Mark
    centres: Mark
    circles: tuple[Circles, Circles]
    pole: Mark
    limits: tuple[Mark, Mark]
    tips: tuple[Mark, Mark]
    ends: tuple[Mark, Mark]
    line: Mark
    angle: Mark
    length: Mark
    to_ends: Mapping[Mark, Mark]
    to_pole: Mark
    working: Mark


def draw_action_line(draft: Draft, sizes: GearSizes) -> ActionLine:
    """Draw the centres, the circles of both wheels and the line of action, wheel 1 below, driving to the right.

    The line of action touches both base circles; wheel 2's tip circle cuts a off it, wheel 1's b. Beyond N1 and
    N2 no flank is an involute: where a tip reaches farther, the teeth touch from there on. The centre of a ring
    lies below that of wheel 1, and N2 on the same side of P as N1.
    """
    draft.open(VIEW)
    mu = draft.scale("μ_l", "m/mm")
    draft.lay_out()
    first = draft.take(Point, "O_{1}", 0j)
    internal = sizes.ring is not None
    upward = draft.direction(90.0)
    centres = draft.draw(ray, "(O_{1}O_{2})", first, upward, why=why.CENTRES)
    distance = draft.draw(to_board, "[a_{w}]", sizes.a_w)
    axis = centres
    if internal:
        axis = draft.draw(parallel, "(O_{1}O_{2})", first, centres, sense=-1, why=why.CENTRES)
    second = draft.draw(lay_off, "O_{2}", axis, distance, why=why.CENTRES)
    own, other = sizes.wheels
    circles = (_circles(draft, own, first), _circles(draft, other, second))
    reach = next(m for m in draft.uses(circles[0].working) if m != first)
    pole = draft.draw(lay_off, "P", centres, reach, why=why.POLE)
    side = draft.take(Side, "σ", -1.0)
    limits = (
        draft.draw(touch, "N_{1}", pole, circles[0].base, side, why=why.LIMIT),
        draft.draw(touch, "N_{2}", pole, circles[1].base, side, why=why.LIMIT),
    )
    along = limits[::-1] if internal else limits
    name = "".join(mark.letter for mark in along)
    line = draft.draw(join, f"({name})", *along, why=why.ACTION)
    forward, back = draft.take(Side, "+", 1.0), draft.take(Side, "−", -1.0)
    if internal:
        start = draft.draw(cut, "g", line, circles[1].root, forward, why=why.ROOT)
        a = limits[0]
        if not sizes.beyond[0]:
            reach = _outmost(draft, other, circles[1])
            a = draft.draw(cut, "a", line, reach, forward, why=why.ENTERS)
    else:
        start, a = _end(draft, sizes, circles, (line, limits[0], back), 0)
    stop, b = _end(draft, sizes, circles, (line, limits[1], forward), 1)
    angle = draft.draw(bearing, sizes.alpha_w.letter, *along, why=why.MESH_ANGLE)
    wanted = (along, (limits[0], a), (limits[0], b), (limits[0], pole), (a, b))
    spans = {
        (one, end): draft.draw(
            measure_along, f"{one.letter}{end.letter}", one, end, line, why=why.SPAN
        )
        for one, end in dict.fromkeys(wanted)
        if one is not end
    }
    to_ends = {end: spans[limits[0], end] for end in (a, b) if end not in limits}
    return ActionLine(
        mu, centres, circles, pole, limits, (start, stop), (a, b), line, angle, spans[along], to_ends,
        spans[limits[0], pole], spans[a, b],
    )  # fmt: skip


def _end(
    draft: Draft,
    sizes: GearSizes,
    circles: tuple[Circles, Circles],
    toward: tuple[Mark, Mark, Mark],
    k: int,
) -> tuple[Mark, Mark]:
    """Cut the line of action where the tip circle of the other wheel passes on the side of wheel ``k``.

    ``toward``: the line, the limit on that side, the side. Returns that point and the end of the working line:
    where the teeth themselves reach, at the limit at most.
    """
    other, letter = sizes.wheels[1 - k], "ab"[k]
    line, limit, side = toward
    reason, at = (why.ENTERS, why.LEAVES)[k], circles[1 - k]
    short = other.top is not other.r_a
    name = "ef"[k] if short or sizes.beyond[k] else letter
    tip = draft.draw(cut, name, line, at.tip, side, why=reason)
    if sizes.beyond[k]:
        return tip, limit
    if not short:
        return tip, tip
    return tip, draft.draw(cut, letter, line, _outmost(draft, other, at), side, why=reason)


def _outmost(draft: Draft, wheel: WheelSizes, own: Circles) -> Mark:
    """Return the circle up to which the teeth of a wheel are there, pointed ones no farther."""
    if wheel.top is wheel.r_a:
        return own.tip
    reach = draft.draw(to_board, f"[{wheel.top.letter}]", wheel.top)
    return draft.draw(strike, f"({wheel.top.letter})", own.centre, reach, why=why.APEX)


def _circles(draft: Draft, wheel: WheelSizes, centre: Mark) -> Circles:
    """Strike the five circles of a wheel."""
    arcs = []
    for real in (wheel.r, wheel.r_b, wheel.r_w, wheel.r_f, wheel.r_a):
        radius = draft.draw(to_board, f"[{real.letter}]", real)
        arcs.append(draft.draw(strike, f"({real.letter})", centre, radius, why=why.CIRCLE))
    return Circles(centre, *arcs)
