"""How far figures, points and lines are off, and what that comes to: on plain values, in plain functions.

The page has the same functions: they are written down in JavaScript from here (`board/script.py`), so that what
a student is told there is what `check` tells. So they say nothing that single numbers cannot be asked for.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from graphic_tmm.board.geometry import along, unit, wedge
from graphic_tmm.board.values import Arc, Line


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


def off_ray(found: Any, due: Any, centre: Any) -> Any:
    """Return how far a point is off the ray that goes from a centre through its place, mm."""
    way = found - centre
    ray = unit(due - centre)
    return np.where(along(way, ray) < 0.0, np.abs(way), np.abs(wedge(ray, way)))


def off_opening(found: Any, due: Any, centre: Any) -> Any:
    """Return how far a point is off the arc about a centre through its place, mm."""
    return np.abs(np.abs(found - centre) - np.abs(due - centre))


def sine_between(due: Any, first: Any, second: Any) -> Any:
    """Return the sine of the angle at which the ways from two centres to a point meet, without its sign."""
    return np.abs(wedge(unit(due - first), unit(due - second)))


def reflected(due: Any, first: Any, second: Any) -> Any:
    """Return the other point that is as far from two centres."""
    base = unit(second - first)
    return due - 2.0 * wedge(base, due - first) * (1j * base)


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


def swung(far: float, swing: float) -> float:
    """Return how far off a ray a hand is, mm: it turns it by ``swing`` degrees, the point is so ``far``."""
    return math.radians(swing) * far


def opened(share: float, compass: float, reading: float, half: float) -> float:
    """Return how far off an arc a hand is, mm.

    Its opening is known (``share`` 0), or this share of a length that is read with a slip of ``reading`` off a
    ruler of so many mm ``half`` a division (whose rounding has this by √3 as its root mean square).
    """
    rounded = half / math.sqrt(3.0)
    return math.hypot(compass, share * math.hypot(reading, rounded))


def found_within(slip: float, prick: float, pointing: float) -> float:
    """Return how far off a line or arc a point is found that itself slips, is pricked and then read, mm."""
    return math.hypot(slip, math.hypot(prick, pointing))


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


FUNCTIONS = (
    off_line,
    off_arc,
    off_place,
    off_length,
    off_meeting,
    off_ray,
    off_opening,
    sine_between,
    reflected,
    nearer,
    excess,
    directed,
    counted,
    sized,
    swung,
    opened,
    found_within,
    severity,
    times_off,
    unblurred,
    lost,
    rounding,
)
"""All of them."""
