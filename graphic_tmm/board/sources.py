"""Where the real numbers of values stand, for calculations that work on these: lines of passes and loops."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.tape import Part, Tape
from graphic_tmm.board.unknown import NotTraced, Value


class Source(NamedTuple):
    """Where real numbers come from: the slot of a value, which of its arrays, "real" or "imag" of it."""

    slot: int
    array: int
    part: str

    def of(self, values: Mapping[int, Any]) -> NDArray[np.float64]:
        """Return the numbers, (trial, position)."""
        value = values[self.slot]
        array = value[self.array] if isinstance(value, tuple) else value
        found: NDArray[np.float64] = getattr(array, self.part) if array.dtype.kind == "c" else array
        return found


RULER = Source(-1, 0, "real")
"""Stands for the division of a ruler, which is no value."""


def sources(slot: int, complexes: Sequence[bool]) -> list[list[Source]]:
    """Return where the numbers of a value come from, by array; ``complexes``: which of these are complex."""
    return [
        [Source(slot, k, part) for part in (("real", "imag") if two else ("real",))]
        for k, two in enumerate(complexes)
    ]


def assembled(kind: type, tape: Tape, parts: Sequence[Sequence[Part]]) -> Any:
    """Return a value on a tape of the parts of its arrays; ``kind``: its type."""
    found = [Value(tape, *each) for each in parts]
    return kind(*found) if issubclass(kind, tuple) else found[0]


def taken_apart(value: Any, complexes: Sequence[bool]) -> list[tuple[Part, ...]]:
    """Return the parts of the arrays of a value on a tape.

    Raises
    ------
    NotTraced
        If it is none, or complex where it should be real.
    """
    found = value if isinstance(value, tuple) else (value,)
    if len(found) != len(complexes) or not all(isinstance(one, Value) for one in found):
        raise NotTraced("no number")
    if any(one.im is not None and not two for one, two in zip(found, complexes, strict=True)):
        raise NotTraced("a complex number")
    return [
        (one.re, one.im) if two else (one.re,) for one, two in zip(found, complexes, strict=True)
    ]
