"""How a photograph shows a sheet: its curl, a pinhole's projection, the lens; and what bends its lines."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.checking.photo.perspective import through
from graphic_tmm.paper.ruled import Box

MOST_BOWED = 0.1
"""No lens is believed to bow more, as a share at the half width: fisheyes need another law."""
_STEPS = 8
"""Newton's steps for the place at which a ray is seen; from 10 % off four reach the last place."""
_NEAR = 1e-9
"""As a share of the half width: a place is found when its ray is so near."""


class Lens(NamedTuple):
    """The middle of a photograph, px, half its width, px, and by what share the lens bows lines there."""

    middle: complex
    radius: float
    share: float = 0.0

    def straight(self, seen: Any) -> Complexes:
        """Return where a pinhole would show what is seen at some places, px (any shape)."""
        off = np.asarray(seen, np.complex128) - self.middle
        found: Complexes = self.middle + off * (1 + self.share * abs(off / self.radius) ** 2)
        return found

    def seen(self, straight: Any) -> Complexes:
        """Return where is seen what a pinhole would show at some places, px; NaN where no ray is seen."""
        off = np.asarray(straight, np.complex128) - self.middle
        if self.share == 0.0:
            return self.middle + off
        due = abs(off) / self.radius
        far = due.copy()
        with np.errstate(all="ignore"):
            for _ in range(_STEPS):
                slope = 1 + 3 * self.share * far**2
                far = far - (far + self.share * far**3 - due) / np.where(slope > 0, slope, np.nan)
            found = abs(far + self.share * far**3 - due) < _NEAR
            part = np.where(due > 0, far / due, 1.0)
        return np.where(found, self.middle + off * part, complex(np.nan, np.nan))

    def reduced(self, factor: int) -> Lens:
        """Return the lens of the photograph whose dots are the means of ``factor`` × ``factor``."""
        half = complex(0.5, 0.5)
        return Lens((self.middle + half) / factor - half, self.radius / factor, self.share)


def pinhole(image: NDArray[np.uint8]) -> Lens:
    """Return the lens that bows nothing, of a photograph (rows, columns, 3)."""
    rows, columns = image.shape[:2]
    return Lens(complex((columns - 1) / 2, (rows - 1) / 2), columns / 2)


def straightening(lens: Lens, lines: Iterable[tuple[Complexes, Reals]]) -> Lens:
    """Return the lens that makes lines straight: a line is the places seen, px, (points,), and their weights.

    Least squares: what is left of a line beside its own straight one depends on the share by a factor. With
    fewer than two lines the lens stays as it is.
    """
    bows = [bow_of(lens, seen, weights) for seen, weights in lines]
    square = sum(float((weights * by**2).sum()) for weights, _, by in bows)
    if len(bows) < 2 or square <= 0.0:
        return lens
    product = sum(float((weights * off * by).sum()) for weights, off, by in bows)
    return lens._replace(share=float(np.clip(-product / square, -MOST_BOWED, MOST_BOWED)))


def bow_of(lens: Lens, seen: Complexes, weights: Reals) -> tuple[Reals, Reals, Reals]:
    """Return a line's weights, how far its points are from straight, px, and what a share of 1 adds to that."""
    way = seen[-1] - seen[0]
    way /= abs(way)
    turned = (seen - seen[0]) / way
    off = seen - lens.middle
    by = off * abs(off / lens.radius) ** 2 / way
    return (
        weights,
        left_of_line(turned.real, turned.imag, weights),
        left_of_line(turned.real, by.imag, weights),
    )


def left_of_line(along: Reals, across: Reals, weights: Reals) -> Reals:
    """Return what is left of ``across`` beside its weighted line of least squares over ``along``."""
    whole = weights.sum()
    x = along - (weights * along).sum() / whole
    y = across - (weights * across).sum() / whole
    slope = (weights * x * y).sum() / max((weights * x**2).sum(), np.finfo(float).tiny)
    left: Reals = y - slope * x
    return left


USUAL_CURL = 1.5
"""Of a camera: from its lens to its image, half widths of this; a telephone's, 27 mm of 36."""
CURL_DOUBT = 4e-6
"""How far the usual camera is believed against what is seen: corners are true to 0.1 % of the photograph, and
other cameras are other than the usual one by a half; the square of the quotient."""
CURL_SIZES = 0.25, 4.0
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
    usual = 1 / USUAL_CURL**2
    square = (CURL_DOUBT * usual - deep / size) / (CURL_DOUBT + skew**2 + apart**2)
    square = min(max(square, usual * CURL_SIZES[0]), usual * CURL_SIZES[1])
    scale = np.array([square, square, 1.0])
    x, y = (-float(way * scale @ far) / float(way * scale @ way) for way in (across, up))
    return complex(x, y)


class Shot(NamedTuple):
    """A photograph, and how it shows the sheet: its curl, the projection into a pinhole's, then the lens."""

    image: NDArray[np.uint8]
    matrix: Reals
    lens: Lens
    curl: Curl

    def to_picture(self, points: Any) -> Complexes:
        """Return where points of the sheet, mm, are seen, px."""
        return self.lens.seen(through(self.matrix, self.curl.seen(points)))

    def sheet(self, seen: Any) -> Complexes:
        """Return which points of the sheet, mm, are seen at places, px."""
        back: Reals = np.linalg.inv(self.matrix).astype(np.float64)
        return self.curl.flat(through(back, self.lens.straight(seen)))


def bowed(shot: Shot, feet: Complexes) -> float:
    """Return how far the lens alone bows the frame's edges from their chords' means, mm."""
    shot = shot._replace(curl=Curl(shot.curl.box))
    back: Reals = np.linalg.inv(shot.matrix).astype(np.float64)
    worst = 0.0
    for foot, head in zip(feet, np.roll(feet, -1), strict=True):
        share = np.linspace(0.0, 1.0, 33, dtype=np.float64)
        edge = through(back, shot.to_picture(foot + (head - foot) * share))
        aside = ((edge - foot) / (head - foot) * abs(head - foot)).imag
        line = np.polyval(np.polyfit(share, aside, 1), share)
        worst = max(worst, float(abs(aside - line).max()))
    return worst


STIFF = 1e-4
"""What a millimetre of curl costs, as a share of what it costs that all places seen are a millimetre off:
keeps small what the frame does not tell, and takes less than 1 % of the rest."""

CLEARER = 0.97
"""A curl is believed if it leaves less than this share of the squares that the lens alone leaves. In
1.5 megapixels flat sheets, in ink or pencil, leave 0.995 and more, those that curl by 0.6 mm 0.92, by 2 mm
0.4 to 0.6."""


Line = tuple[Complexes, Reals]
"""Places seen along a line, px, and their weights."""


class Bends(NamedTuple):
    """A lens and a curl, and the squares that they leave of the lines' distance from straight, px²."""

    lens: Lens
    curl: Curl
    left: float


def unbending(shot: Shot, lines: list[Line]) -> tuple[Lens, Curl]:
    """Return the lens and the curl that make the frame's lines straight, seen near where ``shot`` has them.

    The curl only where all four lines were found: of fewer it could not be told from the lens. A flat sheet
    has none.
    """
    lens = straightening(shot.lens, lines)
    flat = Curl(shot.curl.box)
    if len(lines) < 4:
        return lens, flat
    alone = Bends(lens, flat, CLEARER * _left(lens, lines))
    best = min(
        alone, _curled(shot, lines, True), _curled(shot, lines, False), key=lambda one: one.left
    )
    return best.lens, best.curl


def _left(lens: Lens, lines: list[Line]) -> float:
    """Return the squares that a lens leaves."""
    bows = [bow_of(lens, *line) for line in lines]
    return sum(float((weights * (off + lens.share * by) ** 2).sum()) for weights, off, by in bows)


def _curled(shot: Shot, lines: list[Line], upright: bool) -> Bends:
    """Return lens and curl by least squares, the curl about one of the sheet's two directions."""
    tried = Curl(shot.curl.box, foot_of(shot.matrix, shot.lens), upright)
    normal, due, whole, dots = np.zeros((3, 3)), np.zeros(3), 0.0, 0.0
    for seen, given in lines:
        weights, off, by = bow_of(shot.lens, seen, given)
        columns = np.stack([by, *_shifts(shot, tried, seen, weights)])
        normal += columns * weights @ columns.T
        due -= columns * weights @ off
        whole += float((weights * off**2).sum())
        first, last = shot.sheet(seen[[0, -1]])
        dots += float(weights.sum()) * (abs(seen[-1] - seen[0]) / abs(last - first)) ** 2
    normal[1:, 1:] += STIFF * dots * np.eye(2)
    share, middle, more = np.linalg.solve(normal, due).tolist()
    lens = shot.lens._replace(share=float(np.clip(share, -MOST_BOWED, MOST_BOWED)))
    curl = tried._replace(parts=(middle, more))
    return Bends(lens, curl, whole - float(due @ [share, middle, more]))


def _shifts(shot: Shot, curl: Curl, seen: Complexes, weights: Reals) -> Reals:
    """Return what a millimetre of each part of a curl, taken out, moves a line across, px, beside straight."""
    way = (seen[-1] - seen[0]) / abs(seen[-1] - seen[0])
    along = ((seen - seen[0]) / way).real
    flat = shot.sheet(seen)
    here = through(shot.matrix, flat)
    moved = (through(shot.matrix, flat + curl.shapes(flat)) - here) / way
    return np.stack([-left_of_line(along, one.imag, weights) for one in moved])
