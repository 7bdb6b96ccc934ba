"""The page's benches: what Python draws, they draw; each task can be worked in any order."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from support.benches import Packed, packed, practised, worked

from graphic_tmm.board.values import arrays

NEAR = 1e-9
"""So near are two ways to calculate, as a share of what is calculated; mm where it is less than that."""


@pytest.fixture(scope="module", params=["windrower", pytest.param("", marks=pytest.mark.slow)])
def answers(
    tmp_path_factory: pytest.TempPathFactory, request: pytest.FixtureRequest
) -> list[tuple[Packed, dict[str, Any]]]:
    """Scenes of the package, and what the page's benches have of them: one every day, all of them in CI."""
    scenes = [packed(request.param)] if request.param else practised()
    return list(zip(scenes, worked(scenes, {}, tmp_path_factory.mktemp("benches")), strict=True))


def test_every_step_comes_to_what_python_has(answers: list[tuple[Packed, dict[str, Any]]]) -> None:
    compared = 0
    for scene, answer in answers:
        row = scene.packing.row
        for task, exact in zip(scene.data["tasks"], answer["exact"], strict=True):
            for step in scene.packing.steps:
                due = _numbers(row.reading[step.it], task["at"])
                found = exact[str(step.it.slot)]
                if not row.there(step.it, task["at"]):
                    continue
                compared += 1
                size = max(1.0, *map(abs, due))
                apart = [abs(a - b) for a, b in zip(due, found, strict=True)]
                assert max(apart) < NEAR * size, (scene.name, step.it, task["at"], due, found)
    assert compared > 1_500 * len(answers)


def test_every_task_is_worked_in_two_orders(answers: list[tuple[Packed, dict[str, Any]]]) -> None:
    faults = [
        (scene.name, task["plan"], task["at"], one["faults"])
        for scene, answer in answers
        for task, both in zip(scene.data["tasks"], answer["solved"], strict=True)
        for one in both
        if one["faults"]
    ]
    assert faults == []
    orders = [both for _, answer in answers for both in answer["solved"]]
    assert sum(first["order"] != last["order"] for first, last in orders) > len(orders) / 2


def _numbers(value: Any, at: int) -> list[float]:
    flat: list[float] = []
    for part in arrays(value):
        z = part[0][at if part.shape[1] > 1 else 0]
        flat += [z.real, z.imag] if np.iscomplexobj(part) else [float(z)]
    return flat
