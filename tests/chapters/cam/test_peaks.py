"""The largest dS/dφ and d²S/dφ² are those of the law, whether a position stands there or not."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from support.boards import usual_part
from support.scenes import written

from graphic_tmm.readers.findings import warnings
from graphic_tmm.readers.table import results_of
from graphic_tmm.scene.read import read

U = np.linspace(0.0, 1.0, 400_001)
"""At a smooth peak the nearest of these is off by less than 2e-11 of it."""
RISE, FALL, STROKE = np.radians(110.0), np.radians(95.0), 0.03


def cosine(u: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    return np.pi / 2 * np.sin(np.pi * u), np.pi**2 / 2 * np.cos(np.pi * u)


def sine(u: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    return 1 - np.cos(2 * np.pi * u), 2 * np.pi * np.sin(2 * np.pi * u)


def polynomial(u: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    s = np.polynomial.Polynomial([0, 0, 0, 10, -15, 6])
    return s.deriv(1)(u), s.deriv(2)(u)


def even(u: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    return np.where(u < 0.5, 4 * u, 4 - 4 * u), np.where(u < 0.5, 4.0, -4.0)


def uneven(u: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    return np.minimum(2 * u / 0.75, 2 * (1 - u) / 0.25), np.where(u < 0.75, 2 / 0.75, -2 / 0.25)


def by_points(u: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Of POINTS, by sums of strips: the stroke is made 1."""
    a = np.interp(u, *np.array(POINTS).T)
    step = u[1] - u[0]
    speed = np.concatenate([[0.0], np.cumsum((a[1:] + a[:-1]) / 2 * step)])
    lift = float(np.sum((speed[1:] + speed[:-1]) / 2 * step))
    return speed / lift, a / lift


POINTS = [(0.0, 0.5), (0.3, 2.0), (0.7, -2.0), (1.0, -0.5)]
LAWS = {
    '"cosine"': cosine,
    '"sine"': sine,
    '"3-4-5"': polynomial,
    '"constant acceleration"': even,
    '"constant acceleration"\nshares = [3, 1]': uneven,
    '"diagram"': by_points,
}


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("follower", ["flat", "rocker"])
def test_peaks_are_those_of_the_law(tmp_path: Path, law: str, follower: str) -> None:
    rocks = follower == "rocker"
    sizes = 'lever = "100 mm"\nr0 = "60 mm"\ncentres = "150 mm"\n' if rocks else ""
    points = (
        f"law_points = {[list(p) for p in POINTS]}\nreturn_points = {[list(p) for p in POINTS]}\n"
    )
    stroke = "20 deg" if rocks else f"{STROKE} m"
    path = tmp_path / "scene.toml"
    path.write_text(
        f'title = "T"\nlanguage = "en"\n[cam]\nstroke = "{stroke}"\nrise = 110\n'
        f'upper_dwell = 20\nfall = 95\nlaw = {law}\nfollower = "{follower}"\n{sizes}'
        f"{points if 'diagram' in law else ''}"
    )
    found = results_of(usual_part("cam", read(path)))
    own: Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]] = LAWS[law]
    speed, second = (float(np.abs(one).max()) for one in own(U))
    high = np.radians(20.0) if rocks else STROKE
    for name, extent in (("rise", RISE), ("return", FALL)):
        assert found[f"dS_max_{name}"][0] == pytest.approx(high * speed / extent, rel=1e-9)
        assert found[f"ddS_max_{name}"][0] == pytest.approx(high * second / extent**2, rel=1e-9)


@pytest.mark.parametrize(
    "cam",
    [
        'form = "translating"\nrise = "80 mm"\nupper_dwell = "20 mm"',
        'form = "drum"\nradius = "60 mm"\nrise = 120\nfall = 90',
    ],
)
def test_the_curvature_of_a_straight_profile_is_not_in_doubt(tmp_path: Path, cam: str) -> None:
    """Its heights are rounding, so their crest is nowhere; the first point is taken in every trial."""
    text = f'title = "T"\nlanguage = "en"\n[cam]\nstroke = "20 mm"\nlaw = "uniform"\n{cam}\n'
    drawn = usual_part("cam", read(written(tmp_path, text)))
    assert not [told for told in warnings(drawn, "en") if "uncertain" in told]
