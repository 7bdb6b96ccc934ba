"""Where a view stands on the sheet of a student: its lines laid over the pencil, moved until most of them lie on it."""

from __future__ import annotations

import numpy as np

from graphic_tmm.checking.pencil.darkness import Flat
from graphic_tmm.checking.pencil.expected import View

REACH = 8.0
"""A view is sought as far from where it should stand, mm: a student measures it off the frame, or puts it by eye."""
STEP = 0.5
MOST = 1500
"""So many places of its lines are looked at."""
FAR = 0.02
"""What a millimetre of moving costs, as a share of cover: of two places alike the nearer one."""


def placed(flat: Flat, view: View, shift: complex = 0j, reach: float = REACH) -> tuple[complex, float]:
    """Return by how much a view is moved beside ``shift``, mm, and what share of its lines is then on pencil."""
    some = [
        line.start + line.way * np.arange(0.0, line.length, 1.0) for line in view.lines
    ]
    if not some:
        return shift, 0.0
    ink = np.concatenate(some)
    ink = ink[:: -(-len(ink) // MOST)]
    axis = np.arange(-reach, reach + 1e-9, STEP)
    moves = shift + (axis[:, None] + 1j * axis).ravel()
    cover = np.array([float(flat.near(ink + move).mean()) for move in moves])
    worth = cover - FAR * abs(moves - shift)
    best = int(np.argmax(worth))
    return complex(moves[best]), float(cover[best])
