"""Orders that cannot be a gear pair: each refused with what is wrong and what to do."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from support.each import each
from support.scenes import calling

from graphic_tmm.board.draft import Draft
from graphic_tmm.chapters.gears.plan import draw_gear
from graphic_tmm.chapters.gears.task import GearTask
from graphic_tmm.errors import SceneError, StructureError
from graphic_tmm.scene.read import read

GOOD = GearTask(15, 25, 0.008, 0.83, 0.445)
NAN = float("nan")


@each(
    "changes, says",
    [
        ({"z1": 4}, "z1 = 4: a whole number 5 to 2000 is wanted"),
        ({"z2": -5}, "z2 = -5: a whole number 5"),
        ({"z2": -15}, "a ring of 15 teeth has no room for a wheel of 15: give it more"),
        ({"z2": -40, "x1": 1.0, "x2": -1.0}, r"no working angle .* x2 − x1 = -2 must be greater"),
        ({"ha": (1.0, 0.0)}, "ha = 0: a number greater than 0"),
        ({"ha": (1.0, 2.5)}, r"comes to a point above the depth ha \+ c = 2.75"),
        ({"beta": 60.0}, "beta = 60: a number not less than 0 and less than 60"),
        ({"width": -0.1}, "width = -0.1: a number greater than 0"),
        ({"speed": -10.0}, "speed = -10: a number greater than 0"),
        ({"x_sum": 11.0}, "x_sum = 11: a number -10 to 10"),
        ({"distance": 0.17}, "x1 and x2 are both given, too: leave one out"),
        ({"x2": None, "distance": 0.1}, "at 100 mm the base circles .* greater than 150.35 mm"),
        ({"x2": None, "distance": 0.17, "x_sum": 1.0}, "x_sum is given, too: leave one of the two"),
        ({"z1": 15.5}, "z1 = 15.5: a whole number"),
        ({"z2": NAN}, "z2 = nan: a whole number"),
        ({"z1": True}, "z1 = True: a whole number"),
        ({"m": 0.0}, "m = 0: a number greater than 0 is wanted"),
        ({"m": float("inf")}, "m = inf: a number greater than 0"),
        ({"ha": -1.0}, "ha = -1: a number greater than 0"),
        ({"c": -0.1}, "c = -0.1: a number 0 to 5"),
        ({"alpha": 0.0}, "alpha = 0: a number greater than 0 and less than 45"),
        ({"alpha": 50.0}, "alpha = 50: a number greater than 0 and less than 45"),
        ({"x1": NAN}, "x1 = nan: a number -5 to 5"),
        ({"delta_y": NAN}, "delta_y = nan: a number"),
        ({"steps": 2}, "steps = 2: a whole number 4 to 60"),
        ({"steps": 7.5}, "steps = 7.5: a whole number"),
        ({"stations": (-3.0,)}, "stations = -3: a number greater than 0"),
        ({"mu": -0.001}, "mu_l = -0.001: a number 1e-09 to 1000000000"),
        ({"ha": 2.5}, r"comes to a point above the depth ha \+ c = 2.75: take a smaller ha or c"),
        ({"x1": -1.0, "x2": -1.0}, r"no working angle .* must be greater than -0.819"),
        ({"z1": 5, "x1": -1.4, "x2": 1.5}, "wheel 1 has no body.* raise x1 or z1"),
        ({"delta_y": 2.0, "x1": 0.4}, "tip circle of wheel 1 .* inside its base circle"),
        (
            {"z1": 60, "x1": 2.0, "delta_y": 2.9},
            "lies inside its root circle|inside its base circle",
        ),
        ({"z1": 60, "x1": -3.0, "x2": 3.5}, "inside its base circle .* raise x1"),
        ({"z1": 5, "x1": 5.0}, "leaves wheel 1 no tooth"),
        (
            {"x1": None, "x2": None, "z1": 20, "z2": 40, "m": 0.005, "distance": 0.17},
            "x2 = 5.449.* give another distance",
        ),
        (
            {"x1": None, "x2": None, "z1": 20, "z2": 40, "m": 0.005, "distance": 0.19},
            "x2 = 12.69.* give another distance",
        ),
        (
            {"x1": None, "x2": None, "z1": 20, "z2": -60, "m": 0.005, "distance": 0.12},
            "x2 = 5.94.* give another distance",
        ),
        ({"x2": None, "x_sum": 9.0}, "x2 = 8.17 follows: .* give another x_sum"),
        (
            {"z1": 60, "x1": None, "x2": 4.5, "x_sum": 0.5},
            "the tip circle of wheel 1 .* give another x_sum",
        ),
    ],
)
def test_what_cannot_be_a_gear_is_refused_with_a_remedy(changes: dict, says: str) -> None:
    with pytest.raises(StructureError, match=says):
        draw_gear(Draft(), replace(GOOD, **changes))


def test_a_good_order_is_drawn() -> None:
    assert draw_gear(Draft(), GOOD).order == GOOD


def test_the_speed_of_a_pair_has_no_sense_that_a_key_could_tell(tmp_path: Path) -> None:
    """Wheel 1 turns as it does: no key turns it about, so none is named."""
    section = '[gears]\nz1 = 15\nz2 = 25\nm = "8 mm"\nspeed = "-100 rpm"\n'
    with pytest.raises(SceneError, match='"-100 rpm" is not greater than 0') as raised:
        read(calling(tmp_path, section, sheet="", head='title = "T"\nlanguage = "en"\n'))
    assert "turns" not in str(raised.value)
