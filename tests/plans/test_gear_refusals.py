"""Orders that cannot be a gear pair: each refused with what is wrong and what to do."""

from __future__ import annotations

from dataclasses import replace

import pytest

from graphic_tmm.errors import StructureError
from graphic_tmm.mechanism.gear_orders import GearOrder
from graphic_tmm.plans.draft import Draft
from graphic_tmm.plans.gear import draw_gear

GOOD = GearOrder(15, 25, 0.008, 0.83, 0.445)
NAN = float("nan")


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"z1": 4}, "z1 = 4 is too few teeth: take 5"),
        ({"z2": -20}, "z2 = -20 is too few teeth"),
        ({"z1": 15.5}, "z1 = 15.5 is not a whole number"),
        ({"z2": NAN}, "z2 = nan is not a whole number"),
        ({"z1": True}, "z1 = True is not a whole number"),
        ({"m": 0.0}, "m = 0 is not greater than 0"),
        ({"m": float("inf")}, "m = inf is not greater than 0"),
        ({"ha": -1.0}, "ha = -1 is not greater than 0"),
        ({"c": -0.1}, "c = -0.1 is less than 0"),
        ({"alpha": 0.0}, "alpha = 0° is not between"),
        ({"alpha": 50.0}, "alpha = 50° is not between"),
        ({"x1": NAN}, "x1 = nan is not a number"),
        ({"delta_y": NAN}, "delta_y = nan is not a number"),
        ({"steps": 2}, "2 steps to roll a flank: take a whole number of them, from 4"),
        ({"steps": 7.5}, "7.5 steps to roll a flank"),
        ({"stations": (-3.0,)}, "the station -3 mm does not lie beyond N1"),
        ({"mu": -0.001}, "mu = -0.001 is not greater than 0"),
        ({"ha": 2.5}, r"comes to a point above the depth ha \+ c = 2.75: take a smaller ha or c"),
        ({"x1": -1.0, "x2": -1.0}, r"no working angle .* must be greater than -0.819"),
        ({"z1": 5, "x1": -1.4, "x2": 1.5}, "wheel 1 has no body.* raise x1 or z1"),
        ({"delta_y": 2.0, "x1": 0.4}, "tip circle of wheel 1 .* inside its base circle"),
        ({"z1": 60, "x1": 2.0, "delta_y": 2.9}, "lies inside its root circle|inside its base circle"),
        ({"z1": 60, "x1": -3.0, "x2": 3.5}, "inside its base circle .* raise x1"),
        ({"z1": 5, "x1": 5.0}, "leaves wheel 1 no tooth"),
    ],
)  # fmt: skip
def test_what_cannot_be_a_gear_is_refused_with_a_remedy(changes: dict, says: str) -> None:
    with pytest.raises(StructureError, match=says):
        draw_gear(Draft(), replace(GOOD, **changes))


def test_a_good_order_is_drawn() -> None:
    assert draw_gear(Draft(), GOOD).order == GOOD
