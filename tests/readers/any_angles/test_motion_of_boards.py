"""Motion of cams, trains and pairs at any angle: against closed forms, contact and rolling."""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support import arc_cams, cams
from support import train_oracle as rolling
from support.gallery import SHEETS
from support.scenes import written

import graphic_tmm
from graphic_tmm.chapters.arc_cam.task import ArcTask
from graphic_tmm.chapters.cam.kinds import FlatFollower, FlatRockerFollower, RockerFollower
from graphic_tmm.chapters.cam.kinds import RollerFollower as Roller
from graphic_tmm.chapters.cam.plan import CAM_PLAN
from graphic_tmm.chapters.cam.task import CamTask
from graphic_tmm.chapters.cam.task_motion import Law, Stage
from graphic_tmm.chapters.gears.task import GearTask
from graphic_tmm.chapters.trains.motion import motion_of
from graphic_tmm.chapters.trains.task import PlanetaryTask
from graphic_tmm.errors import ConstructionError
from graphic_tmm.readers.any_angles.results import Motion
from graphic_tmm.readers.table import columns_of
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make

LAWS = (
    *(Law(name) for name in cams.SHAPES),
    Law("constant acceleration", shares=(2.0, 1.0)),
)
FOLLOWERS = {
    "central": Roller(),
    "offset": Roller(0.006),
    "against": RockerFollower(0.1, 0.13, same_sense=False),
    "along": RockerFollower(0.1, 0.13, same_sense=True),
    "flat": FlatFollower(0.004),
    "flat rocker": FlatRockerFollower(0.12, 0.01, 0.004, False),
}
SPEED = 20.0


def scene(**tasks: Any) -> Scene:
    return Scene("boards", "", "en", tasks=tasks)


def at(angles: Any, *, exact: bool = True, **tasks: Any) -> Motion:
    return graphic_tmm.motion(scene(**tasks), angles, exact=exact)


def lifts(draw: random.Random, kind: str) -> CamTask:
    """Two lifts, the first of both, a fall between, and rests."""
    most = {"against": 0.2, "along": 0.2, "flat rocker": 0.1}.get(kind, 0.02)
    rows: list[dict[str, Any]] = [
        {"rise": draw.uniform(75, 95), "stroke": most},
        {"dwell": draw.uniform(5, 15)},
        {"fall": draw.uniform(55, 65), "stroke": 0.4 * most},
        {"rise": draw.uniform(50, 60), "stroke": 0.2 * most},
        {"fall": draw.uniform(85, 95), "stroke": 0.8 * most},
    ]
    for row in rows:
        if "dwell" not in row:
            row["law"] = draw.choice(LAWS)
    rest = 360.0 - sum(v for row in rows for k, v in row.items() if k in ("rise", "dwell", "fall"))
    return CamTask(
        most, 0.0, 0.0, 0.0, 0.0, phases=tuple(Stage(**row) for row in (*rows, {"dwell": rest})),
        follower=FOLLOWERS[kind], turns=draw.choice(("clockwise", "counterclockwise")),
        pressure=50.0, speed=SPEED, roller=0.004 if kind in ("central", "offset") else None,
    )  # fmt: skip


def away_from_ends(order: CamTask, angles: np.ndarray) -> np.ndarray:
    """Leave out what lies next to a jump of an acceleration, where two values are right."""
    ends = np.array(
        [
            one.start + one.extent * share
            for one in cams.stages(order)
            for share in (0.0, 1 / 6, 0.5, 2 / 3, 1 / 3, 5 / 6, 1.0)
        ]
    )
    near = np.abs((angles[:, None] - ends + 180.0) % 360.0 - 180.0).min(axis=1)
    return angles[near > 1e-6]


@pytest.mark.parametrize("kind", FOLLOWERS)
def test_a_cam_moves_its_follower_by_its_laws(kind: str, many: Callable[[int, int], int]) -> None:
    draw = random.Random(f"motion {kind}")
    for _ in range(many(30, 2)):
        order = lifts(draw, kind)
        angles = away_from_ends(order, np.random.default_rng(3).uniform(-500.0, 900.0, 700))
        found, due = at(angles, cam=order), cams.motion(order, angles)
        names = ("omega", "eps") if order.rocks else ("v", "a")
        times = (SPEED, SPEED**2)
        for name, one in zip(("S", "dS", "ddS"), due, strict=True):
            np.testing.assert_allclose(found.columns[name], one, atol=1e-9 * np.abs(one).max())
        for name, by, one in zip(names, times, due[1:], strict=True):
            np.testing.assert_allclose(found.columns[name], by * one, rtol=1e-9, atol=1e-9 * by)


@pytest.mark.parametrize("kind", [k for k in FOLLOWERS if not k.startswith("flat")])
def test_the_pressure_angle_and_the_points_of_both_profiles(kind: str) -> None:
    """The roller's centre by trigonometry; K stands a radius from it, square to the way of the centre."""
    order = lifts(random.Random(f"profile {kind}"), kind)
    of = cams.made(order)
    angles, step = np.random.default_rng(4).uniform(0.0, 360.0, 300), 1e-4
    angles = away_from_ends(order, angles)
    found, behind, ahead = (at(angles + by, cam=order) for by in (0.0, -step, step))
    alpha = cams.pressure_angles(order, of.one(of.cam.r0), angles)
    np.testing.assert_allclose(found.columns["pressure"], alpha, atol=1e-6)
    centre, contact = found.profile["B"], found.profile["K"]
    due = cams.place_of(of, angles)(cams.motion(order, angles)[0])
    np.testing.assert_allclose(centre, due, atol=1e-9)
    assert of.cam.roller is not None
    np.testing.assert_allclose(np.abs(contact - centre), of.one(of.cam.roller.radius), atol=1e-9)
    way = ahead.profile["B"] - behind.profile["B"]
    slope = ((contact - centre) * np.conj(way)).real / np.abs(way)
    assert np.abs(slope).max() <= 1e-7
    assert (np.abs(contact) < np.abs(centre)).all()


def test_a_flat_face_touches_the_points_and_none_lies_above_it() -> None:
    order = lifts(random.Random("face"), "flat")
    angles = np.linspace(0.0, 360.0, 1441)
    found, of = at(angles, cam=order), cams.made(order)
    sense = 1.0 if order.turns == "counterclockwise" else -1.0
    for k in range(0, 1441, 60):
        turned = found.profile["K"] * np.exp(1j * sense * np.radians(angles[k]))
        assert turned[k].imag == pytest.approx(of.one(of.cam.r0) + found.columns["S"][k], abs=1e-9)
        assert turned.imag.max() <= turned[k].imag + 1e-9


def test_a_law_that_is_integrated_is_read_off_its_curves() -> None:
    points = ((0.0, 0.0), (0.25, 1.0), (0.5, 0.0), (0.75, -1.0), (1.0, 0.0))
    law = Law("diagram", points)
    order = CamTask(0.03, 120.0, 30.0, 120.0, 90.0, rise_law=law, return_law=law, pressure=45.0)
    angles = np.linspace(0.5, 359.5, 901)
    found, due = at(angles, cam=order), cams.motion(order, angles)
    for name, one in zip(("S", "dS", "ddS"), due, strict=True):
        off = np.abs(found.columns[name] - one).max() / np.abs(one).max()
        assert off < 2e-3, name


@pytest.mark.parametrize("exact", [False, True])
def test_at_the_positions_it_is_what_the_table_has(exact: bool) -> None:
    """Two lifts; a lever with a spring, whose forces are told, too."""
    as_in_the_table(read(SHEETS / "two-lifts"), exact=exact)
    one = read(SHEETS / "flat-rocker-cam")
    as_in_the_table(one, exact=exact)
    assert {*"PNM"} < set(graphic_tmm.motion(one, 0.0, exact=exact).columns)


@pytest.mark.parametrize("kind", ["offset", "along", "flat", "edge", "against"])
def test_at_the_end_of_the_lift_it_is_what_the_table_has(kind: str) -> None:
    """The table tells its angles rounded: some of them just behind the lift."""
    for k in range(3):
        order = arc_cams.random_order(random.Random(f"{kind} {k}"), kind, "convex")
        as_in_the_table(scene(arc_cam=replace(order, speed=SPEED)), exact=True)


def as_in_the_table(one: Scene, *, exact: bool) -> None:
    (board,) = make(one, exact=exact).boards
    columns = {c.segment: c for c in columns_of(board)}
    places = np.array([p for _, p in columns["S"].at], dtype=float)
    found = graphic_tmm.motion(one, places, exact=exact)
    for name, row in found.columns.items():
        value = np.ravel(columns[name].value)
        np.testing.assert_allclose(row, value, atol=1e-9 * np.abs(value).max(), err_msg=name)


@pytest.mark.parametrize(("format", "r0"), [("A4", 0.023), ("A1", 0.024)])
def test_it_is_the_cam_of_its_own_sheet(tmp_path: Path, format: str, r0: float) -> None:
    """To a smaller scale the least radius reads otherwise, and another whole millimetre is chosen."""
    text = 'title = "T"\nlanguage = "en"\n[cam]\nstroke = "19 mm"\nrise = "120 deg"\n'
    text += 'upper_dwell = "30 deg"\nfall = "120 deg"\n[[sheet]]\nplace = ["cam"]\n'
    one = read(written(tmp_path, f'{text}format = "{format}"\n'))
    (board,) = make(one).boards
    assert board.value(CAM_PLAN.on(board).r0) == pytest.approx(r0)
    found = graphic_tmm.motion(one, 0.0)
    assert abs(found.profile["B"][0]) == pytest.approx(r0)


@pytest.mark.parametrize("flank", ["convex", "straight", "hollow", "unlike"])
@pytest.mark.parametrize("kind", ["offset", "against", "tilted", "flat"])
def test_a_cam_of_arcs_lifts_what_is_lowered_onto_it(kind: str, flank: str) -> None:
    if kind in arc_cams.FLATS and flank in ("hollow", "straight"):
        kind = "central"
    order: ArcTask = arc_cams.random_order(random.Random(f"{kind} {flank} any"), kind, flank)
    order = replace(order, speed=SPEED)
    made, _, _ = arc_cams.drawn(order)
    first, work = made.lie.changes[0], made.lie.work
    angles = np.linspace(0.013, 0.987, 9) * work
    found = at(np.append(angles, [work + 5.0, -3.0]), arc_cam=order)
    lines = arc_cams.contour(order)
    high = [arc_cams.place(order, first + phi, lines) for phi in angles]
    due = np.array(high) - arc_cams.lowest(order)
    np.testing.assert_allclose(found.columns["S"][:-2], due, atol=2e-7)
    for name, row in found.columns.items():
        if name != "pressure":
            assert np.abs(row[-2:]).max() <= 1e-9 * np.abs(row).max(), name


@pytest.mark.parametrize("kind", ["offset", "along", "tilted along", "flat", "edge"])
def test_derivatives_on_arcs_are_those_of_the_places(kind: str) -> None:
    """Central differences of S, and of dS, away from changes of arcs."""
    order = arc_cams.random_order(random.Random(f"{kind} rates"), kind, "convex")
    order = replace(order, speed=SPEED)
    lie, step = arc_cams.drawn(order)[0].lie, 1e-3
    angles = np.linspace(0.02, 0.98, 57) * lie.work
    changes = np.array(lie.changes) - lie.changes[0]
    angles = angles[np.abs(angles[:, None] - changes).min(axis=1) > 0.01]
    found, behind, ahead = (at(angles + by, arc_cam=order).columns for by in (0.0, -step, step))
    names = ("omega", "eps") if order.rocks else ("v", "a")
    for name, rate in (("S", "dS_K"), ("dS_K", "ddS_K")):
        slope = (ahead[name] - behind[name]) / (2.0 * np.radians(step))
        assert np.abs(slope - found[rate]).max() <= 1e-6 * np.abs(slope).max(), rate
    np.testing.assert_allclose(found[names[0]], SPEED * found["dS_K"], rtol=1e-12)
    np.testing.assert_allclose(found[names[1]], SPEED**2 * found["ddS_K"], rtol=1e-12)


@pytest.mark.parametrize("scheme", ["ring", "external-internal", "3K"])
def test_wheels_of_a_train_turn_as_they_roll(scheme: str) -> None:
    draw = random.Random(f"angles {scheme}")
    teeth = rolling.random_teeth(draw, scheme)
    order = PlanetaryTask(scheme, 0.004, 30.0, teeth=teeth, satellites=(1,))
    angles = np.array([0.0, 30.0, -100.0, 4000.0, np.nan])
    found = at(angles, planetary=order).columns
    driven = {name.removeprefix("planetary_phi_") for name in found if "_phi_" in name}
    due = rolling.solved(scheme, teeth, {"1": Fraction(1), motion_of(order).fixed: Fraction(0)})
    assert due is not None
    for body in driven:
        phi, n = found[f"planetary_phi_{body}"], found[f"planetary_n_{body}"]
        np.testing.assert_allclose(phi, float(due[body]) * angles, rtol=1e-9)
        np.testing.assert_allclose(n, float(due[body]) * 30.0 * 30.0 / np.pi, rtol=1e-9)


@pytest.mark.parametrize(("z2", "share"), [(30, -0.5), (-60, 0.25)])
def test_both_wheels_of_a_pair_turn_by_their_teeth(z2: int, share: float) -> None:
    order = GearTask(15, z2, 0.004, x1=0.3 if z2 > 0 else 0.0, speed=10.0)
    found = at([0.0, 20.0, -1000.0], gears=order).columns
    np.testing.assert_allclose(found["phi1"], [0.0, 20.0, -1000.0])
    np.testing.assert_allclose(found["phi2"], share * found["phi1"], rtol=1e-12)
    np.testing.assert_allclose(found["n2"], abs(share) * found["n1"], rtol=1e-12)


def test_a_rack_runs_on_with_its_wheel() -> None:
    order = GearTask(20, "rack", 0.005, speed=10.0)
    found = at([0.0, 36.0, -720.0], gears=order).columns
    np.testing.assert_allclose(found["s2"], np.pi * 0.1 * np.array([0.0, 0.1, -2.0]), rtol=1e-12)
    assert set(found) == {"phi1", "n1", "s2"}


def test_compiled_a_cam_moves_the_same() -> None:
    pytest.importorskip("llvmlite")
    one, angles = read(SHEETS / "cam"), np.linspace(0.0, 720.0, 5001)
    plain, fast = (graphic_tmm.motion(one, angles, fast=way) for way in (False, True))
    for name in plain.columns:
        np.testing.assert_allclose(fast.columns[name], plain.columns[name], atol=1e-12)
    np.testing.assert_allclose(fast.profile["K"], plain.profile["K"], atol=1e-12)


def test_a_board_is_asked_for_by_the_name_of_its_section() -> None:
    one = read(SHEETS / "project")
    cam = graphic_tmm.motion(one, [40.0, np.nan], plans="cam")
    assert np.isfinite(cam.columns["S"]).tolist() == [True, False]
    assert "columns S, dS, ddS" in repr(cam)
    mechanism = graphic_tmm.motion(one, 40.0)
    assert not mechanism.columns
    assert mechanism.places
    with pytest.raises(ConstructionError, match="cam, gears turn with shafts of their own"):
        graphic_tmm.motion(one, 0.0, plans=("cam", "gears"))
    with pytest.raises(ConstructionError, match=r"asks for no arc_cam: write \[arc_cam\]"):
        graphic_tmm.motion(one, 0.0, plans="arc_cam")
    with pytest.raises(ConstructionError, match="no plan wheels; there are positions"):
        graphic_tmm.motion(one, 0.0, plans="wheels")
    assert not at([], gears=GearTask(15, 30, 0.004)).columns["phi2"].size
