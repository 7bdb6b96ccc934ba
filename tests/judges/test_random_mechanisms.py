"""Random mechanisms of any drives, drawn by the package, against the judge of all links at once."""

from __future__ import annotations

import copy
import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.against_judge import LIMITS, PLANS, errors, page_is_right, parameter, ways
from support.random_mechanisms import KINDS, Random, drawn

import graphic_tmm
from graphic_tmm.board.execute import translator


def turning(seed: int, groups: int, kinds: Sequence[str] = KINDS) -> tuple[Random, dict[str, Any]]:
    """A random mechanism that a crank drives, its whole turn the row."""
    found = next(r for k in range(9) if (r := drawn(seed + 1000 * k, ("crank",), groups, kinds)))
    scene = copy.deepcopy(found.scene)
    scene["drive"]["zero"] = math.degrees(found.at[0])
    return found, scene


def judged(seed: int) -> None:
    found, scene = turning(seed, 1 + seed % 4)
    off = errors(found, scene, ways(found, 5))
    assert all(off[kind] <= LIMITS[kind] for kind in off), (seed, found.kinds, off)


@pytest.mark.parametrize("seed", range(5))
def test_what_a_crank_drives(seed: int) -> None:
    judged(seed)


@pytest.mark.turns(4)
@pytest.mark.slow
@pytest.mark.parametrize("block", range(10))
def test_what_a_crank_drives_oftener(block: int) -> None:
    for seed in range(10 + 10 * block, 20 + 10 * block):
        judged(seed)


def behind(seed: int) -> tuple[Random, dict[str, Any], float, int]:
    """A mechanism with a dead place: the way to it, and on which side it is."""
    for k in range(99):
        found, scene = turning(seed + 100 * k, 1 + seed % 3, KINDS[:3])
        for sense in (1, -1):
            way = found.dead(sense)
            if way is not None and abs(way) + 0.1 < math.pi:
                return found, scene, way, sense
    raise AssertionError("no mechanism has a dead place")


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(3))
def test_behind_a_dead_place_nothing_is_told_but_a_finding(seed: int) -> None:
    found, scene, way, sense = behind(seed)
    scene["drive"]["extra"] = [
        f"{parameter(found, way + sense * step)!r} deg" for step in (0.03, 0.05)
    ]
    read = graphic_tmm.read(scene)
    motion = graphic_tmm.motion(
        read, [parameter(found, way + sense * s) for s in (-1e-4, 1e-7, 0.03)], exact=True
    )
    last = found.walked[0 if sense < 0 else -1][1]
    due = found.judge.solve(found.coordinates(way - sense * 1e-4), last.poses)
    largest = max(abs(due.point(*key)[0]) for key in motion.places)
    off = [abs(z[0] - due.point(*key)[0]) / largest for key, z in motion.places.items()]
    assert np.max(off) < 1e-9
    for k in (1, 2):
        assert any(np.isnan(z[k]) for z in motion.places.values())
    sheet = graphic_tmm.draw(read, exact=True)
    table = sheet.table("velocities")
    for name in table.positions[-2:]:
        assert any("cannot be drawn" in warning and name in warning for warning in sheet.warnings)
        k = table.positions.index(name)
        assert any(np.isnan(column.value[0, k]) for column in table.values())


@pytest.mark.skipif(not translator(), reason="nothing compiles here")
@pytest.mark.parametrize("seed", range(2))
def test_compiled_is_as_drawn_step_by_step(seed: int) -> None:
    found, scene = turning(seed, 4)
    at = [parameter(found, way) for way in ways(found, 9)]
    slow, fast = (
        graphic_tmm.motion(graphic_tmm.read(scene), at, plans=PLANS,
                           exact=True, fast=fast)
        for fast in (False, True)
    )  # fmt: skip
    for kind in ("places", "velocities", "accelerations", "omega", "epsilon", "forces", "balance"):
        rows, others = getattr(slow, kind), getattr(fast, kind)
        largest = max(np.abs(row).max() for row in rows.values())
        for key, row in rows.items():
            np.testing.assert_allclose(others[key], row, rtol=0, atol=1e-12 * largest)


@pytest.mark.slow
@pytest.mark.parametrize("seed", [1, 2])
def test_the_page_calculates_as_python_does(seed: int, tmp_path: Path) -> None:
    _, scene = turning(seed, 1 + seed)
    page_is_right(scene, tmp_path)
