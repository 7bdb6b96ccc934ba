"""Formulas of gears against mpmath: the involute function and its inverse to the last digits."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest

from graphic_tmm.board.grammar import OPERATIONS
from graphic_tmm.board.operations.formulas import pitch_radius
from graphic_tmm.chapters.gears import formulas as g
from graphic_tmm.chapters.gears import rack

EPS = float(np.finfo(float).eps)
ANGLES = np.concatenate([np.geomspace(1e-5, 0.1, 40), np.linspace(0.1, 1.5, 60)])


def exact_involute(angle: float) -> float:
    with mpmath.workdps(50):
        return float(mpmath.tan(mpmath.mpf(angle)) - mpmath.mpf(angle))


def one(value: float) -> np.ndarray:
    return np.array([[value]])


def test_the_involute_function() -> None:
    due = np.array([exact_involute(a) for a in ANGLES])
    found = g.involute_of(ANGLES)
    # in the series: its six roundings; in the difference: two roundings of tan α
    allowed = np.where(ANGLES < 0.1, 16 * EPS * due, 2 * EPS * np.tan(ANGLES))
    assert (np.abs(found - due) <= allowed).all()


def test_the_angle_of_an_involute_function() -> None:
    values = np.concatenate([np.geomspace(1e-15, 1.0, 80), [3.0, 20.0]])
    found = g.angle_with(values)
    for value, angle in zip(values, found, strict=True):
        with mpmath.workdps(50):
            start = mpmath.mpf(float(angle))
            root = mpmath.findroot(
                lambda a, v=value: mpmath.tan(a) - a - mpmath.mpf(float(v)), start
            )
        # an error of inv α comes back divided by its slope, tan² α
        passed = max(16 * EPS * value, 2 * EPS * np.tan(angle)) / np.tan(angle) ** 2
        assert abs(float(root - start)) <= passed + 2 * EPS * angle


def test_no_angle_has_a_negative_involute_function() -> None:
    with np.errstate(all="ignore"):
        found = g.angle_of_involute.run(np.array([[-1e-9, 0.0, np.nan]]))
    assert np.isnan(found[0, [0, 2]]).all()
    assert found[0, 1] == 0.0


@pytest.mark.parametrize("z", [6, 17, 60, 400])
def test_the_least_shift_brings_the_limit_of_the_rack_to_the_base_circle(z: int) -> None:
    m, alpha, h = one(2e-3), one(20.0), one(2e-3)
    least = rack.least_shift.run(h, m, one(z), alpha)
    r = pitch_radius.run(m, one(z))
    assert rack.limit_curvature.run(r, alpha, h, least, m) == pytest.approx(0.0, abs=1e-16)
    # the usual rule: (z0 − z)/z0 with z0 = 2/sin² α teeth
    z0 = 2.0 / np.sin(np.radians(20.0)) ** 2
    assert least[0, 0] == pytest.approx((z0 - z) / z0, abs=1e-14)


@pytest.mark.parametrize(
    ("alpha", "ha", "c"), [(20.0, 1.0, 0.25), (20.0, 1.0, 0.5), (25.0, 1.0, 0.2)]
)
def test_the_rounding_touches_the_flank_the_bottom_and_fits_the_tip(
    alpha: float, ha: float, c: float
) -> None:
    m, angle = one(1.0), one(alpha)
    rho = rack.rounding.run(m, one(ha), one(c), angle)
    offset = rack.rounding_offset.run(m, one(ha), one(c), rho, angle)[0, 0]
    depth = ha + c - rho[0, 0]
    # the flank: half thickness π/4 on the middle line, leaning by α; its distance from the centre is ρ
    a = np.radians(alpha)
    distance = (np.pi / 4 - depth * np.tan(a) - offset) * np.cos(a)
    assert distance == pytest.approx(rho[0, 0], abs=1e-15)
    assert offset >= -1e-15  # beyond the middle both roundings of a tooth would cross
    straight = rack.straight_depth.run(one(ha), one(c), m, rho, angle)[0, 0]
    assert straight == pytest.approx(depth + rho[0, 0] * np.sin(a), abs=1e-15)
    assert straight >= ha - 1e-15


def test_specific_sliding_is_zero_at_the_pitch_point_and_one_at_the_other_limit() -> None:
    z1, z2, length = one(15.0), one(25.0), 181.35
    x = np.array([[length * 15 / 40, length, 0.0, -1.0]])
    rest = length - x
    with np.errstate(all="ignore"):
        first = g.specific_sliding.run(z1, z2, rest, x)[0]
        second = g.specific_sliding.run(z2, z1, x, rest)[0]
    assert first[0] == pytest.approx(0.0, abs=1e-15)
    assert second[0] == pytest.approx(0.0, abs=1e-15)
    assert first[1] == 1.0
    assert second[2] == 1.0
    assert np.isnan(first[[2, 3]]).all()
    assert np.isnan(second[[1, 3]]).all()


def test_sentences_name_marks_of_the_operation() -> None:
    import re

    for name in ("along_arc", "measure_arc", "angle_at", "turn_about", "reflect", "smooth_through",
                 "beginning", "curve_meets_arc", "curves_cross"):  # fmt: skip
        op = OPERATIONS[name]
        assert set(re.findall(r"{(\w+)}", op.sentence)) - {"it"} <= set(op.arguments), name
