"""Plans of a student's own making proposed without a click: where they stand, in his μ, turned."""

from __future__ import annotations

import functools
from pathlib import Path

import pytest
from support.own_boards import A, V
from support.own_plans import own_plans
from support.own_sheets import Kind

from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking.own_sheet.proposals import Proposal, proposals
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

CASES = Path(__file__).parents[2] / "cases" / "check"


@functools.cache
def exact(machine: str) -> DrawnScene:
    return make(read(CASES / f"{machine}.toml"), exact=True)


def proposed(kind: Kind, machine: str = "") -> tuple[Proposal, ...]:
    """What is proposed of a drawing, taken for one of its mechanism, or of another."""
    return proposals(exact(machine or kind.machine), own_plans(kind).flat, HANDS["student"])


@pytest.mark.turns(2)
@pytest.mark.parametrize(
    "kind",
    [
        Kind("sc", mu={V: 0.8, A: 1.25}),
        Kind("fb", mu={V: 1.6, A: 1.0}, heads=0.0),
        Kind("rpr", mu={V: 1.3, A: 1.6}, rings=True),
        Kind("sc", turn=90.0),
        Kind("rpr", turn=-90.0, mu={V: 1.25, A: 1.0}),
    ],
)
@pytest.mark.slow
def test_plans_are_proposed_where_they_stand_in_the_students_scale_factor(kind: Kind) -> None:
    due = {(one.plan, one.position): one for one in own_plans(kind).clicked}
    found = proposed(kind)
    assert len(found) >= 2
    for one in found:
        own = due[one.plan.plan, one.plan.position]
        assert one.plan.first is not None
        assert own.first is not None
        assert abs(one.plan.pole - own.pole) < 2.0
        assert abs(one.plan.first - own.first) < 3.0


@pytest.mark.parametrize(("kind", "machine"), [("sc", "fb"), ("fb", "rpr"), ("rpr", "sc")])
@pytest.mark.slow
def test_nothing_is_proposed_of_a_mechanism_that_was_not_drawn(kind: str, machine: str) -> None:
    assert proposed(Kind(kind), machine) == ()


@pytest.mark.slow
def test_a_plan_that_was_drawn_wrongly_is_not_proposed() -> None:
    kind = Kind("sc", "t from a", mu={V: 1.0, A: 1.25})
    assert {one.plan.plan for one in proposed(kind)} == {V}
