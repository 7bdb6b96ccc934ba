"""Tables of many drawings at once: each trial is the drawing that it would be alone."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from support.gallery import NAMES, made

from graphic_tmm.board.hand import HANDS, MOST
from graphic_tmm.checking.cells import RESULTS, Key, cells, figures, points, spots
from graphic_tmm.drawn import single
from graphic_tmm.readers.table import scene_columns, scene_results
from graphic_tmm.studio import blocks, drawings

HAND = HANDS["student"]._replace(ruler=0.5, seed=11, trials=3)


@pytest.mark.parametrize("name", NAMES)
def test_each_trial_of_a_table_is_the_table_of_that_drawing(name: str) -> None:
    (block,) = blocks(made(name), HAND)
    assert block.trials in (1, HAND.trials)  # 1 of a scene without boards
    columns, results = scene_columns(block), scene_results(block)
    for k, drawn in enumerate(drawings(made(name), HAND)):
        for all_, one in zip(columns, scene_columns(drawn), strict=True):
            assert all_.segment == one.segment
            for rows, due in ((all_.mm, one.mm), (all_.value, one.value)):
                np.testing.assert_array_equal(np.broadcast_to(rows, (3, due.shape[1]))[k], due[0])
        told = {n: float(np.broadcast_to(row, 3)[k]) for n, (row, _) in results.items()}
        due = {n: value for n, (value, _) in single(scene_results(drawn)).items()}
        assert {n: x for n, x in told.items() if n in due or x == x} == due
    varied = [one for one in columns if np.ptp(one.value, axis=0).any()]
    assert bool(columns) == bool(varied)


def at(found: Mapping[Key, Any], trial: int) -> dict[Key, Any]:
    """What is known in one trial."""
    told = {key: np.broadcast_to(row, HAND.trials)[trial] for key, row in found.items()}
    return {key: figure for key, figure in told.items() if np.isfinite(figure)}


@pytest.mark.parametrize("name", ["engine", "windrower", "cam", "planetary"])
def test_each_trial_of_the_figures_is_what_readings_of_that_drawing_are_compared_with(
    name: str,
) -> None:
    (block,) = blocks(made(name), HAND)
    mm, value, stand = figures(block, in_mm=True), figures(block, in_mm=False), spots(block)
    assert mm.keys() == {key for key in value if key[0] != RESULTS}
    for k, drawn in enumerate(drawings(made(name), HAND)):
        due = cells(drawn)
        assert at(mm, k) == {key: one.mm for key, one in due.items() if one.mm is not None}
        assert at(value, k) == {key: one.value for key, one in due.items() if one.value is not None}
        assert at(stand, k) == points(drawn)


def test_blocks_number_their_trials_on() -> None:
    """The first trial of the second block is drawn as by a hand that begins there."""
    hand = HAND._replace(trials=MOST + 2)
    sizes = [block.trials for block in blocks(made("lever"), hand)]
    assert sizes == [MOST, 2]
    *_, last = blocks(made("lever"), hand)
    (alone,) = blocks(made("lever"), hand._replace(first=MOST, trials=2))
    for one, other in zip(scene_columns(last), scene_columns(alone), strict=True):
        np.testing.assert_array_equal(one.value, other.value)
