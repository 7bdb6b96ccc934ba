"""The results of a gear pair by name, in SI and degrees, as tables and machines read them."""

from __future__ import annotations

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.gears.beside import BESIDE
from graphic_tmm.chapters.gears.plan import GEARS_PLAN
from graphic_tmm.drawn import Drawn, Results


def gear_results(drawn: Drawn) -> Results:
    """Return each result with its unit: those of the pair, those of each wheel with its number behind them.

    ``contact_ratio`` is that of the formula, ``contact_ratio_drawn`` ab over the base pitch as measured.
    """
    gear, reading = GEARS_PLAN.on(drawn), drawn.reading
    sizes, contact, beside = gear.sizes, gear.contact, BESIDE.on(drawn)
    marks: dict[str, Mark] = {
        "gear_ratio": beside.ratio,
        "alpha_w": sizes.alpha_w,
        "a": sizes.a,
        "a_w": sizes.a_w,
        "y": sizes.y,
        "delta_y": sizes.dy,
        "h": sizes.h,
        "h_w": sizes.h_w,
        "p": sizes.p,
        "p_b": sizes.p_b,
        "arc_of_engagement": beside.arc,
        "contact_ratio": sizes.contact_ratio,
        "contact_ratio_drawn": contact.drawn,
        "contact_ratio_difference": contact.difference,
    }
    for wheel, engaged in zip(sizes.wheels, contact.wheels, strict=True):
        own = {
            "r": wheel.r,
            "r_b": wheel.r_b,
            "r_w": wheel.r_w,
            "r_f": wheel.r_f,
            "r_a": wheel.r_a,
            "s": wheel.s,
            "s_a": wheel.s_a,
            "x_min": wheel.x_min,
            "arc_of_engagement": engaged.real,
        }
        marks |= {f"{name}{wheel.number}": mark for name, mark in own.items()}
    units = {"alpha_w": "°"}
    return {
        name: (reading[mark][:, 0].copy(), units.get(name, mark.unit))
        for name, mark in marks.items()
    }
