"""Ways of drawing random mechanisms: in order, each what it says; budgets kept by fresh drawings."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from itertools import pairwise

import pytest
from support.drawn_at_random import errors, scenes

from graphic_tmm.accuracy.budget import Measured, Taken, cheapest, choose, choose_from, nearest_way
from graphic_tmm.accuracy.drawing import References, draw, pinned
from graphic_tmm.accuracy.measure import work_of
from graphic_tmm.accuracy.quantities import quantities
from graphic_tmm.accuracy.ways import Ways, pace, wanted, worst
from graphic_tmm.readers.position_count import at_all_positions
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make

BUDGETS = (20.0, 10.0, 5.0, 2.0, 1.0)
FRESH = 60_000


@cache
def scene(k: int) -> Scene:
    return [*scenes(k + 1)][k].scene


@cache
def ways(k: int) -> Ways:
    scales = pinned(make(scene(k), exact=True))
    return Ways(scene(k), References(at_all_positions(scene(k)), scales))


def claims(taken: Taken) -> bool:
    """Whether a sentence says that a budget is kept, and not that this is the nearest."""
    return not taken.sentence.startswith("--budget")


@pytest.mark.parametrize("k", [0, 8])
def test_ways_stand_in_the_order_of_their_minutes_and_the_scenes_own_is_among_them(k: int) -> None:
    found = ways(k)
    assert all(a.minutes <= b.minutes for a, b in pairwise(found.every))
    own = found.own
    assert (own.hand, own.ruler, own.times) == (scene(k).hand, scene(k).ruler, 1.0)
    assert own.of(scene(k)) == scene(k)


@pytest.mark.parametrize("k", [0, 8])
def test_the_minutes_of_the_scenes_own_way_are_those_of_its_log(k: int) -> None:
    due = 0.0
    for drawing in draw(scene(k), pinned(make(scene(k), exact=True))):
        marks = [m for q in quantities(drawing) if wanted(scene(k), q) for m in q.marks]
        due += work_of(drawing, marks).minutes
    same = [way for way in ways(k).every if way.boards == ways(k).own.boards]
    assert len({way.hand for way in same}) > 1 or scene(k).hand == "exact"
    for way in same:
        assert way.minutes == pytest.approx(due * pace(way.hand, way.ruler))


@pytest.mark.parametrize("k", [0, 3])
@pytest.mark.slow
def test_a_way_is_drawn_as_it_says(k: int) -> None:
    for way in ways(k).every[:: len(ways(k).every) // 7]:
        drawn = way.of(scene(k))
        assert (drawn.hand, drawn.ruler) == (way.hand, way.ruler)
        assert str(drawn.row.count) == dict(way.changes)["positions"]


@pytest.mark.slow
def test_what_is_expected_is_what_fresh_drawings_give() -> None:
    """To the scene's own scales, by a hand that slips: a ruler alone rounds by no chance."""
    scales = pinned(make(scene(3), exact=True))
    slipping = [
        w for w in ways(3).every if w.hand == "careful" and w.times == 1.0 and w.ruler == 0.1
    ]
    assert len(slipping) >= 4
    for way in slipping:
        due = errors(way.of(scene(3)), FRESH, 600, scales)
        assert way.errors.keys() == due.keys()
        assert way.worst == pytest.approx(max(due.values()), rel=0.15), way.changes


def test_a_ruler_is_chosen_on_paper_only() -> None:
    own = replace(scene(0), hand="cad", ruler=0.01)
    references = References(at_all_positions(own), pinned(make(own, exact=True)))
    assert {way.ruler for way in Ways(own, references).every} == {0.01}
    assert {way.ruler for way in ways(0).every if way.hand == "student"} >= {0.5, 0.1}


def test_no_error_that_is_not_known_is_small() -> None:
    assert worst({"v": 1.0, "a": float("nan")}) == float("inf")
    assert worst({}) == float("inf")


def kept(k: int, budgets: tuple[float, ...], trials: int) -> list[bool]:
    """Whether what claims to keep within each budget does; none costs more than a tighter one."""
    measured = Measured(scene(k))
    taken = [(percent, choose_from(measured, percent, nearest=True)) for percent in budgets]
    claimed = [(percent, one) for percent, one in taken if claims(one)]
    minutes = [one.minutes for _, one in claimed]
    assert minutes == sorted(minutes)
    for percent, one in claimed:
        assert max(one.errors.values()) <= percent
    return [max(errors(one.scene, FRESH, trials).values()) <= percent for percent, one in claimed]


@pytest.mark.parametrize("k", [0, 1])
@pytest.mark.slow
def test_a_budget_is_kept_by_fresh_drawings(k: int) -> None:
    """The scene's own error is the budget, too: what only just keeps within it is not taken."""
    own = max(errors(scene(k), FRESH).values())
    assert all(kept(k, (own, 0.5 * own), 1000))


def test_none_cheaper_keeps_within() -> None:
    own = ways(0).own
    for percent in (own.worst, 0.5 * own.worst):
        taken = choose(scene(0), percent)
        assert taken.way.worst < 1.2 * percent
        assert not [
            way
            for way in ways(0).every
            if way.minutes < taken.minutes and way.times == 1.0 and way.worst < 0.8 * percent
        ]


@pytest.mark.slow
def test_what_is_measured_is_what_fresh_drawings_give() -> None:
    """And what is said to be kept for sure is hardly exceeded."""
    measured = Measured(scene(1))
    for way in [way for way in measured.ways.every if way.hand == "careful"][::9]:
        if (drawn := measured.of(way)) is not None:
            due = errors(drawn[0], FRESH)
            assert drawn[1].measured == pytest.approx(due, rel=0.1)
            assert all(due[name] <= 1.03 * sure for name, sure in drawn[1].sure.items())


@pytest.mark.slow
@pytest.mark.parametrize(("k", "percent"), [(8, 0.02), (14, 1.0)])
def test_the_nearest_is_hardly_less_exact_than_any(k: int, percent: float) -> None:
    """Than any that is drawn on its own sheets, whatever was expected of it."""
    measured = Measured(scene(k))
    assert cheapest(measured, percent) is None
    _, drawn, told = nearest_way(measured)
    assert worst(told) == pytest.approx(worst(errors(drawn, FRESH)), rel=0.1)
    others = (measured.of(way) for way in measured.ways.every if way.worst < 2.0 * worst(told))
    assert worst(told) <= 1.1 * min(worst(one[1].measured) for one in others if one is not None)


@pytest.mark.slow
def test_of_a_hundred_budgets_ninety_five_are_kept(many: Callable[[int, int], int]) -> None:
    """20 random mechanisms when measured, else 6, five budgets each; see benchmarks/budgets.py."""
    count = many(20, 6)
    found = [one for k in range(count) for one in kept(k, BUDGETS, 1000)]
    assert len(found) >= 4.5 * count
    assert sum(found) >= 0.95 * len(found)
