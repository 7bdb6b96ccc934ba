"""The motion at any angles of the crank: against closed form, and against the drawing of the same scene."""

from __future__ import annotations

import numpy as np
import pytest
from support.gallery import SHEETS

import graphic_tmm
from graphic_tmm.errors import ConstructionError, SceneError
from graphic_tmm.scene.read import read

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


def test_only_the_points_asked_for_are_found() -> None:
    found = graphic_tmm.motion(read(SHEETS / "crank-rocker"), 40.0, ["E"])
    assert set(found.places) == set(found.velocities) == set(found.accelerations) == {("E", 2)}
    assert found.places["E", 2].shape == (1,)
    with pytest.raises(ConstructionError, match="no link has a point Q"):
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


def test_a_scene_without_a_mechanism_has_no_motion() -> None:
    with pytest.raises(SceneError, match="no mechanism"):
        graphic_tmm.motion(read(SHEETS / "gear-pair"), 0.0)


@pytest.mark.slow
def test_a_hand_that_slips_is_the_same_compiled_or_not() -> None:
    from dataclasses import replace

    scene = replace(read(SHEETS / "crank-rocker"), hand="student", seed=2)
    plain = graphic_tmm.motion(scene, ANGLES, ["E"])
    fast = graphic_tmm.motion(scene, ANGLES, ["E"], fast=True)
    np.testing.assert_array_equal(plain.accelerations["E", 2], fast.accelerations["E", 2])
    exact = graphic_tmm.motion(scene, ANGLES, ["E"], exact=True)
    assert np.abs(plain.places["E", 2] - exact.places["E", 2]).max() > 1e-5
