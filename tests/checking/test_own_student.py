"""A student who draws in his own μ, places and axes: his constructions are right, mistakes are told.

A sample; all of it, by kinds: `python tests/benchmarks/own_student.py`.
"""

from __future__ import annotations

import math
from collections import Counter

import pytest
from support.own_student.hand import Exact
from support.own_student.machines import MACHINES, Machine
from support.own_student.mistakes import KINDS
from support.own_student.student import drawn, due_factors, student
from support.own_student.table import WAYS
from support.own_told import NAMED, checker, report_of, scales, with_mistake

from graphic_tmm.checking.cells import cells, points
from graphic_tmm.checking.records import DOUBTFUL, WRONG, Report

HONEST = 40
PLANS = [machine for machine in MACHINES.values() if not machine.loads]
SURE_OF = 2.5
"""How many standard deviations of a sample's share a threshold of the whole is stretched by."""


def stretched(share: float, count: int) -> float:
    """Return how many of a sample may be so where ``share`` of all is."""
    return count * share + SURE_OF * math.sqrt(count * share * (1 - share))


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


@pytest.mark.slow
def test_mistakes_move_what_is_read() -> None:
    """Each kind's drawing differs from the honest one of the same hand and seed."""
    for k, kind in enumerate(KINDS):
        wrong = with_mistake(kind, k)
        mu = wrong.mu if kind.scene_mu else None
        right = student(wrong.machine, wrong.seed, way=wrong.manner.way, mu=mu)
        assert wrong.csv != right.csv, kind.name
        assert wrong.truth is not None


@pytest.mark.slow
def test_honest_drawings_in_his_own_scale_factors_are_not_wrong() -> None:
    count: Counter[str] = Counter()
    bad = []
    for k in range(HONEST):
        machine = PLANS[k % len(PLANS)]
        drawing = student(machine, 7000 + k, way=WAYS[k // len(PLANS) % len(WAYS)])
        report = report_of(drawing)
        assert isinstance(report, Report), report
        verdicts = Counter(one.verdict for one in report.readings)
        count += verdicts
        if verdicts[WRONG]:
            bad.append((machine.name, drawing.seed, drawing.manner, verdicts[WRONG]))
        named = [one for one in report.mistakes if one.kind in NAMED and one.chance >= 0.8]
        assert not named or verdicts[WRONG], (machine.name, drawing.seed, named)
        count.update(what for _, what in scales(report, drawing))
    assert count["false"] == 0
    assert len(bad) <= stretched(0.005, HONEST), bad
    assert count[DOUBTFUL] <= stretched(0.02, sum(count[one] for one in ("fine", DOUBTFUL, WRONG)))
