"""How far figures, points and lines are off, and what that comes to: on plain values, in plain functions.

The page has the same functions: they are written down in JavaScript from here (`board/script.py`), so that what
a student is told there is what `check` tells. So they say nothing that single numbers cannot be asked for.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from graphic_tmm.board.geometry import along, wedge
from graphic_tmm.board.values import Arc, Line

WHOLE = 1e-6
"""A length so near (in divisions) to a whole number of them may have been read off the ruler: more than any
rounding of the machine, less than any digit that is written."""


def off_line(line: Line, found: Any) -> Any:
    """Return how far a point is off a line, mm."""
    return np.abs(wedge(line.along, found - line.at))


def off_arc(arc: Arc, found: Any) -> Any:
    """Return how far a point is off an arc, mm."""
    return np.abs(np.abs(found - arc.centre) - arc.radius)


def off_place(found: Any, due: Any) -> Any:
    """Return how far a point is off its place, mm."""
    return np.abs(found - due)


def off_length(line: Line, length: Any, found: Any) -> Any:
    """Return how far a point is off the end of what was laid off along a line, mm."""
    return np.abs(along(found - line.at, line.along) - length)


def off_meeting(found: Any, due: Any, other: Any) -> Any:
    """Return how far a point is off the due one of two meetings where it is nearer to the other, else 0."""
    off = np.abs(found - due)
    return np.where(np.abs(found - other) < off, off, 0.0)


def nearer(one: Any, other: Any) -> Any:
    """Return the lesser of two distances; the one that is known."""
    return np.fmin(one, other)


def excess(found: Any, due: Any) -> Any:
    """Return by how much a figure exceeds its due; a segment without a sign is a magnitude."""
    return np.where(found < 0.0, found - due, found - np.abs(due))


def directed(found: Any, due: Any) -> Any:
    """Return a figure as others start from it: a magnitude has the sense that is due."""
    return np.where(found < 0.0, found, np.copysign(found, due))


def counted(error: float, grain: float) -> float:
    """Return what of an error counts: what rounding may carry does not."""
    return max(abs(error) - grain, 0.0)


def sized(blunt: float, sharp: float, share: float) -> float:
    """Return how large an error a hand makes that reads coordinates with a share of the slip counted upon.

    ``blunt``: with all of it, ``sharp``: with none.
    """
    return math.sqrt(sharp * sharp + share * share * max(blunt * blunt - sharp * sharp, 0.0))


def severity(deviation: float, times: float, doubtful: float, wrong: float, absurd: float) -> int:
    """Return the number of the verdict on a deviation: 0 fine, 1 doubtful, 2 wrong.

    ``times``: so many times too large or too small is the figure (a logarithm); ``absurd``: so many are wrong.
    """
    if deviation > wrong:
        return 2
    if deviation <= doubtful:
        return 0
    return 2 if times > absurd * (1.0 - 1e-9) else 1


def times_off(found: Any, due: Any) -> Any:
    """Return by how many times figures differ from what is due, as logarithms of their sizes; else ∞."""
    times = np.abs(np.log(np.abs(found) / np.abs(due)))
    return np.where(np.isnan(times), np.inf, times)


def unblurred(half: float, written: float, reading: float) -> float:
    """Return how far rounding alone carries a length read off the paper, mm.

    The ruler's ``half`` division, or half a unit of the last digit that was ``written``, less the slip of
    ``reading``: with a slip so large the rounding is lost in it.
    """
    return max(half, written, reading) - reading


def lost(x: float, y: float, slip: float) -> float:
    """Return how far rounding alone carries a point, mm: the digits written, less the slip of reading it."""
    return max(math.hypot(x, y), slip) - slip


def rounding(digits: int, figure: float) -> float:
    """Return half a unit of the last of so many digits of a figure."""
    return 5.0 * math.pow(10.0, -digits) * abs(figure)


def between(length: float, finest: float) -> bool:
    """Whether a length stands between the divisions of a ruler."""
    divisions = abs(length) / finest
    return bool(np.abs(divisions - np.rint(divisions)) > WHOLE)


FUNCTIONS = (
    off_line,
    off_arc,
    off_place,
    off_length,
    off_meeting,
    nearer,
    excess,
    directed,
    counted,
    sized,
    severity,
    times_off,
    unblurred,
    lost,
    rounding,
    between,
)
"""All of them."""
