"""Formulas of cams against fifty digits; what has no answer is NaN with its reason."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath as mp  # type: ignore[import-untyped]
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from graphic_tmm.board.grammar import OPERATIONS, Operation
from graphic_tmm.chapters.cam import formulas as f
from graphic_tmm.chapters.cam import law_formulas as law

EPS = np.finfo(float).eps
PI = mp.pi


def fold(share: Any, turn: Any) -> Any:
    """arcsin(sin(turn·share)) in degrees."""
    return mp.degrees(mp.asin(mp.sin(mp.radians(turn * share))))


REFERENCES: dict[str, Callable[..., Any]] = {
    "radians_of": lambda a: mp.radians(a),
    "along_turn": lambda a, b: a * b / 360,
    "angle_of_turn": lambda x, b: 360 * x / b,
    "angle_of_part": lambda a, n: a / n,
    "scale_of_stroke": lambda h, y: h / y,
    "sine_radius": lambda h: h / (2 * PI),
    "sine_radius_V": lambda h, p, mu: h / (p * mu),
    "sine_radius_A": lambda h, p, mu: 2 * PI * h / (p**2 * mu),
    "cosine_radius": lambda h: h / 2,
    "cosine_radius_V": lambda h, p, mu: PI * h / (2 * p * mu),
    "cosine_radius_A": lambda h, p, mu: PI**2 * h / (2 * p**2 * mu),
    "around_outer": lambda u: fold(u, 360),
    "around_lowest": lambda u: mp.degrees(mp.acos(mp.cos(mp.radians(360 * u)))),
    "half_around_outer": lambda u: fold(u, 180),
    "half_around": lambda u: 180 * u,
    "even_height": lambda u, h: u * h,
    "parabola_V": lambda h, p, mu: 2 * h / (p * mu),
    "parabola_A": lambda h, p, mu: 4 * h / (p**2 * mu),
    "polynomial_S": lambda u, h: h * (10 * u**3 - 15 * u**4 + 6 * u**5),
    "polynomial_V": lambda u, h, p, mu: h * (30 * u**2 - 60 * u**3 + 30 * u**4) / (p * mu),
    "polynomial_A": lambda u, h, p, mu: h * (60 * u - 180 * u**2 + 120 * u**3) / (p**2 * mu),
    "on_chord": lambda u, a, b, y, z: y + (z - y) * (u - a) / (b - a),
    "rest_of_stroke": lambda a, b: a - b,
    "swing_of": lambda y, mu: mp.degrees(y * mu),
    "travel_on_lever": lambda y, mu, lever: y * mu * lever,
    "along_path": lambda v, d, lever: v * d / lever,
    "turning_of_normal": lambda p, q, v, a: 1 - (a * p - q * v) / (p**2 + q**2),
    "curvature_of_profile": lambda t, p, mu: t / (p * mu),
    "least_radius": lambda y, mu: 1 / (y * mu),
    "equidistant_pace": lambda p, r, t: p - r * t,
    "flat_radius": lambda r, s, a: r + s + a,
    "convex": lambda r: r,
    "allowed_share": lambda k, x: k * x,
    "lesser_radius": lambda a, b: min(a, b),
    "whole_mm_above": lambda x: mp.ceil(1000 * x - mp.mpf("1e-9")) / 1000,
    "whole_mm_below": lambda x: mp.floor(1000 * x + mp.mpf("1e-9")) / 1000,
    "share_of_parts": lambda n, parts: n / parts,
    "on_protractor": lambda a, mu: a / mu,
    "off_protractor": lambda y, mu: y * mu,
    "mean_of_strip": lambda a, b, c: (a + 4 * b + c) / 6,
}
SHARE = (0.0, 1.0)
RANGES: dict[str, tuple[tuple[float, float], ...]] = {
    "around_outer": (SHARE,),
    "around_lowest": (SHARE,),
    "half_around_outer": (SHARE,),
    "polynomial_S": (SHARE,),
    "polynomial_V": (SHARE,),
    "polynomial_A": (SHARE,),
    "on_chord": ((0.3, 0.5), (0.0, 0.2), (0.6, 1.0)),
    "equidistant_pace": ((50.0, 100.0), (0.01, 10.0), (0.01, 4.0)),
}
SIZES: dict[str, Callable[..., float]] = {
    "around_outer": lambda u: 180.0,
    "around_lowest": lambda u: 360.0,
    "half_around_outer": lambda u: 180.0,
    "polynomial_S": lambda u, h: 10.0 * h,
    "polynomial_V": lambda u, h, p, mu: 30.0 * h / (p * mu),
    "polynomial_A": lambda u, h, p, mu: 60.0 * h / (p**2 * mu),
    "on_chord": lambda u, a, b, y, z: max(y, z),
    "rest_of_stroke": lambda a, b: max(a, b),
    "turning_of_normal": lambda p, q, v, a: 1 + (a * p + q * v) / (p**2 + q**2),
    "equidistant_pace": lambda p, r, t: p,
}
"""What a result is rounded by where its terms cancel."""
MADE = [op for op in OPERATIONS.values() if op.run.__module__ in (f.__name__, law.__name__)]


def test_every_formula_has_a_reference() -> None:
    assert sorted(op.name for op in MADE) == sorted(REFERENCES)


@pytest.mark.parametrize("op", MADE, ids=repr)
@given(data=st.data())
def test_a_formula_is_exact_to_its_rounding(op: Operation, data: st.DataObject) -> None:
    ranges = RANGES.get(op.name, ())
    values = [
        data.draw(st.floats(*(ranges[k] if k < len(ranges) else (0.01, 100.0))))
        for k in range(len(op.takes))
    ]
    with np.errstate(all="ignore"):
        found = op.run(*[np.array([[v]]) for v in values])[0, 0]
    with mp.workdps(50):
        due = REFERENCES[op.name](*map(mp.mpf, values))
        size = SIZES[op.name](*values) if op.name in SIZES else abs(due)
        step = 1e-3 if op.name.startswith("whole_mm") and abs(found - due) > 1e-6 else 0.0
        if step:  # a last bit may carry a number over the next whole millimetre
            assert abs((1000 * values[0]) % 1 - mp.mpf("1e-9")) < 1e-10 or values[0] > 1e3
        assert abs(found - due) <= 12 * EPS * size + step


@pytest.mark.parametrize(
    ("op", "values"),
    [
        (f.scale_of_stroke, (1.0, 0.0)),
        (f.scale_of_stroke, (1.0, -2.0)),
        (f.turning_of_normal, (0.0, 0.0, 1.0, 1.0)),
        (f.least_radius, (-1.0, 2.0)),
        (f.equidistant_pace, (10.0, 12.0, 1.0)),
        (f.convex, (-0.1,)),
    ],
)
def test_what_cannot_be_is_missing_and_has_a_reason(
    op: Operation, values: tuple[float, ...]
) -> None:
    with np.errstate(all="ignore"):
        assert np.isnan(op.run(*[np.array([[v]]) for v in values])).all()
    assert op.fails != "the figure cannot be drawn"


def test_whole_millimetres_stay_what_they_are() -> None:
    for mm in range(1, 400):
        x = np.array([[mm / 1000.0]])
        assert f.whole_mm_above.run(x)[0, 0] == f.whole_mm_below.run(x)[0, 0] == mm / 1000.0
    assert f.whole_mm_above.run(np.array([[0.0490001]]))[0, 0] == 0.05
    assert f.whole_mm_below.run(np.array([[0.0499999]]))[0, 0] == 0.049
