"""Readings of tables weighed: what draws as the base does gains nothing, in whichever way they were found."""

from __future__ import annotations

import numpy as np

from graphic_tmm.checking.mutations.entries import Reading, column_gains
from graphic_tmm.checking.mutations.evidence import _written
from graphic_tmm.checking.mutations.tables import ReadingTable
from graphic_tmm.checking.records import Taken

TAKEN = Taken("forces", "3", "R12", mm=101.0, line=2)
ONE = Reading(TAKEN, 101.0 + 0j, 130.0 + 0j, 1.0, 1.0, 3)
EXACT, OWN = np.array([130.0, 130.0, 100.0]), np.array([101.5, 101.5, 85.0])
"""Of three rows, the second as the base: by exact figures, and by what was read before."""


def weighed() -> tuple[np.ndarray, ...]:
    return column_gains([ONE], [{ONE.at: EXACT}, {ONE.at: OWN}], 3, 8)


def test_a_row_that_moves_nothing_gains_nothing() -> None:
    gain, *_, moved, squares = weighed()
    assert gain[1].tolist() == [0.0] * 9
    assert moved[1].sum() == squares[1].sum() == 0.0


def test_the_base_is_what_the_readings_are_likelier_with() -> None:
    gain, beyond, *_ = weighed()
    assert beyond[0, 3] == 0.0, "it follows from what was read before"
    assert abs(gain[2, 3]) < 1.0, "nothing was to be explained"
    assert np.flatnonzero(gain).tolist() == [2 * 9 + 3]


def test_a_table_written_otherwise_is_what_its_ways_make_of_it() -> None:
    """Of 17, 20 and 5 mm: as they are; each from the other end of a ruler of 30; rows exchanged, one lost."""
    same = ReadingTable([TAKEN] * 3, ["3"]).same()
    ways = [same, same.scaled("", [0, 1], -1.0, 30.0), same.moved("", {0: 1, 1: 0, 2: -1})]
    found = _written(ways, 3, {0: 17.0, 1: 20.0, 2: 5.0}, [0, 1, 2])
    due = [[17.0, 20.0, 5.0], [13.0, 10.0, 5.0], [20.0, 17.0, np.nan]]
    np.testing.assert_array_equal(found, np.array(due, complex))
