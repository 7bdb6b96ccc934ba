"""Loads reduced to the crank by the lever: every one that is not inertia's counts, however it is carried."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from support.command import printed
from support.scenes import ONLY_POSITIONS

import graphic_tmm

SCENE = Path(graphic_tmm.__file__).parents[1] / "sheets" / "windrower" / "scene.toml"
MOMENT = """[[load]]
link = 3
moment = "40 N*m"

[forces]
couples = "{couples}"
"""


def _segment(folder: Path, forces: str) -> float:
    """Return cd, mm, of the flywheel of the windrower with other loads."""
    file = folder / "scene.toml"
    task = SCENE.read_text("utf-8").partition("[diagrams]")[0]
    file.write_text(task.replace("[forces]\n", forces) + ONLY_POSITIONS, encoding="utf-8")
    told = json.loads(printed("table", file, "-f", "json", "--exact"))
    return float(told["results"]["cd"]["value"])


@pytest.mark.slow
def test_a_moment_does_the_same_work_as_a_pair_of_forces(tmp_path: Path) -> None:
    moment, pair = (
        _segment(tmp_path, MOMENT.format(couples=couples)) for couples in ("moment", "pair")
    )
    assert pair == pytest.approx(moment, rel=1e-12)
    assert abs(moment - _segment(tmp_path, "[forces]\n")) > 1.0


PRESS = """title = "press"
language = "en"
[frame]
number = 4
O = [0, 0]
y = {{ through = [0, 0], angle = "90 deg" }}
[[link]]
number = 1
points = {{ O = [0, 0], A = ["100 mm", 0] }}
mass = "4 kg"
centre = "O"
J = "0.02 kg*m^2"
[[link]]
number = 2
points = {{ A = [0, 0], B = ["350 mm", 0], S2 = ["120 mm", 0] }}
mass = "6 kg"
centre = "S2"
J = "0.07 kg*m^2"
[[link]]
number = 3
points = {{ B = [0, 0] }}
slides = {{ on = "frame", along = "y", side = "above" }}
mass = "12 kg"
centre = "B"
[drive]
link = 1
speed = "90 rpm"
turns = "{turns}"
positions = 12
zero = {{ point = "B", at = "top" }}
accelerations = [2]
[effects]
gravity = true
inertia = true
[[load]]
link = 3
point = "B"
of = "B"
out = [[0, "2 kN"], [1, "2 kN"]]
back = [[0, "0.3 kN"], [1, "0.3 kN"]]
[forces]
positions = [2]
[plans]
velocities = "{velocities}"
[flywheel]
delta = 0.05
constant = "{constant}"
"""


@pytest.mark.parametrize("constant", ["driving", "resisting"])
@pytest.mark.parametrize("velocities", ["direct", "turned"])
@pytest.mark.slow
def test_a_machine_that_turns_clockwise_needs_the_flywheel_of_its_mirror_image(
    tmp_path: Path, constant: str, velocities: str
) -> None:
    """What the loads take they take either way: the press is symmetric."""
    found = []
    for turns in ("clockwise", "counterclockwise"):
        file = tmp_path / f"{turns}.toml"
        file.write_text(
            PRESS.format(turns=turns, velocities=velocities, constant=constant) + ONLY_POSITIONS,
            "utf-8",
        )
        told = json.loads(printed("table", file, "-f", "json", "--exact"))["results"]
        names = ("J_fly", "J_fly_energy_mass", "M_mean", "power", "A_excess")
        found.append([told[name]["value"] for name in names])
    assert found[0] == pytest.approx(found[1], rel=1e-9)
    drives = 1.0 if constant == "driving" else -1.0
    assert drives * found[0][3] > 0.0, "the loads resist: what drives does work"
