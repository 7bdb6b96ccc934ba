"""Where a view stands on a student's sheet: moved until most of its lines lie on pencil."""

from __future__ import annotations

import numpy as np

from graphic_tmm.checking.pencil.darkness import Flat
from graphic_tmm.checking.pencil.expected import View

REACH = 8.0
"""A view is sought as far from where it should stand, mm: a student measures that off the frame, or guesses."""
STEPS = (1.0, 0.25)
"""At first in such steps, mm, then about the best of them more finely."""
MOST = 600
"""So many places of its lines are looked at."""
FAR = 0.02
"""What a millimetre of moving costs, as a share of cover: of two places alike the nearer one."""


def placed(
    flat: Flat, view: View, shift: complex = 0j, reach: float = REACH
) -> tuple[complex, float]:
    """Return by how much a view is moved, mm, beside ``shift``, and the share of its lines on pencil."""
    some = [line.start + line.way * np.arange(0.0, line.length, 1.0) for line in view.lines]
    if not some:
        return shift, 0.0
    ink = np.concatenate(some)
    ink = ink[:: -(-len(ink) // MOST)]
    found, reaches = shift, (reach, STEPS[0])
    for wide, step in zip(reaches, STEPS, strict=True):
        axis = np.arange(-wide, wide + 1e-9, step)
        moves = found + (axis[:, None] + 1j * axis).ravel()
        cover = flat.near(ink + moves[:, None]).mean(axis=1)
        best = int(np.argmax(cover - FAR * abs(moves - shift)))
        found = complex(moves[best])
    return found, float(cover[best])
