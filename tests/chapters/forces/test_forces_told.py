"""What is told of forces that are nothing, of how far two methods differ, of keys that were left out."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import pytest
from support.boards import drawn_of
from support.command import invoke
from support.scenes import written

from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.scene.read import read

SLIDER = """
title = "slider-crank"
language = "en"
[frame]
O = [0, 0]
x = { through = [0, 0], angle = 0 }
[[link]]
number = 1
points = { O = [0, 0], A = [0.1, 0] }
[[link]]
number = 2
points = { A = [0, 0], B = [0.3, 0], S2 = [0.1, 0] }
centre = "S2"
mass = 1
J = 0
[[link]]
number = 3
points = { B = [0, 0] }
slides = { on = "frame", along = "x", side = "right" }
mass = 2
centre = "B"
[drive]
link = 1
speed = 10
positions = 4
first = 1
accelerations = "all"
[effects]
inertia = true
[forces]
positions = "all"
[[load]]
link = 3
point = "B"
force = "50 N"
direction = "180 deg"
[[sheet]]                         # of the numbers: no plan has to be fitted to it
place = ["force table"]
"""
EVEN = """
title = "parallelogram: its rocker turns evenly"
language = "en"
[frame]
O = [0, 0]
C = [0.3, 0.1]
[[link]]
number = 1
points = { O = [0, 0], A = [0.1, 0] }
[[link]]
number = 2
points = { A = [0, 0], B = [0.31622776601683794, 0] }
side = "right of AC"
flips_at = ["18.43494882292201 deg", "198.43494882292201 deg"]
[[link]]
number = 3
points = { C = [0, 0], B = [0.1, 0] }
J = 0.02
[drive]
link = 1
speed = 10
positions = 1
first = 1
zero = "63.1 deg"
extra = ["97 deg"]
[effects]
inertia = true
[forces]
positions = "all"
[scales]                          # at which the ruler rounds the segments that are to be alike alike
mu_v = "0.01 (m/s)/mm"
mu_a = "0.1 (m/s^2)/mm"
[[sheet]]
place = ["forces", "lever", "force table"]
"""


def _run(tmp_path: Path, text: str, *options: str) -> tuple[str, str]:
    path = written(tmp_path, text)
    result = invoke(options[0], path, *options[1:])
    assert result.exit_code == 0, result.output
    return result.stdout, result.stderr


def _json(
    tmp_path: Path, text: str, *options: str
) -> tuple[dict[str, Any], dict[str, list[Any]], str]:
    out, told = _run(tmp_path, text, "table", "-f", "json", *options)
    found = json.loads(out)
    columns = {c["segment"]: c["value"] for c in found["columns"] if c["plan"] == "forces"}
    return found["scales"], columns, told


# forces that are all nothing


@pytest.mark.parametrize("options", [(), ("--exact",)])
def test_forces_of_rounding_alone_are_zero_without_a_scale(
    tmp_path: Path, options: tuple[str, ...]
) -> None:
    """The rocker's ε is zero but for rounding: so is every force, and nothing is drawn to μ of the rounding."""
    scales, columns, told = _json(tmp_path, EVEN, *options)
    assert not [key for key in scales if key.startswith("mu_F")]
    for segment in ("Mi3", "R12", "R03", "R23", "R01", "P_bal_forces", "P_bal_lever"):
        assert columns[segment] == [0.0, 0.0]
    assert columns["P_bal_difference"] == [None, None]
    assert told.count("all forces are zero") == 2
    assert "left out" not in told
    assert "nothing to compare" not in told


def test_a_sheet_of_no_forces_says_so_in_words(tmp_path: Path) -> None:
    _run(tmp_path, EVEN, "draw", "-o", str(tmp_path / "out"))
    drawn = "".join(p.read_text(encoding="utf-8") for p in (tmp_path / "out").glob("*.svg"))
    assert "all forces are zero: there is no polygon" in drawn
    assert "there is nothing to compare" in drawn
    assert "N/mm" not in drawn


def test_a_scale_that_the_scene_gives_stays(tmp_path: Path) -> None:
    text = EVEN.replace("[forces]", '[forces]\nmu_F = "2 N/mm"')
    scales, columns, told = _json(tmp_path, text)
    assert scales["mu_F_2_3"] == {"value": 2.0, "unit": "N/mm"}
    assert columns["R12"] == [0.0, 0.0]
    assert "all forces are zero" not in told


# how far the two methods differ


@pytest.mark.parametrize("options", [(), ("--exact",)])
def test_at_a_dead_centre_there_is_nothing_to_compare_and_nothing_is_told(
    tmp_path: Path, options: tuple[str, ...]
) -> None:
    _, columns, told = _json(tmp_path, SLIDER, *options)
    assert [x is None for x in columns["P_bal_difference"]] == [True, False, True, False]
    assert columns["P_bal_forces"][0] == columns["P_bal_lever"][2] == 0.0
    assert told == ""


@pytest.mark.parametrize("ruler", [1.0, 0.1, 0.01])
def test_the_difference_has_the_digits_that_its_readings_leave(
    tmp_path: Path, ruler: float
) -> None:
    """P_b follows from lengths of 200 mm at most, read to half a division: no digit below what that does."""
    _, columns, _ = _json(tmp_path, SLIDER + f'[hand]\nruler = "{ruler} mm"\n')
    told = columns["P_bal_difference"][1]
    least = 100.0 * (ruler / 2.0) / 200.0
    digit = 10.0 ** math.floor(math.log10(least))
    assert told == pytest.approx(digit * round(told / digit), abs=1e-9)


# g, and J


def test_weights_are_taken_with_the_g_of_the_scene(tmp_path: Path) -> None:
    text = SLIDER.replace("inertia = true", "gravity = true")
    for key, g in (("", 9.81), ('g = "9.80665 m/s^2"', 9.80665), ("g = 1.62", 1.62)):
        _, columns, _ = _json(tmp_path, text.replace("gravity = true", f"gravity = true\n{key}"))
        assert columns["G3"] == pytest.approx([2.0 * g] * 4, rel=1e-12)


def test_that_kgf_and_weights_differ_is_told_once_if_nobody_decides(tmp_path: Path) -> None:
    weights = SLIDER.replace("inertia = true", "gravity = true")
    kgf = weights.replace('"50 N"', '"5 кгс"')
    assert _run(tmp_path, kgf, "table")[1].count("effects.g: it is left out") == 1
    assert "9.81" in _run(tmp_path, kgf, "table")[1]
    for text in (
        weights,
        SLIDER.replace('"50 N"', '"5 kgf"'),
        kgf.replace("gravity = true", "gravity = true\ng = 9.81"),
    ):
        assert "effects.g" not in _run(tmp_path, text, "table")[1]


def test_that_masses_count_for_nothing_is_told(tmp_path: Path) -> None:
    says = "effects: masses are given, but neither gravity nor inertia is switched on"
    off = SLIDER.replace("inertia = true", "inertia = false")
    assert _run(tmp_path, off, "table")[1].count(says) == 1
    bare = "".join(line for line in off.splitlines(True) if not line.startswith("mass"))
    for text in (SLIDER, off.replace("inertia = false", "gravity = true"), bare):
        assert says not in _run(tmp_path, text, "table")[1]


@pytest.mark.parametrize("value", ["0", "-9.81", '"9.81 m"', "true"])
def test_a_g_that_is_none_is_refused(tmp_path: Path, value: str) -> None:
    path = written(tmp_path, SLIDER.replace("[effects]", f"[effects]\ng = {value}"))
    result = invoke("table", path)
    assert result.exit_code == 2
    assert "effects.g" in result.stderr


def test_a_mass_without_J_that_turns_is_told_once(tmp_path: Path) -> None:
    """The rod turns; the slider does not; the crank turns evenly, so its J does nothing."""
    bare = SLIDER.replace("J = 0\n", "").replace(
        "A = [0.1, 0] }", 'A = [0.1, 0] }\nmass = 3\ncentre = "A"'
    )
    told = _run(tmp_path, bare, "table")[1]
    assert told.count("J is left out") == 1
    assert "link 2: J" in told
    speeding = bare.replace("speed = 10", "speed = 10\nacceleration = 5")
    assert "link 1, 2: J" in _run(tmp_path, speeding, "table")[1]
    for text in (SLIDER, bare.replace("inertia = true", "gravity = true")):
        assert "J is left out" not in _run(tmp_path, text, "table")[1]


def test_a_J_of_zero_and_one_left_out_are_drawn_alike(tmp_path: Path) -> None:
    path = tmp_path / "scene.toml"
    found = []
    for text in (SLIDER, SLIDER.replace("J = 0\n", "")):
        path.write_text(text, encoding="utf-8")
        made = drawn_of(read(path), exact=True)
        assert FORCES_PLAN.of(made) is not None
        found.append([step.it.letter for step in made.project.construction.steps])
    assert found[0] == found[1]
