"""Symbols of gears and cams in kinematic schemes (ГОСТ 2.770), and the wavy line of a break (ГОСТ 2.303).

Seen from the end a gear is its pitch circle, a ring with internal teeth has the circle of its rim about it;
seen from the side a gear is a rectangle with the shaft through it. Points are complex, sizes mm.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence

from graphic_tmm.paper.drawing import Bezier, circle, line
from graphic_tmm.paper.symbols.kinematic import HATCH_DEPTH, Strokes, turning_pair

RIM = 4.0
"""From the pitch circle of a ring to the circle of its rim, mm."""
CENTRE_BEYOND = 4.0
"""How far the centre lines of a gear go on behind its circle, mm."""
FIX = 2.0
"""Half the cross that fixes a gear to its shaft, mm."""
GROUND_PITCH, MOST_GROUND = 2.5, 600
"""Way along a rim between the strokes of its ground, mm; their number at the most."""
WAVE, HEIGHT = 12.0, 1.5
"""Length and height of a wave of the line of a break, mm."""


def gear(at: complex, radius: float, *, internal: bool = False) -> Strokes:
    """Return a gear from its end: pitch circle, centre lines, turning pair; a ring has a rim outside."""
    reach = radius + (RIM if internal else 0.0) + CENTRE_BEYOND
    axes = tuple(line("centre", at - reach * way, at + reach * way) for way in (1, 1j))
    rim = (circle("main", at, radius + RIM),) if internal else ()
    return (*axes, circle("main", at, radius), *rim, *(() if internal else turning_pair(at)))


def ring_ground(at: complex, radius: float) -> Strokes:
    """Return the ground of a fixed ring: strokes at 45° outside its rim, all around and evenly."""
    count = min(max(8, round(2 * math.pi * radius / GROUND_PITCH)), MOST_GROUND)
    ways = (cmath.rect(1.0, math.radians(360.0 * (k + 0.5) / count)) for k in range(count))
    slant = HATCH_DEPTH * (1 + 1j)
    return tuple(line("thin", at + radius * way, at + (radius + slant) * way) for way in ways)


def gear_side(at: complex, radius: float, width: float, *, fixed: bool = True) -> Strokes:
    """Return a gear from its side, the shaft level: its outline; a cross fixes it to the shaft."""
    half = width / 2
    corners = (
        complex(-half, -radius),
        complex(half, -radius),
        complex(half, radius),
        complex(-half, radius),
    )
    box = line("main", *(at + z for z in corners), closed=True)
    if not fixed:
        return (box,)
    ends = (complex(FIX, FIX), complex(FIX, -FIX))
    return (box, *(line("main", at - z, at + z) for z in ends))


def cam(at: complex, profile: Sequence[complex]) -> Strokes:
    """Return a cam: its closed profile (points about its centre), its turning pair."""
    return (line("main", *(at + z for z in profile), closed=True), *turning_pair(at))


def wavy(start: complex, end: complex) -> Bezier:
    """Return the wavy line of a break from ``start`` to ``end``: whole waves, thin."""
    span = end - start
    count = 2 * max(1, round(abs(span) / WAVE))
    step, side = span / count, 1j * span / abs(span) * HEIGHT
    controls = [start]
    for k in range(count):
        foot, lift = start + k * step, side * (1 if k % 2 == 0 else -1)
        controls += [foot + step / 3 + lift, foot + 2 * step / 3 + lift, foot + step]
    return Bezier("thin", tuple(controls))
