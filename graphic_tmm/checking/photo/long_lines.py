"""Long straight lines of a photograph: short segments, the lens that lets most of them lie in lines.

Short segments are found by OpenCV (extra ``photo``) in a smaller picture of how dark a dot is beside what is
about it: neither shade nor the colour of a squared sheet is seen there, only pencil and edges.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.checking.photo.camera import Lens, pinhole
from graphic_tmm.errors import SheetError, installing
from graphic_tmm.language.said import said

LONGEST = 2000
"""Dots of the longer side of the picture that lines are sought in: a pencil line of 0.4 mm on an A1 is then
three quarters of a dot wide. With 1300 one frame of sixty is lost; 4000 take four times as long."""

BROAD = 15
"""Dots (odd): what is narrower is a line, what is broader is shade. Main lines of an A4 that fills the picture
have six, with their blur ten."""

SOFT = 4.0
"""Dots: what is about a dot is smoothed so far. An edge of the paper is then dark beside, too: where a line of
the frame is too pale to be found, that edge is, and tells where the frame is."""

COLOURED = 0.5
"""So much of the difference between the colours is taken off their least darkness. Pencil has none; of blue
squares (0.5, 0.35, 0.15 of red, green and blue) nothing is left, though JPEG smooths colours."""

SHORTEST = 12.0
"""Dots: segments that are shorter are letters and grain."""

SHARES = np.linspace(-0.03, 0.03, 13)
"""The lenses that are tried: beyond, a telephone bows no lines (0.02 is promised). Steps of 0.005 leave half of
one, two dots of bow: within what a line may be off."""

CLEARER = 1.05
"""A lens is believed if segments lie in lines so much better than without it; a few lines alone may fall into
other rows of the table by chance, and are not farther off by that than a line may be."""

SLANTS, WIDE = 360, 3.0
"""Of the table of lines that tells how well a lens lets segments lie in them: directions, and dots to a row."""

APART = 4.0
"""Degrees: segments of one line differ by less; a segment of 12 dots is true to 3."""

MOST = 100
"""So many lines are gathered at the most, the longest segments first."""


BESIDE, ALIKE = (0.6, 0.9, 1.2), 0.88
"""A line has paper on both sides: so many times its reach away, at one of these, they are as bright within this
quotient. What has not is the edge of a sheet; a margin seen steeply is narrow, hence the nearer ones."""

DENSE = 0.3
"""So much of a line is covered by its segments at least: half of a frame's line that is pale and seen steeply
is, what a table's grain has in line is not."""


ALONG = (np.arange(60) + 0.5) / 60
"""Where along a line its sides are looked at."""


class Small(NamedTuple):
    """A smaller picture: its ``grey``, how ``dark`` a dot is beside what is about it (0 … 255).

    ``factor``: so many times smaller it is.
    """

    grey: NDArray[np.uint8]
    dark: NDArray[np.uint8]
    factor: int


class Lines(NamedTuple):
    """Long lines: their ends (n,), px of the picture without its lens, how well each is seen, and the lens.

    ``seen``: the length, px, less what of it is not covered.
    """

    feet: Complexes
    heads: Complexes
    seen: Reals
    lens: Lens


def opencv() -> Any:
    """Return OpenCV's module; raises SheetError if it is not installed."""
    try:
        import cv2
    except ImportError as error:
        raise SheetError(
            said(
                "to find a frame by itself the package OpenCV is needed: {remedy}, or "
                "give the frame's corners with --corners",
                remedy=installing("[photo]"),
            )
        ) from error
    return cv2


def smaller(image: NDArray[np.uint8]) -> Small:
    """Return a smaller picture of a photograph in which lines are sought.

    Of the three colours that in which it is least dark, less what they differ: pencil is dark in all of them,
    squares are not.
    """
    cv2 = opencv()
    factor = max(round(max(image.shape[:2]) / LONGEST), 1)
    rows, columns = (max(side // factor, 1) for side in image.shape[:2])
    whole = image[: rows * factor, : columns * factor]
    small = cv2.resize(whole, (columns, rows), interpolation=cv2.INTER_AREA)
    about = cv2.morphologyEx(small, cv2.MORPH_CLOSE, np.ones((BROAD, BROAD), np.uint8))
    about = cv2.GaussianBlur(about, (0, 0), SOFT)
    shares = cv2.divide(small, np.maximum(about, 20), scale=255.0)
    least, most = _ends(cv2, shares)
    colour = cv2.multiply(cv2.subtract(most, least), np.ones_like(most), scale=COLOURED)
    return Small(_ends(cv2, small)[1], cv2.subtract(255 - most, colour), factor)


def _ends(cv2: Any, image: NDArray[np.uint8]) -> tuple[Any, Any]:
    """Return the least and the most of the three colours of each dot."""
    one, two, three = cv2.split(image)
    return cv2.min(cv2.min(one, two), three), cv2.max(cv2.max(one, two), three)


def long_lines(small: Small, reach: float) -> Lines:
    """Return the long lines of a picture; their segments are within ``reach``, px, of them."""
    found = segments(small.dark)
    lens = pinhole(small.dark[..., None])
    lens = lens._replace(share=_share(found, lens))
    straight = lens.straight(found)
    feet: list[complex] = []
    heads: list[complex] = []
    seen: list[float] = []
    left = np.argsort(-abs(straight[:, 1] - straight[:, 0]), kind="stable")
    while left.size and len(feet) < MOST:
        foot, head = straight[left[0]]
        own = left[:1]
        for _ in range(3):
            own = _along(straight, left, foot, head, reach)
            foot, head = _fitted(straight[own])
        dense = _covered(straight[own], foot, head) / abs(head - foot)
        places = lens.seen(foot + (head - foot) * ALONG)
        if dense > DENSE and any(
            _alike(small.grey, places, head - foot, much * reach) for much in BESIDE
        ):
            feet.append(foot)
            heads.append(head)
            seen.append(dense**2 * abs(head - foot))
        left = np.setdiff1d(left[1:], own, assume_unique=False)
        left = left[np.argsort(-abs(straight[left, 1] - straight[left, 0]), kind="stable")]
    return Lines(np.array(feet), np.array(heads), np.array(seen), lens)


def segments(dark: NDArray[np.uint8]) -> Complexes:
    """Return the ends of short segments, px, (n, 2)."""
    cv2 = opencv()
    strong = 255 - cv2.multiply(dark, np.ones_like(dark), scale=2.4)
    found = cv2.createLineSegmentDetector(cv2.LSD_REFINE_STD).detect(strong)[0]
    pairs = np.zeros((0, 4)) if found is None else np.asarray(found, np.float64).reshape(-1, 4)
    ends = pairs[:, 0::2] + 1j * pairs[:, 1::2]
    return ends[abs(ends[:, 1] - ends[:, 0]) > SHORTEST]


def _share(found: Complexes, lens: Lens) -> float:
    """Return the bow of the lens that lets the segments lie in the fewest lines: the peaks of a table of lines.

    0 if no other is clearly better.
    """
    if not len(found):
        return 0.0
    far = abs(lens.middle)
    rows = int(2 * far / WIDE) + 8
    peaks = []
    for share in SHARES:
        ends = lens._replace(share=float(share)).straight(found) - lens.middle
        way = ends[:, 1] - ends[:, 0]
        slant = np.angle(way) % np.pi
        middle = ends.mean(axis=1)
        off = (middle * np.exp(-1j * slant)).imag
        at = np.floor(slant / np.pi * SLANTS).astype(int) % SLANTS
        row = np.clip(np.floor((off + far) / WIDE).astype(int) + 4, 0, rows - 1)
        table = np.bincount(at * rows + row, abs(way), SLANTS * rows).reshape(SLANTS, rows)
        table = table + np.roll(table, 1, axis=0) + np.roll(table, 1, axis=1)
        peaks.append(float((table**2).sum()))
    best = int(np.argmax(peaks))
    return float(SHARES[best]) if peaks[best] > CLEARER * peaks[len(SHARES) // 2] else 0.0


def _alike(grey: NDArray[np.uint8], places: Complexes, way: complex, off: float) -> bool:
    """Whether it is as bright on one side of a line as on the other; not if its lens shows none of it."""
    rows, columns = grey.shape
    places = places[np.isfinite(places)]
    if not places.size:
        return False
    across = 1j * way / abs(way) * off
    level = []
    for side in (places - across, places + across):
        x = np.clip(np.rint(side.real), 0, columns - 1).astype(int)
        y = np.clip(np.rint(side.imag), 0, rows - 1).astype(int)
        level.append(float(np.median(grey[y, x])) + 1.0)
    return min(level) / max(level) > ALIKE


def _along(
    straight: Complexes, left: NDArray[np.intp], foot: complex, head: complex, reach: float
) -> NDArray[np.intp]:
    """Return which segments lie along a line."""
    way = (head - foot) / abs(head - foot)
    ends = (straight[left] - foot) / way
    turn = abs(np.angle((ends[:, 1] - ends[:, 0]) ** 2)) / 2
    own: NDArray[np.intp] = left[(abs(ends.imag).max(axis=1) < reach) & (turn < np.radians(APART))]
    return own if own.size else left[:1]


def _fitted(ends: Complexes) -> tuple[complex, complex]:
    """Return the line of least squares through segments, from its first end to its last."""
    weight = np.repeat(abs(ends[:, 1] - ends[:, 0]), 2)
    points = ends.ravel()
    middle = (weight * points).sum() / weight.sum()
    square = (weight * (points - middle) ** 2).sum()
    way = np.exp(0.5j * np.angle(square))
    along = ((points - middle) / way).real
    return complex(middle + way * along.min()), complex(middle + way * along.max())


def _covered(ends: Complexes, foot: complex, head: complex) -> float:
    """Return how much of a line its segments cover, px."""
    way = (head - foot) / abs(head - foot)
    along = np.sort(((ends - foot) / way).real, axis=1)
    along = along[np.argsort(along[:, 0], kind="stable")]
    until = np.maximum.accumulate(along[:, 1])
    before = np.concatenate([[-np.inf], until[:-1]])
    whole = np.maximum(along[:, 1] - np.maximum(along[:, 0], before), 0.0).sum()
    return float(whole)
