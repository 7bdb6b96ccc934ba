"""What figures are called: as sheets have them, not as code does."""

from __future__ import annotations

import pytest

from graphic_tmm.checking.cells import segment_text


@pytest.mark.parametrize(
    ("name", "language", "called"),
    [
        ("P_bal_forces", "ru", "P_ур"),
        ("P_bal_forces", "en", "P_b"),
        ("omega2", "ru", "ω_2"),
        ("epsilon3", "en", "ε_3"),
        ("omega", "en", "omega"),
        ("pb", "ru", "pb"),
        ("results", "ru", "results"),
        ("", "ru", ""),
    ],
)
def test_a_quantity_is_called_by_its_letter(name: str, language: str, called: str) -> None:
    assert segment_text(name, language) == called
