"""The very log that the machine runs, run once more at 50 digits.

An operation is a function of numbers, and `compile.trace` calls it with numbers that are not known yet, noted
on a tape. Here they are known, to 50 digits, and the tape works each pass out at once: nothing is described
anew. The sine and π are their own, not the series and the 16 digits of the machine.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

import mpmath as mp  # type: ignore[import-untyped]
import numpy as np
import pytest

from graphic_tmm.board import geometry
from graphic_tmm.board.compile import trace
from graphic_tmm.board.compile.trace import Value
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import arrays

DIGITS = 50


def _opposite(a: Any) -> Any:
    return None if a is None else -a


def _quotient(a: Any, b: Any) -> Any:
    if b:
        return mp.mpf(a) / b
    return mp.nan if not a or mp.isnan(a) else mp.inf * mp.sign(a)


def _root(a: Any) -> Any:
    return mp.sqrt(a) if a >= 0 else mp.nan


def _real(of: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """Return a function of mpmath that is undefined where it leaves the real numbers."""

    def function(a: Any) -> Any:
        found = of(a)
        return mp.nan if isinstance(found, mp.mpc) else found

    return function


_PASSES: dict[str, Callable[..., Any]] = {
    "sqrt": _root,
    "absolute": abs,
    "negative": operator.neg,
    "length": lambda a, b: mp.hypot(a, b),
    "hypot": lambda a, b: mp.hypot(a, b),
    "rint": lambda a: mp.nint(a),
    "floor": lambda a: mp.floor(a),
    "ceil": lambda a: mp.ceil(a),
    "sign": lambda a: mp.sign(a),
    "copysign": lambda a, b: abs(a) if b >= 0 else -abs(a),
    "maximum": lambda a, b: mp.nan if mp.isnan(a) or mp.isnan(b) else max(a, b),
    "minimum": lambda a, b: mp.nan if mp.isnan(a) or mp.isnan(b) else min(a, b),
    "sin": lambda a: mp.sin(a),
    "cos": lambda a: mp.cos(a),
    "tan": lambda a: mp.tan(a),
    "arcsin": _real(mp.asin),
    "arccos": _real(mp.acos),
    "arctan": lambda a: mp.atan(a),
    "arctan2": lambda a, b: mp.atan2(a, b) if a or b else mp.mpf(0),
    "radians": lambda a: a * mp.pi / 180,
    "degrees": lambda a: a * 180 / mp.pi,
    "exp": lambda a: mp.exp(a),
    "power": lambda a, b: mp.power(a, b),
    "less": operator.lt,
    "less_equal": operator.le,
    "greater": operator.gt,
    "greater_equal": operator.ge,
    "equal": operator.eq,
    "logical_and": lambda a, b: a and b,
    "logical_or": lambda a, b: a or b,
    "logical_not": operator.not_,
    "isnan": lambda a: mp.isnan(a),
    "isfinite": lambda a: mp.isfinite(a),
}


class _Worked:
    """A tape on which every pass is worked out at once: a part of a number is a number of 50 digits."""

    def call(self, does: str, *parts: Any) -> Any:
        return _PASSES[does](*(0.0 if part is None else part for part in parts))

    note = compare = call

    def there(self, does: str, *parts: Any) -> None:
        return None

    def plain(self, part: Any) -> Any:
        return 0.0 if part is None else part

    def plus(self, a: Any, b: Any) -> Any:
        if a is None or b is None:
            return b if a is None else a
        return a + b

    def minus(self, a: Any, b: Any) -> Any:
        return self.plus(a, _opposite(b))

    def opposite(self, a: Any) -> Any:
        return _opposite(a)

    def times(self, a: Any, b: Any) -> Any:
        return None if a is None or b is None else a * b

    def over(self, a: Any, b: Any) -> Any:
        return None if a is None else _quotient(a, b or 0)

    def choose(self, mask: Any, a: Any, b: Any) -> Any:
        chosen = a if mask else b
        return mp.mpf(0) if chosen is None else chosen


def _sine(x: Any) -> Any:
    return Value(x.tape, mp.sin(x.part())) if isinstance(x, Value) else float(np.sin(x))


@contextmanager
def _own_sine() -> Iterator[None]:
    """Trace operations with the sine and with π of 50 digits."""
    with pytest.MonkeyPatch.context() as patch:
        kept = {geometry.sine: _sine}
        helpers = ("vector", "reverse", "some", "pick", "quadrant")
        kept |= {getattr(geometry, one): trace._KNOWN[getattr(geometry, one)] for one in helpers}
        patch.setattr(trace, "_KNOWN", kept)
        trace.traced(geometry.cis).__globals__["RADIAN"] = Value(_Worked(), mp.pi / 180)  # type: ignore[arg-type]
        # what the machine takes for touching may miss by a rounding of its own more
        trace.traced(geometry.root).__globals__["TANGENT"] = 4 * geometry.TANGENT
        yield


def _digits_of(value: Any, tape: Any, k: int) -> Any:
    """Return a value of the machine at position ``k`` as one of 50 digits."""
    if isinstance(value, tuple):
        return type(value)(*(_digits_of(part, tape, k) for part in value))
    number = value[0, k if value.shape[1] > 1 else 0]
    if np.iscomplexobj(value):
        return Value(tape, mp.mpf(float(number.real)), mp.mpf(float(number.imag)))
    return Value(tape, mp.mpf(float(number)))


def number(value: Any) -> Any:
    """Return what a mark is, mpf or mpc."""
    if not isinstance(value, Value):
        return mp.mpmathify(value)
    return (
        mp.mpf(value.re or 0)
        if value.im is None
        else mp.mpc(mp.mpf(value.re or 0), mp.mpf(value.im))
    )


def digits_run(
    steps: Sequence[Step], given: Mapping[Mark, Any], wanted: Sequence[Mark], places: Sequence[int]
) -> list[list[Any]]:
    """Run steps at some positions of what is given, at 50 digits; return the wanted marks, by position."""
    tape: Any = _Worked()
    found = []
    with mp.workdps(DIGITS), _own_sine():
        runs = [(step, trace.traced(step.op.run)) for step in steps]
        begun = [
            (mark, value)
            for mark, value in given.items()
            if all(a.ndim == 2 for a in arrays(value))
        ]
        for k in places:
            values = {mark.slot: _digits_of(value, tape, k) for mark, value in begun}
            for step, run in runs:
                values[step.it.slot] = run(*(values[m.slot] for m in step.uses), **step.choice)
            found.append([number(values[mark.slot]) for mark in wanted])
    return found
