"""What is no slider-crank whose crank is driven is refused, with what to do."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.boards import in_usual_size

from graphic_tmm.errors import StructureError
from graphic_tmm.scene.read import read

SLIDER = """title = "T"
language = "en"
[frame]
number = 4
O = [0, 0]
x = { through = [0, 0], angle = "0 deg" }
[[link]]
number = 1
points = { O = [0, 0], A = [0.1, 0] }
[[link]]
number = 2
points = { A = [0, 0], B = [0.4, 0], C = [0.2, 0.05] }
[[link]]
number = 3
points = { B = [0, 0] }
slides = { on = "frame", along = "x", side = "+" }
[drive]
link = 1
speed = "20 rad/s"
turns = "counterclockwise"
positions = 12
zero = "10 deg"
[klein]
slider = "B"
[[sheet]]
format = "A1"
"""
SIDE = 'side = "left of OB"\n'
CHANGED = {
    "point": (
        'slider = "B"',
        'points = ["A"]',
        "point A is no further point of the rod AB; it has C",
    ),
    "slider": ('slider = "B"', 'slider = "C"', "point C is not the slider of a slider-crank"),
    "stands": ("20 rad/s", "0 rad/s", "the crank stands"),
    "place": ('slider = "B"', "positions = [40]", "there is no position 40"),
    "drive": (
        'link = 1\nspeed = "20 rad/s"\nturns = "counterclockwise"\npositions = 12\nzero = "10 deg"',
        'link = 3\nspeed = "0.2 m/s"\npositions = 5\nfrom = "350 mm"\nto = "450 mm"',
        "driven otherwise",
    ),
}


@pytest.mark.parametrize("case", CHANGED)
def test_what_is_none_is_refused(tmp_path: Path, case: str) -> None:
    old, new, says = CHANGED[case]
    assert old in SLIDER
    path = tmp_path / "scene.toml"
    text = SLIDER.replace(old, new).replace(
        "A = [0.1, 0] }\n", f"A = [0.1, 0] }}\n{SIDE if case == 'drive' else ''}"
    )
    path.write_text(text, encoding="utf-8")
    with pytest.raises(StructureError, match=says):
        in_usual_size(read(path), exact=True)


FOUR_BAR = """title = "T"
language = "en"
[frame]
number = 4
O = [0, 0]
D = [0.3, 0]
[[link]]
number = 1
points = { O = [0, 0], A = [0.1, 0] }
[[link]]
number = 2
points = { A = [0, 0], B = [0.28, 0] }
[[link]]
number = 3
points = { D = [0, 0], B = [0.2, 0] }
side = "left of AD"
[drive]
link = 1
speed = "10 rad/s"
turns = "counterclockwise"
positions = 12
[klein]
[[sheet]]
format = "A1"
"""


def test_a_four_bar_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "scene.toml"
    path.write_text(FOUR_BAR, encoding="utf-8")
    with pytest.raises(Exception, match="slider-crank alone") as told:
        in_usual_size(read(path), exact=True)
    assert isinstance(told.value, StructureError)
