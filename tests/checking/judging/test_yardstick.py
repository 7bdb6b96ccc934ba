"""A scene's yardsticks are made once, and are those that each drawing would have alone."""

from __future__ import annotations

import random
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.command import invoke
from support.gallery import exact
from support.scenes import calling
from support.trials import cells_and_points, readings

from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking.cells import cells
from graphic_tmm.checking.judging import yardstick as module
from graphic_tmm.checking.judging.own_errors import run
from graphic_tmm.checking.judging.scatter import Limits, sample
from graphic_tmm.checking.judging.step_scatter import scatters_of
from graphic_tmm.checking.judging.taken_marks import as_marks, steps_of
from graphic_tmm.checking.judging.yardstick import Yardstick, Yardsticks
from graphic_tmm.checking.records import Taken

HAND = HANDS["student"]._replace(trials=30)


def chosen(name: str, seed: int) -> Iterator[list[Taken]]:
    """Yield readings of some figures: of lengths, of points, of quantities, of all that there is."""
    chance, made = random.Random(seed), exact(name)
    due = cells_and_points(made)
    for share in (0.2, 0.6, 1.0):
        rows = [*readings(due, due), *readings(due, due, valued=True)]
        kind = chance.choice(["mm", "points", "all"])
        kept = [row for row in rows if kind == "all" or row.pointed == (kind == "points")]
        yield [row for row in kept if chance.random() < share]


def same(one: Yardstick, other: Yardstick) -> None:
    assert one.spread.keys() == other.spread.keys()
    for at, scatter in one.spread.items():
        assert np.array_equal(scatter.sorted, other.spread[at].sorted)
        assert scatter[1:4] == other.spread[at][1:4]
        assert np.array_equal(scatter.drawn, other.spread[at].drawn)
    assert one.steps.keys() == other.steps.keys()
    for at, own in one.steps.items():
        due = other.steps[at]
        assert own.sizes == due.sizes
        assert own.sharp == due.sharp
        assert own.scatter[1:4] == due.scatter[1:4]
        assert np.array_equal(own.drawn, due.drawn)
        assert (own.most, own.steady) == (due.most, due.steady)


@pytest.mark.turns(2)
@pytest.mark.slow
@pytest.mark.parametrize("name", ["crank-rocker", "offset-slider", "cam"])
@pytest.mark.parametrize("kept", [module.KEPT, 0])
def test_kept_they_are_those_of_each_drawing_alone(
    name: str, kept: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Also where a scene is so large that but what is read of it is drawn."""
    monkeypatch.setattr(module, "KEPT", kept)
    together = Yardsticks(exact(name), HAND, Limits())
    for seed in range(2):
        for rows in chosen(name, seed):
            same(together.of(rows), Yardsticks(exact(name), HAND, Limits()).of(rows))


@pytest.mark.slow
@pytest.mark.parametrize("name", ["crank-rocker", "shaper"])
def test_own_errors_are_those_of_the_whole_log_run_with_what_was_read(name: str) -> None:
    made = exact(name)
    work = made.mechanism
    assert work is not None
    together = Yardsticks(made, HAND, Limits())
    for rows in chosen(name, 5):
        parts = [part for row in rows for part in row.parts()]
        found, _ = as_marks(work, steps_of(work), parts, cells(made), together.reader)
        drawn = sample(made, together.reader.hand, {}, found)
        alone = scatters_of(
            work.construction,
            partial(run, work, grain={}),
            found,
            drawn.marks,
            together.reader,
            Limits(),
        )
        of = together.of(rows)
        same(of, of._replace(steps=alone))


def test_the_hand_draws_once_for_all_drawings(monkeypatch: pytest.MonkeyPatch) -> None:
    calls = []

    def counted(*args: Any, **named: Any) -> Any:
        calls.append(args)
        return sample(*args, **named)

    monkeypatch.setattr(module, "sample", counted)
    due = cells_and_points(exact("crank-rocker"))
    whole = readings(due, due)
    together = Yardsticks(exact("crank-rocker"), HAND, Limits())
    together.of(whole)
    assert len(calls) == 1
    for seed in range(3):
        for rows in chosen("crank-rocker", seed):
            together.of(rows)
    assert len(calls) == 1


@pytest.mark.slow
def test_a_plan_that_no_position_asks_for_has_no_yardstick(tmp_path: Path) -> None:
    """Forces of inertia use accelerations that stand on no sheet: lengths of other plans are judged."""
    path = calling(tmp_path, "effects", "load", "forces")
    rows = ["plan,position,segment,mm", *(f"velocities,1,{name},7" for name in ("ab", "pb", "ps2"))]
    readings = tmp_path / "readings.csv"
    readings.write_text("\n".join(rows), encoding="utf-8")
    assert invoke("check", path, readings, "--trials", "20").exit_code == 1
