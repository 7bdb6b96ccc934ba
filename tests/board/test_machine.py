"""Machine code hangs on the text, the machine and the translator; it goes when nobody has it."""

from __future__ import annotations

import gc
import weakref

import numpy as np

from graphic_tmm.board.loop_text import loop_of
from graphic_tmm.board.machine import Run, machine, made, translated
from graphic_tmm.board.tape import Tape


def _text(factor: float) -> str:
    tape = Tape()
    return loop_of(tape, [(tape.plain(tape.times(tape.input(moving=True), factor)),)]).text


def _doubled(run: Run) -> None:
    row, out, still = np.arange(9.0), np.zeros(9), np.zeros(0)
    for base in (0, 64):
        rows = [row.ctypes.data - base, out.ctypes.data - base]
        frame = np.array([0, 9, still.ctypes.data, *rows], np.int64)
        out[:] = 0.0
        run.call(frame.ctypes.data, base)
        np.testing.assert_array_equal(out, 2.0 * row)


def test_a_text_is_made_once() -> None:
    assert made(_text(2.0)) is made(_text(2.0))
    _doubled(made(_text(2.0)))


def test_the_same_text_gives_the_same_code() -> None:
    assert translated(_text(2.0)) == translated(_text(2.0))
    assert translated(_text(2.0)) != translated(_text(3.0))


def test_the_key_tells_all_that_the_code_hangs_on() -> None:
    here = machine()
    others = (
        here._replace(processor="another"),
        here._replace(features=here.features + ",+more"),
        here._replace(triple="another"),
    )
    keys = {one.key("text") for one in (here, *others)} | {here.key("other text")}
    assert len(keys) == 5


def test_code_goes_with_its_function() -> None:
    run = Run(translated(_text(2.0)))
    _doubled(run)
    seen = weakref.ref(run._loader)
    del run
    gc.collect()
    assert seen() is None
