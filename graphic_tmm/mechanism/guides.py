"""A sliding pair seen from either of its links: the guide's direction and how far points lie off it.

Both links of a sliding pair keep one direction u between them. A point's *level* is its distance to the left
of the guide; it never changes. Which link owns the guide does not matter after this file.
"""

from __future__ import annotations

import cmath
import math

from graphic_tmm.mechanism.groups import Pair
from graphic_tmm.mechanism.records import Slide

_EXACT = {0.0: 1 + 0j, 90.0: 1j, 180.0: -1 + 0j, 270.0: -1j}


def turn(degrees: float) -> complex:
    """Return e^{iφ}, exact at right angles."""
    exact = _EXACT.get(degrees % 360.0)
    return cmath.rect(1.0, math.radians(degrees)) if exact is None else exact


def direction(pair: Pair, link: int) -> float:
    """Return the direction of the guide in the own axes of a link of the pair, degrees."""
    slide = _slide(pair)
    return -slide.angle if link == pair.links[0] else slide.guide.angle


def level(pair: Pair, link: int, point: complex) -> float:
    """Return how far a point of the link (own axes, m) lies to the left of the guide, m."""
    slide = _slide(pair)
    if link == pair.links[0]:
        return slide.offset + (point * turn(slide.angle)).imag
    return ((point - slide.guide.through) * turn(-slide.guide.angle)).imag


def _slide(pair: Pair) -> Slide:
    assert pair.slide is not None, f"{pair.name} is not a sliding pair"
    return pair.slide
