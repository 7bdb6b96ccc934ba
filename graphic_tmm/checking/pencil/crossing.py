"""Where the lines that go through a place meet: least squares, of many lines those that agree."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from graphic_tmm.checking.pencil.expected import View
from graphic_tmm.checking.pencil.fitting import Fit
from graphic_tmm.checking.pencil.lines import Track

RULED = 0.08
"""A line is known no better, mm: it is bent by the ruler's edge, the lens, the paper."""
SURE = 0.3
"""A crossing known worse, mm (one standard deviation), is none: its lines are nearly parallel."""
PRICK = 0.1
"""A vector begins so far from its pole (one standard deviation, mm): by eye; a student pricks to 0.15."""
FEW = 2
"""Of more lines than these one that passes the others' crossing is told from them."""
ROUNDS, ASTRAY = 5, 1.5
"""So often all are weighed again; a line that passes by so many of its errors counts half."""


class Cross(NamedTuple):
    """What lines tell of a place: its displacement, mm, in which direction it is known worst, how badly.

    ``misfit``: how far a line passes it; ``lines``: how many there are; ``doubted``: it is known so badly
    because another line may be the right one.
    """

    moved: complex
    way: complex
    error: float
    misfit: float
    lines: int
    doubted: bool


def crossing(view: View, fit: Fit, k: int) -> Cross:
    """Return where the lines of a place meet."""
    rows, asides, errors, clear = [], [], [], []
    for n, (line, track) in enumerate(zip(view.lines, fit.tracks, strict=True)):
        if track is None or k not in line.places:
            continue
        share = ((view.places[k].at - line.start) / line.way).real / line.length
        left = 1j * line.way
        rows.append([left.real, left.imag])
        asides.append(float(track.aside(share)))
        errors.append(_error(track, share, fit.doubt[n]))
        clear.append(_error(track, share, None))
    if not rows:
        return Cross(complex(fit.moved[k]), 1.0, np.inf, 0.0, 0, False)
    ways, off, own = np.array(rows), np.array(asides), np.array(errors)
    sharp = np.array(clear)
    if view.of[k] is None:
        own, sharp = np.hypot(own, PRICK), np.hypot(sharp, PRICK)
    weight = 1 / own**2
    before = np.array([fit.moved[k].real, fit.moved[k].imag])
    for _ in range(ROUNDS if len(rows) > FEW else 1):
        normal = (ways * weight[:, None]).T @ ways
        values, vectors = np.linalg.eigh(normal + 1e-6 * np.eye(2))
        step = vectors @ ((vectors.T @ (ways.T @ (weight * (off - ways @ before)))) / values)
        worst = vectors[:, 0]
        error = float(1 / np.sqrt(values[0]))
        if error > SURE:  # along the worst direction it stays where its neighbours have it
            step = step - worst * (worst @ step)
        moved = before + step
        rest = abs(off - ways @ moved)
        weight = 1 / (own**2 + (rest / ASTRAY) ** 2) if len(rows) > FEW else weight
    misfit = float(np.sort(rest)[-1 - len(rest) // 4])
    best = (ways / sharp[:, None] ** 2).T @ ways
    doubted = error > SURE >= 1 / np.sqrt(max(float(np.linalg.eigvalsh(best)[0]), 1e-6))
    return Cross(complex(*moved), complex(*worst), error, misfit, len(rows), bool(doubted))


def _error(track: Track, share: float, doubt: tuple[float, float] | None) -> float:
    """Return how far a line may be aside at a share of its length, mm: least in its middle.

    ``doubt``: how far aside, at its ends, another one is that may be the right one.
    """
    other = 0.0 if doubt is None else abs(doubt[0] + (doubt[1] - doubt[0]) * share)
    error = track.error * np.sqrt(0.25 + 3 * (share - 0.5) ** 2)
    return float(np.sqrt(error**2 + RULED**2 + other**2))
