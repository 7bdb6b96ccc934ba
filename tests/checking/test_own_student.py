"""A student who draws in his own μ, places and axes: his constructions are right, mistakes are told.

A sample; all of it, by kinds: `python tests/benchmarks/own_student.py`.
"""

from __future__ import annotations

import pytest
from support.own_student.hand import Exact
from support.own_student.machines import MACHINES, Machine
from support.own_student.mistakes import KINDS
from support.own_student.student import drawn, due_factors, student
from support.own_told import checker, with_mistake

from graphic_tmm.checking.cells import cells, points


@pytest.mark.parametrize("machine", MACHINES.values(), ids=list(MACHINES))
def test_without_slips_he_draws_what_is_due(machine: Machine) -> None:
    made = checker(machine.name).made
    due, spots = cells(made), points(made)
    figures = drawn(machine, due_factors(machine), Exact())
    for one in figures:
        key = one.plan, one.segment, str(one.position)
        if one.spot is not None:
            assert abs(one.spot - spots[key]) < 0.01, key
            continue
        cell = due[key]
        if one.mm is not None:
            assert cell.mm is not None
            assert one.mm == pytest.approx(cell.mm, abs=0.06), key
        assert cell.value is not None
        assert one.value == pytest.approx(cell.value, rel=2e-3, abs=2e-3), key
    assert {one.plan for one in figures} >= {"positions", "velocities", "accelerations"}
    assert any(one.plan == "forces" for one in figures) == bool(machine.loads)


def test_mistakes_move_what_is_read() -> None:
    """Each kind's drawing differs from the honest one of the same hand and seed."""
    for k, kind in enumerate(KINDS):
        wrong = with_mistake(kind, k)
        mu = wrong.mu if kind.scene_mu else None
        right = student(wrong.machine, wrong.seed, way=wrong.manner.way, mu=mu)
        assert wrong.csv != right.csv, kind.name
        assert wrong.truth is not None
