"""The numbers of a value are found again, and put together to one on a tape."""

from __future__ import annotations

import numpy as np
import pytest
from support.unknown_values import unknown

from graphic_tmm.board.compile.loop import Source, assembled, sources, taken_apart
from graphic_tmm.board.compile.tape import Tape
from graphic_tmm.board.compile.trace import NotTraced
from graphic_tmm.board.values import Arc, Length, Line, Point, complexes

ARC = Arc(np.array([[1.0 + 2.0j, 3.0 + 4.0j]]), np.array([[5.0]]))


def test_numbers_stand_where_their_source_says() -> None:
    (x, y), (radius,) = sources(7, complexes(Arc))
    assert radius == Source(7, 1, "real")
    values = {7: ARC}
    np.testing.assert_array_equal(x.of(values), [[1.0, 3.0]])
    np.testing.assert_array_equal(y.of(values), [[2.0, 4.0]])
    np.testing.assert_array_equal(radius.of(values), [[5.0]])


@pytest.mark.parametrize("kind", [Point, Length, Line, Arc])
def test_a_value_is_taken_apart_as_it_was_assembled(kind: type) -> None:
    tape = Tape()
    parts = [tuple(tape.input(moving=True) for _ in each) for each in sources(0, complexes(kind))]
    of = kind if kind in (Line, Arc) else np.ndarray
    assert taken_apart(assembled(of, tape, parts), complexes(kind)) == parts


def test_what_is_no_length_is_told() -> None:
    for value in ("nothing", 1.0, unknown(Tape(), Line), unknown(Tape(), Point)):
        with pytest.raises(NotTraced):
            taken_apart(value, complexes(Length))


def test_a_place_on_the_axis_is_a_place() -> None:
    tape = Tape()
    found = taken_apart(unknown(tape, Length), complexes(Point))
    assert len(found) == 1
    assert len(found[0]) == 2
    assert found[0][1] is None
