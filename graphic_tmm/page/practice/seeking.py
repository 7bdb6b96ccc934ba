"""What the page's program is told of a photograph: how a frame is sought in it, what is too much; one truth."""

from __future__ import annotations

from graphic_tmm.checking.photo import bends, curl, flatten, frame_lines, lens


def seeking() -> dict[str, float]:
    """Return how the frame's lines are sought (Seeking of own/strip.js), by the numbers that the check has."""
    return {
        "stations": frame_lines.STATIONS,
        "sights": frame_lines.SIGHTS,
        "reach": frame_lines.REACH,
        "far": frame_lines.FAR,
        "clear": frame_lines.CLEAR,
        "clearDots": frame_lines.CLEAR_DOTS,
        "aside": frame_lines.ASIDE,
        "nearCorner": frame_lines.NEAR_CORNER,
        "faint": frame_lines.FAINT,
        "seen": frame_lines.SEEN,
        "bend": frame_lines.BEND,
        "stray": frame_lines.STRAY,
        "degree": frame_lines.DEGREE,
        "rounds": frame_lines.ROUNDS,
        "cut": frame_lines.CUT,
        "floor": frame_lines.FLOOR,
        "dim": frame_lines.DIM,
        "share": lens.MOST,
        "usual": curl.USUAL,
        "doubt": curl.DOUBT,
        "shortest": curl.SIZES[0],
        "longest": curl.SIZES[1],
        "stiff": bends.STIFF,
        "clearer": bends.CLEARER,
    }


def too_much() -> dict[str, float]:
    """Return from where on a photograph is told of: a bent sheet, a bowing lens, mm."""
    return {"bent": flatten.BENT, "bowed": flatten.BOWED}
