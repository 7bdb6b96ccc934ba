"""The synthetic photographs tell the truth: pencil is seen where they say that points and corners stand."""

from __future__ import annotations

import io

import numpy as np
import pytest
from support.photographed.taking import Conditions, Taken, conditions, taken

image = pytest.importorskip("PIL.Image")

SMALL = Conditions(wide=1600)


def grey(shown: Taken) -> np.ndarray:
    return np.asarray(image.open(io.BytesIO(shown.jpeg)).convert("L")).astype(float)


def darkest(seen: np.ndarray, at: complex, near: int) -> float:
    """How dark the darkest dot near a place is, of the paper about it."""
    x, y = round(at.real), round(at.imag)
    rows, columns = slice(max(y - near, 0), y + near + 1), slice(max(x - near, 0), x + near + 1)
    wide = seen[max(y - 25, 0) : y + 26, max(x - 25, 0) : x + 26]
    return 1 - seen[rows, columns].min() / np.quantile(wide, 0.9)


@pytest.mark.slow
def test_pencil_is_seen_where_points_are_said_to_stand() -> None:
    shown = taken(4, SMALL._replace(quarters=1, tilt=(25.0, 40.0), lens=0.015, sag=1.5))
    seen = grey(shown)
    drawn = [one.seen for one in shown.points.values() if one.drawn]
    assert len(drawn) > 30
    found = [darkest(seen, z, 2) > 0.15 for z in [*drawn, *shown.corners]]
    assert np.mean(found) > 0.95
    aside = [darkest(seen, z + 15 + 15j, 2) > 0.15 for z in drawn]
    assert np.mean(aside) < 0.7  # the test can fail: elsewhere there is mostly paper


@pytest.mark.slow
def test_what_is_left_out_is_told() -> None:
    whole = taken(4, SMALL)
    left = taken(4, SMALL._replace(left=whole.conditions.left._replace(plans=1.0)))
    assert any(one.drawn for one in whole.points.values())
    assert not any(one.drawn for one in left.points.values())


def test_photographs_go_to_the_limits_that_are_promised() -> None:
    several = [conditions(number) for number in range(60)]
    assert max(one.tilt[0] for one in several) > 30
    assert max(one.lens for one in several) > 0.018
    assert max(one.sag for one in several) > 1.8
    assert {one.quarters for one in several} == {0, 1, 2, 3}
    assert sum(one.marks.squares > 0 for one in several) == 18
    assert min(one.light.quality for one in several) < 65
    assert all(one.wide == 4000 for one in several)


@pytest.mark.slow
def test_points_that_pencil_shows_by_themselves_are_some_of_those_drawn() -> None:
    points = taken(4, SMALL).points
    apart = {key for key, one in points.items() if one.apart}
    drawn = {key for key, one in points.items() if one.drawn}
    assert len(apart & drawn) > 0.8 * len(drawn)
    assert any(
        key[0] == "velocities" for key in drawn - apart
    )  # vectors of no length at a dead centre
    assert not any(key[0] == "positions" for key in drawn - apart)
