"""Extreme positions within open rows of random mechanisms, against the judge's own places and velocities."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from judges.test_random_drives import WAYS, random_of
from support.boards import recorded
from support.random_mechanisms import Random

import graphic_tmm
from graphic_tmm.errors import StructureError

SIDES = {"left": -1 + 0j, "right": 1 + 0j, "bottom": -1j, "top": 1j}
STANDS = 1e-9
"""A point as slow as this share of its largest speed stands: velocities are compared no closer."""


def _extreme(scene: dict[str, Any], point: str, at: str) -> float | None:
    """The coordinate of the first drive at an extreme position, rad or m; None where there is none."""
    several = isinstance(scene["drive"], list)
    first, *others = scene["drive"] if several else [scene["drive"]]
    first = {**first, "extra": [{"point": point, "at": at}]}
    read = graphic_tmm.read({**scene, "drive": [first, *others] if several else first})
    assert read.mechanism is not None
    try:
        project = recorded(read.mechanism, read.row, plans=["positions", "velocities"])
    except StructureError as error:
        assert "goes on there" in str(error) or "moves neither" in str(error)  # noqa: PT017
        return None
    found = project.coordinates[-1]
    assert found is not None
    assert project.sweep is not None
    return math.radians(found) if project.sweep.turns else found


def _along(found: Random, key: tuple[str, int], side: complex) -> np.ndarray:
    """Place and velocity of a point along a side at every place walked, (place, 2)."""
    states = [state.point(*key) for _, state in found.walked]
    return np.array([[(z * side.conjugate()).real for z in state[:2]] for state in states])


def judged(kind: str, seed: int) -> tuple[int, int]:
    """Compare the extremes of all points; return how many there were, and how many were rightly refused."""
    found, scene = random_of(kind, seed, forces=False)
    drive, here, none = found.judge.drives[0], 0, 0
    keys = {x: (x, b.number) for b in found.judge.words.bodies if b.number for x in b.points}
    fixed = set(scene["frame"])
    for key in (key for x, key in sorted(keys.items()) if x not in fixed):
        fastest = max(abs(state.point(*key)[1]) for _, state in found.walked)
        for at, side in SIDES.items():
            row = _along(found, key, side)
            most = int(np.argmax(row[:, 0]))
            coordinate = _extreme(scene, key[0], at)
            gains = row[:, 1] * math.copysign(1.0, drive.rate)
            if coordinate is None:
                # the farthest place is an end, and the point comes from the row on its way there
                inward = gains[most] if most == 0 else -gains[most]
                assert most in (0, len(row) - 1), (kind, seed, key, at)
                assert inward <= STANDS * fastest, (kind, seed, key, at)
                none += 1
                continue
            way = coordinate - found.at[0]
            if drive.kind == "turn":
                middle = (found.walked[0][0] + found.walked[-1][0]) / 2.0
                way = middle + math.remainder(way - middle, math.tau)
            place, speed, _ = found.solved(way).point(*key)
            assert abs((speed * side.conjugate()).real) <= STANDS * fastest, (kind, seed, key, at)
            far = (place * side.conjugate()).real
            assert far >= row[:, 0].max() - 1e-12 * found.scale, (kind, seed, key, at)
            here += 1
    return here, none


@pytest.mark.parametrize(
    "kind", ["rod", *(pytest.param(k, marks=pytest.mark.slow) for k in WAYS if k != "rod")]
)
def test_extremes_within_a_row(kind: str) -> None:
    counts = [judged(kind, seed) for seed in range(2)]
    assert sum(here for here, _ in counts) >= 1
    assert sum(none for _, none in counts) >= 3
