"""Where two places of a plate meet, found on single bodies: there it moves, and its drive stands."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from support.plates import Machine, Reals, followed


class DeadPlace(NamedTuple):
    """A machine at its dead place, driven there by its plate: the crank turns back, so its angle is sharp.

    ``sense``: +1 where the crank comes to it by growing angles; ``rate``: the motion by s, of all poses.
    """

    one: Machine
    phi: float
    sense: float
    poses: Reals
    rate: Reals

    def away(self, s: float) -> tuple[float, Reals] | None:
        """Return the crank's angle and the poses at a way s from the dead place; None where none fit."""
        q = _moved(
            self.one, self.poses + s * self.rate, self.rate, s + float(self.rate @ self.poses)
        )
        return None if q is None else (float(q[2]), q)


def _system(one: Machine, q: Reals, row: Reals) -> tuple[Reals, Reals]:
    value, slope = one.bodies.equations(q, float(q[2]))
    slope = slope.copy()
    slope[-1] = row
    return value, slope


def _moved(one: Machine, q: Reals, row: Reals, at: float) -> Reals | None:
    """Return the poses that fit where their part along a row is given, the crank free."""
    for _ in range(30):
        value, slope = _system(one, q, row)
        value = value.copy()
        value[-1] = float(row @ q) - at
        step = np.linalg.solve(slope, value)
        q = q - step
        if np.abs(step).max() < 1e-15 * max(1.0, np.abs(q).max()):
            break
    return q if np.abs(value).max() < 1e-12 else None


def _rate(one: Machine, q: Reals, row: Reals) -> Reals:
    """Return the motion of all poses along a row."""
    _, slope = _system(one, q, row)
    right = np.zeros(len(slope))
    right[-1] = 1.0
    rate = np.linalg.solve(slope, right)
    return np.asarray(rate / np.linalg.norm(rate))


def dead_places(one: Machine) -> list[DeadPlace]:
    """Return the ends of what a machine can do, where its crank turns back."""
    row = followed(one)
    if row[-1][0] - row[0][0] >= 2 * math.pi:
        return []
    found = []
    for sense, (_, q), (_, before) in ((1.0, row[-1], row[-2]), (-1.0, row[0], row[1])):
        along = (q - before) / np.linalg.norm(q - before)
        place = _turned_back(one, q, along, sense)
        if place is not None:
            found.append(place)
    return found


def _turned_back(one: Machine, q: Reals, along: Reals, sense: float) -> DeadPlace | None:
    """Go on until the crank turns back; halve the step there."""
    step = 1e-3
    for _ in range(4000):
        rate = _rate(one, q, along)
        rate = rate if rate @ along > 0 else -rate
        further = _moved(one, q + step * rate, rate, float(rate @ q) + step)
        if further is None:
            return None
        onward = _rate(one, further, rate)
        if onward[2] * sense > 0.0:
            q, along = further, onward
            continue
        step /= 2.0
        if step < 1e-16 or np.array_equal(further, q):
            break
    else:
        return None
    rate = _rate(one, q, along)
    return DeadPlace(one, float(q[2]), sense, q, rate)
