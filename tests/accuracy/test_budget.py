"""A budget keeps its promise, takes the cheapest, and says when none does."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from support.gallery import SHEETS
from support.tasks import text_of, written

from graphic_tmm.accuracy.answer import answer
from graphic_tmm.accuracy.answer_text import sentences
from graphic_tmm.accuracy.budget import choose
from graphic_tmm.accuracy.drawing import References, pinned
from graphic_tmm.accuracy.measure import Measure
from graphic_tmm.accuracy.settings import Setting, hand_named
from graphic_tmm.accuracy.words import WORDS
from graphic_tmm.errors import SceneError
from graphic_tmm.readers.position_count import at_all_positions
from graphic_tmm.scene.drawing import DIVISIONS
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make


def task(name: str, hand: str | None = None) -> Scene:
    """A scene on the sheets of its plans: what only tells of them is no matter of a budget."""
    found = read(SHEETS / name)
    found = replace(found, sheets=found.sheets[:2])
    return found if hand is None else replace(found, hand=hand, ruler=DIVISIONS[hand])


@pytest.mark.turns(2, "budgets")
@pytest.mark.slow
@pytest.mark.parametrize("hand", ["student", "careful"])
def test_a_budget_keeps_its_promise_on_the_sheet_that_is_drawn_by_other_drawings_too(
    hand: str,
) -> None:
    """Measured again with other seeds and 300 drawings, to 3 standard errors of both measurements."""
    taken = choose(task("slider-diagrams", hand), 10.0)
    other = at_all_positions(replace(taken.scene, seed=4711))
    scales = pinned(make(taken.scene, exact=True))
    judge = Measure(scales, References(other, scales), clock=False)
    runs = judge.runs(Setting(other, hand, hand_named(hand, other, 300)), "", "")
    for run in runs:
        if run.quantity != "a":
            few = run.errors.spread * 3**0.5  # of 100 drawings, by which the setting was chosen
            assert run.error <= 10.0 + 3.0 * (run.errors.spread**2 + few**2) ** 0.5


@pytest.mark.turns(2, "budgets")
@pytest.mark.slow
def test_a_smaller_error_costs_no_less() -> None:
    spent = [choose(task("slider-diagrams"), percent).minutes for percent in (25.0, 3.0, 1.5)]
    assert spent == sorted(spent)
    assert spent[0] < spent[-1]


@pytest.mark.turns(2, "budgets")
@pytest.mark.slow
def test_positions_that_the_scene_names_keep_their_places() -> None:
    own = replace(task("offset-slider"), hand="student", ruler=0.5)
    assert own.row.accelerations == ("1", "4", "8")
    taken = choose(own, 20.0)
    assert taken.scene.row.count % 3 == 0 or taken.scene.row.count % 12 == 0
    angles = {int(n) / 12 for n in own.row.accelerations}
    assert {int(n) / taken.scene.row.count for n in taken.scene.row.accelerations} == angles


@pytest.mark.turns(2, "budgets")
@pytest.mark.slow
def test_no_setting_keeps_within_nothing_and_the_best_is_named() -> None:
    with pytest.raises(SceneError) as refused:
        choose(task("slider-diagrams"), 0.0001)
    text = str(refused.value)
    assert "0,0001 %" in text
    assert "положени" in text
    assert "a по диаграмме" in text


@pytest.mark.turns(2, "budgets")
@pytest.mark.slow
def test_only_what_stands_on_the_sheets_has_to_keep_within_it() -> None:
    """The scene's sheets show no accelerations; they are drawn only to judge the diagrams."""
    assert set(choose(task("slider-diagrams"), 5.0).errors) == {"v", "V_diagram", "a_diagram"}


@pytest.mark.turns(2, "budgets")
@pytest.mark.slow
def test_parts_are_divided_too() -> None:
    taken = choose(task("cam"), 0.5)
    assert taken.scene.tasks.get("cam") is not None
    assert taken.scene.tasks["cam"].divisions == 6


NOWHERE = """
[cam]
stroke = "25 deg"
rise = "70 deg"
upper_dwell = "10 deg"
fall = "70 deg"
law = "constant acceleration"
follower = "rocker"
lever = "130 mm"
centres = "160 mm"
pressure = "40 deg"
"""
"""A rocker's cam whose pivots stand so close that no region of centres keeps the angle of pressure."""


@pytest.mark.slow
def test_what_has_no_true_value_is_told_and_stands_in_the_way_of_nothing_else(
    tmp_path: Path,
) -> None:
    own = written(tmp_path, text_of("gear-pair") + NOWHERE)
    taken = choose(own, 10.0)
    assert set(taken.errors) == {"contact_ratio", "contact_arc"}
    weighed = answer(own)
    assert weighed.unjudged == ("r0_min",)
    assert weighed.halved is not None
    assert WORDS["ru"]["r0_min"] in next(sentences(weighed))
