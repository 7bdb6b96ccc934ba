"""Markup of lettering: indices, bars, lines, and what is refused."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.alphabet import ALL, upright
from support.each import each

from graphic_tmm.errors import SheetError
from graphic_tmm.paper.lettering.glyphs import glyph
from graphic_tmm.paper.lettering.letters import (
    Lettering,
    compose,
    escape,
    letter,
    plain,
    width,
)


def parts_of_size(written: Lettering, pen: float) -> list[tuple[float, float]]:
    return [(x, y) for x, y, form in written.parts if form.pen == pytest.approx(pen)]


@pytest.mark.parametrize(("size", "index"), [(14, 10), (10, 7), (7, 5), (5, 3.5), (3.5, 2.5)])
def test_indices_are_one_step_down(size: float, index: float) -> None:
    lower, upper = upright("А_Н", size), upright("А^Н", size)
    assert [y for _, y in parts_of_size(lower, index / 10)] == pytest.approx([-0.3 * size])
    assert [y for _, y in parts_of_size(upper, index / 10)] == pytest.approx([0.6 * size])
    assert upper.ascent == pytest.approx(0.6 * size + index)
    assert lower.descent == pytest.approx(0.3 * size)
    assert lower.pens == pytest.approx((size / 10, index / 10))
    assert lower.width > width("А", size=size) + 0.6 * index


def test_the_smallest_index_and_free_sizes() -> None:
    assert upright("A_A", 2.5).pens == pytest.approx((0.25, 0.18))
    assert upright("A_{A_A}", 2.5).pens == pytest.approx((0.25, 0.18))
    assert upright("A_{A_A}", 6.0).pens == pytest.approx((0.6, 0.42, 0.294))


def test_both_indices_stand_one_above_the_other() -> None:
    one, other = upright("n_{BA}^{t}"), upright("n^{t}_{BA}")
    assert set(one.strokes) == set(other.strokes)
    assert one.width == upright("n_{BA}").width
    lower, upper = parts_of_size(one, 0.7)[:2], parts_of_size(one, 0.7)[2:]
    assert upper[0][0] == lower[0][0]


def test_characters_for_indices_are_indices() -> None:
    assert upright("ω₁").strokes == upright("ω_1").strokes
    assert upright("10⁻³").strokes == upright("10^{−3}").strokes
    assert upright("ω₁²").strokes == upright("ω_1^2").strokes


def test_bars_and_underlines() -> None:
    letters = upright("v")
    barred = upright(r"\bar{v}")
    (line,) = set(barred.strokes) - set(letters.strokes)
    assert line[0][1] == line[1][1] > 7.0
    assert barred.width == letters.width
    assert (line[0][0] - 0.5, line[1][0] + 0.5) == pytest.approx((0.4, letters.width - 0.4))
    rows = [
        sorted({s[0][1] for s in set(upright(text).strokes) - set(upright("v_p").strokes)})
        for text in (r"\u{v_p}", r"\uu{v_p}")
    ]
    assert [len(row) for row in rows] == [1, 2]
    assert rows[0][0] == rows[1][1] < -upright("v_p").descent - 0.5
    assert len(upright(r"\bar{}").strokes) == 0


@each(
    "markup",
    ["v_", "v^", "v__A", "a_b_c", "a^b^c", "{A", "A}", "v_{A", r"\vec{v}", "\\", r"\bar", "_}"],
)
def test_faulty_markup_is_refused(markup: str) -> None:
    with pytest.raises(SheetError, match="character"):
        letter(markup)
    with pytest.raises(SheetError, match="character"):
        plain(markup)


def test_deep_nesting_and_sizes_that_are_none_are_refused() -> None:
    with pytest.raises(SheetError, match="deep"):
        letter("{" * 5000 + "}" * 5000)
    for size in (0.0, -5.0, math.nan, math.inf):
        with pytest.raises(SheetError, match="size"):
            letter("A", size=size)


@given(st.text(alphabet=ALL, max_size=20))
def test_escape_makes_any_text_literal(text: str) -> None:
    assert plain(escape(text)) == text


@given(st.text(alphabet="".join(set(ALL) - set("²³⁻¹₀₁₂₃₄₅₆₇₈₉")), max_size=12))
def test_an_escaped_text_is_drawn_letter_by_letter(text: str) -> None:
    drawn = sum(len(glyph(c).strokes) for c in text)
    assert len(letter(escape(text)).strokes) == drawn


@given(st.text(alphabet=r"_^{}\baruv1A ", max_size=16))
def test_any_markup_is_drawn_or_refused(markup: str) -> None:
    try:
        words = plain(markup)
    except SheetError:
        with pytest.raises(SheetError):
            compose(markup)
        return
    assert compose(markup).width >= 0.0
    assert plain(escape(words)) == words


def test_plain_text_is_readable() -> None:
    assert plain(r"\bar{v}_{BA} ⊥ AB") == "v_BA ⊥ AB"
    assert plain("ω_1, мм^2, c^{-2}") == "ω₁, мм², c⁻²"
    assert plain("n_{BA}^{t}") == "n_BA^t"
    assert plain(r"\uu{a_{A, B}}") == "a_(A, B)"
    assert plain(r"x\_\^\{\}\\") == "x_^{}\\"
