"""Operations on forces: arms and lines of vectors without length, senses at rest."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from graphic_tmm.board.operations import statics as s
from graphic_tmm.board.operations.instruments import similar
from graphic_tmm.board.values import Line
from graphic_tmm.chapters.engine import formulas as g

EPS = np.finfo(float).eps
LENGTHS = st.floats(-1e3, 1e3, allow_subnormal=False)


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
