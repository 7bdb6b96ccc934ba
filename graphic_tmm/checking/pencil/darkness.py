"""How much darker than the paper about it each dot of a sheet is: shade, stains and squares are taken out.

Thin lines are what a closing (the brightest nearby, then of that the darkest) fills: wider things, shadows and
stains, stay in the paper. A ruling of squares is what the medians of long rows and columns show again and again
at its pitch: pencil is no such thing.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.values import Complexes
from graphic_tmm.paper.ruled import Box

THICK = 1.1
"""What is wider is no line, mm: pencil is 0.2 to 0.6 mm wide, a camera's blur spreads it by a dot or two."""
DIM = 20.0
"""Paper darker than this, of 255, is none."""
PITCH = 5.0
"""Of squared paper, mm."""
BLOCK = 40.0
"""Rows of squares are sought in stretches so long, mm: hardly a pencil line fills half of one."""
RULED = 0.01
"""A ruling is darker than the paper by this share at least: less is lost in the noise, and does no harm."""
NOISES = 5.0
"""Pencil is so many times darker than what the grain of the paper scatters; one dot in 10⁶ is by chance."""
FAINTEST = 0.06
"""No dot of pencil is fainter, as a share of the paper; chosen by eye on pencil of 0.2 mm."""

NEAR = 0.75
"""Pencil near a place is at most twice as far away, mm."""

THICKNESS = 1.6
"""A line of pencil lies in so many steps of `NEAR` across it: 0.75 of one and the edges."""

ROWS = 128
"""So many rows of a picture are looked at, at a time: they stay near the processor."""

Greys = NDArray[np.float32]


class Flat:
    """A sheet seen straight from above: ``dark`` (rows, columns), shares of the paper, the uppermost row first.

    ``area``: the rectangle of the sheet that it shows, mm; ``dots`` to the mm. ``level``: how dark pencil is
    that is surely seen.
    """

    def __init__(self, image: NDArray[np.uint8], area: Box, dots: float) -> None:
        self.area, self.dots = area, dots
        dark, grain = _darkness(image, dots)
        _unruled(dark, dots)
        self.dark = dark
        self.level = max(NOISES * grain, FAINTEST)

    def pencil(self, places: Complexes) -> Greys:
        """Return how surely there is pencil at places (mm, any shape), 0 ... 1: of the nearest dot."""
        sure: Greys = self._nearest(places) * np.float32(1.0 / self.level)
        np.minimum(sure, np.float32(1.0), out=sure)
        return sure

    def _nearest(self, places: Complexes) -> Greys:
        rows, columns = self.dark.shape
        x = ((places.real - self.area.left) * self.dots).astype(np.int32)
        y = ((self.area.top - places.imag) * self.dots).astype(np.int32)
        np.clip(x, 0, columns - 1, out=x)
        np.clip(y, 0, rows - 1, out=y)
        return self.dark[y, x]

    @cached_property
    def _coarse(self) -> NDArray[np.uint8]:
        """Where there is pencil, in steps as wide as `NEAR`: 0 or 1."""
        step = max(round(NEAR * self.dots), 1)
        rows, columns = (-(-count // step) for count in self.dark.shape)
        padded = np.zeros((rows * step, columns * step), dtype=bool)
        padded[: self.dark.shape[0], : self.dark.shape[1]] = self.dark > self.level
        return np.asarray(
            padded.reshape(rows, step, columns, step).any(axis=(1, 3)), dtype=np.uint8
        )

    @cached_property
    def _blunt(self) -> NDArray[np.uint8]:
        """Where there is pencil within `NEAR`, in steps as wide: 0 or 1."""
        return np.asarray(_spread(self._coarse, 1, np.maximum), dtype=np.uint8)

    def near(self, places: Complexes) -> Greys:
        """Return whether there is pencil near places of the sheet (mm, any shape): 0 or 1."""
        return self._blunt[self._steps(places)].astype(np.float32)

    def strokes(self, places: Complexes) -> float:
        """Return how much pencil there is beside places of the sheet (mm), each stroke once, about in mm."""
        y, x = self._steps(places)
        rows, columns = self._coarse.shape
        beside = [(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1)]
        around = [
            np.clip(y + i, 0, rows - 1) * np.int64(columns) + np.clip(x + j, 0, columns - 1)
            for i, j in beside
        ]
        once = np.unique(np.concatenate(around))
        return float(self._coarse.ravel()[once].sum()) * NEAR / THICKNESS

    def _steps(self, places: Complexes) -> tuple[NDArray[np.int32], NDArray[np.int32]]:
        step = max(round(NEAR * self.dots), 1)
        rows, columns = self._coarse.shape
        x = ((places.real - self.area.left) * self.dots / step).astype(np.int32)
        y = ((self.area.top - places.imag) * self.dots / step).astype(np.int32)
        return np.clip(y, 0, rows - 1), np.clip(x, 0, columns - 1)

    def darkness(self, places: Complexes) -> Greys:
        """Return the darkness at places (mm, any shape), linear between the four dots about each."""
        rows, columns = self.dark.shape
        x = np.clip((places.real - self.area.left) * self.dots - 0.5, 0, columns - 1.001)
        y = np.clip((self.area.top - places.imag) * self.dots - 0.5, 0, rows - 1.001)
        i, j = y.astype(np.int32), x.astype(np.int32)
        v, u = (y - i).astype(np.float32), (x - j).astype(np.float32)
        dark = self.dark
        upper = dark[i, j] * (1 - u) + dark[i, j + 1] * u
        lower = dark[i + 1, j] * (1 - u) + dark[i + 1, j + 1] * u
        return np.asarray(upper * (1 - v) + lower * v, dtype=np.float32)


def _darkness(image: NDArray[np.uint8], dots: float) -> tuple[Greys, float]:
    """Return how much darker than the paper about it each dot is, as a share, and the scatter of grain.

    Of the colour where it is least: pencil is grey, but what is coloured (a ruling in blue) is hardly darker
    in one of its colours.
    """
    colours = image if image.ndim == 3 else image[..., None]
    half = max(round(THICK * dots), 2)
    beyond = 2 * half + 1
    least = np.empty(image.shape[:2], dtype=np.float32)
    for first in range(0, len(least), ROWS):
        begin = max(first - beyond, 0)
        some = _least(colours[begin : first + ROWS + beyond], half)
        least[first : first + ROWS] = some[first - begin : first - begin + ROWS]
    some = least[::7, ::7]
    middle = float(np.median(some))
    # of what is lighter than most: what is darker may be pencil
    grain = (
        1.4826 * float(np.median(middle - some[some < middle])) if (some < middle).any() else 0.0
    )
    least -= np.float32(middle)
    return np.maximum(least, 0.0, out=least), grain


def _least(colours: NDArray[np.uint8], half: int) -> Greys:
    """Return how much darker than the paper dots are, of the colour where it is least; ``half`` a line wide."""
    least: Any = None
    for k in range(colours.shape[2]):
        grey = _softened(colours[..., k])
        paper = _spread(_spread(grey, half, np.maximum), half, np.minimum)
        # paper is nowhere darker than the dot itself
        dark = np.divide(paper - grey, np.maximum(paper, np.uint8(DIM)), dtype=np.float32)
        least = dark if least is None else np.minimum(least, dark, out=least)
    return np.asarray(least, dtype=np.float32)


def _softened(grey: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return the means of a dot, twice, and its four neighbours: grain is half as strong."""
    padded = np.pad(grey, 1, mode="edge").astype(np.uint16)
    whole = 4 * padded[1:-1, 1:-1]
    for part in (padded[:-2, 1:-1], padded[2:, 1:-1], padded[1:-1, :-2], padded[1:-1, 2:]):
        whole += part
    return (whole >> 3).astype(np.uint8)


def _spread(grey: NDArray[np.uint8], half: int, most: Any) -> NDArray[np.uint8]:
    """Return the largest (or smallest) of the dots within ``half`` across and along, edges repeated."""
    for axis in (0, 1):
        wide = [(half, half) if k == axis else (0, 0) for k in (0, 1)]
        padded = np.pad(grey, wide, mode="edge")
        reach, width = 1, 2 * half + 1
        while reach < width:
            step = min(reach, width - reach)
            count = padded.shape[axis] - step
            cut = [slice(None), slice(None)]
            cut[axis] = slice(0, count)
            on = list(cut)
            on[axis] = slice(step, step + count)
            padded = most(padded[tuple(cut)], padded[tuple(on)])
            reach += step
        grey = padded
    return grey


def _unruled(dark: Greys, dots: float) -> None:
    """Take a ruling of squares out of the darkness, both ways."""
    for turned in (dark, dark.T):
        block = max(round(BLOCK * dots), 1)
        for first in range(0, turned.shape[0], block):
            part = turned[first : first + block]
            ruling = _ruling(np.median(part[::2], axis=0).astype(np.float32), dots)
            if ruling is not None:
                np.maximum(part - ruling, 0.0, out=part)


def _ruling(profile: Greys, dots: float) -> Greys | None:
    """Return what of a profile is there again a pitch before and behind; None if that is no ruling."""
    wide = _spread_row(profile, 1)
    shifts = [round(k * PITCH * dots) for k in (-3, -2, -1, 1, 2, 3)]
    again = np.median([np.roll(wide, shift) for shift in shifts], axis=0)
    ruling = np.minimum(profile, again * 1.3).astype(np.float32)
    return ruling if np.percentile(ruling, 98) > RULED else None


def _spread_row(profile: Greys, half: int) -> Greys:
    found: Greys = np.max([np.roll(profile, k) for k in range(-half, half + 1)], axis=0)
    return found
