"""The scenes of the source documents give the rows that the documents show, as `published.csv` and tables do.

The figures are the documents', or recomputed from their own data where they contradict themselves.
"""

from __future__ import annotations

import json
from functools import cache
from typing import Any

import pytest
from support.command import printed
from support.gallery import SHEETS

from graphic_tmm.checking.check import check
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.records import FINE
from graphic_tmm.scene.read import read

pytestmark = pytest.mark.every

STATIONS = ("1", "2", "3", "4", "5")


@cache
def told(name: str) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(printed("table", name, "-f", "json"))
    return found


def result(name: str, key: str) -> float:
    return float(told(name)["results"][key]["value"])


def row(name: str, plan: str, segment: str, kind: str = "value") -> dict[str, float]:
    found = next(
        one for one in told(name)["columns"] if (one["plan"], one["segment"]) == (plan, segment)
    )
    return dict(zip(found["positions"], found[kind], strict=True))


@pytest.mark.parametrize(
    ("key", "due", "within"),
    [
        ("cd", 61.0, 0.5),
        ("J_fly", 1.77, 0.005),
        ("D_max", 4.4, 0.0),
        ("D_e", 0.45, 0.0),
        ("D_i", 0.38, 0.0),
        ("D_mean", 0.415, 1e-12),
        ("rim_mass", 41.1, 0.05),
        ("rim_width", 0.115, 0.0005),
    ],
)
def test_the_engines_flywheel(key: str, due: float, within: float) -> None:
    assert result("engine", key) == pytest.approx(due, abs=within)


def test_the_engines_largest_moment_by_its_own_reading() -> None:
    """881.71 N·m of 110.21 mm: right for the document's X = 65 mm; the exact plan has 65.29 mm."""
    found = check(read(SHEETS / "engine"), read_readings(SHEETS / "engine" / "published.csv"))
    assert {one.verdict for one in found.readings if one.taken.segment == "M"} == {FINE}
    assert row("engine", "flywheel", "M")["3"] == pytest.approx(881.71 * 65.29 / 65.0, rel=2e-3)


@pytest.mark.parametrize(
    ("segment", "due"),
    [
        ("theta1", (-3.030, -0.715, 0.442, 0.828, 0.939)),
        ("theta2", (0.752, 0.417, -0.793, -4.82, -15.27)),
    ],
)
def test_specific_sliding_at_the_documents_stations(segment: str, due: tuple[float, ...]) -> None:
    """All ten, to what 0.1 mm of the line of action of 181.35 mm is worth there."""
    found = row("gear-pair", "sliding-table", segment)
    for name, one in zip(STATIONS, due, strict=True):
        slope = abs((1 - one) * (1 + abs(one)))  # dϑ by a share of the shorter stretch, at most
        assert found[name] == pytest.approx(one, abs=2e-3 + 1e-3 * slope)


@pytest.mark.parametrize("name", ["gear-pair", "project"])
def test_the_centre_distance_is_400_mm_on_the_sheet(name: str) -> None:
    scale = told(name)["scales"]["mu_l_gears"]["value"]
    assert result(name, "a_w") / scale == pytest.approx(400.0, abs=1e-9)


def test_the_project_gives_the_rockers_inertia_by_its_rod_and_the_force_by_travel() -> None:
    scene = read(SHEETS / "project")
    assert scene.mechanism is not None
    rocker = next(link for link in scene.mechanism.links if link.number == 3)
    assert rocker.rod == pytest.approx(0.3936)
    assert (rocker.mass, rocker.rod**2 * 25.0 / 12.0) == (25.0, pytest.approx(0.323, abs=5e-4))
    assert [one.travel is not None for one in scene.tasks["forces"].loads] == [True]
    assert "load 1, out" in scene.told
    assert row("project", "forces", "F5")["8"] == pytest.approx(190.0)


def test_the_sliders_accelerations() -> None:
    """Table 5: 122, 70, 23, 71, 81.4, 71, 23, 71 m/s²; its draughtsman's peak is 1.9 mm above the curve."""
    found = [abs(one) for one in row("slider-diagrams", "diagrams", "a").values()]
    due = (122.0, 70.0, 23.0, 71.0, 81.4, 71.0, 23.0, 71.0)
    assert found == pytest.approx(due, abs=2.5 * 2.0)
    sheet = "".join(one.read_text("utf-8") for one in (SHEETS / "slider-diagrams").glob("*.svg"))
    assert sheet
    scales = told("slider-diagrams")["scales"]
    assert scales["mu_diagram_a"]["value"] == pytest.approx(2.0)
    assert scales["mu_diagram_V"]["value"] == pytest.approx(0.075)


def test_the_lever_reproduces_the_segments_by_similarity() -> None:
    """as2 = ab·AS2/AB, cs3 = pb·CS3/CB, ds4 = de·DS4/DE: 40/120, 20/100, 60/140 of the links' segments."""

    def of(segment: str) -> float:
        return abs(row("lever", "velocities", segment, "mm")["4"])

    assert of("ps3") == pytest.approx(of("pb") / 5, abs=0.5)
    assert abs(row("lever", "forces", "P_bal_difference")["4"]) < 5.0
