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
THERE, SURELY = 0.55, 0.78
"""A plan is on the sheet if so much of its lines is on pencil, near its due and elsewhere: of lettering and
other lines about a half is, of all other plans of a sheet somewhere 0.65."""
ELSEWHERE, LITTLE = 45.0, 0.002
"""A plan that is not there may stand elsewhere: as far away, mm, and what a millimetre costs then."""


def placed(
    flat: Flat, view: View, shift: complex = 0j, reach: float = REACH, far: float = FAR
) -> tuple[complex, float]:
    """Return by how much a view is moved, mm, beside ``shift``, and the share of its lines on pencil.

    ``reach``: it is sought as far, mm; ``far``: what a millimetre of that costs.
    """
    some = [line.start + line.way * np.arange(0.0, line.length, 1.0) for line in view.lines]
    if not some:
        return shift, 0.0
    ink = np.concatenate(some)
    ink = ink[:: -(-len(ink) // MOST)]
    found, reaches = shift, (reach, STEPS[0])
    for wide, step in zip(reaches, STEPS, strict=True):
        axis = np.arange(-wide, wide + 1e-9, step)
        best, most = found, -np.inf
        for rise in axis:  # a row at a time: memory
            moves = found + axis + 1j * rise
            worth = flat.near(ink + moves[:, None]).mean(axis=1) - far * abs(moves - shift)
            k = int(np.argmax(worth))
            if worth[k] > most:
                best, most = complex(moves[k]), float(worth[k])
        found = best
    return found, float(most + far * abs(found - shift))


def stood(flat: Flat, view: View) -> tuple[complex, float]:
    """Return where a view stands, and the share of its lines on pencil: near its due, or surely elsewhere."""
    near = placed(flat, view)
    if near[1] >= THERE:
        return near
    far = placed(flat, view, 0j, ELSEWHERE, LITTLE)
    return far if far[1] >= SURELY else near
