"""Formulas of work and energy against fifty digits; what has no answer is NaN with its reason."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath as mp  # type: ignore[import-untyped]
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from graphic_tmm.board.grammar import OPERATIONS, Operation
from graphic_tmm.board.operations import energetics as e

EPS = np.finfo(float).eps
PI = mp.pi
REFERENCES: dict[str, Callable[..., Any]] = {
    "ring_area": lambda a, b: PI * (a**2 - b**2) / 4,
    "polytropic": lambda p, c, a, t, s, n: p * ((c + a) / (c + t / s)) ** n,
    "polytropic_at_shaft": lambda p, c, a, t, s, n: p * ((c + 1 - a) / (c + 1 - t / s)) ** n,
    "moment_of_drive": lambda m, r, a: m * r / a,
    "moment_of_resistance": lambda m, r, a: -m * r / a,
    "between": lambda p, q, a, b, t, s: p + (q - p) * (t / s - a) / (b - a),
    "gas_force": lambda p, f: p * f,
    "net_force": lambda a, b: a - b,
    "reduced_moment": lambda s, f, b, a, x: -s * f * b / a * x,
    "translation": lambda m, s, mu: m * (s * mu) ** 2 / 2,
    "rotation": lambda j, w: j * w**2 / 2,
    "added": lambda a, b: a + b,
    "reduced_inertia": lambda t, w: 2 * t / w**2,
    "flywheel_inertia": lambda s, mu, d, w: s * mu / (d * w**2),
    "steepest": lambda j, t, w, d: mp.degrees(mp.atan(j * w**2 * (1 + d) / (2 * t))),
    "flattest": lambda j, t, w, d: mp.degrees(mp.atan(j * w**2 * (1 - d) / (2 * t))),
    "largest_rim": lambda v, w: 2 * v / w,
    "share": lambda x, k: k * x,
    "mean": lambda a, b: (a + b) / 2,
    "rim_mass": lambda j, d: 4 * j / d**2,
    "rim_width": lambda j, r, a, b, m: 16 * j / (PI * r * (a**2 - b**2) * m**2),
    "mean_ordinate": lambda f, b: f / b,
}
RANGES = {
    "polytropic": ((1.0, 100.0), (0.01, 0.2), (0.0, 1.0), (1.0, 100.0), (100.0, 200.0), (0.0, 1.6)),
    "polytropic_at_shaft": (
        (1.0, 100.0),
        (0.01, 0.2),
        (0.0, 0.9),
        (1.0, 90.0),
        (100.0, 200.0),
        (0.0, 1.6),
    ),
    "between": ((1.0, 9.0), (20.0, 40.0), (0.0, 0.2), (0.5, 1.0), (60.0, 90.0), (100.0, 120.0)),
    "ring_area": ((50.0, 100.0), (1.0, 40.0)),
    "rim_width": ((0.01, 100.0), (0.01, 100.0), (50.0, 100.0), (1.0, 40.0)),
}
"""Values of arguments where others would leave nothing of a difference."""
MADE = [op for op in OPERATIONS.values() if op.run.__module__ == e.__name__]


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
        # a difference is rounded as its larger member is; an angle as its tangent, up to 90°
        size = {"net_force": max(values), "flattest": 90.0}.get(op.name, abs(due))
        assert abs(found - due) <= 12 * EPS * size


def test_the_flywheel_of_the_engine_by_its_published_segment() -> None:
    found = e.flywheel_inertia.run(*[np.array([[v]]) for v in (61.0, 16.7, 0.23, 50.0)])
    assert found[0, 0] == pytest.approx(1.77, abs=0.005)
    rim = e.rim_width.run(*[np.array([[v]]) for v in (1.77, 7800, 0.45, 0.38, 0.415)])
    assert rim[0, 0] == pytest.approx(0.115, abs=0.001)
    assert e.rim_mass.run(np.array([[1.77]]), np.array([[0.415]]))[0, 0] == pytest.approx(
        41.1, abs=0.1
    )


@pytest.mark.parametrize("segment", [0.0, -3.0, np.nan])
def test_a_flywheel_that_is_not_needed_is_no_number(segment: float) -> None:
    one = np.array([[1.0]])
    assert np.isnan(e.flywheel_inertia.run(np.array([[segment]]), one, one, one)).all()
    assert "no flywheel is needed" in e.flywheel_inertia.fails


def test_a_crank_that_stands_has_no_reduced_moment() -> None:
    one = np.array([[1.0]])
    with np.errstate(all="ignore"):
        assert np.isnan(e.reduced_moment.run(one, one, one, np.zeros((1, 1)), one)).all()
