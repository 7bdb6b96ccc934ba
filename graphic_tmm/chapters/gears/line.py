"""Where two gears mesh: centres, circles, the line of action with its limits, its working part."""

from __future__ import annotations

from dataclasses import dataclass

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import to_board
from graphic_tmm.board.operations.instruments import (
    bearing,
    cut,
    join,
    lay_off,
    measure_along,
    ray,
    strike,
    touch,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Point, Side
from graphic_tmm.chapters.gears import reasons as why
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

    ``centres``: the line of centres. ``angle``: that of the line of action with the common tangent in P as
    drawn (Angle). ``length``: N1N2, ``to_ends``: N1a and N1b, ``to_pole``: N1P, ``working``: ab, all as
    measured (Length).
    """

    mu: Mark
    centres: Mark
    circles: tuple[Circles, Circles]
    pole: Mark
    limits: tuple[Mark, Mark]
    ends: tuple[Mark, Mark]
    line: Mark
    angle: Mark
    length: Mark
    to_ends: tuple[Mark, Mark]
    to_pole: Mark
    working: Mark


def draw_action_line(draft: Draft, sizes: GearSizes) -> ActionLine:
    """Draw the centres, the circles of both wheels and the line of action, wheel 1 below, driving to the right.

    The line of action touches both base circles; wheel 2's tip circle cuts a off it, wheel 1's b.
    """
    draft.open(VIEW)
    mu = draft.scale("μ_l", "m/mm")
    draft.lay_out()
    first = draft.take(Point, "O_{1}", 0j)
    centres = draft.draw(ray, "(O_{1}O_{2})", first, draft.direction(90.0), why=why.CENTRES)
    distance = draft.draw(to_board, "[a_{w}]", sizes.a_w)
    second = draft.draw(lay_off, "O_{2}", centres, distance, why=why.CENTRES)
    own, other = sizes.wheels
    circles = (_circles(draft, own, first), _circles(draft, other, second))
    reach = next(m for m in draft.uses(circles[0].working) if m != first)
    pole = draft.draw(lay_off, "P", centres, reach, why=why.POLE)
    side = draft.take(Side, "σ", -1.0)
    limits = (
        draft.draw(touch, "N_{1}", pole, circles[0].base, side, why=why.LIMIT),
        draft.draw(touch, "N_{2}", pole, circles[1].base, side, why=why.LIMIT),
    )
    line = draft.draw(join, "(N_{1}N_{2})", *limits, why=why.ACTION)
    forward, back = draft.take(Side, "+", 1.0), draft.take(Side, "−", -1.0)
    a = draft.draw(cut, "a", line, circles[1].tip, back, why=why.ENTERS)
    b = draft.draw(cut, "b", line, circles[0].tip, forward, why=why.LEAVES)
    angle = draft.draw(bearing, "α_{w}", *limits, why=why.MESH_ANGLE)
    spans = [
        draft.draw(measure_along, f"{start.letter}{end.letter}", start, end, line, why=why.SPAN)
        for start, end in (
            (limits[0], limits[1]),
            (limits[0], a),
            (limits[0], b),
            (limits[0], pole),
            (a, b),
        )
    ]
    return ActionLine(
        mu, centres, circles, pole, limits, (a, b), line, angle, spans[0], (spans[1], spans[2]), spans[3],
        spans[4],
    )  # fmt: skip


def _circles(draft: Draft, wheel: WheelSizes, centre: Mark) -> Circles:
    """Strike the five circles of a wheel."""
    arcs = []
    for real in (wheel.r, wheel.r_b, wheel.r_w, wheel.r_f, wheel.r_a):
        radius = draft.draw(to_board, f"[{real.letter}]", real)
        arcs.append(draft.draw(strike, f"({real.letter})", centre, radius, why=why.CIRCLE))
    return Circles(centre, *arcs)
