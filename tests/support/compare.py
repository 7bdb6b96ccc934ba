"""How far plans are from the vector loops, relative to the largest of each kind of quantity."""

from __future__ import annotations

import numpy as np

from graphic_tmm.chapters.kinematics.wheels import Wound
from support.drawn import board
from support.mechanisms import Sampled
from support.oracle import solve_fast


def errors(drawn: Sampled, *, turned: bool, wound: Wound | None = None) -> dict[str, float]:
    """Largest relative errors of points r, v, a and rates omega, epsilon in the drawn position."""
    read = board(drawn.mechanism, turned=turned, wound=wound).read([[drawn.phi]])
    state = solve_fast(drawn.mechanism, drawn.phi, drawn.poses)
    speed = abs(drawn.mechanism.drive.speed)
    largest = {"r": state.size, "v": state.size * speed, "a": state.size * speed**2}
    off = dict.fromkeys("rva", 0.0)
    for link in drawn.mechanism.links:
        for letter in link.points:
            for name, due in zip("rva", state.points[letter, link.number], strict=True):
                found = complex(read[name][letter, link.number][0])
                largest[name] = max(largest[name], abs(due))
                off[name] = _worse(off[name], abs(found - due))
    told = {name: off[name] / largest[name] for name in off}
    for name, due, least in (("omega", state.omega, speed), ("epsilon", state.epsilon, speed**2)):
        top, worst = max(least, *map(abs, due.values())), 0.0
        for link in drawn.mechanism.links:
            found = float(np.ravel(read[name].get(link.number, 0.0))[0])
            worst = _worse(worst, abs(found - due[link.number]))
        told[name] = worst / top
    return told


def _worse(worst: float, value: float) -> float:
    """The larger of two, where NaN is worst of all."""
    return float("inf") if np.isnan(value) else max(worst, value)
