"""What the page's program is told of a photograph: how a frame is sought in it, what is too much; one truth."""

from __future__ import annotations

from graphic_tmm.checking.photo import camera, flatten, frame_lines


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
        "share": camera.MOST_BOWED,
        "usual": camera.USUAL_CURL,
        "doubt": camera.CURL_DOUBT,
        "shortest": camera.CURL_SIZES[0],
        "longest": camera.CURL_SIZES[1],
        "stiff": camera.STIFF,
        "clearer": camera.CLEARER,
    }


def too_much() -> dict[str, float]:
    """Return from where on a photograph is told of: a bent sheet, a bowing lens, mm."""
    return {"bent": flatten.BENT, "bowed": flatten.BOWED}
