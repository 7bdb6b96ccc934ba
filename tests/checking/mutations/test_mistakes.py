"""The mistakes that a scene offers: what tables say with each, executed in parts, is what each says alone."""

from __future__ import annotations

import numpy as np
import pytest
from support.gallery import exact

from graphic_tmm.checking.cells import figures
from graphic_tmm.checking.mutations import mistakes
from graphic_tmm.checking.mutations.execution import figures_of


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
