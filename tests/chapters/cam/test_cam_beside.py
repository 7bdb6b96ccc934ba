"""What is calculated beside a cam: dwells in radians, speeds of the follower; own scales of its derivatives."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from support.boards import usual_part
from support.cams import curvatures, motion, pressure_angles
from support.gallery import SHEETS
from support.notes import concluded
from support.scenes import edited

from graphic_tmm.chapters.cam.plan import CAM_PLAN
from graphic_tmm.chapters.cam.record import BESIDE, VIEW
from graphic_tmm.chapters.cam.table import results
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.fitting.choice import choices
from graphic_tmm.project import record
from graphic_tmm.readers.table import columns_of
from graphic_tmm.readers.task_sheet import given_rows
from graphic_tmm.scene.read import read

ROCKER = 'stroke = "20 deg"\nfollower = "rocker"\nlever = "0.1 m"\ncentres = "0.13 m"\n'
SPEED = 'speed = "120 rpm"\n'


def part(path: Path) -> Drawn:
    return usual_part("cam", read(path))


def fast(folder: Path, more: str = "", *, rocker: bool = False) -> Drawn:
    law = ('law          = "sine"', f'law = "cosine"\n{SPEED}{more}')
    if not rocker:
        return part(edited(folder, law, name="cam"))
    held = [
        (line, "") for line in ('follower     = "roller"\n', 'r0           = "52.1 mm"', "height ")
    ]
    gone = [(old, new if old != "height " else "# ") for old, new in held]
    stroke = ('stroke       = "28 mm"\n', ROCKER)
    return part(edited(folder, law, stroke, *gone, name="cam"))


def test_what_is_calculated_beside_moves_no_mark_of_the_drawing() -> None:
    log = record(read(SHEETS / "cam" / "scene.toml"), "cam").construction
    beside = [step for step in log.steps if step.it.view == VIEW]
    others = [step for step in log.steps if step not in beside]
    assert min(step.it.slot for step in beside) > max(step.it.slot for step in others)
    assert not {step.it for step in beside} & {mark for step in others for mark in step.uses}


def test_dwells_are_told_in_radians() -> None:
    drawn = part(SHEETS / "cam" / "scene.toml")
    found = {k: float(drawn.reading[mark].item()) for k, mark in BESIDE.on(drawn).dwells.items()}
    assert found == {2: pytest.approx(math.radians(20)), 4: pytest.approx(math.radians(150))}
    assert BESIDE.on(drawn).velocity is None


def test_what_is_left_up_to_the_limits_is_what_a_dense_turn_leaves() -> None:
    """Pressure angle and curvature of the closed form at every 0.02° of the cam."""
    drawn = part(SHEETS / "cam" / "scene.toml")
    order, found = CAM_PLAN.on(drawn).order, single(results(drawn))
    dense = np.arange(0.0, 360.0, 0.02)
    alpha = pressure_angles(order, 0.0521, dense)
    assert found["left_rise"] == (pytest.approx(30.0 - alpha.max(), abs=0.05), "°")
    assert found["left_return"] == (pytest.approx(30.0 + alpha.min(), abs=0.05), "°")
    assert found["left_roller_r0"][0] == pytest.approx(0.4 * 0.0521 - 0.0168)
    sharpest = np.abs(curvatures(order, 0.0521, dense)).max()
    assert found["left_roller_profile"][0] == pytest.approx(0.7 / sharpest - 0.0168, rel=1e-3)


def test_that_all_limits_are_kept_is_told_in_words_and_only_then(tmp_path: Path) -> None:
    words = concluded(part(SHEETS / "cam" / "scene.toml"))[-1]
    assert words.startswith("All conditions of the cam hold")
    for figure in ("3.687", "1.213", "0.00404"):
        assert figure in words
    steep = part(edited(tmp_path, ('"52.1 mm"', '"45 mm"'), name="cam"))
    assert not [one for one in concluded(steep) if "All conditions" in one]
    flat = tmp_path / "flat"
    flat.mkdir()
    gone = ('transmission = "60 deg"', "#"), ('roller       = "16.8 mm"', "#")
    follower = ('"roller"', '"flat"'), ('r0           = "52.1 mm"', "#")
    told = concluded(part(edited(flat, *follower, *gone, name="cam")), "ru")
    assert "выпуклый" in told[-1]


@pytest.mark.parametrize("rocker", [False, True])
def test_the_followers_speeds_are_those_of_its_way_in_time(rocker: bool, tmp_path: Path) -> None:
    """Differences of the closed form S(ω·t) over milliseconds; where the acceleration jumps, none."""
    drawn = fast(tmp_path, rocker=rocker)
    made, omega = CAM_PLAN.on(drawn), 120.0 * math.pi / 30.0
    columns = {one.segment: one for one in columns_of(drawn)}
    names, units = (("omega", "eps"), ("1/s", "1/s²")) if rocker else (("v", "a"), ("m/s", "m/s²"))
    assert tuple(columns[name].unit for name in names) == units
    turn, step = made.diagrams.turn, 1e-4
    inside = [k for p in turn.phases for k in range(p.first + 1, p.last)]
    angles = np.array(turn.angles)[inside]
    way = [motion(made.order, angles + np.degrees(omega * t))[0] for t in (-step, 0.0, step)]
    speed = (way[2] - way[0]) / (2.0 * step)
    growth = (way[2] - 2.0 * way[1] + way[0]) / step**2
    for name, right in zip(names, (speed, growth), strict=True):
        found = columns[name].value[0][inside]
        np.testing.assert_allclose(found, right, atol=1e-4 * np.abs(right).max())
    assert ("n_1", 120.0) in [row[:2] for row in given_rows(drawn.scene, "cam")]


def test_the_derivatives_may_have_scales_of_their_own(tmp_path: Path) -> None:
    drawn = fast(tmp_path, 'mu_dS = "0.001 m/mm"\nmu_ddS = 0.002\n')
    made, found = CAM_PLAN.on(drawn), choices(drawn)
    for view, diagram, due in (("cam dS", "V", 0.001), ("cam ddS", "A", 0.002)):
        assert drawn.scales[view].value == due
        assert found.value(getattr(made.diagrams, diagram).chart.mu) == due
    turn = fast(tmp_path, 'mu_dS = "0.01 rad/mm"\n', rocker=True)
    assert turn.scales["cam dS"].value == 0.01
