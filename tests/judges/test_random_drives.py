"""Random mechanisms of sliders, cylinders and several drives, drawn by the package, against the judge."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.against_judge import LIMITS, PLANS, errors, page_is_right, parameter, ways
from support.random_mechanisms import Random, drawn

import graphic_tmm
from graphic_tmm.board.execute import translator

WAYS = {
    "slider": ("slider",),
    "rod": ("rod",),
    "open crank": ("crank",),
    "two cranks": ("crank", "crank"),
    "crank and rod": ("crank", "rod"),
    "slider and rod": ("slider", "rod"),
    "rod and crank": ("rod", "crank"),
}
POSITIONS = 6
DEAR = "open crank", "crank and rod", "slider and rod", "rod and crank"
SOME = [pytest.param(kind, marks=pytest.mark.slow) if kind in DEAR else kind for kind in WAYS]
"""Of the kinds, those that are compared every day."""


def random_of(kind: str, seed: int, *, forces: bool) -> tuple[Random, dict[str, Any]]:
    """A mechanism, and its scene with an open row from one end of its walk to the other."""
    drives, groups = WAYS[kind], 1 + seed % (4 if len(WAYS[kind]) < 2 else 3)
    found = next(r for k in range(9) if (r := drawn(seed + 1000 * k, drives, groups)))
    scene = found.row(found.walked[0][0], found.walked[-1][0], POSITIONS)
    if not forces:
        scene = {
            key: told
            for key, told in scene.items()
            if key not in ("load", "spring", "forces", "effects")
        }
    return found, scene


def judged(kind: str, seed: int, *, forces: bool) -> None:
    found, scene = random_of(kind, seed, forces=forces)
    plans = PLANS if forces else PLANS[:3]
    zero = found.walked[0 if found.judge.drives[0].rate > 0 else -1][0]
    off = errors(found, scene, ways(found, 5), plans, zero)
    assert all(off[name] <= LIMITS[name] for name in off), (kind, seed, found.kinds, off)


@pytest.mark.parametrize("kind", WAYS)
def test_motion(kind: str) -> None:
    judged(kind, 1, forces=False)


@pytest.mark.turns(7)
@pytest.mark.slow
@pytest.mark.parametrize("block", range(5))
@pytest.mark.parametrize("kind", WAYS)
def test_motion_oftener(kind: str, block: int) -> None:
    for seed in range(10 + 10 * block, 20 + 10 * block):
        judged(kind, seed, forces=False)


@pytest.mark.parametrize("kind", SOME)
def test_a_row_goes_from_its_one_end_to_its_other(kind: str) -> None:
    found, scene = random_of(kind, 1, forces=False)
    ends = found.walked[0][0], found.walked[-1][0]
    low, high = ends if found.judge.drives[0].rate > 0 else ends[::-1]
    table = graphic_tmm.draw(graphic_tmm.read(scene), exact=True).table("velocities")
    assert table.positions == tuple(map(str, range(POSITIONS)))
    states = [found.solved(way) for way in np.linspace(low, high, POSITIONS)]
    largest = max(abs(turn) for state in states for turn in state.omega.values())
    compared = 0
    for number in (link["number"] for link in scene["link"]):
        if (name := f"omega{number}") in table:
            due = [abs(state.omega[number]) for state in states]
            np.testing.assert_allclose(
                np.abs(table[name].value[0]), due, rtol=0, atol=1e-9 * largest
            )
            compared += 1
    assert compared


@pytest.mark.skipif(not translator(), reason="nothing compiles here")
@pytest.mark.parametrize("kind", SOME)
def test_compiled_is_as_drawn_step_by_step(kind: str) -> None:
    found, scene = random_of(kind, 2, forces=False)
    at = [parameter(found, way) for way in ways(found, 9)]
    read = graphic_tmm.read(scene)
    slow, fast = (graphic_tmm.motion(read, at, exact=True, fast=fast) for fast in (False, True))
    for name in ("places", "velocities", "accelerations", "omega", "epsilon"):
        rows, others = getattr(slow, name), getattr(fast, name)
        largest = max((np.abs(row).max() for row in rows.values()), default=0.0)
        for key, row in rows.items():
            np.testing.assert_allclose(others[key], row, rtol=0, atol=1e-12 * largest)


@pytest.mark.parametrize(
    "kind", ["rod", *(pytest.param(k, marks=pytest.mark.slow) for k in ("slider", "open crank"))]
)
def test_behind_a_dead_place_nothing_is_told_but_a_finding(kind: str) -> None:
    for seed in range(99):
        found = drawn(seed, WAYS[kind], 1, ("RRR", "RRP", "RPR"))
        sense = next((s for s in (1, -1) if found and found.dead(s) is not None), 0)
        if found is not None and sense:
            break
    assert found is not None
    way = found.dead(sense)
    assert way is not None
    step = 0.03 if found.judge.drives[0].kind == "turn" else 0.03 * found.scale
    ends = sorted((0.0, way + sense * step))
    scene = found.row(ends[0], ends[1], POSITIONS)
    for key in ("load", "spring", "forces", "effects"):
        scene.pop(key, None)
    read = graphic_tmm.read(scene)
    at = [parameter(found, way + sense * x * step) for x in (-1e-3, 1e-6, 1.0)]
    motion = graphic_tmm.motion(read, at, exact=True)
    last = found.walked[0 if sense < 0 else -1][1]
    due = found.judge.solve(found.coordinates(way - sense * 1e-3 * step), last.poses)
    largest = max(abs(due.point(*key)[0]) for key in motion.places)
    off = [abs(z[0] - due.point(*key)[0]) for key, z in motion.places.items()]
    assert np.max(off) < 1e-9 * largest
    for k in (1, 2):
        assert any(np.isnan(z[k]) for z in motion.places.values())
    sheet = graphic_tmm.draw(read, exact=True)
    behind = (sense > 0) == (found.judge.drives[0].rate > 0)
    name = str(POSITIONS - 1) if behind else "0"
    assert any("cannot be drawn" in warning and name in warning for warning in sheet.warnings)
    table = sheet.table("velocities")
    k = table.positions.index(name)
    assert any(np.isnan(column.value[0, k]) for column in table.values())


@pytest.mark.parametrize("kind", ["rod", pytest.param("slider and rod", marks=pytest.mark.slow)])
def test_the_page_calculates_as_python_does(kind: str, tmp_path: Path) -> None:
    _, scene = random_of(kind, 0, forces=False)
    page_is_right(scene, tmp_path)
