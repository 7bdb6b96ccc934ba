"""Formulas of planetary trains against fifty digits; what has no answer is NaN with its reason."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import mpmath as mp  # type: ignore[import-untyped]
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from graphic_tmm.board.grammar import OPERATIONS, Operation
from graphic_tmm.chapters.planetary import formulas as t

EPS = np.finfo(float).eps
REFERENCES: dict[str, Callable[..., Any]] = {
    "axes_outside": lambda m, a, b: m * (a + b) / 2,
    "axes_inside": lambda m, a, b: m * (a - b) / 2,
    "tip_diameter": lambda m, z, h: m * (z + 2 * h),
    "tooth_difference": lambda a, b: a - b,
    "neighbouring_axes": lambda a, k: 2 * a * mp.sin(mp.pi / k),
    "ratio_of_row": lambda a, c: 1 + c / a,
    "ratio_opposed": lambda a, b, c, d: 1 + b * d / (a * c),
    "ratio_alike": lambda a, b, c, d: 1 - b * d / (a * c),
    "inverse_ratio": lambda u: 1 / u,
    "overall_ratio": lambda u, b, a: u * b / a,
    "common_divisor": lambda a, b: math.gcd(int(a), int(b)),
    "assembly_of_row": lambda a, c, k: (a + c) / k,
    "assembly_opposed": lambda a, b, c, d, k, g: (a * c + b * d) / (k * g),
    "assembly_alike": lambda a, b, c, d, k, g: (a * c - b * d) / (k * g),
    "least_ring": lambda z, a, h: (
        (z**2 * mp.sin(mp.radians(a)) ** 2 - 4 * h**2)
        / (2 * z * mp.sin(mp.radians(a)) ** 2 - 4 * h)
    ),
    "ratio_of_segments": lambda a, b: a / b,
    "miss_of_ratio": lambda u, v: 100 * abs(u - v) / abs(v),
}
COUNTED = ("common_divisor", "ratio_alike", "assembly_alike", "least_ring")
"""Formulas whose arguments are tooth numbers, so that a difference of them is exact."""
MADE = [op for op in OPERATIONS.values() if op.run.__module__ == t.__name__ and not op.across]


def one(*values: float) -> list[np.ndarray]:
    return [np.array([[float(value)]]) for value in values]


def test_every_formula_has_a_reference() -> None:
    assert sorted(op.name for op in MADE) == sorted(REFERENCES)


@pytest.mark.parametrize("op", MADE, ids=repr)
@given(data=st.data())
def test_a_formula_is_exact_to_its_rounding(op: Operation, data: st.DataObject) -> None:
    numbers = st.integers(17, 300).map(float) if op.name in COUNTED else st.floats(0.01, 100.0)
    values = [data.draw(numbers) for _ in op.takes]
    if op.name == "least_ring":
        values = [data.draw(st.integers(20, 300)), data.draw(st.floats(20, 30)), 1.0]
    if op.name == "neighbouring_axes":
        values[1] = float(data.draw(st.integers(2, 12)))
    found = op.run(*one(*values))[0, 0]
    with mp.workdps(50):
        due = REFERENCES[op.name](*map(mp.mpf, values))
        size = (
            max(abs(due), *(abs(v) for v in values)) if op.name == "tooth_difference" else abs(due)
        )
        if op.name in ("axes_inside", "miss_of_ratio", "ratio_alike", "least_ring"):
            size = abs(due) + 100 * max(values) / min(values)  # differences of rounded members
        assert abs(found - due) <= 12 * EPS * size


@pytest.mark.parametrize(
    ("op", "values"),
    [
        (t.ratio_of_row, (0, 89)),
        (t.ratio_opposed, (0, 1, 1, 1)),
        (t.ratio_alike, (1, 1, 0, 1)),
        (t.inverse_ratio, (0,)),
        (t.overall_ratio, (4.56, 25, 0)),
        (t.assembly_of_row, (25, 89, 0)),
        (t.assembly_opposed, (1, 1, 1, 1, 0, 1)),
        (t.assembly_alike, (1, 1, 1, 1, 3, 0)),
        (t.neighbouring_axes, (1, 0)),
        (t.ratio_of_segments, (3, 0)),
        (t.miss_of_ratio, (3, 0)),
        (t.least_ring, (17, 20, 1)),
        (t.common_divisor, (math.nan, 3)),
    ],
)
def test_what_has_no_answer_is_not_a_number(op: Operation, values: tuple[float, ...]) -> None:
    with np.errstate(invalid="ignore"):  # as `execute` runs
        assert np.isnan(op.run(*one(*values))).all()
    assert op.fails


def test_the_figures_of_the_windrower() -> None:
    assert t.ratio_of_row.run(*one(25, 89))[0, 0] == pytest.approx(4.56, rel=1e-15)
    assert t.assembly_of_row.run(*one(25, 89, 3))[0, 0] == 38.0
    assert t.assembly_of_row.run(*one(25, 89, 4))[0, 0] == 28.5
    assert t.overall_ratio.run(*one(4.56, 25, 15))[0, 0] == pytest.approx(7.6, rel=1e-15)


def test_the_next_of_the_satellites() -> None:
    axes = np.exp(2j * np.pi * np.arange(3) / 3)[None, :]
    after = t.next_satellite.run(axes, row=3)
    np.testing.assert_array_equal(after, axes[:, [1, 2, 0]])
    longer = np.concatenate([axes, [[9j]]], axis=1)
    after = t.next_satellite.run(longer, row=3)
    np.testing.assert_array_equal(after[:, :3], axes[:, [1, 2, 0]])
    assert np.isnan(after[0, 3])
