"""Random slider-cranks at their dead centres and next to them: each figure is right, or is not there."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from chapters.klein.test_klein import drawn_of, due, sizes_at_random, values

from graphic_tmm.chapters.klein.task import KLEIN, VIEWS


@pytest.mark.parametrize("seed", range(100, 112))
@pytest.mark.parametrize("outer", [True, False])
def test_at_dead_centres_of_any_guide(tmp_path: Path, seed: int, outer: bool) -> None:
    """Offset, turned, in both senses; 0 and 1e-7° from the line. Klein's figures are there in all of them."""
    told = sizes_at_random(np.random.default_rng(seed))
    r, rod, e, tilt = (told[name] for name in ("r", "rod", "e", "tilt"))
    base = math.degrees(math.asin(e / (rod + r if outer else rod - r))) + tilt
    base += 0.0 if outer else 180.0
    at = sorted({base % 360.0, (base + 1e-7) % 360.0, (base + 70.0) % 360.0})
    drawn = drawn_of(tmp_path, **{**told, "at": at[:: told["sense"]]})
    for view in VIEWS:
        own = values(drawn, view)
        assert view != KLEIN or np.isfinite(own["a_B"]).all()
        for k, phi in enumerate(drawn.project.coordinates):
            assert phi is not None
            exact = due(math.radians(phi - tilt), told["omega"], r, rod, e, told["c"])
            for letter, value in exact.items():
                size = r * told["omega"] ** (1 if letter[0] == "v" else 2)
                figure = own[letter][k]
                assert np.isnan(figure) or figure == pytest.approx(value, abs=1e-6 * size)
