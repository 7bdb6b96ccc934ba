"""The text of a line takes no more rows than it needs, and no pass that nobody asks for."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.passage import passage
from graphic_tmm.board.tape import Part, Tape


def _chain(tape: Tape, part: Part, passes: int) -> Part:
    for k in range(passes):
        part = tape.call("sin", tape.plus(part, float(k)))
    return part


def test_a_long_chain_needs_one_row() -> None:
    tape = Tape()
    line = passage(tape, [_chain(tape, tape.input(moving=True), 20)], [False])
    assert (line.slots, line.masks) == (1, 0)


def test_what_nobody_asks_for_is_not_done_and_does_not_enter() -> None:
    tape = Tape()
    x, y = tape.input(moving=True), tape.input(moving=True)
    _chain(tape, x, 5)
    line = passage(tape, [tape.times(y, 2.0)], [False])
    assert line.entering == (1,)
    assert "sin" not in line.text
    assert line.slots == 0  # it is written where it is to stay


def test_what_does_not_vary_is_found_once_and_returned() -> None:
    tape = Tape()
    x, a = tape.input(moving=True), tape.input(moving=False)
    line = passage(
        tape, [tape.plus(x, tape.call("sin", a)), tape.opposite(a), None, 2.5], [False] * 4
    )
    assert line.rows == (0,)
    row = np.empty(3)
    arena, masks = np.empty((line.slots, 2)), np.empty((line.masks, 2), np.bool_)
    single = line.run(3, 2, arena, masks, np.arange(3.0), np.float64(0.5), row)
    np.testing.assert_array_equal(row, np.arange(3.0) + np.sin(0.5))
    assert single == (-0.5, 0.0, 2.5)
    before = line.text.split("for start")[0]
    assert before.count("sin") == line.text.count("sin") == 1


def test_what_is_chosen_outlives_the_row_it_was_chosen_from() -> None:
    """The chosen row is no copy: nothing may be written there as long as it is used."""
    tape = Tape()
    x, y = tape.input(moving=True), tape.input(moving=True)
    first, second = tape.call("sin", x), tape.call("cos", x)
    chosen = tape.choose(tape.compare("less", y, 0.0), first, second)
    other = tape.times(tape.call("exp", x), tape.call("exp", y))
    line = passage(tape, [tape.plus(tape.times(other, other), chosen)], [False])
    rows = np.linspace(0.1, 1.0, 6), np.array([-1.0, -1.0, -1.0, -1.0, 1.0, 1.0])
    due = np.exp(rows[0]) * np.exp(rows[1])
    due = due * due + np.where(rows[1] < 0.0, np.sin(rows[0]), np.cos(rows[0]))
    for block in (2, 3, 6):
        out = np.empty(6)
        arena, masks = np.empty((line.slots, block)), np.empty((line.masks, block), np.bool_)
        line.run(6, block, arena, masks, *rows, out)
        np.testing.assert_allclose(out, due, rtol=1e-15)


def test_parts_of_complex_numbers_are_written_apart() -> None:
    tape = Tape()
    x = tape.input(moving=True)
    y = tape.call("sin", x)
    z = np.empty(5, np.complex128)
    line = passage(tape, [tape.opposite(y), y], [True, True])
    row = np.linspace(0.0, 1.0, 5)
    line.run(5, 5, np.empty((line.slots, 5)), np.empty((0, 5), np.bool_), row, z.real, z.imag)
    np.testing.assert_array_equal(z, -np.sin(row) + 1j * np.sin(row))
