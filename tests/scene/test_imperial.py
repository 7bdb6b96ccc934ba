"""A scene in feet and pounds: the same mechanism as in SI, printed in its units by every reader of the log."""

from __future__ import annotations

import csv
import io
import json
import re
import tomllib
from pathlib import Path

import numpy as np
import pytest
from support.boards import in_usual_size
from support.command import invoke
from support.found_once import found_once as found_once
from support.scenes import MECHANISM, SECTIONS, written

from graphic_tmm.drawn import DrawnScene
from graphic_tmm.language.catalogue import languages
from graphic_tmm.readers.table import scene_columns, scene_results
from graphic_tmm.scene.read import understood
from graphic_tmm.scene.units import UNITS, plain_unit

SCENE = """title = "Inches and pounds"
language = "en"
units = "imperial"
[frame]
O = [0, 0]
x = { through = [0, 0], angle = "0 deg" }
[[link]]
number = 1
points = { O = [0, 0], A = ["2 in", 0] }
[[link]]
number = 2
points = { A = [0, 0], B = ["8 in", 0], S2 = ["3 in", 0] }
mass = "2 lb"
J = "6.8 lb*in^2"
centre = "S2"
[[link]]
number = 3
points = { B = [0, 0] }
mass = "3 lb"
centre = "B"
slides = { on = "frame", along = "x", side = "right" }
[drive]
link = 1
speed = "600 rpm"
accelerations = [2]
[effects]
inertia = true
[[load]]
link = 3
point = "B"
force = "100 lbf"
direction = "180 deg"
[forces]
positions = [2]
[hand]
ruler = "exact"
"""
METRIC = re.compile(r"(?<![\w/(])(?:m/s²?|N|N·m|kg|kg·m²|Pa|м/с²?|Н|кг)(?![\w·.])")
ALL = (
    MECHANISM
    + "".join(SECTIONS[name] for name in ("effects", "load", "forces", "diagrams", "flywheel"))
    + '[hand]\nruler = "exact"\n'
)
OTHERS = {"J": 1.0, "W": 1.0, "ft·lbf/s": 1.3558179483314004, "mm": 1.0}


def _made(text: str, units: str) -> DrawnScene:
    return in_usual_size(understood({**tomllib.loads(text), "units": units}, "scene"))


def _si(unit: str) -> float:
    known = UNITS.get(plain_unit(unit))
    return float(known.factor) if known is not None else OTHERS.get(unit, 1.0)


@pytest.mark.parametrize("text", [SCENE, ALL])
def test_every_figure_is_that_of_the_scene_in_si(text: str) -> None:
    one, other = (_made(text, units) for units in ("SI", "imperial"))
    columns = {(c.plan, c.segment): c for c in scene_columns(one)}
    found = {(c.plan, c.segment): c for c in scene_columns(other)}
    assert columns.keys() == found.keys()
    for key, column in columns.items():
        due, own = column.value * _si(column.unit), found[key].value * _si(found[key].unit)
        largest = np.nanmax(np.abs(due))
        np.testing.assert_allclose(own, due, rtol=1e-9, atol=1e-9 * largest, err_msg=str(key))
    numbers = scene_results(other)
    for name, (due, unit) in scene_results(one).items():
        value, own_unit = numbers[name]
        if unit == "mm":
            continue  # drawn to another scale factor
        np.testing.assert_allclose(value * _si(own_unit), due * _si(unit), rtol=1e-8, err_msg=name)


def test_the_force_on_the_crank_follows_from_the_loop_in_pounds() -> None:
    """By Newton-Euler in slugs and feet, written out for the slider-crank: no plan, no package."""
    r, length, s, w = 2 / 12, 8 / 12, 3 / 12, 20 * np.pi
    lb = 0.45359237 / (4.4482216152605 / 0.3048)  # in slugs
    m2, m3, inertia = 2 * lb, 3 * lb, 6.8 * lb / 144
    phi = 2 * np.pi * 2 / 12
    a = r * np.exp(1j * phi)
    psi = np.arcsin(-a.imag / length)
    v_a, a_a = 1j * w * a, -(w**2) * a
    psi1 = -v_a.imag / (length * np.cos(psi))
    psi2 = (-a_a.imag + length * np.sin(psi) * psi1**2) / (length * np.cos(psi))
    rod = np.exp(1j * psi)
    a_b = (a_a + length * rod * (1j * psi2 - psi1**2)).real
    a_s = a_a + s * rod * (1j * psi2 - psi1**2)
    v_b = (v_a + length * rod * 1j * psi1).real
    # unknown: F12 at A (x, y) on the rod, N on the slider; the rod's moment about A
    f3 = -100 - m3 * a_b
    pull = f3 - m2 * a_s.real  # horizontal: F12x + pull = 0
    arm = length * rod
    at_s = s * rod
    couple = -(np.conj(at_s) * (m2 * a_s)).imag - inertia * psi2
    normal = (arm.imag * f3 - couple) / arm.real
    f12 = complex(-pull, m2 * a_s.imag - normal)
    made = {(c.plan, c.segment): c for c in scene_columns(_made(SCENE, "imperial"))}
    assert made["velocities", "pb"].unit == "ft/s"
    assert made["velocities", "pb"].value[0, 2] == pytest.approx(abs(v_b), rel=1e-9)
    assert made["accelerations", "πb"].value[0, 2] == pytest.approx(abs(a_b), rel=1e-9)
    reaction = next(c for (_, name), c in made.items() if name in ("R12", "F12"))
    assert reaction.unit == "lbf"
    assert reaction.value[0, 2] == pytest.approx(abs(f12), rel=1e-9)


@pytest.mark.slow
@pytest.mark.turns(1)
@pytest.mark.usefixtures("found_once")
@pytest.mark.parametrize("language", languages())
def test_no_unit_of_si_is_printed(language: str, tmp_path: Path) -> None:
    file = written(tmp_path, SCENE)
    for command in (
        ("table", file),
        ("table", file, "-f", "csv"),
        ("table", file, "-f", "json"),
        ("steps", file),
    ):
        done = invoke(command[0], *map(str, command[1:]), "-l", language)
        assert done.exit_code == 0, done.output
        assert not METRIC.search(done.output), (command, METRIC.search(done.output))
    out = tmp_path / "out"
    for command in (("draw", "-f", "svg,png"), ("note", "-f", "html")):
        done = invoke(command[0], str(file), "-o", str(out), "-l", language, *command[1:])
        assert done.exit_code == 0, done.output
    for made in (*out.glob("*.svg"), *out.glob("*.html")):
        told = re.findall(
            r"<(?:text|title|td|tspan)[^>]*>([^<]*)<|data-unit=\"([^\"]*)", made.read_text("utf-8")
        )
        words = " | ".join(one or other for one, other in told)
        assert ("ft" if language == "en" else "фут") in words
        assert not METRIC.search(words), METRIC.search(words)


def test_json_names_the_units(tmp_path: Path) -> None:
    told = json.loads(invoke("table", str(written(tmp_path, SCENE)), "-f", "json").stdout)
    assert told["scales"]["mu_l"]["unit"] == "ft/mm"
    assert {one["unit"] for one in told["columns"] if one["plan"] == "velocities"} == {
        "ft/s",
        "1/s",
    }


@pytest.mark.usefixtures("found_once")
@pytest.mark.parametrize("wrong", [1.0, 1.5])
@pytest.mark.slow
def test_values_are_checked_in_the_units_in_which_they_are_printed(
    wrong: float, tmp_path: Path
) -> None:
    file = written(tmp_path, SCENE.replace('[hand]\nruler = "exact"\n', ""))
    rows = list(csv.reader(io.StringIO(invoke("table", str(file), "-f", "csv").stdout)))
    told = json.loads(invoke("table", str(file), "-f", "json").stdout)
    column = next(one for one in told["columns"] if one["segment"] == "pb")
    assert rows
    value = column["value"][2] * wrong
    for unit, times in (("ft/s", 1.0), ("in/s", 12.0), ("m/s", 0.3048)):
        readings = tmp_path / "readings.csv"
        readings.write_text(
            f"plan,position,segment,mm,value,unit\nvelocities,2,pb,,{value * times:.5g},{unit}\n"
        )
        done = invoke("check", str(file), str(readings))
        assert done.exit_code == (0 if wrong == 1.0 else 1), done.output


def test_a_chapter_that_is_told_in_mm_says_so(tmp_path: Path) -> None:
    text = SCENE + SECTIONS["gears"]
    done = invoke("table", str(written(tmp_path, text)))
    assert done.exit_code == 2
    assert 'the sizes of [gears] are told in mm; write units = "SI"' in done.output
