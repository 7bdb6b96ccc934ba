"""What is said of signs holds of every number that a pass leaves, zeros and what is undefined among them."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from graphic_tmm.board.signs import Sign, of_known, of_pass
from graphic_tmm.board.tape import Tape

NUMBERS = (0.0, -0.0, 1.0, -1.0, 0.4, -0.4, 2.5, -2.5, 1e-300, -1e-300, np.inf, -np.inf, np.nan)
HAVE = {
    Sign.FREE: NUMBERS,
    Sign.UNSIGNED: tuple(x for x in NUMBERS if x != 0.0 or not np.signbit(x)),
    Sign.POSITIVE: tuple(x for x in NUMBERS if not (x < 0.0) and not (x == 0.0 and np.signbit(x))),
}
"""Numbers of which so much is known."""
TWO = {
    "add": np.add,
    "subtract": np.subtract,
    "multiply": np.multiply,
    "divide": np.divide,
    "copysign": np.copysign,
    "length": np.hypot,
    "choose": lambda x, y: np.array([x, y]),
}
ONE = {
    "sqrt": np.sqrt,
    "absolute": np.abs,
    "floor": np.floor,
    "ceil": np.ceil,
    "rint": np.rint,
    "negative": np.negative,
    "arctan": np.arctan,
}


def holds(sign: Sign, found: np.ndarray) -> bool:
    zeros = found[found == 0.0]
    if sign >= Sign.UNSIGNED and np.signbit(zeros).any():
        return False
    return sign < Sign.POSITIVE or not (found < 0.0).any()


@pytest.mark.parametrize("does", [*TWO, *ONE])
def test_what_a_pass_leaves_is_as_it_is_said(does: str) -> None:
    """For all that may be known of what it takes."""
    with np.errstate(all="ignore"):
        for signs in product(Sign, repeat=2 if does in TWO else 1):
            rows = [HAVE[sign] for sign in signs]
            found = np.array([(TWO | ONE)[does](*each) for each in product(*rows)], dtype=float)
            said = of_pass(does, signs, alike=False)
            assert holds(said, np.ravel(found)), signs


def test_a_square_is_nothing_below_nothing() -> None:
    found = np.array([x * x for x in NUMBERS])
    assert holds(of_pass("multiply", (Sign.FREE, Sign.FREE), alike=True), found)
    assert of_pass("multiply", (Sign.FREE, Sign.FREE), alike=True) == Sign.POSITIVE
    assert not holds(Sign.POSITIVE, np.array(NUMBERS))
    assert not holds(Sign.UNSIGNED, np.array([-0.0]))


def test_known_numbers() -> None:
    for number in NUMBERS:
        assert holds(of_known(number), np.array([number]))
    assert [of_known(x) for x in (0.0, -0.0, 2.0, -2.0)] == [
        Sign.POSITIVE,
        Sign.FREE,
        Sign.POSITIVE,
        Sign.UNSIGNED,
    ]


def test_sums_with_nothing_cost_no_pass_where_they_change_no_byte() -> None:
    tape = Tape()
    x, y = tape.input(moving=True), tape.input(moving=True)
    assert tape.plus(x, -0.0) == x
    assert tape.minus(x, 0.0) == x
    kept = tape.plus(x, 0.0)
    assert kept != x
    assert tape.plus(kept, 0.0) == kept
    assert tape.plus(tape.plus(kept, y), 0.0) == tape.plus(kept, y)
    assert tape.plus(tape.opposite(kept), 0.0) != tape.opposite(kept)


def test_what_is_nothing_below_nothing_has_no_sign_to_take_off() -> None:
    tape = Tape()
    x, y = tape.input(moving=True), tape.input(moving=True)
    size = tape.call("length", x, y)
    assert tape.call("absolute", size) == size
    assert tape.call("copysign", size, tape.call("absolute", x)) == size
    assert tape.call("copysign", x, size) == tape.call("absolute", x)
    assert tape.call("absolute", x) != x
    assert tape.call("copysign", size, x) != size
