"""The mistakes that a scene offers: what tables say with each, executed in parts, is what each says alone."""

from __future__ import annotations

import numpy as np
import pytest
from support.gallery import exact
from support.own_told import checker

from graphic_tmm.checking.cells import figures
from graphic_tmm.checking.judging.taken_marks import steps_of
from graphic_tmm.checking.mutations import mistakes
from graphic_tmm.checking.mutations.execution import figures_of
from graphic_tmm.checking.mutations.mutation import SENSE


@pytest.mark.slow
def test_figures_of_parts_are_those_of_each_mistake(monkeypatch: pytest.MonkeyPatch) -> None:
    made = exact("crank-rocker")
    offered = mistakes.Offered(made, made.boards[0])
    monkeypatch.setattr(mistakes, "PART", len(offered.mutations) // 3)
    keys = [(key, mm) for mm in (True, False) for key in figures(made, in_mm=mm)]
    whole = offered.figures(keys)
    rows = np.arange(0, len(offered.mutations), 97)
    some = offered.figures(keys, rows)
    moved = 0
    for row, k in enumerate(rows):
        beside = offered.run([mistakes.NONE, offered.mutations[k]])
        alone = figures_of(made, offered.board, beside, np.arange(2), keys)
        for at, figure in alone.items():
            assert whole[at][k] == pytest.approx(figure[1], rel=1e-9, abs=1e-9, nan_ok=True)
            assert some[at][row] == pytest.approx(whole[at][k], nan_ok=True)
            moved += not np.isclose(figure[1], figure[0], equal_nan=True)
    assert moved > rows.size


@pytest.mark.turns(1)
@pytest.mark.parametrize("name", ["crank-rocker", "engine"])
@pytest.mark.slow
def test_what_no_part_reaches_none_of_it_moves(monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    made = exact(name)
    offered = mistakes.Offered(made, made.boards[0])
    every = figures_of(
        made,
        offered.board,
        offered.run(offered.mutations),
        np.arange(len(offered.mutations)),
        offered.keys,
    )
    monkeypatch.setattr(mistakes, "PART", len(offered.mutations) // 60)
    parts: list[int] = []
    run = mistakes.Offered.run
    monkeypatch.setattr(
        mistakes.Offered, "run", lambda self, some, *base: parts.append(0) or run(self, some, *base)
    )
    plans = [at for at in offered.keys if at[1] and at[0][:2] in steps_of(made.mechanism)]
    plans = [at for at in plans if at[0][0] in ("positions", "velocities")]
    drawn = offered.figures(plans)
    assert 1 < len(parts) < 50, "what comes after these plans is not calculated"
    for at, figure in (drawn | offered.figures([at for at in offered.keys if not at[1]])).items():
        np.testing.assert_allclose(
            figure, np.broadcast_to(every[at], figure.shape), rtol=1e-9, atol=1e-9
        )


def test_a_mistake_of_signs_alone_moves_lengths_that_bear_them() -> None:
    offered = checker("frc")._due.mistakes.boards[0]
    row = next(
        k
        for k, one in enumerate(offered.mutations)
        if one.family == SENSE and one.at is not None and one.at.it.letter == "y_S"
    )
    at = ("diagrams", "S", "4"), True
    assert row not in offered.moving({at: 0.5})
    assert row in offered.moving({at: 0.5}, signed={at})
