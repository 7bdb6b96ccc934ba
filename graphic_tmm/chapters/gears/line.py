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
    meet,
    parallel,
    ray,
    square,
    strike,
    touch,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Point, Side
from graphic_tmm.chapters.gears import words as why
from graphic_tmm.chapters.gears.dimensions import GearSizes, WheelSizes
from graphic_tmm.chapters.gears.driven_rack import DrivenRack

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
class RackLines:
    """Lines of a rack: on which it rolls (of no shift its datum line, too), datum, tips, roots, ends of flanks.

    ``foot``: where the line of centres crosses the datum line.
    """

    foot: Mark
    rolling: Mark
    datum: Mark
    tip: Mark
    root: Mark
    straight: Mark


@dataclass(frozen=True)
class ActionLine:
    """The line of action N1N2 (Line) with its limits N1, N2, the pitch point P, its working part ab.

    ``tips``: where the tip circles cut it, wheel 2's and wheel 1's; of a ring its root circle, where its
    flanks end. ``ends``: a and b, where teeth touch first and last, the same but of pointed teeth and beyond
    the limits.

    ``centres``: the line of centres. ``angle``: that of the line of action with the common tangent in P as
    drawn (Angle). ``length``: N1N2, ``to_ends``: N1a and N1b by a and b where these are no limits,
    ``to_pole``: N1P, ``working``: ab, all as measured (Length). ``rack``: with one there is one wheel and one
    limit, and ``length`` is N1P.
    """

    mu: Mark
    centres: Mark
    circles: tuple[Circles, ...]
    pole: Mark
    limits: tuple[Mark, ...]
    tips: tuple[Mark, Mark]
    ends: tuple[Mark, Mark]
    line: Mark
    angle: Mark
    length: Mark
    to_ends: Mapping[Mark, Mark]
    to_pole: Mark
    working: Mark
    rack: RackLines | None


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
    name = "(O_{1}O_{2})" if sizes.rack is None else "(O_{1}P)"
    centres = draft.draw(ray, name, first, upward, why=why.CENTRES)
    middles = [first]
    if sizes.rack is None:
        distance = draft.draw(to_board, "[a_{w}]", sizes.a_w)
        axis = centres
        if internal:
            axis = draft.draw(parallel, "(O_{1}O_{2})", first, centres, sense=-1, why=why.CENTRES)
        middles.append(draft.draw(lay_off, "O_{2}", axis, distance, why=why.CENTRES))
    circles = tuple(_circles(draft, *of) for of in zip(sizes.wheels, middles, strict=True))
    reach = next(m for m in draft.uses(circles[0].working) if m != first)
    pole = draft.draw(lay_off, "P", centres, reach, why=why.POLE)
    side = draft.take(Side, "σ", -1.0)
    limits = tuple(
        draft.draw(touch, f"N_{{{i}}}", pole, one.base, side, why=why.LIMIT)
        for i, one in enumerate(circles, 1)
    )
    along = (limits[0], limits[-1]) if sizes.rack is None else (limits[0], pole)
    if internal:
        along = along[::-1]
    name = "".join(mark.letter for mark in along)
    line = draft.draw(join, f"({name})", *along, why=why.ACTION)
    forward, back = draft.take(Side, "+", 1.0), draft.take(Side, "−", -1.0)
    rack = _rack_lines(draft, sizes, sizes.rack, centres, pole) if sizes.rack else None
    if rack is not None:
        start = draft.draw(meet, "e" if sizes.beyond[0] else "a", line, rack.tip, why=why.RACK_TIP)
        a = limits[0] if sizes.beyond[0] else start
    elif internal:
        start = draft.draw(cut, "g", line, circles[1].root, forward, why=why.ROOT)
        a = limits[0]
        if not sizes.beyond[0]:
            reach = _outmost(draft, sizes.wheels[1], circles[1])
            a = draft.draw(cut, "a", line, reach, forward, why=why.ENTERS)
    else:
        start, a = _end(draft, sizes, circles, (line, limits[0], back), 0)
    stop, b = _end(draft, sizes, circles, (line, limits[-1], forward), 1)
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
        spans[limits[0], pole], spans[a, b], rack,
    )  # fmt: skip


def _end(
    draft: Draft,
    sizes: GearSizes,
    circles: tuple[Circles, ...],
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
    short, beyond = other.top is not other.r_a, k < len(sizes.beyond) and sizes.beyond[k]
    name = "ef"[k] if short or beyond else letter
    tip = draft.draw(cut, name, line, at.tip, side, why=reason)
    if beyond:
        return tip, limit
    if not short:
        return tip, tip
    return tip, draft.draw(cut, letter, line, _outmost(draft, other, at), side, why=reason)


def _rack_lines(
    draft: Draft, sizes: GearSizes, rack: DrivenRack, centres: Mark, pole: Mark
) -> RackLines:
    """Draw the lines of a rack, square to that of centres; none is its datum line twice."""
    rolling = draft.draw(square, "(w_{2})", pole, centres, sense=-1, why=why.RACK_LINE)
    feet, lines = [], []
    for letter, real in zip("mafl", (sizes.a_w, rack.tip, rack.root, rack.straight), strict=True):
        high = draft.draw(to_board, f"[{real.letter}]", real)
        feet.append(draft.draw(lay_off, f"Q_{{{letter}}}", centres, high, why=why.RACK_LINE))
        lines.append(
            draft.draw(parallel, f"({letter}_{{2}})", feet[-1], rolling, why=why.RACK_LINE)
        )
    return RackLines(feet[0], rolling, *lines)


def _outmost(draft: Draft, wheel: WheelSizes, own: Circles) -> Mark:
    """Return the circle up to which the teeth of a wheel are there, pointed ones no farther."""
    if wheel.top is wheel.r_a:
        return own.tip
    reach = draft.draw(to_board, f"[{wheel.top.letter}]", wheel.top)
    return draft.draw(strike, f"({wheel.top.letter})", own.centre, reach, why=why.APEX)


def _circles(draft: Draft, wheel: WheelSizes, centre: Mark) -> Circles:
    """Strike the five circles of a wheel."""
    arcs: list[Mark] = []
    for real in (wheel.r, wheel.r_b, wheel.r_w, wheel.r_f, wheel.r_a):
        if real is wheel.r and arcs:
            arcs.append(arcs[0])  # on a rack a wheel rolls with its pitch circle
            continue
        radius = draft.draw(to_board, f"[{real.letter}]", real)
        arcs.append(draft.draw(strike, f"({real.letter})", centre, radius, why=why.CIRCLE))
    return Circles(centre, *arcs)
