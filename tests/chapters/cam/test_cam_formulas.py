"""Whole millimetres of cams."""

from __future__ import annotations

import numpy as np

from graphic_tmm.chapters.cam import formulas as f


def test_whole_millimetres_stay_what_they_are() -> None:
    for mm in range(1, 400):
        x = np.array([[mm / 1000.0]])
        assert f.whole_mm_above.run(x)[0, 0] == f.whole_mm_below.run(x)[0, 0] == mm / 1000.0
    assert f.whole_mm_above.run(np.array([[0.0490001]]))[0, 0] == 0.05
    assert f.whole_mm_below.run(np.array([[0.0499999]]))[0, 0] == 0.049
