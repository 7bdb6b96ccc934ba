"""Hatching of sections and of plates: thin lines at 45° (ГОСТ 2.306)."""

from __future__ import annotations

import cmath
import math

import numpy as np
import shapely

from graphic_tmm.paper.drawing import Stroke, line

HATCH = 2.5
"""Pitch of section hatching, mm."""
_LINE = 1
"""The kind of a shape that is a line, as shapely counts them."""
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
    slope = 1 if rising else -1
    count = math.ceil(span * math.sqrt(0.5) / pitch) + 1
    middle = complex((left + right) / 2, (low + high) / 2)
    along = cmath.rect(1.0, slope * math.pi / 4)
    feet = middle + np.arange(-count, count + 1) * pitch * 1j * along
    ends = np.stack([feet - span * along, feet + span * along], axis=1)
    lines = shapely.linestrings(np.stack([ends.real, ends.imag], axis=2))
    parts = shapely.get_parts(shapely.intersection(lines, area))
    there = (shapely.get_type_id(parts) == _LINE) & (shapely.length(parts) > 0.2)
    return tuple(line("thin", *(complex(x, y) for x, y in part.coords)) for part in parts[there])
