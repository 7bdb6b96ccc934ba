"""The motion where a drive slides: against closed form, against power, compiled against step by step."""

from __future__ import annotations

import warnings

import numpy as np
import pytest
from support.drives import BOOM, LEVER, RACK, SLIDER, rated, scene

import graphic_tmm
from graphic_tmm.errors import ConstructionError
from graphic_tmm.readers.any_angles.turn import Plan

ALL: tuple[Plan, ...] = ("positions", "velocities", "accelerations", "forces")


def test_a_boom_turns_by_the_law_of_cosines() -> None:
    length = np.linspace(0.55, 0.88, 101)
    found = graphic_tmm.motion(scene(BOOM), length, exact=True)
    og, on, speed, gain = 0.4, 0.5, 0.05, 0.3
    angle = np.arccos((og**2 + on**2 - length**2) / (2 * og * on))
    omega = length * speed / (og * on * np.sin(angle))
    epsilon = (speed**2 + length * gain) / (og * on * np.sin(angle))
    epsilon -= omega**2 / np.tan(angle)
    np.testing.assert_allclose(found["C"].place, np.exp(1j * angle), atol=1e-12)
    np.testing.assert_allclose(found.omega[1], omega, rtol=1e-11)
    np.testing.assert_allclose(found.epsilon[1], epsilon, rtol=1e-9)
    np.testing.assert_array_equal(found.at, length)


@pytest.mark.parametrize(
    ("text", "link", "point", "ends"),
    [
        (BOOM, 1, "C", (0.55, 0.88)),
        (SLIDER, 3, "A", (0.24, 0.37)),
        (LEVER, 3, "B", (20.0, 75.0)),
        (RACK, 3, "B", (0.01, 0.12)),
    ],
)
def test_what_drives_has_the_power_of_the_load(
    text: str, link: int, point: str, ends: tuple[float, float]
) -> None:
    one, at = scene(text, link, point), np.linspace(*ends, 57)
    assert one.mechanism is not None
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        slow, fast = (
            graphic_tmm.motion(one, at, plans=ALL, exact=True, fast=fast) for fast in (False, True)
        )
    rate = 0.1 * slow.omega[1] if text in (LEVER, RACK) else one.mechanism.drive.speed
    power = (np.conj(-500j) * slow[point, link].velocity).real
    for name in ("forces", "lever"):
        kind = next(key for key in slow.balance if key.endswith(name))
        np.testing.assert_allclose(
            slow.balance[kind] * rate, -power, atol=1e-9 * np.abs(power).max()
        )
    for quantity in ("places", "velocities", "accelerations", "omega", "epsilon", "forces"):
        steps, compiled = getattr(slow, quantity), getattr(fast, quantity)
        assert steps.keys() == compiled.keys()
        for key, row in steps.items():
            np.testing.assert_allclose(compiled[key], row, rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("text", [BOOM, SLIDER, LEVER, RACK])
def test_rates_that_are_listed_hold_at_their_positions_and_between_in_proportion(text: str) -> None:
    one = scene(rated(text))
    assert one.row.ends is not None
    at = np.linspace(*one.row.ends, 11)
    found = graphic_tmm.motion(one, at, exact=True)
    sheet = graphic_tmm.draw(one, exact=True)
    for table, quantity, letter in (
        ("velocities", found.omega, "omega2"),
        ("accelerations", found.epsilon, "epsilon2"),
    ):
        due = sheet.table(table)[letter].value.ravel()
        np.testing.assert_allclose(quantity[2][::2], due, rtol=1e-9, atol=1e-9)


def test_lengths_are_named_so() -> None:
    pytest.importorskip("pandas")
    found = graphic_tmm.motion(scene(BOOM), [0.6, 0.7], exact=True)
    assert np.isnan(found.angles).all()
    assert repr(found).startswith("<motion at 2 lengths: ")
    assert list(found.to_pandas()["length_m"]) == [0.6, 0.7]
    assert "angle_deg" not in found.to_pandas()


def test_the_earlier_name_of_the_places_is_understood() -> None:
    one = scene(LEVER)
    new, old = graphic_tmm.motion(one, [30.0]), graphic_tmm.motion(one, angles=[30.0])
    np.testing.assert_array_equal(new.omega[3], old.omega[3])
    with pytest.raises(ConstructionError, match="say where the drive stands"):
        graphic_tmm.motion(one)
