"""Central projection of a flat sheet into a photograph, and a photograph read between its dots.

Points are complex: on the sheet mm, y upward; in the photograph pixels, y downward, and the centre of
the first pixel is 0.

Written here rather than taken from a library. Pillow's PERSPECTIVE transform samples the same places four
times as fast (0.25 s for an A1 at 4 dots to the mm, of 1.0 s), but cuts greys down to the next whole one
(points of the sheet come back up to 0.0012 mm worse), shows beyond the horizon a mirrored sheet, and reads
no lines, so that `bilinear` would be needed all the same; in floating point it has these figures and takes
1.2 s. Bicubic it loses up to 0.013 mm to noise. OpenCV, which finds frames, is not asked for what the
corners given need, so that these need no wheel of 61 MB.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.checking.photo.picture import MOST
from graphic_tmm.errors import SheetError
from graphic_tmm.language.said import said
from graphic_tmm.paper.ruled import Box

SHORTEST = 20.0
"""No side of a frame in a photograph is shorter, nor any corner nearer to the diagonal, pixels: with
less, a click 2 px off turns a side by 6° and more."""

Corners = Sequence[tuple[float, float]] | Reals
"""Four points (x, y) in pixels."""


def vertices(box: Box) -> Complexes:
    """Return the corners of a box, mm: lower left, lower right, upper right, upper left."""
    return np.array(
        [
            complex(box.left, box.bottom),
            complex(box.right, box.bottom),
            complex(box.right, box.top),
            complex(box.left, box.top),
        ]
    )


def ordered(corners: Corners) -> Complexes:
    """Return four corners, given in any order, in the order of `vertices` as the photograph is seen.

    Of the four turns of a quadrilateral the one nearest to upright is taken.

    Raises
    ------
    SheetError
        If they are not four points of a photograph that make a convex quadrilateral.
    """
    try:
        pairs = np.asarray(corners, dtype=np.float64)
    except (TypeError, ValueError):
        pairs = np.empty(0)
    if pairs.shape != (4, 2) or not np.isfinite(pairs).all():
        raise SheetError(
            said("corners: give the four corners of the frame, x and y of each in pixels")
        )
    if abs(pairs).max() > MOST:
        raise SheetError(
            said(
                "corners: {far:g} lies outside every photograph: give x and y of each corner in pixels",
                far=pairs.flat[abs(pairs).argmax()],
            )
        )
    seen = pairs[:, 0] - 1j * pairs[:, 1]
    rays = seen - seen.mean()
    turn = np.argsort(np.angle(rays), kind="stable")
    rays = rays[turn]
    diagonal = np.array([-1 - 1j, 1 - 1j, 1 + 1j, -1 + 1j])
    upright = [float((np.roll(rays, -k) * diagonal.conj()).sum().real) for k in range(4)]
    seen = np.roll(seen[turn], -int(np.argmax(upright)))
    ring: Complexes = seen.conj()
    sides = np.roll(ring, -1) - ring
    chords = np.roll(ring, -2) - ring
    # y downward: the way round is clockwise in these numbers, so that a corner lies at a negative side
    heights = -cross(sides, chords) / np.maximum(abs(chords), 1.0)
    if not (min(abs(sides)) > SHORTEST and min(heights) > SHORTEST):
        raise SheetError(
            said(
                "corners: the four points make no convex quadrilateral: give each corner of the "
                "frame once"
            )
        )
    return ring


def cross(a: Any, b: Any) -> Any:
    """Return the outer product of plane vectors, positive where ``b`` is to the left of ``a``."""
    return np.imag(np.conj(a) * b)


def homography(box: Box, corners: Complexes) -> Reals:
    """Return the projection (3, 3) of the sheet, mm, into the photograph, px: exact at four corners.

    ``corners`` (4,): where the `vertices` of ``box`` are seen; of many at once (4, n), the projections
    (n, 3, 3). The third coordinate is positive on this side of the horizon.
    """
    one, two, three, four = corners
    excess = one - two + three - four
    right, left = two - three, four - three
    whole = cross(right, left)
    g, h = cross(excess, left) / whole, cross(right, excess) / whole
    along, up = two - one + g * two, four - one + h * four
    square = np.array(
        [[along.real, up.real, one.real], [along.imag, up.imag, one.imag], [g, h, np.ones_like(g)]]
    )
    width, height = box.right - box.left, box.top - box.bottom
    share = np.array(
        [[1 / width, 0, -box.left / width], [0, 1 / height, -box.bottom / height], [0, 0, 1.0]]
    )
    product: Reals = np.moveaxis(square, (0, 1), (-2, -1)) @ share
    return product


def through(matrix: Reals, points: Any) -> Complexes:
    """Return where points (complex, any shape) are seen; NaN on and beyond the horizon."""
    z = np.asarray(points, dtype=np.complex128)
    x, y, w = (row[0] * z.real + row[1] * z.imag + row[2] for row in matrix)
    seen = (x + 1j * y) / np.where(w > 0, w, 1.0)
    return np.where(w > 0, seen, complex(np.nan, np.nan))


def bilinear(image: NDArray[np.uint8], points: Complexes) -> Reals:
    """Return an image (rows, columns, colours) at ``points`` (any shape): that shape and its colours.

    Linear between the four dots about a point; NaN outside the centres of the outermost dots.
    """
    found = np.empty((*points.shape, image.shape[2]))
    for k, colour in enumerate(colours_at(image, points)):
        found[..., k] = colour
    return found


def colours_at(image: NDArray[np.uint8], points: Complexes) -> Iterator[Reals]:
    """Yield the colours of an image as `bilinear` reads them, one after the other: rows of one are quick."""
    rows, columns, colours = image.shape
    x, y = points.real, points.imag
    inside = (x >= 0) & (x <= columns - 1) & (y >= 0) & (y <= rows - 1)
    x, y = np.where(inside, x, 0.0), np.where(inside, y, 0.0)
    column = np.minimum(x.astype(np.intp), max(columns - 2, 0))
    row = np.minimum(y.astype(np.intp), max(rows - 2, 0))
    right, down = x - column, y - row
    left, up = 1 - right, 1 - down
    flat = image.reshape(-1)
    corner = (row * columns + column) * colours
    beside = colours if columns > 1 else 0
    under = columns * colours if rows > 1 else 0
    for k in range(colours):
        one, other = flat[k:], flat[k + beside :]
        upper = one.take(corner) * left + other.take(corner) * right
        lower = one[under:].take(corner) * left + other[under:].take(corner) * right
        yield np.where(inside, upper * up + lower * down, np.nan)
