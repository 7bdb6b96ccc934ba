"""The four corners of a sheet of paper in a photograph, by its edges, where no frame of ours is drawn.

Paper is brighter than the table that it lies on: it is the largest bright part of the picture. A line is laid
through the outermost dots of each of its sides; a side is a bit longer than what a stain or a hand covers.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.checking.photo.long_lines import opencv
from graphic_tmm.checking.photo.perspective import Corners, cross, ordered
from graphic_tmm.errors import SheetError
from graphic_tmm.language.said import said

COARSE = 1000
"""So many dots of the longer side tell where the paper is; its edges are sought in all of them."""
LEAST = 0.15
"""Paper fills so much of a photograph at least."""
SHARES = (1.0, 0.85, 0.7, 0.55, 1.2)
"""Of the usual threshold between table and paper: such are tried."""
SEEN = 0.4
"""Of each side the edge must be seen in so many places."""
ENDS = 0.06
"""Of a side so much is left out at either end: corners are bent."""
BAND = 14
"""Dots of the photograph: so far beside the coarse edge the fine one is sought."""
STATIONS = 240
"""So many places of a side are looked at."""
ROUNDS = 6
"""Fits of a side, each without what is farther off than others."""


def paper_found(image: NDArray[np.uint8], clicked: Corners | None = None) -> Complexes:
    """Return the corners of the paper, px: lower left, lower right, upper right, upper left as it is seen.

    ``clicked``: about where they are.

    Raises
    ------
    SheetError
        If no paper with four corners is seen.
    """
    several = _coarse(image) if clicked is None else [ordered(clicked)]
    found = [
        [_side(image, a, b) for a, b in zip(one, np.roll(one, -1), strict=True)] for one in several
    ]
    best = max(found, key=lambda sides: sum(side.clear for side in sides), default=None)
    if best is None or (clicked is None and min(side.clear for side in best) < SEEN):
        raise SheetError(
            said(
                "neither a frame of this sheet nor the four edges of the paper are seen in the photograph: "
                "photograph the whole sheet on a darker table, or give its corners with --corners"
            )
        )
    return np.array([_met(best[k - 1], best[k]) for k in range(4)], np.complex128)


class Side(NamedTuple):
    """Two places on a side of the paper, px, and of how much of it an edge is seen, 0 … 1."""

    start: complex
    end: complex
    clear: float


def _coarse(image: NDArray[np.uint8]) -> list[Complexes]:
    """Return the corners of what is bright in a picture, by several thresholds: a shadow may lie on paper."""
    cv2 = opencv()
    factor = max(image.shape[0], image.shape[1]) / COARSE
    size = round(image.shape[1] / factor), round(image.shape[0] / factor)
    grey = cv2.GaussianBlur(
        cv2.resize(image, size, interpolation=cv2.INTER_AREA).min(axis=2), (0, 0), 2
    )
    usual, _ = cv2.threshold(grey, 0, 255, cv2.THRESH_BINARY + cv2.THRESH_OTSU)
    found = (_quadrilateral(grey, usual * share, factor) for share in SHARES)
    return [one for one in found if one is not None]


def _quadrilateral(grey: NDArray[np.uint8], level: float, factor: float) -> Complexes | None:
    cv2 = opencv()
    _, mask = cv2.threshold(grey, level, 255, cv2.THRESH_BINARY)
    mask = cv2.morphologyEx(mask, cv2.MORPH_CLOSE, np.ones((9, 9), np.uint8))
    several, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    whole = max(several, key=cv2.contourArea, default=None)
    if whole is None or cv2.contourArea(whole) < LEAST * grey.size:
        return None
    hull = cv2.convexHull(whole)
    for share in (0.01, 0.015, 0.02, 0.03, 0.05):
        found = cv2.approxPolyDP(hull, share * cv2.arcLength(hull, True), True)[:, 0]
        if len(found) == 4:
            return _ordered((found[:, 0] + 1j * found[:, 1] + complex(0.5, 0.5)) * factor)
    return None


def _ordered(corners: Complexes) -> Complexes:
    """Return four corners from the lower left one, round about as the sheet is seen."""
    area = cross(corners[2] - corners[0], corners[3] - corners[1])
    round_about = corners if area < 0 else corners[::-1]  # y is downward
    lowest = int(np.argmin(round_about.real - round_about.imag))
    return np.asarray(np.roll(round_about, -lowest) - complex(0.5, 0.5), np.complex128)


def _side(image: NDArray[np.uint8], a: complex, b: complex) -> Side:
    """Return a side of the paper, by where it is half as bright as within."""
    share = np.linspace(ENDS, 1 - ENDS, STATIONS)
    way = (b - a) / abs(b - a)
    inward = -1j * way  # of corners in this order, y downward
    across = np.arange(-BAND, BAND + 1.0)
    places = (a + (b - a) * share)[:, None] + inward * across
    rows = np.clip(np.rint(places.imag), 0, image.shape[0] - 1).astype(np.intp)
    columns = np.clip(np.rint(places.real), 0, image.shape[1] - 1).astype(np.intp)
    level = image[rows, columns].min(axis=2).astype(np.float64)
    table, paper = level[:, :5].mean(axis=1), level[:, -5:].mean(axis=1)
    half = ((table + paper) / 2)[:, None]
    first = np.argmax(level > half, axis=1)
    before = np.maximum(first - 1, 0)
    row = np.arange(STATIONS)
    low, high = level[row, before], level[row, first]
    part = np.where(high > low, (half[:, 0] - low) / np.where(high > low, high - low, 1.0), 0.0)
    off = across[before] + np.clip(part, 0.0, 1.0)
    clear = (paper - table > 25) & (first > 0)
    off = _line(share, off, clear) if clear.sum() > STATIONS // 4 else np.zeros(2)
    return Side(complex(a + inward * off[0]), complex(b + inward * off[1]), float(clear.mean()))


def _line(share: Reals, off: Reals, clear: NDArray[np.bool_]) -> Reals:
    """Return how far aside a straight line through most of some places is at its two ends."""
    kept = clear
    for _ in range(ROUNDS):
        slope, start = np.polyfit(share[kept], off[kept], 1)
        rest = abs(off - start - slope * share)
        usual = 1.4826 * float(np.median(rest[kept])) + 0.3
        kept = clear & (rest < 2.5 * usual)
    return np.array([start, start + slope])


def _met(one: Side, other: Side) -> complex:
    way, across = one.end - one.start, other.end - other.start
    part: Any = cross(np.array(other.start - one.start), np.array(across))
    return complex(one.start + way * part / cross(np.array(way), np.array(across)))
