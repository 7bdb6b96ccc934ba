"""A student's sheet in pencil, seen straight from above: what a photograph without its perspective is."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from support.photographed.pencil import DOTS as DRAWN
from support.photographed.pencil import drawn
from support.photographed.student import WHOLE, Left, Paper, student
from support.photographed.taking import conditions


class FlatSheet(NamedTuple):
    """``grey`` (rows, columns), ``dots`` to the mm; the paper with the places of its points."""

    grey: np.ndarray
    dots: int
    paper: Paper


def flat_sheet(
    name: str, number: int, seed: int, left: Left = WHOLE, *, dots: int = 8, noise: float = 4.0
) -> FlatSheet:
    """Draw a sheet of a scene by the hand and with the pencil of a seed."""
    random = np.random.default_rng(seed)
    paper = student(name, number, seed, left)
    lead = drawn(paper.ink, paper.size, conditions(seed).pencil, seed)[::-1].astype(np.float32)
    step = DRAWN // dots
    rows, columns = lead.shape[0] // step, lead.shape[1] // step
    lead = lead[: rows * step, : columns * step].reshape(rows, step, columns, step).mean((1, 3))
    grey = 235 * (1 - 0.8 * lead / 255) * np.linspace(1, 0.6, columns)
    grey += random.normal(0, noise, grey.shape)
    return FlatSheet(np.clip(np.rint(grey), 0, 255).astype(np.uint8), dots, paper)
