"""A bit of grey paper with lines of pencil, as an array: what a reader of lines sees of a sheet laid flat."""

from __future__ import annotations

import numpy as np

from graphic_tmm.checking.pencil.darkness import Flat
from graphic_tmm.paper.ruled import Box

DOTS, WIDTH, HEIGHT = 4, 160, 120
"""Dots a millimetre, and millimetres."""


def paper(seed: int = 1, *, squared: bool = False, shade: float = 0.5) -> np.ndarray:
    """Grey paper with grain: a lamp falls off across it, a stain with a sharp edge lies on it."""
    random = np.random.default_rng(seed)
    x = (np.arange(WIDTH * DOTS) + 0.5) / DOTS
    y = (np.arange(HEIGHT * DOTS)[:, None] + 0.5) / DOTS
    grey = 235.0 * np.linspace(1, shade, x.size) * np.ones_like(y)
    grey[abs(x - 75 + 1j * (y - 70)) < 12] *= 0.8
    if squared:
        ruled = (abs((x + 1.3) % 5 - 2.5) < 0.1) | (abs((y + 3.1) % 5 - 2.5) < 0.1)
        grey = np.where(ruled, grey * 0.8, grey)
    return grey + random.normal(0, 3, grey.shape)


def rubbed(grey: np.ndarray, a: complex, b: complex, *, dashed: bool = False) -> np.ndarray:
    """A line of pencil, 0.4 mm wide, from one place of the sheet to another."""
    x = (np.arange(grey.shape[1]) + 0.5) / DOTS
    y = HEIGHT - (np.arange(grey.shape[0])[:, None] + 0.5) / DOTS
    own = (x + 1j * y - a) / (b - a) * abs(b - a)
    part = np.clip((0.2 - abs(own.imag)) * DOTS + 0.5, 0, 1)
    part = part * ((own.real > 0) & (own.real < abs(b - a)))
    if dashed:
        part = part * (own.real % 5.5 < 4)
    return grey * (1 - 0.5 * part)


def flat(grey: np.ndarray) -> Flat:
    """The paper as it is read."""
    return Flat(np.clip(np.rint(grey), 0, 255).astype(np.uint8), Box(0, 0, WIDTH, HEIGHT), DOTS)
