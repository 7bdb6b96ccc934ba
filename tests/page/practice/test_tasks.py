"""Poses: the same plans at other angles of the crank, by a seed."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from support import gallery
from support.benches import SOME
from support.each import each

from graphic_tmm.board.values import Length
from graphic_tmm.page.dense import dense
from graphic_tmm.page.practice.pack import Packing, practice
from graphic_tmm.page.practice.tasks import APART, SHORT, PoseRow, posed, sheet_row, with_others
from graphic_tmm.scene.packaged import packaged

NAMES = ("windrower", "scotch-yoke", "crank-rocker", "toggle-press")


def row(name: str) -> PoseRow:
    found = sheet_row(gallery.exact(name))
    assert found is not None
    return found


def poses(name: str, seed: int) -> PoseRow:
    found = posed(row(name), seed)
    assert found is not None
    return found


def test_a_seed_poses_alike_and_another_one_otherwise() -> None:
    assert poses("windrower", 3).names == poses("windrower", 3).names
    assert len({poses("windrower", seed).names for seed in range(6)}) == 6


@each("name", NAMES)
def test_every_plan_is_posed_where_it_can_be_drawn(name: str) -> None:
    there = row(name)
    turn = dense(there.work)
    assert turn is not None
    bad = np.array([turn.turned[k] for k in turn.drawn.undrawn])
    for seed in range(5):
        found = poses(name, seed)
        assert set(found.places) == set(there.places)
        for plan, (at,) in found.places.items():
            angle = float(found.names[at].rstrip("°").replace(",", "."))
            off = np.abs((turn.angles[0] + bad - angle + 180.0) % 360.0 - 180.0)
            assert bad.size == 0 or off.min() > APART - 0.1
            for step in found.steps:
                if step.it.view == plan:
                    assert found.there(step.it, at), (name, seed, step)
                if step.it.view == plan and step.it.kind is Length:
                    (length,) = found.numbers(step.it)[at if len(found.numbers(step.it)) > 1 else 0]
                    everywhere = np.abs(turn.drawn.reading[step.it])
                    assert abs(length) >= SHORT or (everywhere < SHORT).all(), (name, seed, step)


@pytest.mark.slow
def test_poses_stand_behind_the_positions_and_change_nothing_of_them() -> None:
    made, there = gallery.exact("windrower"), row("windrower")
    plain = Packing(made, there, ()).data(())
    more = Packing(made, with_others(there, poses("windrower", 3)), ()).data(())
    count = len(plain["names"])
    assert more["names"][:count] == plain["names"]
    assert [task for task in more["tasks"] if not task.get("pose")] == plain["tasks"]
    assert {task["at"] for task in more["tasks"] if task.get("pose")} == set(
        range(count, len(more["names"]))
    )
    for manner, limits in plain["manners"].items():
        for slot, own in limits["own"].items():
            for key, column in own.items():
                told = more["manners"][manner]["own"][slot][key]
                assert told[: len(column)] == column
                assert len(told) == len(column) + 1


def test_a_pose_is_the_same_mechanism_at_that_angle() -> None:
    found = poses("windrower", 3)
    turn = dense(row("windrower").work)
    assert turn is not None
    for step in found.steps:
        own = turn.drawn.reading
        if step.it not in own:
            continue
        for name in found.names:
            at = found.names.index(name)
            near = np.abs(
                (turn.angles - float(name[:-1].replace(",", ".")) + 180.0) % 360.0 - 180.0
            )
            k = int(np.argmin(near))
            due: Any = own[step.it]
            parts = due if isinstance(due, tuple) else (due,)
            mine = found.reading[step.it]
            mine = mine if isinstance(mine, tuple) else (mine,)
            for one, other in zip(mine, parts, strict=True):
                a = one[0, at if one.shape[1] > 1 else 0]
                b = other[0, k if other.shape[1] > 1 else 0]
                assert abs(a - b) < 1e-9 * max(1.0, abs(b)), step


@pytest.mark.slow
@each("name", [path.name for path in packaged()])
def test_every_scene_can_be_posed(name: str, many: Callable[[int, int], int]) -> None:
    """Some scenes with groups of every kind, loads and diagrams; with ``--measured`` every one."""
    there = sheet_row(gallery.exact(name)) if many(1, 0) or name in SOME else None
    others = None if there is None else posed(there, 5)
    if there is None or others is None:
        return
    whole = with_others(there, others)
    for plan, places in others.places.items():
        for step in whole.steps:
            if step.it.view == plan:
                for at in places:
                    assert whole.there(step.it, len(there.names) + at), (plan, step)


@pytest.mark.parametrize("name", ["planetary", "lettering"])
def test_what_has_no_mechanism_has_nothing_to_practise(name: str) -> None:
    assert practice(gallery.exact(name), (), ()) is None
