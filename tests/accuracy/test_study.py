"""A whole study: what it makes plain, the same twice, told in both languages, drawn."""

from __future__ import annotations

import json
from dataclasses import replace
from io import StringIO
from string import Formatter

import pytest
from rich.console import Console
from support.gallery import SHEETS
from support.tasks import studied

from graphic_tmm.accuracy.answer_text import sentences
from graphic_tmm.accuracy.cost import MINUTES
from graphic_tmm.accuracy.cost_figure import figures
from graphic_tmm.accuracy.lessons import along, divisions
from graphic_tmm.accuracy.report_json import json_report
from graphic_tmm.accuracy.report_text import best_numbers, slopes, text_report
from graphic_tmm.accuracy.study import Study, study
from graphic_tmm.accuracy.words import WORDS, counted
from graphic_tmm.errors import SceneError
from graphic_tmm.fitting.choice import choices
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

NAME = "slider-diagrams"


def printed(found: Study) -> str:
    out = StringIO()
    console = Console(file=out, width=240)
    for part in text_report(found):
        console.print(part)
    return out.getvalue()


@pytest.mark.turns(2, "studies")
@pytest.mark.slow
def test_with_an_exact_hand_errors_of_chords_fall_as_the_square_and_work_grows_as_the_number() -> (
    None
):
    """Chords have an error of the second order; fixed work at the board lessens its power by a few percent."""
    (found,) = [one for one in studied(NAME).fitted if one.quantity == "a_diagram"]
    assert found.error.slope == pytest.approx(-2.0, abs=0.05)
    assert found.error.half_width() < 0.05
    assert 0.95 < found.minutes.slope <= 1.0


@pytest.mark.turns(2, "studies")
@pytest.mark.slow
@pytest.mark.parametrize("hand", ["student", "careful"])
def test_with_a_hand_that_slips_there_is_a_best_number_of_positions(hand: str) -> None:
    """Fewer positions err by the chords, more by the slips: both ends are worse by more than chance."""
    found = studied(NAME)
    (one,) = [o for o in found.optima if (o.quantity, o.hand) == ("a_diagram", hand)]
    row = along(found.runs, "a_diagram", hand)
    assert one.inside
    assert not one.flat
    for end in (row[0], row[-1]):
        assert end.error - 3 * end.errors.spread > one.best.error + 3 * one.best.errors.spread


@pytest.mark.slow
def test_a_better_hand_takes_more_positions() -> None:
    best = {o.hand: divisions(o.best) for o in studied(NAME).optima if o.quantity == "a_diagram"}
    assert best["student"] <= best["careful"] <= best["scene"]


@pytest.mark.slow
def test_what_plans_give_does_not_depend_on_the_number_of_positions() -> None:
    for one in studied(NAME).optima:
        if one.quantity in ("v", "a") and one.hand == "student":
            assert one.flat


@pytest.mark.turns(2, "studies")
@pytest.mark.slow
def test_the_same_scene_gives_the_same_bytes() -> None:
    again = study(read(SHEETS / NAME), trials=40, clock=False)
    assert json_report(again) == json_report(studied(NAME))
    one, two = figures(again.answer), figures(studied(NAME).answer)
    assert one == two
    assert b"<dc:date>" not in one["svg"]


def test_json_is_what_the_study_found() -> None:
    found = studied(NAME)
    told = json.loads(json_report(found))
    assert len(told["runs"]) == len(found.runs)
    keys = {"quantity", "positions", "hand", "error_percent", "simplicity", "exactitude", "minutes"}
    assert all(keys <= set(run) for run in told["runs"])
    assert keys & set(told["choice"]) == {"simplicity", "exactitude", "minutes"}
    assert not any("seconds" in run for run in told["runs"])
    assert told["answer"]["sentences"] == [*sentences(found.answer)]
    (student,) = [one for one in told["answer"]["sources"] if one["hand"] == "student"]
    steps = student["of"]["a_diagram"]["steps"]
    assert 0.0 < steps[-1]["share"] <= steps[0]["share"] < 1.0


@pytest.mark.parametrize("language", ["ru", "en"])
def test_sentences_are_told_in_both_languages(language: str) -> None:
    found = studied(NAME)
    scene = replace(found.scene, language=language)
    found = replace(found, answer=replace(found.answer, scene=scene))
    lines = [*slopes(found), *best_numbers(found), *sentences(found.answer)]
    a = WORDS[language]["a_diagram"]
    optimum = next(o for o in found.optima if (o.quantity, o.hand) == ("a_diagram", "student"))
    assert any(
        a in x and counted(divisions(optimum.best), "positions", language) in x for x in lines
    )
    assert not any("{" in line or "nan" in line for line in lines)
    text = " ".join(printed(found).split())
    assert all(line in text for line in lines)
    assert WORDS[language]["tangents"] in text


def test_words_of_both_languages_take_the_same_letters() -> None:
    def taken(text: str) -> set[str]:
        return {name for _, name, _, _ in Formatter().parse(text) if name}

    assert WORDS["ru"].keys() == WORDS["en"].keys()
    for key, text in WORDS["en"].items():
        assert taken(text) == taken(WORDS["ru"][key]), key


def test_positions_are_counted_as_russian_counts() -> None:
    found = [counted(n, "positions", "ru") for n in (1, 3, 5, 11, 12, 21, 24)]
    assert " ".join(found) == (
        "1 положение 3 положения 5 положений 11 положений 12 положений 21 положение 24 положения"
    )


def test_a_scene_without_quantities_is_refused() -> None:
    with pytest.raises(SceneError, match="nothing whose error can be told"):
        study(read(SHEETS / "lettering"), clock=False)


def test_the_choice_of_scale_factors_is_counted_and_told() -> None:
    """Each step of it is a calculation or a figure taken: N1 a step, done once for all boards."""
    found, scene = studied(NAME), read(SHEETS / NAME)
    logs = [choices(drawn).construction for drawn in make(scene, exact=True).boards]
    steps = sum(len(log.steps) for log in logs)
    assert sum(found.choice.elements.values()) >= steps // 2 > 3
    assert found.choice.minutes == sum(MINUTES[k] * n for k, n in found.choice.elements.items())
    line = WORDS["ru"]["choice"].split("{")[0]
    told = printed(found)
    assert line in told
    assert found.choice.symbol in told
