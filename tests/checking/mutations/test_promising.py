"""Mutations left out before tables are weighed with them: none of these is likely, by everything weighed."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from support.own_student.mistakes import KINDS
from support.own_told import report_of, with_mistake

from graphic_tmm.checking.mutations import diagnosis
from graphic_tmm.checking.mutations.evidence import of_mutations
from graphic_tmm.checking.mutations.promising import promising
from graphic_tmm.checking.mutations.refinement import plain_figures

NEAR = 8.0
"""What is less likely than the likeliest by more (natural logarithm) changes no name."""


@pytest.mark.turns(1)
@pytest.mark.parametrize("name", ["omega halved", "omega not squared in πa", "inertia along a"])
@pytest.mark.slow
def test_no_likely_mutation_is_left_out(monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    calls: list[tuple[Any, ...]] = []

    def recorded(*args: Any) -> list[int]:
        rows = promising(*args)
        calls.append((*args[:4], rows))
        return rows

    monkeypatch.setattr(diagnosis, "promising", recorded)
    kind = next(kind for kind in KINDS if kind.name == name)
    report_of(with_mistake(kind, 1, 7100, own=False, mu_rows=True))
    assert calls
    readings, offered, base, left, rows = calls[0]
    every = [int(k) for k in offered.moving(readings.visible(left))]
    some = [offered.mutations[k] for k in every]
    plain = plain_figures(readings, offered, some, base)
    gain = of_mutations(readings, base, some, plain)[0].gain
    whole = np.maximum(gain.sum(axis=1), gain.max(axis=1))
    likely = {k for k, w in zip(every, whole, strict=True) if w > max(NEAR, whole.max() - NEAR)}
    assert likely
    assert likely <= set(rows)
    assert len(rows) < len(every) / 3
