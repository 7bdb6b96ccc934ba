"""The rule for marks: what is lost, which mark that makes, exactly; its file and its words."""

from __future__ import annotations

import random
from decimal import ROUND_HALF_UP, Decimal
from fractions import Fraction
from pathlib import Path

import pytest
from support.each import each

from graphic_tmm.classroom.marks.rule import (
    FIVE,
    Faults,
    Rule,
    decimal,
    losses,
    mark_of,
    marked,
    rule_sentences,
)
from graphic_tmm.classroom.marks.rule_file import read_rule
from graphic_tmm.errors import SceneError
from graphic_tmm.language.catalogue import languages

AB, PB = ("velocities", "ab"), ("velocities", "pb")


def test_a_mistake_that_is_named_is_punished_once() -> None:
    twelve = Faults(wrong=tuple((("velocities", f"s{k}"), 0) for k in range(12)))
    assert losses(FIVE, twelve)["mistake"] == FIVE.mistake
    assert marked(FIVE, twelve).points == 100 - FIVE.mistake


def test_a_mistake_costs_no_more_than_its_readings() -> None:
    assert marked(FIVE, Faults(wrong=((AB, 0),))).points == 100 - FIVE.wrong


def test_one_segment_costs_no_more_than_its_cap() -> None:
    many = Faults(wrong=((AB, -1),) * 20 + ((PB, -1),))
    assert losses(FIVE, many)["wrong"] == FIVE.segment + FIVE.wrong


def test_doubtful_readings_have_a_cap() -> None:
    assert losses(FIVE, Faults(doubtful=Fraction(3, 2)))["doubtful"] == 6
    assert losses(FIVE, Faults(doubtful=Fraction(50)))["doubtful"] == FIVE.doubtful_most


def test_what_is_as_good_as_wrong_costs_what_is_wrong() -> None:
    doubtful = losses(FIVE, Faults(doubtful=Fraction(1)))["doubtful"]
    assert doubtful == losses(FIVE, Faults(wrong=((AB, -1),)))["wrong"]


def test_a_drawing_that_is_off_as_a_whole_costs_as_a_mistake() -> None:
    assert marked(FIVE, Faults(whole=True)).points == 84


def test_another_variant_costs_what_the_rule_says() -> None:
    other = Faults(other=True)
    assert marked(FIVE, other) == ("2", 49)
    assert marked(FIVE._replace(variant=Fraction(0)), other).points == 100


def test_no_mark_is_below_the_lowest() -> None:
    nothing = Faults(missing=("a", "b", "c", "d", "e"), unread=50)
    assert marked(FIVE, nothing) == ("2", 0)
    assert marked(Rule(lowest=Fraction(1)), nothing).text == "1"


def test_points_are_summed_exactly() -> None:
    """With floats ten times 0.1 is less than 1, and a mark on the step would flicker."""
    rule = FIVE._replace(doubtful=Fraction("0.1"), doubtful_most=Fraction(100))
    assert marked(rule, Faults(doubtful=Fraction(150))) == ("5", 85)


def test_proportional_marks_are_rounded_as_people_round() -> None:
    """Held against the decimals of Python."""
    rng = random.Random(1)
    for _ in range(300):
        points = Decimal(rng.randrange(0, 100_001)) / 1000
        unit = rng.choice([Decimal("0.1"), Decimal("0.5"), Decimal(1), Decimal(2)])
        rule = Rule(scale=Fraction(10), lowest=Fraction(1), round=Fraction(unit))
        exact = 1 + 9 * points / 100
        due = (exact / unit).quantize(Decimal(1), ROUND_HALF_UP) * unit
        assert Decimal(mark_of(rule, Fraction(points))) == due


def test_a_scale_may_go_downward() -> None:
    german = Rule(scale=Fraction(1), lowest=Fraction(6), round=Fraction("0.1"))
    assert mark_of(german, Fraction(100)) == "1"
    assert mark_of(german, Fraction(0)) == "6"


@each("text", ["0.30", "12", "7.125"])
def test_numbers_are_written_as_they_are(text: str) -> None:
    assert Decimal(decimal(Fraction(text))) == Decimal(text)


def written(tmp_path: Path, text: str) -> Rule:
    file = tmp_path / "marks.toml"
    file.write_text(text, "utf-8")
    return read_rule(file)


def test_a_file_says_the_rule(tmp_path: Path) -> None:
    rule = written(
        tmp_path,
        '[mark]\nsteps = { A = 90, B = 80.5 }\nbelow = "F"\n[points]\nwrong = 0.1\n'
        '[asked]\nplans = ["velocities"]\n',
    )
    assert rule.steps == (("A", 90), ("B", Fraction(161, 2)))
    assert (rule.below, rule.wrong, rule.plans) == ("F", Fraction(1, 10), ("velocities",))
    assert rule.mistake == FIVE.mistake


def test_a_scale_takes_the_place_of_the_steps(tmp_path: Path) -> None:
    rule = written(tmp_path, "[mark]\nscale = 100\n")
    assert mark_of(rule, Fraction("71.5")) == "72"
    assert mark_of(rule, Fraction(0)) == "0"


def test_an_empty_file_is_the_usual_rule(tmp_path: Path) -> None:
    assert written(tmp_path, "") == FIVE


BAD = """\
[mark]
steps = { "5" = 85, "4" = 70, "3" = 70, "2" = 101 }
scale = 5
[points]
wrong = -1
mistake = "much"
doubtfull = 3
[asked]
plans = []
[marks]
"""


def test_all_faults_are_told_at_once_with_key_and_line(tmp_path: Path) -> None:
    with pytest.raises(SceneError) as caught:
        written(tmp_path, BAD)
    assert {(one.key, one.line) for one in caught.value.faults} == {
        ("mark.below", 1), ("mark.scale", 3), ("mark.steps.4", 2), ("mark.steps.2", 2), ("points.wrong", 5),
        ("points.mistake", 6), ("points.doubtfull", 7), ("asked.plans", 9), ("marks", 10),
    }  # fmt: skip


NONSENSE = (
    "[mark]\nscale = nan\n",
    "[mark]\nscale = 1e999\n",
    "[mark]\nscale = true\n",
    "[mark]\nround = 0\nscale = 5\n",
    "mark = 3\n",
    "[mark]\nlowest = 2\n",
    "[mark]\nscale = 2\nlowest = 2\n",
    "[mark]\nsteps = {}\nbelow = 2\n",
    '[mark]\nsteps = { "\\u0007" = 3 }\nbelow = 2\n',
    "[mark]\nsteps = 3\nbelow = 2\n",
    "[points]\nplan = 1001\n",
    f"[points]\nplan = {'9' * 400}\n",
)


@each("text", NONSENSE)
def test_nonsense_is_refused(tmp_path: Path, text: str) -> None:
    with pytest.raises(SceneError):
        written(tmp_path, text)


@each("language", languages())
def test_the_rule_is_told_with_all_its_numbers(language: str) -> None:
    says = " ".join(rule_sentences(FIVE, language, ("velocities",)))
    assert all(number in says for number in ("100", "85", "70", "50", "25", "16", "10", "8", "4"))
    proportional = " ".join(rule_sentences(Rule(scale=Fraction(77)), language))
    assert "77" in proportional
