from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from graphic_tmm.errors import SheetError
from graphic_tmm.paper.pens import CENTRE, DASHED, PHANTOM, pens, stretched


@pytest.mark.parametrize("format", ["A1", "A4"])
def test_widths_keep_to_the_standard(format: str) -> None:
    box = pens(format)
    s = box["main"].width
    assert 0.5 <= s <= 1.4
    for name in ("thin", "dashed", "centre", "phantom", "medium"):
        assert s / 3 - 0.005 <= box[name].width <= s / 2 + 0.005
        assert box[name].width >= 0.2
    assert s <= box["thick"].width <= 1.5 * s + 0.005
    assert box["joint"].width == s
    assert box["joint"].fill == "white"


def test_dashes_keep_to_the_standard() -> None:
    assert 2 <= DASHED[0] <= 8
    assert 5 <= CENTRE[0] <= 30
    assert 3 <= sum(CENTRE[1:]) <= 5


def test_pins_lie_above_all_lines() -> None:
    order = list(pens("A1"))
    assert order[-1] == "joint"
    places = [order.index(name) for name in ("thin", "main", "body", "rod", "joint")]
    assert places == sorted(places)


def test_unknown_format_is_refused() -> None:
    with pytest.raises(SheetError, match="A7"):
        pens("A7")


@given(st.floats(0.1, 2000), st.sampled_from([DASHED, CENTRE]))
def test_a_dashed_line_begins_and_ends_with_a_whole_stroke(
    length: float, dashes: tuple[float, ...]
) -> None:
    pattern = stretched(dashes, length)
    if not pattern:
        assert length < 2.5 * sum(dashes)
        return
    periods = (length - pattern[0]) / sum(pattern)
    assert periods == pytest.approx(round(periods), abs=1e-6)
    assert 0.4 < pattern[0] / dashes[0] < 1.5


@given(st.floats(20.1, 2000), st.sampled_from([CENTRE, PHANTOM]))
def test_a_dash_dot_line_has_a_stroke_in_its_middle(
    length: float, dashes: tuple[float, ...]
) -> None:
    pattern = stretched(dashes, length)
    if not pattern:
        assert length < 5.0 * (2 * sum(dashes) + dashes[0]) / dashes[0]
        return
    period = sum(pattern)
    into = (length / 2) % period
    assert into < pattern[0] or into == pytest.approx(period)
    assert into == pytest.approx(pattern[0] / 2, abs=1e-6)


def test_a_closed_line_takes_whole_periods() -> None:
    pattern = stretched(CENTRE, 100.0, closed=True)
    assert 100.0 / sum(pattern) == pytest.approx(6.0)


def test_a_short_centre_line_and_a_solid_one_have_no_dashes() -> None:
    assert stretched(CENTRE, 12.0) == ()
    assert stretched((), 100.0) == ()
