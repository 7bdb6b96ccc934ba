"""What a refinement costs: its trials, and the smaller construction of each."""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest
from support.boards import recorded
from support.gallery import SHEETS
from support.logs import FourBar

from graphic_tmm.accuracy.cost import MINUTES, count, varying
from graphic_tmm.accuracy.geometrography import elements, symbol
from graphic_tmm.board.operations.locus import PARTS, PASSES, refinement
from graphic_tmm.board.record import Board, Construction, Mark
from graphic_tmm.board.values import Angle
from graphic_tmm.errors import ConstructionError
from graphic_tmm.mechanism.records import Extreme, Row
from graphic_tmm.scene.read import read


def refined() -> tuple[Construction, Mark, Mark]:
    board = Board()
    board.open("extremes")
    low, high = board.take(Angle, "φ′"), board.take(Angle, "φ″")

    def tried(row: np.ndarray) -> np.ndarray:
        raise AssertionError("nothing is run to count it")

    found = board.draw(refinement(tried, "{it}"), "φ", low, high)
    return board.construction(), low, found


def test_a_refinement_costs_its_trials() -> None:
    log, low, found = refined()
    bar = FourBar()
    inner = count(bar.log, [bar.phi])
    trials = PARTS + 1 + (PASSES - 1) * (PARTS - 1)
    own = elements(symbol(log.steps[0].op), trials)
    work = count(log, [], tried={found: inner})
    assert work.untold == ()
    assert work.operations == Counter({"refine": 1}) + Counter(
        {name: n * trials for name, n in inner.operations.items()}
    )
    assert work.elements == own + Counter((inner * trials).elements)
    assert work.minutes == pytest.approx(
        inner.minutes * trials + sum(n * MINUTES[e] for e, n in own.items())
    )
    one = count(log, [], tried={found: inner}, passes=1)
    assert one.operations["cross"] == PARTS + 1
    two = count(log, [], tried={found: inner}, passes=2)
    assert two.operations["cross"] == 2 * PARTS
    varied = count(log, [low], tried={found: inner}, passes=1, positions=5)
    assert varied == one * 5


def test_a_refinement_whose_construction_is_not_told_is_named() -> None:
    log, _, found = refined()
    work = count(log, [])
    assert work.untold == (found,)
    assert work.operations == {"refine": 1}
    with pytest.raises(ConstructionError, match="passes: at least one, not 0"):
        count(log, [], passes=0)


def test_the_refined_extreme_of_a_mechanism_is_counted() -> None:
    mechanism = read(SHEETS / "crank-rocker").mechanism
    assert mechanism is not None
    inner = mechanism.links[1]
    letter = next(p for p in inner.points if p not in ("A", "B"))
    project = recorded(mechanism, Row(8, zero=Extreme(letter, "top")), plans=("positions",))
    names = [step.op.name for step in project.construction.steps]
    work = count(project.construction, varying(project.given), positions=8)
    assert names.count("refine") == len(work.untold) == 1
