"""Belts and chains between links: their runs touch both wheels and nothing else, rims are equally fast."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest
import shapely
from support import gallery
from support.live_logs import by_page, live_page

import graphic_tmm as tmm
from graphic_tmm.chapters.kinematics.given import given, stated
from graphic_tmm.chapters.kinematics.ink_links import LinksInk
from graphic_tmm.chapters.kinematics.ink_wheels import runs, wheels
from graphic_tmm.chapters.kinematics.scales import reaches
from graphic_tmm.chapters.structure.table import link_name, pair_rows, structure_lines
from graphic_tmm.drawn import Drawn
from graphic_tmm.mechanism.structure import dissect
from graphic_tmm.paper.drawing import Stroke
from graphic_tmm.studio import make

BELT = """
title = "T"
language = "en"
[frame]
number = 3
O = [0, 0]
D = [0.4, 0.1]
[[link]]
number = 1
points = { O = [0, 0], A = [0.03, 0] }
[[link]]
number = 2
points = { D = [0, 0], B = [0.05, 0] }
[[mesh]]
by = "belt"
links = [1, 2]
centres = ["O", "D"]
radii = [0.06, 0.15]
[drive]
link = 1
speed = 10
acceleration = -40
accelerations = "all"
"""


def belt(by: str, first: float, second: float, sense: str = "counterclockwise") -> str:
    text = BELT.replace('by = "belt"', f'by = "{by}"').replace(
        "[0.06, 0.15]", f"[{first}, {second}]"
    )
    return text.replace("speed = 10", f'speed = 10\nturns = "{sense}"')


def drawn(text: str) -> Drawn:
    made = make(tmm.read(text)).mechanism
    assert made is not None
    return made


@pytest.mark.parametrize("by", ["belt", "crossed belt", "chain"])
def test_runs_touch_both_wheels_and_cross_as_the_belt_is_told(by: str) -> None:
    """By shapely: each run lies on both circles at its ends only; open ones are apart, crossed ones meet."""
    source = random.Random(3)
    for sense in ("counterclockwise", "clockwise"):
        for sizes in (
            (0.06, 0.15),
            (0.1, 0.1),
            (source.uniform(0.02, 0.3), source.uniform(0.01, 0.1)),
        ):
            made = drawn(belt(by, *sizes, sense))
            ink = LinksInk(made.construction, made.reading, reaches(made))
            both = [one.path for one in runs(ink, made.main) if isinstance(one, Stroke)]
            lines = [shapely.LineString([point[:2] for point in path]) for path in both]
            assert len(lines) == 2
            assert lines[0].intersects(lines[1]) == (by == "crossed belt")
            scale = float(np.ravel(made.given[next(m for m in made.given if m.name == "μ_l")])[0])
            for figure, radius in zip(("1", "2"), sizes, strict=True):
                (rim,) = ink.of(figure, "wheel")
                middle = shapely.Point(*_xy(ink.at(rim.marks[0], made.main)))
                for line in lines:
                    off = 1000.0 * radius / (1000.0 * scale)
                    assert line.distance(middle) == pytest.approx(off, rel=1e-9)
                    ends = [middle.distance(shapely.Point(end)) for end in line.coords]
                    assert min(ends) == pytest.approx(off, rel=1e-9)


def _xy(z: complex) -> tuple[float, float]:
    return z.real, z.imag


@pytest.mark.parametrize("sense", ["counterclockwise", "clockwise"])
@pytest.mark.parametrize(("by", "turned"), [("belt", 1), ("chain", 1), ("crossed belt", -1)])
def test_the_run_that_is_drawn_moves_towards_what_drives(by: str, turned: int, sense: str) -> None:
    """Equal rims: ω2·r2 = ±ω1·r1, ε alike; the run that pulls goes from the driven wheel to the driver."""
    text = belt(by, 0.06, 0.15, sense)
    found = tmm.motion(text, [0.0, 50.0, 700.0], exact=True)
    assert np.allclose(found.omega[2] * 0.15, turned * found.omega[1] * 0.06, rtol=1e-12)
    assert np.allclose(found.epsilon[2] * 0.15, turned * found.epsilon[1] * 0.06, rtol=1e-12)
    made = drawn(text)
    views = {(step.it.view, step.it.name): step.it for step in made.construction.steps}
    start, end = (complex(np.ravel(made.reading[views["positions", k]])[0]) for k in "LK")
    rims = [complex(np.ravel(made.reading[views["velocities", k]])[0]) for k in "lk"]
    assert rims[0] == rims[1]
    assert (rims[0] / (start - end)).real > 0.0
    assert abs((rims[0] / (start - end)).imag) < 1e-12 * abs(rims[0] / (start - end))


def test_wheels_of_a_belt_have_rims_and_sprockets_pitch_circles() -> None:
    for by, pen in (("belt", "main"), ("crossed belt", "main"), ("chain", "centre")):
        made = drawn(belt(by, 0.06, 0.15))
        ink = LinksInk(made.construction, made.reading, reaches(made))
        pens = {one.pen for one in runs(ink, made.main)}
        circles = [one for one in wheels(ink, ("1", "2"), made.main) if one.part == "wheel"]
        assert pens == {pen}
        assert [one.pen for one in circles].count(pen) >= 2


@pytest.mark.parametrize(
    ("by", "kind", "wheel"),
    [
        ("belt", "open belt", "pulley"),
        ("crossed belt", "crossed belt", "pulley"),
        ("chain", "chain", "sprocket"),
    ],
)
def test_a_belt_takes_one_freedom_and_is_called_by_name(by: str, kind: str, wheel: str) -> None:
    scene = tmm.read(belt(by, 0.06, 0.15))
    mechanism = scene.mechanism
    assert mechanism is not None
    structure = dissect(mechanism)
    assert (structure.mobility, structure.formula) == (1, "I(1) → p4(2)")
    last = pair_rows(mechanism, structure, "en")[-1]
    assert last[:4] == ["LK", "1,2", kind, "as a higher one"]
    assert link_name(mechanism, structure, mechanism.by_number[2], "en") == wheel
    lines = structure_lines(mechanism, structure, "en")
    assert any("flexible link, which counts as a higher one" in line for line in lines)
    sizes = {one.symbol: one.value for one in given(scene) if one.symbol.startswith("r_")}
    assert sizes == {"r_1": 0.06, "r_2": 0.15}
    (says,) = (one for one in stated(scene, "en") if "joined by" in one)
    assert kind.removeprefix("open ") in says


def test_a_pulley_farther_off_turns_as_fast_on_the_page() -> None:
    """The page runs the log with other givens: ω4 = ω1·r1/r4 wherever the rotor is, with any radii."""
    made = gallery.drawn("belt-drive")
    page = live_page(made)
    assert page is not None
    own = {mark.name: mark for mark in page.log.own}
    marks = {step.it.name: step.it for step in page.log.live if step.it.view == "velocities"}
    driver = float(np.ravel(page.log.own[own["ω_1"]])[0])
    for changes, ratio in (({"l_{OD}": 1.2}, 1.5), ({"r_1": 1.5}, 2.25), ({"r_4": 0.5}, 3.0)):
        values = {
            own[name]: float(page.log.own[own[name]]) * share for name, share in changes.items()
        }
        (told,) = by_page(page, [values], [0, 4, 9])
        rates = [one[marks["ω_4"].slot][0] for one in told]
        assert np.allclose(rates, ratio * driver, rtol=1e-9), changes


def test_on_an_arm_about_a_standing_pulley_equal_wheels_do_not_turn() -> None:
    """Equal pulleys, one standing: carried by an arm the other only moves along (as an aerial's pulleys do)."""
    text = """
title = "T"
language = "en"
[frame]
number = 5
O = [0, 0]
[[link]]
number = 1
points = { O = [0, 0], A = [0.3, 0] }
[[link]]
number = 2
points = { A = [0, 0], B = [0.05, 0] }
[[mesh]]
by = "belt"
links = [5, 2]
centres = ["O", "A"]
radii = [0.08, 0.08]
[drive]
link = 1
speed = 10
acceleration = 30
accelerations = "all"
"""
    found = tmm.motion(text, np.linspace(0.0, 360.0, 13), exact=True)
    assert np.allclose(found.omega[2], 0.0, atol=1e-10)
    assert np.allclose(found.epsilon[2], 0.0, atol=1e-8)
    assert np.allclose(found.velocities["B", 2], found.velocities["A", 1], atol=1e-10)
    assert np.allclose(found.accelerations["B", 2], found.accelerations["A", 1], atol=1e-8)
    crossed = tmm.motion(text.replace('"belt"', '"crossed belt"'), [30.0], exact=True)
    assert math.isclose(crossed.omega[2][0], 20.0, rel_tol=1e-9)
