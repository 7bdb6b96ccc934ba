"""One quantity has one letter and one number of digits, in figures, formulas and tables of a note."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest
from support.laid_out import drawn_case, note_of_case
from support.notes import noted
from support.tex_sums import Unread, worked_out

from graphic_tmm.board import roles
from graphic_tmm.note.document import (
    Document,
    Formula,
    Number,
    Symbol,
    Text,
    Tree,
    leaves,
    runs_of,
    walk,
)
from graphic_tmm.note.tex import spelt, tex
from graphic_tmm.paper.views import pole_figures


def test_pole_distances_on_figures_are_as_a_ruler_lays_them_off() -> None:
    """H = 60,2 mm in a formula is H = 60,2 on the figure."""
    drawn = drawn_case("slotting").boards[0]
    log, reading = drawn.construction, drawn.reading
    views = {step.it.view for step in log.steps if log.roles(step.it.view, roles.POLE)}
    told = [text for view in views for text in pole_figures(log, reading, view, "ru").values()]
    exact = [
        float(reading[log.step(pole).uses[1]][0, 0])  # type: ignore[union-attr]
        for view in views
        for pole in log.roles(view, roles.POLE)
    ]
    assert any(abs(value - round(value, 1)) > 1e-3 for value in exact)
    assert all(re.fullmatch(r"H\S* = \d+(,\d)?", text) for text in told), told


def test_the_mean_moment_has_no_second_letter() -> None:
    """The power is calculated with the letter of the results, M_ср."""
    (power,) = (
        run
        for block in walk(note_of_case("slotting").blocks)
        for run in runs_of(block)
        if isinstance(run, Formula)
        and run.sides[0] == Symbol("N")
        and isinstance(run.sides[1], Tree)
    )
    letters = {leaf.markup for leaf in leaves(power.sides[1]) if isinstance(leaf, Symbol)}
    assert "M_{ср}" in letters


def _results(document: Document) -> Iterator[tuple[str, float, float, float]]:
    """The results of formulas but lengths: how they are printed, what figures give, their last digit."""
    for block in walk(document.blocks):
        for run in runs_of(block):
            if not isinstance(run, Formula) or not isinstance(run.sides[-1], Number):
                continue
            told, result = tex(run, "ru", spelt), run.sides[-1]
            trees = [side for side in run.sides if isinstance(side, Tree)]
            if not trees or not all(isinstance(one, Number) for one in trees[-1].put.values()):
                continue
            found = re.fullmatch(r"(−?)(\d{1,4}(?:,(\d+))?)", result.text)
            if found is None or result.unit == "mm":
                continue
            try:
                due = worked_out(tex(Formula((trees[-1],), flat=True), "ru", spelt)).value
            except (Unread, ZeroDivisionError, ValueError):
                continue
            printed = float(found[2].replace(",", ".")) * (-1.0 if found[1] else 1.0)
            yield told, due, printed, 10.0 ** -len(found[3] or "")


@pytest.mark.parametrize("name", ["slotting", "project", "cam", "gear-pair"])
@pytest.mark.slow
def test_results_agree_with_the_figures_printed_before_them(name: str) -> None:
    """Within their last digit: what comes of lengths read to 0.1 mm has no more digits than these give."""
    document = note_of_case(name) if name == "slotting" else noted(name)
    found = list(_results(document))
    assert len(found) > 10
    assert not [one for one in found if abs(one[1] - one[2]) > 1.0001 * one[3]]


def test_what_is_a_small_difference_is_of_figures_that_give_it() -> None:
    """y = (a_w − a)/m of a gear pair: a_w has six digits there, so that y keeps its own."""
    told = {
        run.sides[0].markup: run.sides[-1].text
        for block in walk(noted("gear-pair").blocks)
        for run in runs_of(block)
        if isinstance(run, Formula)
        and isinstance(run.sides[0], Symbol)
        and isinstance(run.sides[-1], Number)
    }
    assert len(told["y"].replace("0,", "").replace(",", "")) >= 3
    assert len(told["a_{w}"].replace("0,", "")) > 4


def test_a_difference_says_what_it_is_a_share_of() -> None:
    """0.682 for 0.714 m/s are 3.6 % of the largest, 0.886 m/s, not 4.5 %."""
    words = "".join(
        run.text
        for block in walk(note_of_case("slotting").blocks)
        for run in runs_of(block)
        if isinstance(run, Text)
    )
    assert "в процентах наибольшего из них" in words
