"""Functions met by a four-bar by Chebyshev's cosines, what no angles stand for; places in a line or in one."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from support.examples import most

from graphic_tmm.errors import StructureError
from graphic_tmm.mechanism.synthesis import lengths_found
from graphic_tmm.mechanism.synthesis_functions import pairs_of_function


def test_a_function_is_met_at_the_places_of_chebyshev() -> None:
    given = {"x": [1.0, 2.0], "power": 1.5, "crank": [30.0, 120.0], "rocker": [60.0, 120.0]}
    crank, rocker = pairs_of_function(given)
    x = [1.0 + (phi - 30.0) / 90.0 for phi in crank]
    assert x == pytest.approx([1.5 - 0.5 * math.cos(math.pi * (2 * k + 1) / 6) for k in range(3)])
    y = [1.0 + (psi - 60.0) / 60.0 * (2**1.5 - 1.0) for psi in rocker]
    assert y == pytest.approx([one**1.5 for one in x])


@pytest.mark.parametrize(
    ("name", "of", "ends"),
    [("ln x", math.log, (1.0, 3.0)), ("sin x", lambda x: math.sin(x * math.pi / 180), (0.0, 90.0))],
)
def test_other_functions_are_met_at_the_places_of_chebyshev(
    name: str, of: Callable[[float], float], ends: tuple[float, float]
) -> None:
    given = {
        "x": [*ends],
        "y": name,
        "crank": [20.0, 110.0],
        "rocker": [50.0, 120.0],
        "OA": 0.05,
        "OC": 0.1,
    }
    lengths = lengths_found("function", given)
    row = [math.cos(math.pi * (2 * k + 1) / 6) for k in (2, 1, 0)]
    x = [(ends[0] + ends[1]) / 2 + one * (ends[1] - ends[0]) / 2 for one in row]
    crank = [20.0 + 90.0 * (one - ends[0]) / (ends[1] - ends[0]) for one in x]
    rocker = [50.0 + 70.0 * (of(one) - of(ends[0])) / (of(ends[1]) - of(ends[0])) for one in x]
    assert pairs_of_function(given) == (pytest.approx(crank), pytest.approx(rocker))
    assert lengths == pytest.approx(
        lengths_found("angles", {"crank": crank, "rocker": rocker, "OA": 0.05, "OC": 0.1})
    )


@pytest.mark.parametrize(
    ("low", "high", "power"),
    [(0.0, 1.0, 2.0), (-1.0, 2.0, 2.0), (-2.0, -1.0, -1.0), (0.0, 1.0, 0.5), (-1.0, 1.0, 3.0)],
)
def test_a_power_is_met_wherever_there_is_one(low: float, high: float, power: float) -> None:
    task = {"x": [low, high], "power": power, "crank": [30.0, 120.0], "rocker": [60.0, 140.0]}
    lengths = lengths_found("function", {**task, "OA": 0.04, "OC": 0.1})
    x = [
        (low + high) / 2 - (high - low) / 2 * math.cos(math.pi * (2 * k + 1) / 6) for k in range(3)
    ]
    crank = [30.0 + 90.0 * (one - low) / (high - low) for one in x]
    rocker = [60.0 + 80.0 * (one**power - low**power) / (high**power - low**power) for one in x]
    due = lengths_found("angles", {"crank": crank, "rocker": rocker, "OA": 0.04, "OC": 0.1})
    assert lengths == pytest.approx(due)


def test_a_table_of_three_points_is_met() -> None:
    given = {"x": [1.0, 2.0, 4.0], "values": [3.0, 1.0, 0.5], "crank": [30.0, 120.0]}
    given |= {"rocker": [60.0, 110.0], "OA": 0.05, "OC": 0.1}
    lengths = lengths_found("function", given)
    pairs = {"crank": [30.0, 60.0, 120.0], "rocker": [60.0, 100.0, 110.0]}
    assert lengths == pytest.approx(lengths_found("angles", {**pairs, "OA": 0.05, "OC": 0.1}))


@pytest.mark.parametrize(
    ("task", "key", "words"),
    [
        ({"x": [0.0, 2.0], "y": "ln x"}, "x", "above 0"),
        ({"x": [2.0, 2.0], "y": "sin x"}, "x", "have to differ"),
        ({"x": [0.0, 180.0], "y": "sin x"}, "x", "same value at both ends"),
        ({"x": [1.0, 2.0], "values": [1.0, 2.0, 3.0]}, "x", "3 values are wanted here, not 2"),
        ({"x": [1.0, 2.0, 3.0], "values": [1.0, 2.0, 1.0]}, "values", "same value at both ends"),
        ({"x": [1.0, 2.0, 1.0], "values": [1.0, 2.0, 3.0]}, "x", "have to differ"),
        ({"x": [0.0, 1.0], "power": -1.0}, "x", "0 has no power below 0"),
        ({"x": [-1.0, 1.0], "power": -2.0}, "x", "0 has no power below 0"),
        ({"x": [-1.0, 1.0], "power": 0.5}, "x", "below 0 has no such power"),
        ({"x": [1.0, 2.0, 3.0], "power": 2.0}, "x", "2 values are wanted here, not 3"),
    ],
)
def test_a_function_that_no_angles_stand_for_is_refused(
    task: dict[str, Any], key: str, words: str
) -> None:
    rest = {"crank": [20.0, 110.0], "rocker": [50.0, 120.0], "OA": 0.05, "OC": 0.1}
    with pytest.raises(StructureError, match=words) as error:
        lengths_found("function", {**task, **rest})
    assert error.value.keys == (f"task.{key}",)


def test_equal_places_and_a_turn_about_one_point_are_named() -> None:
    row = {"A": [0j, 0.03 + 0.02j, 0j], "angles": [60.0, 20.0, -30.0], "AB": 0.08}
    with pytest.raises(StructureError, match="places 1 and 3 of A are one") as error:
        lengths_found("coupler", row)
    assert error.value.keys == ("task.A",)
    pairs = {"crank": [40.0, 40.0, 90.0], "rocker": [70.0, 70.0, 90.0], "OA": 0.04, "OC": 0.1}
    with pytest.raises(StructureError, match="places 1 and 2 of A are one"):
        lengths_found("angles", pairs)
    rng = np.random.default_rng(16)
    for _ in range(most(40)):
        about, arm = complex(*rng.uniform(-0.1, 0.1, 2)), complex(*rng.uniform(0.02, 0.1, 2))
        turns = rng.uniform(-170, 170, 3)
        A = [about + arm * cmath.rect(1.0, math.radians(turn)) for turn in turns]
        row = {"A": A, "angles": (turns + 25.0).tolist(), "AB": 0.08}
        with pytest.raises(StructureError, match="turns about one point") as error:
            lengths_found("coupler", row)
        assert error.value.keys == ("task.angles",)
        said = str(error.value).replace(" mm", "").split("= ")
        x, y = (float(part.split(",")[0]) / 1000.0 for part in said[1:])
        assert complex(x, y) == pytest.approx(about, abs=1e-4)
        row["angles"] = np.add(turns, (25.0, 25.1, 25.0)).tolist()
        assert lengths_found("coupler", row)["OA"] == pytest.approx(abs(arm), rel=1e-6)


def test_three_places_in_a_line_are_refused() -> None:
    row = {"A": [0j, 0.03 + 0.02j, 0.06 + 0.04j], "angles": [10.0, 30.0, 70.0], "AB": 0.08}
    with pytest.raises(StructureError, match="three places of A lie in one line") as error:
        lengths_found("coupler", row)
    assert error.value.keys == ("task.A",)
    level = {**row, "A": [0j, 0.03 + 0j, 0.05 + 0.06j], "angles": [90.0, 90.0, 90.0]}
    assert lengths_found("coupler", level)["BC"] == pytest.approx(
        lengths_found("coupler", level)["OA"]
    )


def test_a_swinging_cylinder_has_its_swing_and_stroke() -> None:
    lengths = lengths_found("cylinder", {"stroke": 0.1, "psi": 40.0})
    row = [
        lengths["OC"] - cmath.rect(lengths["OA"], phi)
        for phi in np.linspace(0.0, math.tau, 100_001)
    ]
    assert max(map(abs, row)) - min(map(abs, row)) == pytest.approx(0.1, rel=1e-9)
    assert 2.0 * math.degrees(max(map(cmath.phase, row))) == pytest.approx(40.0, rel=1e-7)
