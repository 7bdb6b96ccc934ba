"""Analogues of velocity and acceleration by `motion`: the loop of a four-bar, twice by a complex step."""

from __future__ import annotations

import math
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from chapters.hodograph.test_hodograph import ROW, SCENE, SIZES, STEP, first, place_of_k

import graphic_tmm
from graphic_tmm.errors import StructureError


def scene_of(folder: Path, omega: float, sense: int, asks: str = "", row: str = "") -> Path:
    path, k = folder / "scene.toml", SIZES["k"]
    sizes = {name: size for name, size in SIZES.items() if name != "k"}
    path.write_text(
        SCENE.format(
            **sizes, kx=k.real, ky=k.imag, omega=omega, plans="", asks=asks or 'points = ["K"]',
            turns="counterclockwise" if sense > 0 else "clockwise",
            row=row or ROW.format(count=12, zero=20.0),
        ),
        encoding="utf-8",
    )  # fmt: skip
    return path


def rates(phi: Any, a: float, b: float, c: float, d: float, k: complex) -> tuple[Any, Any]:
    """Return dx/dφ, dy/dφ of K by the loop of velocities, of real or complex angles, reals only."""
    ex, ey = np.cos(phi), np.sin(phi)
    bx, by = place_of_k(phi, a, b, c, d, complex(b, 0.0))
    ux, uy = (bx - a * ex) / b, (by - a * ey) / b
    wx, wy = (bx - d) / c, by / c
    # a·e′ + b·θ₂′·u′ = c·θ₃′·w′ along w, to which w′ is square
    turn = -a * (-ey * wx + ex * wy) / (b * (-uy * wx + ux * wy))
    kx, ky = k.real * ux - k.imag * uy, k.real * uy + k.imag * ux
    return -a * ey - turn * ky, a * ex + turn * kx


def second(phi: float) -> complex:
    """Return d²K/dφ² by a complex step over the rates."""
    x, y = rates(phi + 1j * STEP, **SIZES)
    return complex(x.imag, y.imag) / STEP


def test_the_rates_of_the_judge_are_those_of_its_places() -> None:
    for phi in np.linspace(0.1, 6.1, 9):
        assert complex(*rates(phi, **SIZES)) == pytest.approx(first(phi, **SIZES), abs=1e-14)


@pytest.mark.parametrize(("omega", "sense"), [(10.0, 1), (10.0, -1), (0.37, 1), (420.0, -1)])
def test_they_are_derivatives_by_the_turn(tmp_path: Path, omega: float, sense: int) -> None:
    """Along both axes, whatever ω is; the turn counts in the sense in which the crank goes."""
    at = np.random.default_rng(3).uniform(-360.0, 720.0, 200)
    found = graphic_tmm.motion(scene_of(tmp_path, omega, sense), at, plans="hodograph", exact=True)
    assert sorted(found.analogues) == ["dS_K", "ddS_K"]
    for k, phi in enumerate(np.radians(at)):
        assert found.analogues["dS_K"][k] == pytest.approx(sense * first(phi, **SIZES), abs=1e-12)
        assert found.analogues["ddS_K"][k] == pytest.approx(second(phi), abs=1e-11)


def test_of_many_angles_they_are_those_of_few(tmp_path: Path) -> None:
    """At 1e5 angles in less than a second (0.02 s of it is usual), with and without a compiled log."""
    scene = graphic_tmm.read(scene_of(tmp_path, 10.0, 1, 'points = ["B", "K"]'))
    at = np.linspace(0.0, 360.0, 100_001)
    graphic_tmm.motion(scene, at[:7], plans="hodograph", exact=True)
    start = time.perf_counter()
    slow = graphic_tmm.motion(scene, at, plans="hodograph", exact=True, fast=False)
    assert time.perf_counter() - start < 1.0
    few = graphic_tmm.motion(scene, at[::1000], plans="hodograph", exact=True)
    assert sorted(slow.analogues) == ["dS_B", "dS_K", "ddS_B", "ddS_K"]
    for name, row in slow.analogues.items():
        assert np.allclose(row[::1000], few.analogues[name], rtol=0, atol=1e-12)


def test_they_come_with_the_plans_that_they_are_read_off(tmp_path: Path) -> None:
    plans: list[Any] = ["velocities", "accelerations", "hodograph"]
    found = graphic_tmm.motion(scene_of(tmp_path, 5.0, 1), [33.0], plans=plans, exact=True)
    assert found.analogues["dS_K"] == pytest.approx(found["K"].velocity / 5.0, rel=1e-12)
    assert found.analogues["ddS_K"] == pytest.approx(found["K"].acceleration / 25.0, rel=1e-12)
    assert "analogues dS_K, ddS_K" in repr(found)


def test_a_crank_that_gains_speed_has_none(tmp_path: Path) -> None:
    row = ROW.format(count=12, zero=20.0) + '\nacceleration = "5 rad/s^2"'
    path = scene_of(tmp_path, 5.0, 1, row=row)
    with pytest.raises(StructureError, match="only where the crank turns evenly"):
        graphic_tmm.motion(path, [33.0], plans="hodograph")


def test_where_it_does_not_assemble_there_are_none(tmp_path: Path) -> None:
    path = scene_of(tmp_path, 5.0, 1, row='positions = 5\nfrom = "20 deg"\nto = "120 deg"')
    text = path.read_text(encoding="utf-8").replace("A = [0.1, 0]", "A = [0.25, 0]")
    path.write_text(text, encoding="utf-8")
    found = graphic_tmm.motion(path, [60.0, 200.0], plans="hodograph", exact=True)
    sizes = {**SIZES, "a": 0.25}
    assert found.analogues["dS_K"][0] == pytest.approx(
        first(math.radians(60.0), **sizes), abs=1e-12
    )
    assert np.isnan(found.analogues["dS_K"][1])
