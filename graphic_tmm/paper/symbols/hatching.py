"""Hatching of sections and of plates: thin lines at 45° (ГОСТ 2.306)."""

from __future__ import annotations

import cmath
import math

import shapely

from graphic_tmm.paper.drawing import Stroke, line

HATCH = 2.5
"""Pitch of section hatching, mm."""
MOST = 1000
"""Lines at the most: more than the largest sheet takes at the usual pitch."""


def hatched(
    area: shapely.Polygon, *, pitch: float = HATCH, rising: bool = True
) -> tuple[Stroke, ...]:
    """Return the hatching of a section: thin lines at 45°.

    An area that no sheet holds is hatched more coarsely: it is refused only later, and not to be waited for.
    """
    left, low, right, high = area.bounds
    span = right - left + high - low
    pitch = max(pitch, span / MOST)
    found = []
    slope = 1 if rising else -1
    count = math.ceil(span * math.sqrt(0.5) / pitch) + 1
    middle = complex((left + right) / 2, (low + high) / 2)
    along = cmath.rect(1.0, slope * math.pi / 4)
    for k in range(-count, count + 1):
        foot = middle + k * pitch * 1j * along
        ends = [foot - span * along, foot + span * along]
        cut = shapely.intersection(shapely.LineString([(z.real, z.imag) for z in ends]), area)
        for part in shapely.get_parts(cut):
            if isinstance(part, shapely.LineString) and part.length > 0.2:
                found.append(line("thin", *(complex(x, y) for x, y in part.coords)))
    return tuple(found)
