"""Numbers as a sheet writes them: no zero bears a minus, no rounding makes one."""

from __future__ import annotations

import math

import pytest

from graphic_tmm.language.numbers import decimals_of, fixed, number


@pytest.mark.parametrize("language", ["en", "ru"])
@pytest.mark.parametrize("value", [0.0, -0.0])
def test_zero_bears_no_minus(value: float, language: str) -> None:
    assert number(value, language) == "0"
    assert fixed(value, 0, language) == "0"
    assert (
        fixed(value, 1, language)
        == fixed(-0.04, 1, language)
        == {"en": "0.0", "ru": "0,0"}[language]
    )


def test_what_is_not_zero_keeps_its_sign_and_size() -> None:
    assert fixed(-0.05001, 1, "en") == "−0.1"
    assert number(-0.0004, "en") == "−0.0004"
    assert number(-2.5e-7, "ru") == "−2,5·10⁻⁷"
    assert number(-123456.0, "en") == "−123456"
    assert (number(math.nan, "en"), fixed(None, 2, "en"), fixed(math.inf, 2, "en")) == ("—",) * 3


@pytest.mark.parametrize(
    ("value", "told"),
    [
        (1096.5, "1097"),
        (-9532.5, "−9533"),
        (12344.5, "12345"),
        (0.25625, "0.2563"),
        (245.25, "245.3"),
        (245.24999999999997, "245.3"),
        (245.2499, "245.2"),
        (1e300, "1·10³⁰⁰"),
        (5e-324, "4.941·10⁻³²⁴"),
        (1.7974999999999951e308, "1.797·10³⁰⁸"),
    ],
)
def test_halves_go_up_as_in_tables(value: float, told: str) -> None:
    assert number(value, "en") == told


@pytest.mark.parametrize(
    ("division", "places"),
    [
        (20.0, 0),
        (1.0, 0),
        (0.5, 1),
        (0.25, 1),
        (0.1, 1),
        (0.05, 2),
        (0.01, 2),
        (0.001, 3),
        (1e-4, 4),
    ],
)
def test_a_figure_has_the_decimal_of_its_division_and_none_behind(
    division: float, places: int
) -> None:
    assert decimals_of(division) == places
