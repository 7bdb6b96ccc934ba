"""The motion at any angles of the crank: against closed form, and against the drawing of the same scene."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from support.driven_scenes import ROCKER, scene
from support.gallery import SHEETS
from support.linkages import four_bar

import graphic_tmm
from graphic_tmm.board import execute
from graphic_tmm.board.compile import run
from graphic_tmm.board.compile.run import LEAST
from graphic_tmm.errors import ConstructionError, SceneError
from graphic_tmm.readers.any_angles import motion, ready
from graphic_tmm.readers.any_angles.results import Motion
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene

ANGLES = np.linspace(-30.0, 400.0, 1001)
OMEGA, CRANK, ROD = 50.0, 0.3, 0.64
"""The scene `engine`: in line, counter-clockwise."""


def test_the_piston_of_an_engine_moves_by_the_closed_form() -> None:
    found = graphic_tmm.motion(read(SHEETS / "engine"), ANGLES, exact=True)
    phi = np.radians(ANGLES)
    a = CRANK * np.exp(1j * phi)
    reach = np.sqrt(ROD**2 - a.imag**2)
    omega = -OMEGA * a.real / reach
    epsilon = (OMEGA**2 * a.imag + omega**2 * -a.imag) / reach
    x = a.real + reach
    v = -OMEGA * a.imag + omega * a.imag
    acceleration = -(OMEGA**2) * a.real + epsilon * a.imag - omega**2 * reach
    np.testing.assert_array_equal(found.angles, ANGLES)
    np.testing.assert_allclose(found.places["B", 3], x, atol=1e-12)
    np.testing.assert_allclose(found.velocities["B", 3], v, atol=1e-11)
    np.testing.assert_allclose(found.accelerations["B", 3], acceleration, atol=1e-9)
    np.testing.assert_allclose(found.omega[2], omega, atol=1e-11)
    np.testing.assert_allclose(found.epsilon[2], epsilon, atol=1e-9)


def test_what_is_read_with_the_ruler_is_off_by_half_a_division_at_most() -> None:
    scene = read(SHEETS / "engine")
    assert scene.ruler == 0.1
    read_, exact = graphic_tmm.motion(scene, ANGLES), graphic_tmm.motion(scene, ANGLES, exact=True)
    off = np.abs(read_.omega[2] - exact.omega[2])
    # ω2 = ab·μ_v / l, and μ_v = μ_l·ω1 with pa = OA = 60 mm
    assert 0.0 < off.max() <= 0.05 * (CRANK / 60.0) * OMEGA / ROD * (1 + 1e-6)


def test_places_are_those_of_the_frames_axes_wherever_the_crank_turns() -> None:
    """A four-bar whose shaft is not the origin, drawn to a scale: lengths and places are those given."""
    r, rod, rocker, shaft, pivot = 0.1, 0.3, 0.25, 0.5 + 0.2j, 0.85 + 0.3j
    mechanism = four_bar(r, rod, rocker, 0j)
    frame = replace(mechanism.frame, points={"O": shaft, "C": pivot})
    scene = Scene("moved", "", "en", replace(mechanism, frame=frame))
    found = graphic_tmm.motion(scene, ANGLES[::50])
    a, b = (found.places[at] for at in (("A", 1), ("B", 2)))
    np.testing.assert_allclose(a - shaft, r * np.exp(1j * np.radians(ANGLES[::50])), atol=1e-9)
    np.testing.assert_allclose(np.abs(b - a), rod, atol=1e-9)
    np.testing.assert_allclose(np.abs(b - pivot), rocker, atol=1e-9)


def test_only_the_points_asked_for_are_found() -> None:
    found = graphic_tmm.motion(read(SHEETS / "crank-rocker"), 40.0, ["E"])
    assert set(found.places) == set(found.velocities) == set(found.accelerations) == {("E", 2)}
    assert found.places["E", 2].shape == (1,)
    with pytest.raises(
        ConstructionError, match="no link has a point Q; there are O, C, A, B, E, S2, S3"
    ):
        graphic_tmm.motion(read(SHEETS / "crank-rocker"), 40.0, ["E", "Q"])


@pytest.mark.parametrize("name", ["windrower", "crank-rocker", "oscillating-cylinder"])
def test_velocities_are_the_rates_of_places(name: str) -> None:
    """Central differences: their error is h²/6 of the third derivative, h the step in time."""
    scene = read(SHEETS / name)
    assert scene.mechanism is not None
    speed = scene.mechanism.drive.speed
    middle, step = np.linspace(5.0, 355.0, 36), 0.01
    three = [graphic_tmm.motion(scene, middle + k * step, exact=True) for k in (-1, 0, 1)]
    time = 2 * np.radians(step) / speed
    for point, place in three[2].places.items():
        if place.size == 1:
            continue
        for rising, due in (("places", "velocities"), ("velocities", "accelerations")):
            values = [getattr(one, rising)[point] for one in (three[0], three[2])]
            rate = (values[1] - values[0]) / time
            found = getattr(three[1], due)[point]
            assert np.abs(rate - found).max() <= 1e-5 * np.abs(found).max(), (point, due)


def test_a_scene_of_nothing_that_moves_has_no_motion() -> None:
    with pytest.raises(SceneError, match="no mechanism"):
        graphic_tmm.motion(read(SHEETS / "lettering"), 0.0)


@pytest.mark.slow
def test_a_hand_that_slips_is_the_same_compiled_or_not() -> None:
    scene = replace(read(SHEETS / "crank-rocker"), hand="student", seed=2)
    plain = graphic_tmm.motion(scene, ANGLES, ["E"])
    fast = graphic_tmm.motion(scene, ANGLES, ["E"], fast=True)
    np.testing.assert_array_equal(plain.accelerations["E", 2], fast.accelerations["E", 2])
    exact = graphic_tmm.motion(scene, ANGLES, ["E"], exact=True)
    assert np.abs(plain.places["E", 2] - exact.places["E", 2]).max() > 1e-5


def every(found: Motion) -> list[np.ndarray]:
    tables = (found.places, found.velocities, found.accelerations, found.omega, found.epsilon)
    return [one for table in tables for one in table.values()]  # type: ignore[attr-defined]


def test_everything_has_full_length_and_constants_take_no_memory() -> None:
    found = graphic_tmm.motion(read(SHEETS / "windrower"), ANGLES)
    assert {one.shape for one in every(found)} == {ANGLES.shape}
    assert found.places["O", 1].strides == (0,)
    np.testing.assert_allclose(found.omega[1], 380.0 * math.pi / 30.0, rtol=1e-12)
    assert found.omega[1].strides == (0,)


def test_a_point_of_two_links_that_are_pinned_is_one_array() -> None:
    found = graphic_tmm.motion(read(SHEETS / "windrower"), ANGLES)
    assert found.places["C", 3] is found.places["C", 4]
    assert found.velocities["C", 3] is found.velocities["C", 4]
    point = found["C"]
    assert point.place is found.places["C", 3]
    assert point.velocity is found.velocities["C", 4]
    assert point.acceleration is found.accelerations["C", 4]
    assert found["D", 5].place is found["D"].place
    assert "C" in found
    assert ("C", 3) in found
    assert "Q" not in found
    assert "omega 1, 3, 2, 4" in repr(found)
    assert repr(point) == "<point C of link 3 at 1001 angles>"


def test_links_that_differ_in_their_point_are_told_apart() -> None:
    scene = read(SHEETS / "windrower")
    found = graphic_tmm.motion(scene, ANGLES)
    apart = replace(found, velocities={**found.velocities, ("C", 4): found.velocities["D", 5]})
    with pytest.raises(ConstructionError, match=r"say of which it is, \('C', 3\), \('C', 4\)"):
        apart["C"]
    assert apart["C", 4].velocity is found.velocities["D", 5]
    with pytest.raises(ConstructionError, match="no point Q; there are O, B"):
        found["Q"]
    with pytest.raises(ConstructionError, match=r"no point \('D', 3\)"):
        found["D", 3]


def test_no_plan_is_run_that_nobody_asked_for() -> None:
    found = graphic_tmm.motion(read(SHEETS / "windrower"), ANGLES, "D", plans=["velocities"])
    assert set(found.velocities) == {("D", 4), ("D", 5)}
    assert not any(map(len, (found.places, found.accelerations, found.epsilon, found.forces)))
    with pytest.raises(
        ConstructionError, match=r'positions were not asked for: write plans=\["pos'
    ):
        _ = found["D"].place
    for one in (found.forces, found.balance):
        with pytest.raises(
            ConstructionError, match=r'forces were not asked for: write plans=\["for'
        ):
            dict(one)
        with pytest.raises(ConstructionError, match="forces were not asked for"):
            one["R12"]
        assert "forces were not asked for" in repr(one)
    with pytest.raises(ConstructionError, match="there is no plan speeds; there are positions"):
        graphic_tmm.motion(read(SHEETS / "windrower"), 0.0, plans=["speeds"])  # type: ignore[list-item]
    with pytest.raises(ConstructionError, match=r"asks for no forces: write \[forces\]"):
        graphic_tmm.motion(read(SHEETS / "crank-rocker"), 0.0, plans=["forces"])


def test_a_scene_is_recorded_once(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = read(SHEETS / "crank-rocker")
    first = graphic_tmm.motion(scene, ANGLES, exact=True)
    monkeypatch.setattr(motion, "record_project", None)
    monkeypatch.setattr(ready, "prepare", None)
    again = graphic_tmm.motion(scene, ANGLES, exact=True)
    np.testing.assert_array_equal(first["E"].acceleration, again["E"].acceleration)
    some = graphic_tmm.motion(scene, ANGLES[5:9], exact=True)
    np.testing.assert_allclose(some["E"].place, first["E"].place[5:9], rtol=1e-14)


def test_angles_of_every_shape() -> None:
    scene = read(SHEETS / "windrower")
    due = graphic_tmm.motion(scene, ANGLES, exact=True)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        one = graphic_tmm.motion(scene, float(ANGLES[3]), exact=True)
        none = graphic_tmm.motion(scene, [], exact=True)
        odd = graphic_tmm.motion(scene, [math.nan, math.inf, 10.0, -math.inf], exact=True)
    np.testing.assert_allclose(one["D"].place, due["D"].place[3:4], rtol=1e-14)
    assert {array.shape for array in every(none)} == {(0,)}
    assert np.isfinite(odd["D"].acceleration).tolist() == [False, False, True, False]
    np.testing.assert_array_equal(odd.angles, [math.nan, math.inf, 10.0, -math.inf])
    with pytest.raises(ConstructionError, match=r"a number or a row, not \(1, 2\)"):
        graphic_tmm.motion(scene, [[1.0, 2.0]])
    with pytest.raises(ConstructionError, match="angles are numbers"):
        graphic_tmm.motion(scene, ["a"])


def test_where_nothing_assembles_there_is_nothing() -> None:
    scene = read(SHEETS / "crank-rocker")
    assert scene.mechanism is not None
    first, *links = scene.mechanism.links
    long = {letter: 3.0 * at for letter, at in first.points.items()}
    mechanism = replace(scene.mechanism, links=(replace(first, points=long), *links))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = graphic_tmm.motion(replace(scene, mechanism=mechanism), ANGLES, exact=True)
    reached = np.isfinite(found["B"].place)
    assert reached.any()
    assert not reached.all()
    assert np.isfinite(found["A"].place).all()
    np.testing.assert_array_equal(np.isfinite(found.epsilon[3]), reached)


@pytest.mark.parametrize("times", [1e-9, 1e9])
def test_size_changes_nothing(times: float) -> None:
    scene = read(SHEETS / "crank-rocker")
    assert scene.mechanism is not None
    moved = 3.0 - 2.0j
    bodies = [
        replace(link, points={k: times * at for k, at in link.points.items()})
        for link in scene.mechanism.links
    ]
    base = scene.mechanism.frame
    frame = replace(base, points={k: times * (at + moved) for k, at in base.points.items()})
    mechanism = replace(scene.mechanism, frame=frame, links=tuple(bodies))
    due = graphic_tmm.motion(scene, ANGLES, exact=True)
    found = graphic_tmm.motion(replace(scene, mechanism=mechanism), ANGLES, exact=True)
    for quantity in ("places", "velocities", "accelerations"):
        offset = times * moved if quantity == "places" else 0.0
        for key, one in getattr(due, quantity).items():
            off = np.abs(getattr(found, quantity)[key] - offset - times * one).max()
            assert off <= 1e-12 * times * np.abs(one).max() + 1e-15 * abs(offset), (quantity, key)


@pytest.mark.parametrize("exact", [False, True])
def test_compiled_it_is_the_same(exact: bool) -> None:
    pytest.importorskip("llvmlite")
    scene = read(SHEETS / "windrower")
    plain, fast = (
        graphic_tmm.motion(scene, ANGLES, ["D"], exact=exact, fast=one) for one in (False, True)
    )
    for one, other in zip(every(plain), every(fast), strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-12, atol=1e-12 * np.abs(one).max())


class Ways:
    """Which ways the steps of a log were run: compiled, or by numpy."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.ran = list[str]()
        for way, of, name in (
            ("bound", run.Bound, "run"),
            ("loops", run, "in_loops"),
            ("steps", execute, "in_blocks"),
        ):
            monkeypatch.setattr(of, name, self.counted(way, getattr(of, name)))

    def counted(self, way: str, real: Callable[..., Any]) -> Callable[..., Any]:
        def called(*asked: Any, **named: Any) -> Any:
            self.ran.append(way)
            return real(*asked, **named)

        return called


@pytest.mark.parametrize("installed", [True, False])
@pytest.mark.parametrize("fast", [None, True, False])
@pytest.mark.parametrize("count", [1, 9, 300, 40_000])
def test_a_log_is_compiled_at_any_number_of_angles_if_nobody_says(
    monkeypatch: pytest.MonkeyPatch, count: int, fast: bool | None, installed: bool
) -> None:
    """By what is installed and what is asked for, whatever was asked for before."""
    scene, angles = read(SHEETS / "crank-rocker"), np.linspace(0.0, 360.0, count)
    plain = graphic_tmm.motion(scene, angles, ["B"], fast=False, exact=True)
    monkeypatch.setattr(motion, "translator", lambda: installed)
    ways = Ways(monkeypatch)
    for _ in range(2):
        found = graphic_tmm.motion(scene, angles, ["B"], fast=fast, exact=True)
    compiles = installed if fast is None else fast
    due = ("bound" if count < LEAST else "loops") if compiles else "steps"
    assert ways.ran == 2 * [due]
    largest = float(np.abs(plain["B"].acceleration).max())
    assert np.abs(found["B"].acceleration - plain["B"].acceleration).max() <= 1e-12 * largest


@pytest.mark.parametrize("zero", [-100.0, 30.0, 250.0])
def test_a_load_over_two_turns_begins_at_the_zero_position_as_the_scene_says_it(
    zero: float,
) -> None:
    """A turn later the crank stands where it stood, and the load is another."""
    drive = f'speed = "10 rad/s"\npositions = 8\nzero = "{zero} deg"\n'
    load = '[[load]]\nlink = 1\nby_angle = [[0, "1 N*m"], [720, "721 N*m"]]\n'
    forces = '[forces]\npositions = [1]\nbalance = "moment"\n'
    turned = np.array([10.0, 200.0, 370.0, 560.0, 730.0])
    found = graphic_tmm.motion(
        scene(ROCKER, drive + load + forces), zero + turned, plans=("forces",)
    )
    due = -(1.0 + turned % 720.0)
    np.testing.assert_allclose(found.balance["M_bal_forces"], due, rtol=1e-9)
