"""Which vectors are too short to be measured, by a drawing of rows that are given here."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pytest

from graphic_tmm.board.hand import EXACT
from graphic_tmm.classroom.variants import good


class Row(NamedTuple):
    segment: str
    mm: np.ndarray


class Plans:
    """A drawing: rows of mm as its own hand reads them, and as they are drawn exactly."""

    def __init__(self, read: list[float], exact: list[float]) -> None:
        self.read, self.exact = read, exact

    def drawn_by(self, hand: object) -> Plans:
        assert hand is EXACT
        return Plans(self.exact, self.exact)


@pytest.mark.parametrize(
    ("read", "exact", "short"),
    [
        ([40.0, 3.5], [40.1, 3.4], False),
        ([40.0, 2.5], [40.1, 2.4], True),
        ([40.0, 0.0], [40.1, 0.0], False),  # at its dead centre a ram stands still
        ([40.0, 0.0], [40.1, 0.3], True),  # the ruler reads nothing of what is there
        ([40.0, 0.5], [40.1, 2e-4], False),
        ([3.0, 9.0], [2.9, 9.0], False),  # the ruler says 3
    ],
)
def test_a_vector_is_short_if_it_is_something_and_less_than_the_limit(
    read: list[float], exact: list[float], short: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(good, "_vectors", lambda plans: [Row("pb", np.array([plans.read]))])
    assert bool(list(good.shortest(Plans(read, exact), 3.0))) is short  # type: ignore[arg-type]
