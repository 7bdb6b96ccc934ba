"""The meshing: working parts of the flanks, arcs of engagement, contact ratio; is the pair a good one."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import Reading
from graphic_tmm.board.geometry import EPS
from graphic_tmm.board.operations.formulas import in_si, to_board
from graphic_tmm.board.operations.instruments import lay_off, measure, parallel, strike
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.gears import words as why
from graphic_tmm.chapters.gears.dimensions import VIEW, GearSizes
from graphic_tmm.chapters.gears.formulas import at_least, percent_off, ratio_of
from graphic_tmm.chapters.gears.line import ActionLine
from graphic_tmm.chapters.gears.rolling import (
    angle_at,
    curve_meets_arc,
    measure_arc,
    smooth_through,
    turn_about,
)
from graphic_tmm.chapters.gears.teeth import Wheel


@dataclass(frozen=True)
class Engagement:
    """One wheel while a pair of teeth is in contact: from a to b.

    ``lowest``: the lowest working point of the flank through the pitch point. ``entering``, ``leaving``: that
    flank (Curve) when it touches in a, in b; ``arc``: where it then crosses the working circle, ``length``: of
    the arc between (Length), ``real``: the same in m.
    """

    lowest: Mark
    entering: Mark
    leaving: Mark
    arc: tuple[Mark, Mark]
    length: Mark
    real: Mark


@dataclass(frozen=True)
class Contact:
    """The working line laid off in base pitches: ``pair``: where a second pair of teeth leaves, enters.

    ``pitch``: the base pitch as measured (Length); ``drawn``: ab over it; ``difference`` from the formula, %.
    """

    wheels: tuple[Engagement, ...]
    pair: tuple[Mark, Mark]
    pitch: Mark
    drawn: Mark
    difference: Mark


NEAR = 0.1
"""A flank that works within this share of the base radius from its limit ends within half a percent of it
above the base circle: a ruler may read less than the base radius there."""


def draw_contact(
    draft: Draft,
    sizes: GearSizes,
    line: ActionLine,
    wheels: tuple[Wheel, ...],
    value: Callable[[Mark], float],
) -> Contact:
    """Draw the working parts of the flanks and the arcs of engagement; measure the contact ratio."""
    (a, b) = line.ends
    near = [0.0 <= value(w.lowest) < NEAR * value(w.r_b) for w in sizes.wheels]
    engaged = tuple(_engagement(draft, k, line, wheel, near[k]) for k, wheel in enumerate(wheels))
    pitch = draft.draw(to_board, "[p_{b}]", sizes.p_b)
    onward = draft.draw(parallel, "(ab)", a, line.line, sense=1, why=why.NEXT_PAIR)
    backward = draft.draw(parallel, "(ba)", b, line.line, sense=-1, why=why.NEXT_PAIR)
    second = draft.draw(lay_off, "a′", onward, pitch, why=why.NEXT_PAIR)
    first = draft.draw(lay_off, "b′", backward, pitch, why=why.NEXT_PAIR)
    measured = draft.draw(measure, f"{a.letter}a′", a, second, why=why.NEXT_PAIR)
    drawn = draft.draw(ratio_of, "ε_{dr}", line.working, measured)
    off = draft.draw(percent_off, "Δε", drawn, sizes.contact_ratio, unit="%")
    return Contact(engaged, (first, second), measured, drawn, off)


def _engagement(draft: Draft, k: int, line: ActionLine, wheel: Wheel, near: bool) -> Engagement:
    """Turn the flank through the pitch point to where it touches in a, and in b.

    In the wheel's own limit point it touches where the involute begins, on the base circle; ``near``: it is.
    """
    centre, i = wheel.circles.centre, k + 1
    turned, crossings, lows = [], [], []
    for end, name in zip(line.ends, "ab", strict=True):
        if end is line.limits[k]:
            spot = wheel.origin
        else:
            reach = draft.draw(measure, f"O_{{{i}}}{end.letter}", centre, end, why=why.TURNED_FLANK)
            if near and name == "ab"[k]:
                least = next(m for m in draft.uses(wheel.circles.base) if m != centre)
                reach = draft.draw(at_least, f"O_{{{i}}}{end.letter}", reach, least)
            arc = draft.draw(
                strike, f"(O_{{{i}}}{end.letter})", centre, reach, why=why.TURNED_FLANK
            )
            spot = draft.draw(curve_meets_arc, f"{name}_{{{i}}}", wheel.flank, arc, free=True)
        angle = draft.draw(angle_at, f"∠{name}_{i}", centre, spot, end)
        points = draft.draw(
            turn_about,
            f"E_{{{name}{i}}}",
            wheel.points,
            centre,
            angle,
            sense=1,
            why=why.TURNED_FLANK,
        )
        turned.append(
            draft.draw(smooth_through, f"(E_{{{name}{i}}})", points, row=wheel.roll.count)
        )
        letter = f"{'cd'['ab'.index(name)]}_{{{i}}}"
        crossings.append(
            draft.draw(turn_about, letter, line.pole, centre, angle, sense=1, why=why.TURNED_FLANK)
        )
        lows.append(spot)
    sense = 1 if k and wheel.sizes.cut else -1
    length = draft.draw(measure_arc, f"c_{i}d_{i}", *crossings, wheel.circles.working, sense=sense)
    real = draft.draw(in_si, f"c_{i}d_{i}·μ", length, unit="m")
    return Engagement(lows[k], turned[0], turned[1], (crossings[0], crossings[1]), length, real)


ROUNDING = 64 * EPS
"""A value that is short of its limit by less than this share of what it is made of stands on it."""


LEAST_RATIO = 1.0
"""The contact ratio below which a pair of teeth leaves before the next one touches."""


@dataclass(frozen=True)
class Check:
    """``value`` shall not be less than ``least`` (both Number); ``scale``: the size of what they are made of.

    ``name``: "pointed tooth" (tip thickness against 0), "tip thickness" (against its usual limit), "undercut"
    (shift against the least one), "interference" (the lowest working radius of curvature against that at which
    the flank begins), "clearance" (at the root), "contact ratio". Of a ring: "ring tip" (not beyond N1),
    "tip overlap" and "assembly" (what is left between the corners). ``wheel``: 0 for the pair.
    """

    name: str
    wheel: int
    value: Mark
    least: Mark
    scale: float


@dataclass(frozen=True)
class Verdict:
    """A check with its numbers (m, or a coefficient): does it hold?"""

    name: str
    wheel: int
    value: float
    least: float
    unit: str
    holds: bool


def record_checks(draft: Draft, sizes: GearSizes) -> tuple[Check, ...]:
    """Record the limits of the checks."""
    draft.open(VIEW)
    zero = draft.take(Number, "0", 0.0, "m")
    one = draft.take(Number, "[ε_{α}]", LEAST_RATIO)
    teeth, found = float(sum(sizes.order.teeth)), []
    size = sizes.order.m * teeth
    for wheel in sizes.wheels:
        i = wheel.number
        found += [
            Check("pointed tooth", i, wheel.s_a, zero, size),
            Check("tip thickness", i, wheel.s_a, sizes.least_tip, size),
        ]
        if wheel.cut is not None:
            found += [
                Check("undercut", i, wheel.x, wheel.cut.x_min, teeth),
                Check("interference", i, wheel.lowest, wheel.cut.free, size),
            ]
        found.append(Check("clearance", i, wheel.clearance, zero, size))
    if sizes.rack is not None:
        found.append(Check("clearance", 2, sizes.rack.clearance, zero, size))
    if (ring := sizes.ring) is not None:
        wheel = sizes.wheels[1]
        tip = wheel.r_a if wheel.top is wheel.r_b else wheel.top
        found += [
            Check("ring tip", 2, tip, ring.least_tip, size),
            Check("tip overlap", 0, ring.overlap, zero, size),
            Check("assembly", 0, ring.assembly, zero, size),
        ]
    return (*found, Check("contact ratio", 0, sizes.contact_ratio, one, teeth))


def verdicts(checks: tuple[Check, ...], reading: Reading) -> tuple[Verdict, ...]:
    """Return the checks with their numbers, in their order."""
    found = []
    for check in checks:
        value, least = (float(reading[mark][0, 0]) for mark in (check.value, check.least))
        holds = value >= least - ROUNDING * check.scale
        found.append(Verdict(check.name, check.wheel, value, least, check.value.unit, holds))
    return tuple(found)
