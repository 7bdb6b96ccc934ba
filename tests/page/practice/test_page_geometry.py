"""Plane figures and cameras as the page's program has them, run by node: against plain geometry."""

from __future__ import annotations

import math

import numpy as np
from support.scripts import run

from graphic_tmm.page.practice.own import seeking

PIECES = """
import { pieceIn } from "./practice/figures.js";
tell(asked.map(([at, along]) => pieceIn({ at, along }, [0, 0, 40, 30])));
"""
FEET = """
import { footOf } from "./own/curl.js";
tell(asked.cases.map(([matrix, lens]) => footOf(matrix, lens, asked.seeking)));
"""


def test_of_a_line_the_piece_within_the_frame_is_seen() -> None:
    """A frame of 40 by 30 mm: level and upright lines, a diagonal of 3, 4, 5, lines that pass it by."""
    lines = {
        ((10, 20), (1, 0)): [[0, 20], [40, 20]],
        ((10, 20), (0, -1)): [[10, 30], [10, 0]],
        ((20, 15), (0.8, 0.6)): [[0, 0], [40, 30]],
        ((30, 15), (0.6, 0.8)): [[18.75, 0], [40, 85 / 3]],
        ((10, 31), (1, 0)): None,
        ((-1, 10), (0, 1)): None,
        ((50, 0), (0.6, 0.8)): None,
    }
    for piece, due in zip(run(PIECES, list(lines)), lines.values(), strict=True):
        assert (piece is None) == (due is None)
        if due is not None:
            np.testing.assert_allclose(piece, due, atol=1e-9)


def turned(x: float, y: float, z: float) -> np.ndarray:
    """Return the rotation about three axes, one after the other, degrees."""
    made = np.eye(3)
    for axis, angle in enumerate((x, y, z)):
        c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        one, two = [k for k in range(3) if k != axis]
        by = np.eye(3)
        by[one, one] = by[two, two] = c
        by[one, two], by[two, one] = -s, s
        made = by @ made
    return made


def test_the_camera_stands_above_its_foot() -> None:
    """Usual cameras at places that are known: what they see gives the place back, mm."""
    how, half = seeking(), 1400.0
    f = how["usual"] * half
    camera = np.array([[f, 0, half], [0, f, 1050.0], [0, 0, 1]])
    cases, due = [], []
    for angles in ((24.0, -17.0, 8.0), (-20.0, 25.0, -95.0), (30.0, 5.0, 171.0)):
        place = np.array([150.0, 90.0, 700.0]) + np.array(angles)
        about = turned(*angles)
        matrix = camera @ np.column_stack([about[:, 0], about[:, 1], -about @ place])
        lens = {"x": half, "y": 1050.0, "radius": half, "share": 0}
        cases.append((matrix.ravel().tolist(), lens))
        due.append(place[:2])
    found = run(FEET, {"cases": cases, "seeking": how})
    np.testing.assert_allclose(found, due, atol=1e-6)
