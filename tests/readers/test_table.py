"""The figures of many drawings as arrays."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from support.columns import along
from support.gallery import made

from graphic_tmm import studio
from graphic_tmm.board import hand as hands
from graphic_tmm.drawn import hand_of
from graphic_tmm.readers.columns import Column
from graphic_tmm.readers.table import (
    joined_columns,
    joined_results,
    scene_columns,
    scene_results,
    trial_figures,
)


def test_blocks_of_drawings_are_one_row_of_trials() -> None:
    """Where nothing varies one trial stands for all; a last one may be alone; a result may be missing."""
    rows = np.random.default_rng(9).standard_normal((7, 2))
    base = Column("velocities", "pb", "pb", "m/s", along(1.0, 2.0), along(0.0, 0.0))
    blocks = [(3, rows[:3]), (3, rows[:1]), (1, rows[6:])]
    (made,) = joined_columns([(n, [replace(base, value=some)]) for n, some in blocks])
    assert made.mm is base.mm
    assert made.value.tolist() == [*rows[:3].tolist(), *[rows[0].tolist()] * 3, rows[6].tolist()]
    results = joined_results([(2, {}), (1, {"J": (rows[0, :1], "kg")})])
    np.testing.assert_array_equal(results["J"][0], [np.nan, np.nan, rows[0, 0]])


@pytest.mark.parametrize("trials", [1, 6])
def test_figures_hold_a_row_a_drawing(monkeypatch: pytest.MonkeyPatch, trials: int) -> None:
    for room in (hands, studio):
        monkeypatch.setattr(room, "MOST", 4)
    scene = made("windrower")
    scene = scene._replace(scene=replace(scene.scene, hand="student", seed=3))
    found, results = trial_figures(scene, trials)
    alone = [scene] if trials == 1 else studio.drawings(scene, hand_of(scene.scene, trials))
    for k, drawn in enumerate(alone):
        for column, one in zip(found, scene_columns(drawn), strict=True):
            assert (column.plan, column.segment) == (one.plan, one.segment)
            for rows, row in ((column.mm, one.mm), (column.value, one.value)):
                np.testing.assert_array_equal(
                    np.broadcast_to(rows, (trials, rows.shape[1]))[k], row[0]
                )
        for name, (figures, unit) in scene_results(drawn).items():
            row = np.broadcast_to(results[name][0], trials)
            np.testing.assert_array_equal(row[k : k + 1], figures)
            assert results[name][1] == unit
    assert found
