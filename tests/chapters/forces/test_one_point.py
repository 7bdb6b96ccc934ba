"""Stone and bar that meet in one letter: a group without length keeps the scale of the plan of positions."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from support.command import column, printed, tabled
from support.scenes import written

MECHANISM = """title = "Rocker, stone and bar"
language = "en"
[frame]
O = [0, 0]
y = { through = ["0.3 m", 0], angle = "90 deg" }
[[link]]
number = 1
points = { O = [0, 0], C = ["0.5 m", 0] }
[[link]]
number = 2
points = { A = [0, 0] }
slides = { on = 1, along = "OC", side = "+" }
[[link]]
number = 3
points = { A = [0, 0] }
slides = { on = "frame", along = "y" }
[drive]
link = 1
speed = "1 rad/s"
positions = 1
zero = "30 deg"
"""
FORCE = '[[load]]\nlink = 3\npoint = "A"\nforce = "100 N"\ndirection = "90 deg"\n[forces]\n'
LOADS = {
    "force": FORCE,
    "moment": '[[load]]\nlink = 3\nmoment = "7 N*m"\n[forces]\n',
    "moment on the stone": '[[load]]\nlink = 2\nmoment = "7 N*m"\n[forces]\n',
    "nothing": "[forces]\n",
    "friction": f"[effects]\nfriction = true\n{FORCE}[friction]\nf = 0.1\nradius = 0.01\n",
}
ANGLE = math.radians(30.0)


def scene(folder: Path, name: str) -> Path:
    return written(folder, MECHANISM + LOADS[name])


@pytest.mark.parametrize("name", LOADS)
def test_the_forces_of_one_point_are_drawn(tmp_path: Path, name: str) -> None:
    found = tabled(scene(tmp_path, name), "--exact")
    scales = {key: one["value"] for key, one in found["scales"].items()}
    assert scales["mu_l_2_3"] == scales["mu_l"] >= scales["mu_l_1"]
    if name != "force":
        return
    due = {"R12": 100.0 / math.cos(ANGLE), "R03": 100.0 * math.tan(ANGLE)}
    # of the force at A on the rocker about O: R12 at the distance OA, square to it
    due["P_bal_forces"] = -due["R12"] * 0.3 / math.cos(ANGLE) / 0.5
    for segment, size in due.items():
        assert column(found, "forces", segment)["value"][0] == pytest.approx(size, rel=1e-9)


@pytest.mark.slow
def test_the_choice_of_its_scale_is_told(tmp_path: Path) -> None:
    told = printed("steps", scene(tmp_path, "force"), "-p", "scales", "--why")
    assert "Take μ_l for μ_l23." in told
    assert "All points of what is detached lie in one" in " ".join(told.split())


@pytest.mark.slow
@pytest.mark.parametrize("name", LOADS)
def test_its_sheet_is_drawn_and_its_figure_stands_on_it(tmp_path: Path, name: str) -> None:
    out = tmp_path / "out"
    printed("draw", scene(tmp_path, name), "-o", out)
    text = "".join(path.read_text("utf-8") for path in out.glob("*.svg"))
    assert "group-2-3-0" in text
    assert "nan" not in text
