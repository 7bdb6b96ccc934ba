"""Forces of random mechanisms of sliders, cylinders and several drives, against the judge."""

from __future__ import annotations

import math

import numpy as np
import pytest
from judges.test_random_drives import POSITIONS, SOME, WAYS, judged, random_of
from support.free_forces import statics

import graphic_tmm


@pytest.mark.parametrize("kind", WAYS)
def test_forces(kind: str) -> None:
    judged(kind, 3, forces=True)


@pytest.mark.slow
@pytest.mark.parametrize("block", range(5))
@pytest.mark.parametrize("kind", WAYS)
def test_forces_oftener(kind: str, block: int) -> None:
    for seed in range(10 + 10 * block, 20 + 10 * block):
        judged(kind, seed, forces=True)


@pytest.mark.parametrize("kind", SOME)
def test_forces_along_a_row(kind: str) -> None:
    """The table of a sheet has at every place of its row what balances the first drive there."""
    found, scene = random_of(kind, 4, forces=True)
    scene["drive"] = _all_accelerated(scene["drive"])
    forward = found.judge.drives[0].rate > 0
    ends = found.walked[0][0], found.walked[-1][0]
    first, last = ends if forward else ends[::-1]
    table = graphic_tmm.draw(graphic_tmm.read(scene), exact=True).table("forces")
    for k, way in enumerate(np.linspace(first, last, POSITIONS)):
        due = statics(found.judge, found.solved(way), math.degrees(abs(way - first)))
        moment = found.judge.words.balance == "moment"
        arm = found.judge.size if moment else 1.0
        for name in ("forces", "lever"):
            value = table[f"{'M' if moment else 'P'}_bal_{name}"].value[0, k]
            assert value == pytest.approx(due.drives[0], abs=1e-8 * due.largest * arm), (k, name)


def _all_accelerated(drives: object) -> object:
    """The drives, the first with a plan of accelerations in every position."""
    if isinstance(drives, list):
        return [_all_accelerated(drives[0]), *drives[1:]]
    assert isinstance(drives, dict)
    return {**drives, "accelerations": "all"}
