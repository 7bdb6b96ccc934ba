"""What is said of scale factors: one question for all plans, its remedy once, in numbers that are so."""

from __future__ import annotations

import pytest
from support.reports import LANGUAGES

from graphic_tmm.checking.congruence.words import head
from graphic_tmm.checking.records import OwnScale

PLANS = (
    OwnScale("velocities", "velocities", "μ_v", 0.04, 0.025, "(m/s)/mm", "round", first="pa"),
    OwnScale("accelerations", "accelerations", "μ_a", 0.4, 0.5, "(m/s²)/mm", "lengths", first="πa"),
    OwnScale("forces", "forces", "μ_F", 2.5, 4.0, "N/mm", "round"),
    OwnScale("forces", "forces_1", "μ_F", 2.5, 4.0, "N/mm", "round"),
)


@pytest.mark.parametrize("language", LANGUAGES)
def test_scale_factors_that_only_lengths_say_are_one_question(language: str) -> None:
    (says,) = head(PLANS, {}, {}, language)
    said = says.replace(",", ".")
    assert says.count("?") == 1
    assert "(pa, πa)" in says
    for figure in ("0.04", "0.025", "0.625", "0.4", "1.25", "2.5", "1.6"):
        assert said.count(f" {figure} ") == 1
    for once in ("Write your μ", "Запишите свои μ"):
        assert says.count(once) == (once.startswith("W") is (language == "en"))
    assert "раза" not in says


@pytest.mark.parametrize("language", LANGUAGES)
def test_without_a_first_length_nothing_is_named(language: str) -> None:
    (says,) = head(PLANS[2:3], {}, {}, language)
    assert "()" not in says
    assert "  " not in says
