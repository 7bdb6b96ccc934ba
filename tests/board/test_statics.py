"""Operations on forces: arms and lines of vectors without length, senses at rest, formulas against mpmath."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from mpmath import mp  # type: ignore[import-untyped]

from graphic_tmm.board.grammar import OPERATIONS, Operation
from graphic_tmm.board.operations import statics as s
from graphic_tmm.board.operations.instruments import similar
from graphic_tmm.board.values import Line
from graphic_tmm.chapters.engine import formulas as g

EPS = np.finfo(float).eps
LENGTHS = st.floats(-1e3, 1e3, allow_subnormal=False)
REFERENCES: dict[str, Callable[..., Any]] = {
    "weight": lambda m, a: m * a,
    "inertia_force": lambda m, a, mu: m * a * mu,
    "inertia_force_along": lambda m, a, mu: m * abs(a) * mu,
    "inertia_couple": lambda j, e: -j * e,
    "with_motion": lambda f, v, p: f,
    "against_turning": lambda m, w, p: -m,
    "offset": lambda m, f, mu: -m / (f * mu),
    "place_of": lambda m, f, mu: abs(m) / (abs(f) * mu),
    "moment": lambda f, h, mu: f * h * mu,
    "reversed_": lambda x: -x,
    "tangential": lambda m, a, mu: m / (a * mu),
    "balancing": lambda m, a, mu: -m / (a * mu),
    "per_times": lambda a, b: a / b,
    "on_lever": lambda f, h: f * h,
    "converted": lambda m, k, a, b, mu: m * k * a / (b * mu),
    "converted_reversed": lambda m, k, a, b, mu: -m * k * a / (b * mu),
    "balancing_on_lever": lambda m, a: -m / a,
    "moment_on_arm": lambda f, a: f * a,
    "apart_percent": lambda a, b: 100 * abs(a - b) / abs(b),
    "circle_radius": lambda f, r: f * r,
    "difference_of": lambda a, b: a - b,
    "pin_friction": lambda r, f, w, p: -r * abs(f),
    "efficiency": lambda a, b, w: 100 * a / b if a <= b else mp.nan,
    "still_open": lambda a, b, c: _rest(abs(a - b), abs(b - c)),
    "settled": lambda a, r: a if r <= a else mp.nan,
    "split_by_lever": lambda m, a, b: m * a / b,
    "mass_of_share": lambda m, k: m * k,
    "rest_of": lambda a, b: a - b,
    "lumped_inertia": lambda m, a, n, b: m * a * a + n * b * b,
    "towards_crank": lambda s, a, mu: -s * a * mu,
    "against_acceleration": lambda m, a: -m * a,
    "crank_ratio": lambda a, b: a / b,
    "first_order": lambda m, w, r: m * w * w * r,
    "second_order": lambda f, k: f * k,
    "projected": lambda a, mu: -a * mu,
    "per_mass": lambda f, m: -f / m,
    "in_kgf": lambda f, u: f / u,
    "couple_of": lambda f, a, mu: f * a * mu,
}
DIFFERENCES = {"apart_percent", "difference_of", "rest_of", "still_open"}
MADE = [
    op for op in OPERATIONS.values() if op.run.__module__ in (s.__name__, g.__name__) and op.formula
]


def _rest(change: Any, earlier: Any) -> Any:
    if earlier == 0 or change >= earlier:
        return mp.inf if change else mp.mpf(0)
    q = change / earlier
    return change * max(mp.mpf(1), q / (1 - q))


def test_every_formula_has_a_reference() -> None:
    assert sorted(op.name for op in MADE) == sorted(REFERENCES)


@pytest.mark.parametrize("op", MADE, ids=repr)
@given(data=st.data())
def test_a_formula_is_exact_to_its_rounding(op: Operation, data: st.DataObject) -> None:
    values = [data.draw(st.sampled_from([0.5, 1.0, 3.0, 7.0, 20.0])) for _ in op.takes]
    with np.errstate(all="ignore"):
        found = float(op.run(*[np.array([[v]]) for v in values])[0, 0])
    with mp.workdps(50):
        due = REFERENCES[op.name](*map(mp.mpf, values))
        if mp.isnan(due):
            assert math.isnan(found)
        elif mp.isinf(due):
            assert found == math.inf
        else:
            size = max(*values, 100.0) if op.name in DIFFERENCES else abs(due)
            assert abs(found - due) <= 12 * EPS * max(size, abs(due))


def one(z: complex) -> np.ndarray:
    return np.array([[z]], dtype=complex)


@given(x=LENGTHS, y=LENGTHS, turn=st.floats(0.0, 360.0), size=st.floats(1e-6, 1e6))
def test_an_arm_is_the_moment_of_a_unit_force(x: float, y: float, turn: float, size: float) -> None:
    way = size * complex(math.cos(math.radians(turn)), math.sin(math.radians(turn)))
    line = s.action.run(one(complex(x, y)), one(0j), one(way))
    found = s.arm.run(one(0j), line)[0, 0]
    due = (complex(x, y).conjugate() * (way / abs(way))).imag
    assert abs(found - due) <= 8 * EPS * (abs(x) + abs(y))


def test_a_vector_without_length_has_no_direction_and_no_arm() -> None:
    line = s.action.run(one(3 + 4j), one(1 + 1j), one(1 + 1j))
    assert line.along[0, 0] == 0
    assert s.arm.run(one(100j), line)[0, 0] == 0.0
    with np.errstate(all="ignore"):
        missing = s.action.run(one(3 + 4j), one(1 + 1j), one(complex(math.nan, math.nan)))
    assert np.isnan(missing.along[0, 0])


@pytest.mark.parametrize("quarters", [-1, 0, 1])
def test_a_line_of_action_turns_by_right_angles(quarters: int) -> None:
    line = s.action.run(one(0j), one(0j), one(2 + 0j), quarters=quarters)
    assert line.along[0, 0] == pytest.approx(1j**quarters)


@pytest.mark.parametrize(
    ("speed", "due"), [(1e-9, 0.0), (-1e-12, 0.0), (1.1e-9, 5.0), (-2.0, -5.0)]
)
def test_what_does_not_move_has_no_sense(speed: float, due: float) -> None:
    found = s.with_motion.run(np.array([[5.0]]), np.array([[speed]]), np.array([[1.0]]))
    assert found[0, 0] == due


def test_a_force_and_a_couple_that_vanish_together_lie_nowhere_off() -> None:
    zero, some = np.array([[0.0]]), np.array([[2.0]])
    with np.errstate(all="ignore"):
        assert s.offset.run(zero, zero, some)[0, 0] == 0.0
        assert not np.isfinite(s.offset.run(some, zero, some)[0, 0])
        assert s.place_of.run(zero, zero, some)[0, 0] == 0.0


@pytest.mark.parametrize(("normal", "speed"), [(2.0, 1.0), (-2.0, 1.0), (2.0, -1.0), (-2.0, -1.0)])
def test_a_reaction_leans_against_the_speed(normal: float, speed: float) -> None:
    f, guide = 0.25, Line(one(0j), one(1 + 0j))
    args = [np.array([[v]]) for v in (f, normal, speed, 1.0)]
    line = s.at_friction_angle.run(one(0j), guide, *args)
    force = line.along[0, 0] * math.copysign(1.0, normal * line.along[0, 0].imag)
    assert abs(line.along[0, 0]) == pytest.approx(1.0, rel=4 * EPS)
    assert force.real / abs(force.imag) == pytest.approx(-f * math.copysign(1.0, speed), rel=1e-14)


def test_twice_the_angle_of_the_crank() -> None:
    crank = Line(one(0j), one(complex(math.cos(0.3), math.sin(0.3)) * 1j))
    outward = Line(one(0j), one(1j))
    found = g.doubled.run(one(0j), outward, crank).along[0, 0]
    assert found == pytest.approx(complex(math.cos(0.6), math.sin(0.6)) * 1j, rel=1e-15)


def test_the_couples_of_the_published_lever() -> None:
    """A1: similarity on the plan, and M′ = M·(segment)/(length)."""
    for ab, link, part, due in ((84, 120, 40, 28.0), (64, 100, 20, 12.8), (14, 140, 60, 6.0)):
        args = [one(z) for z in (0j, complex(ab), 0j, complex(link), complex(part))]
        assert similar.run(*args)[0, 0] == pytest.approx(due)
    for due, segment, length in (
        (63700.0, 84.0, 0.36),
        (59136.0, 64.0, 0.30),
        (4560.0, 14.0, 0.42),
    ):
        couple = due * length / segment
        args = [np.array([[v]]) for v in (couple, 1.0, segment, length * 1000.0, 0.001)]
        assert s.converted.run(*args)[0, 0] == pytest.approx(due)
