"""Planetary trains by published figures; the row of satellites."""

from __future__ import annotations

import numpy as np
import pytest

from graphic_tmm.chapters.trains import formulas as t


def one(*values: float) -> list[np.ndarray]:
    return [np.array([[float(value)]]) for value in values]


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
