"""A sheet that curls: how far its points are seen aside of where they would lie flat.

What lies higher than the plane of the four corners hides a place farther from the foot of the camera. A sheet
curls like a scroll, about one of its two directions: two edges rise alike, two stay straight. These tell the
lens, the others the rise, and the foot the way: so also how far points are aside *along* an edge, where no line
shows it. That is why the edges' bends are not just spread over the sheet between them.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.checking.photo.lens import Lens
from graphic_tmm.paper.ruled import Box

USUAL = 1.5
"""Of a camera: from its lens to its image, half widths of this; a telephone's, 27 mm of 36."""
DOUBT = 4e-6
"""How far the usual camera is believed against what is seen: corners are true to 0.1 % of the photograph, and
other cameras are other than the usual one by a half; the square of the quotient."""
SIZES = 0.25, 4.0
"""No camera's share of the usual one's is believed to be outside these (squares)."""
TURNS = 8
"""Rounds for the flat place of what is seen; each leaves a hundredth."""


class Curl(NamedTuple):
    """How a sheet curls within its frame ``box``, mm, seen from above the ``foot`` of the camera on the sheet.

    ``upright``: about its upright direction, the lower and upper edges rise. ``parts``: of the rise, mm aside
    at half the frame's diagonal from the foot: in the middle, and what grows with the way along the edge.
    """

    box: Box
    foot: complex = 0j
    upright: bool = True
    parts: tuple[float, float] = (0.0, 0.0)

    def shapes(self, points: Any) -> Reals:
        """Return how far points (any shape) are aside for a millimetre of each part, complex mm, (2, ...)."""
        half = complex(self.box.right - self.box.left, self.box.top - self.box.bottom) / 2
        off = np.asarray(points, np.complex128) - complex(self.box.left, self.box.bottom) - half
        along = off.real / half.real if self.upright else off.imag / half.imag
        rise = (1 - along**2) * (points - self.foot) / abs(half)
        return np.stack([rise, rise * along])

    def seen(self, points: Any) -> Complexes:
        """Return on which places of the plane through the corners points of the sheet are seen, mm."""
        flat = np.asarray(points, np.complex128)
        if not any(self.parts):
            return flat
        middle, more = self.parts
        shapes = self.shapes(flat)
        found: Complexes = flat + middle * shapes[0] + more * shapes[1]
        return found

    def flat(self, seen: Any) -> Complexes:
        """Return which points of the sheet are seen on places of the plane through its corners, mm."""
        due = np.asarray(seen, np.complex128)
        found = due
        for _ in range(TURNS if any(self.parts) else 0):
            found = due - (self.seen(found) - found)
        return found


def foot_of(matrix: Reals, lens: Lens) -> complex:
    """Return above which point of the sheet, mm, the camera stands, by its projection: dots are square.

    The two ways of the sheet are at right angles and alike, which tells how long the camera is; of a sheet
    seen straight from above it tells little: then it is taken for a usual one.
    """
    middle, radius = lens.middle, lens.radius
    centred = np.array(
        [[1 / radius, 0, -middle.real / radius], [0, 1 / radius, -middle.imag / radius], [0, 0, 1]]
    )
    across, up, far = (centred @ matrix).T
    size = float(across[:2] @ across[:2] + up[:2] @ up[:2]) / 2
    skew = float(across[:2] @ up[:2]) / size
    apart = float(across[:2] @ across[:2] - up[:2] @ up[:2]) / 2 / size
    deep = skew * across[2] * up[2] + apart * (across[2] ** 2 - up[2] ** 2) / 2
    usual = 1 / USUAL**2
    square = (DOUBT * usual - deep / size) / (DOUBT + skew**2 + apart**2)
    square = min(max(square, usual * SIZES[0]), usual * SIZES[1])
    scale = np.array([square, square, 1.0])
    x, y = (-float(way * scale @ far) / float(way * scale @ way) for way in (across, up))
    return complex(x, y)
