"""An eccentric, one circle about a centre beside the shaft: what its follower does, against closed forms."""

from __future__ import annotations

import math
import random
from dataclasses import replace
from pathlib import Path

import mpmath
import numpy as np
import pytest
from mpmath import mp
from support.arc_cams import KINDS, contour, drawn, lowest, place
from support.figures import assert_pictures_make_the_view, without_ink, without_source

import graphic_tmm
from graphic_tmm.board.execute import execute
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.arc_cam.ink import TRACELESS, ArcNames, draw_contour_ink
from graphic_tmm.chapters.arc_cam.plan import ARC_CAM_PLAN
from graphic_tmm.chapters.arc_cam.record import BESIDE
from graphic_tmm.chapters.arc_cam.scheme import scheme
from graphic_tmm.chapters.arc_cam.task import (
    ARC_CAM,
    FLAT,
    FLAT_ROCKER,
    ROCKER,
    ROLLER,
    ArcTask,
    Flank,
)
from graphic_tmm.errors import SceneError
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.seen import Subject
from graphic_tmm.project import record
from graphic_tmm.scene.records import Scene


def eccentric(draw: random.Random, kind: str) -> ArcTask:
    """An eccentric with a follower."""
    radius = draw.uniform(0.02, 0.04)
    e = draw.uniform(0.1, 0.6) * radius
    turns = draw.choice(("clockwise", "counterclockwise"))
    flank = Flank(None)
    order = ArcTask(radius - e, e, radius, flank, flank, turns=turns, parts=24, eccentric=True)
    roller = draw.uniform(0.2, 0.5) * radius
    if kind == "flat":
        return replace(order, follower=FLAT)
    if kind.startswith("tilted"):
        size = {"centres": 3.6 * radius, "same_sense": kind.endswith("along")}
        return replace(order, follower=FLAT_ROCKER, roller=0.3 * roller, **size)
    if kind in ("against", "along"):
        size = {"lever": 3.0 * radius, "centres": 3.6 * radius, "same_sense": kind == "along"}
        return replace(order, follower=ROCKER, roller=roller, **size)
    offset = draw.uniform(-0.3, 0.3) * order.base if kind == "offset" else 0.0
    return replace(order, follower=ROLLER, roller=0.0 if kind == "edge" else roller, offset=offset)


CASES = [(kind, seed) for kind in KINDS for seed in range(20)]


@pytest.mark.turns(12)
@pytest.mark.parametrize(("kind", "seed"), CASES)
def test_its_follower_stands_where_it_touches_the_circle(kind: str, seed: int) -> None:
    order = eccentric(random.Random(f"stands {kind} {seed}"), kind)
    made, _, reading = drawn(order)
    assert made.lie.work == pytest.approx(360.0, abs=1e-9)
    travel, lines, rest = reading[made.follower.travel][0], contour(order), lowest(order)
    for k in range(0, 25, 3):
        height = place(order, made.lie.changes[0] + made.angles[k], lines)
        if order.rocks:
            assert math.radians(travel[k]) == pytest.approx(height - rest, abs=2e-5)
        else:
            due = height - rest
            assert travel[k] * reading[made.contour.mu][0, 0] == pytest.approx(due, abs=1e-6)


def loop(order: ArcTask, gamma: mpmath.mpf) -> mpmath.mpf:
    """The follower's place by the loop O, C, B (and the lever's pivot); ``gamma``: of OC from above O."""
    e, reach = mp.mpf(order.distance), mp.mpf(order.nose) + mp.mpf(order.roller)
    if order.follower == FLAT:
        return e * mp.cos(gamma) + reach
    sense = 1 if order.turns == "counterclockwise" else -1
    if order.follower == ROLLER:
        x = -sense * e * mp.sin(gamma) - sense * mp.mpf(order.offset)
        return e * mp.cos(gamma) + mp.sqrt(reach**2 - x**2)
    # the lever lies on the side to which the cam's top goes, or on the other
    side = -1 if order.same_sense else 1
    across, down = e * mp.sin(gamma) * side, mp.mpf(order.centres) - e * mp.cos(gamma)
    far, arm = mp.sqrt(across**2 + down**2), mp.mpf(order.lever or 0)
    if order.follower == FLAT_ROCKER:
        return mp.atan2(across, down) + mp.asin(reach / far)
    return mp.atan2(across, down) + mp.acos((arm**2 + far**2 - reach**2) / (2 * arm * far))


@pytest.mark.turns(12)
@pytest.mark.parametrize(("kind", "seed"), CASES)
def test_its_linkage_gives_the_derivatives_of_the_closed_loop(kind: str, seed: int) -> None:
    order = eccentric(random.Random(f"loop {kind} {seed}"), kind)
    project = record(Scene("", "T", "en").asking(arc_cam=order), ARC_CAM)
    made, plans = ARC_CAM_PLAN.on(project), BESIDE.on(project).plans
    given = {**project.given, **{chart.mu: 0.001 for chart in made.charts.values()}}
    given |= dict(zip(plans.scales, (0.0003, 0.0007), strict=True))
    reading = execute(project.construction, given)

    def row(mark: object) -> Reals:
        return np.asarray(reading[mark][0], dtype=float)  # type: ignore[index]

    assert len(project.names) == 25
    with mp.workdps(30):
        for k, angle in enumerate(made.angles):
            gamma = mp.radians(mp.mpf(made.lie.changes[0]) + angle + 180)
            for n, mark in ((1, plans.first), (2, plans.second[0]), (2, plans.second[1])):
                due = float(mpmath.diff(lambda at: loop(order, at), gamma, n))
                assert row(mark)[k] == pytest.approx(due, rel=1e-9, abs=1e-9), (k, n)


@pytest.mark.parametrize("kind", KINDS)
def test_its_steps_are_its_ink(kind: str) -> None:
    made, log, reading = drawn(eccentric(random.Random(f"ink {kind}"), kind))
    names = ArcNames([str(k) for k in range(len(made.angles))], {"nose": "R"})
    view = finished(draw_contour_ink(Subject(log, reading, "X"), made, names))
    assert not without_ink(log, [view], TRACELESS)
    assert not without_source(view)
    assert_pictures_make_the_view(log, view)
    assert len([one for one in view.strokes if one.part == "contour"]) == 1


CIRCLE = 'radius = "30 mm"\neccentricity = "8 mm"\n'


def scene(folder: Path, rest: str) -> Path:
    found = folder / "scene.toml"
    found.write_text(f'title = "T"\nlanguage = "en"\n[arc_cam]\n{rest}\n')
    return found


def test_under_a_flat_face_it_moves_harmonically(tmp_path: Path) -> None:
    path = scene(
        tmp_path,
        'radius = "30 mm"\neccentricity = "10 mm"\nfollower = "flat"\nspeed = "600 rpm"\nparts = 12',
    )
    work = graphic_tmm.draw(path, exact=True)
    assert work.results["arc_stroke"].value == pytest.approx(0.020, rel=1e-9)
    omega = 20.0 * math.pi
    assert work.results["arc_v_max"].value == pytest.approx(0.01 * omega, rel=1e-9)
    assert work.results["arc_a_max"].value == pytest.approx(0.01 * omega**2, rel=1e-9)
    table = work.table("arc_cam")
    travel = np.asarray(table["S"].value, dtype=float)[0]
    assert travel == pytest.approx(0.01 * (1.0 - np.cos(np.arange(13) * np.pi / 6)), abs=1e-12)


def test_its_task_shows_radius_and_eccentricity() -> None:
    order = eccentric(random.Random("scheme"), "central")
    shown = scheme(Scene("", "T", "en").asking(arc_cam=order), 150 + 200j)
    assert shown is not None
    texts = {label.text for label in shown.view.labels}
    assert {"R", "e_{C}", "r"} <= texts
    assert not {"d", "r_{1}", "r_{2}"} & texts


@pytest.mark.parametrize(
    ("keys", "named"),
    [
        ('radius = "30 mm"', "eccentricity"),
        ('eccentricity = "8 mm"', "radius"),
        ('radius = "30 mm"\neccentricity = "8 mm"\nflank = "60 mm"', "flank"),
        ('radius = "30 mm"\neccentricity = "30 mm"', "eccentricity"),
        ('radius = "30 mm"\neccentricity = "8 mm"\noffset = "25 mm"', "offset"),
        ('base = "20 mm"\nflank = "60 mm"', "distance"),
        (f'{CIRCLE}accelerations = ["I"]', "accelerations"),
        (f'{CIRCLE}follower = "flat rocker"', "centres"),
        (f'{CIRCLE}follower = "flat rocker"\ncentres = "80 mm"\nlever = "60 mm"', "lever"),
        (f'{CIRCLE}follower = "flat"\nface = "6 mm"', "face"),
    ],
)
def test_what_does_not_go_together_is_refused_by_its_key(
    keys: str, named: str, tmp_path: Path
) -> None:
    with pytest.raises(SceneError, match=rf"arc_cam\W+{named}") as found:
        graphic_tmm.draw(scene(tmp_path, keys))
    assert "changes of arcs" not in str(found.value)
