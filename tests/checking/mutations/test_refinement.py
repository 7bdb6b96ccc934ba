"""Steps whose results are so many times as large as due, by a number that the readings tell."""

from __future__ import annotations

import pytest
from support.own_told import kind_of, report_of, told, with_mistake


def test_a_number_that_no_list_has_is_told() -> None:
    """pa is laid off 1.25 times as long, the angular velocities follow from it."""
    drawing = with_mistake(kind_of("pa laid off 1.25 times"), 0, 61000)
    report = report_of(drawing)
    assert not isinstance(report, str)
    one = told(report, drawing)
    assert one.name
    assert one.sure
    assert "1.2" in report.mistakes[0].says


@pytest.mark.parametrize("name", ["c not found by BC", "n doubled"])
@pytest.mark.slow
def test_usual_numbers_are_told_once(name: str) -> None:
    drawing = with_mistake(kind_of(name), 0, 61000)
    report = report_of(drawing)
    assert not isinstance(report, str)
    assert told(report, drawing).name
    assert not any("1.9" in one or "0.49" in one for one in report.mistakes[0].like)


@pytest.mark.parametrize(
    "name", ["arc of AB with a wrong opening", "arc of BC with a wrong opening"]
)
@pytest.mark.slow
def test_an_arc_struck_with_another_opening_is_no_given_misread(name: str) -> None:
    """The link is drawn with that opening, and angular velocities are calculated with its own length."""
    drawing = with_mistake(kind_of(name), 1, 83000)
    report = report_of(drawing)
    assert not isinstance(report, str)
    assert told(report, drawing).name
    assert "opening" in report.mistakes[0].says


def test_a_slip_is_not_sure_where_mistakes_explain_the_reading_too() -> None:
    drawing = with_mistake(kind_of("digits exchanged"), 0, 61000)
    report = report_of(drawing)
    assert not isinstance(report, str)
    one = told(report, drawing)
    assert (report.mistakes[0].kind, one.name, one.sure) == ("slip", True, False)
