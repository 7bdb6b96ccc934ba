"""Shares of sources against switching each off, by 20,000 other drawings; steps against sources."""

from __future__ import annotations

import pytest
from support.gallery import scene
from support.switched_off import (
    FRESH,
    Task,
    brute,
    by_kind,
    deviations,
    sources_of,
    tasks,
    told_by_kind,
)

from graphic_tmm.accuracy.answer_text import parts
from graphic_tmm.accuracy.sources import Sources, sources
from graphic_tmm.board.hand import EXACT, HANDS

SCENES = ("slider-diagrams", "windrower", "crank-rocker", "cam", "engine", "gear-pair")
"""Of each sort of drawing one."""


def agree(name: str, hand: str, trials: int, within: float) -> None:
    for task in tasks(scene(name)):
        due = brute(task, hand, trials)
        found = sources_of(task, hand)
        assert found.keys() == due.keys()
        for quantity, one in found.items():
            assert one.parts.keys() == due[quantity].keys()
            assert one.parts == pytest.approx(due[quantity], abs=within), (name, quantity)


@pytest.mark.slow
def test_a_share_is_what_goes_when_its_source_is_switched_off() -> None:
    agree("crank-rocker", "student", 6_000, 0.03)


@pytest.mark.turns(1, "sources")
@pytest.mark.slow
@pytest.mark.parametrize("name", SCENES)
def test_shares_are_known_to_three_hundredths(name: str) -> None:
    agree(name, "student", 20_000, 0.03)


@pytest.mark.turns(1, "sources")
@pytest.mark.slow
@pytest.mark.parametrize("name", ["slider-diagrams", "crank-rocker"])
def test_shares_of_a_careful_hand_too(name: str) -> None:
    agree(name, "careful", 20_000, 0.03)


def each(*names: str) -> list[tuple[str, Task, str, Sources]]:
    return [
        (name, task, quantity, one)
        for name in names
        for task in tasks(scene(name))
        for quantity, one in sources_of(task, "student").items()
    ]


@pytest.mark.slow
def test_shares_add_up_to_one() -> None:
    for name, _, quantity, one in each("slider-diagrams", "crank-rocker", "gear-pair", "engine"):
        alone = sum(max(share, 0.0) for share in one.parts.values())
        assert alone == pytest.approx(1.0, abs=0.05), (name, quantity)
        assert sum(share for _, share in parts(one)) == pytest.approx(1.0)


def test_what_no_source_brings_alone_is_told() -> None:
    one = Sources(4.0, {"swing": 0.5, "reading": 0.3, "digits": -0.1}, ())
    assert parts(one) == [("swing", 0.5), ("reading", 0.3), ("together", pytest.approx(0.2))]
    whole = Sources(4.0, {"swing": 0.6, "reading": 0.38}, ())
    assert dict(parts(whole)) == pytest.approx({"swing": 0.6 / 0.98, "reading": 0.38 / 0.98})


@pytest.mark.slow
def test_steps_of_a_kind_add_up_to_their_source() -> None:
    """Where sources do not act upon each other: those that do differ by what several steps do together."""
    judged = 0
    for name, _, quantity, one in each("slider-diagrams", "crank-rocker", "gear-pair", "engine"):
        if abs(1.0 - sum(one.parts.values())) <= 0.03:
            judged += 1
            assert by_kind(one) == pytest.approx(told_by_kind(one), abs=0.05), (name, quantity)
    assert judged >= 5


def test_what_slips_in_mm_weighs_a_quarter_on_a_drawing_twice_as_large() -> None:
    """The mean square of the larger drawing is the other three quarters of `in_mm` less."""
    student = HANDS["student"]._replace(trials=4_000, seed=FRESH)
    own, larger = (list(tasks(scene("crank-rocker"), times)) for times in (1.0, 2.0))
    for one, two in zip(own, larger, strict=True):
        found, before = sources_of(one, "student"), deviations(one, student)
        after = deviations(two, student)
        for quantity, shares in found.items():
            left = after[quantity][0] / before[quantity][0]
            assert left == pytest.approx(1.0 - 0.75 * shares.in_mm, abs=0.06), quantity


def test_what_is_drawn_without_a_slip_errs_by_its_method_alone() -> None:
    (task,) = tasks(scene("slider-diagrams"))
    found = sources_of(task, "exact")
    assert found["a_diagram"].parts == {"method": 1.0}
    ruled = sources(*task, EXACT._replace(ruler=0.1))["a_diagram"]
    assert ruled.parts.keys() == {"method", "ruler"}
    assert found["a_diagram"].steps == ruled.steps == ()
    assert deviations(task, EXACT)["a_diagram"][1] == 0.0
