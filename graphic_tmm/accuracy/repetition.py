"""Which steps have to be done anew at each position: found from the log and what varies, without numbers.

A line may turn about a fixed point, or move without turning, and an operation may take no more of it than
its direction. So each operation is asked itself: it is run on ones, at one position where a part of a value
stays the same and at two where it does not, and the sizes of what it leaves are looked at.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import lru_cache
from typing import Any, cast

import numpy as np

from graphic_tmm.board.grammar import OPERATIONS, Operation
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Arc, Curve, Kind, Line, Point, arrays
from graphic_tmm.errors import ConstructionError

ALONG = frozenset({"following", "succession", "next_satellite"})
"""Operations across positions that leave a mark at every position; the others leave one for the row."""

Parts = tuple[bool, ...]
"""Of each array that a value is made of: whether it has a number of its own at each position."""
Choice = tuple[tuple[str, int], ...]


def varying(given: Mapping[Mark, object]) -> frozenset[Mark]:
    """Return the given marks whose values are arrays (trial, position) with more than one position."""
    return frozenset(m for m, value in given.items() if np.shape(cast(Any, value))[-1:] > (1,))


def repeated(construction: Construction, varies: Iterable[Mark]) -> frozenset[int]:
    """Return the slots of the marks of pointwise steps that are not the same at all positions.

    ``varies``: the given marks that are not; all else that is given is the same.

    Raises
    ------
    ConstructionError
        If one of them is not given on this board.
    """
    given = frozenset(varies)
    if strange := given - frozenset(construction.given):
        mark = min(strange)
        raise ConstructionError(f"{mark.view}: '{mark.letter}' is not given on this board")
    parts = {m.slot: (m in given,) * _size(m.kind) for m in construction.given}
    for step in construction.steps:
        parts[step.it.slot] = _left(step, tuple(parts[mark.slot] for mark in step.uses))
    return frozenset(
        s.it.slot for s in construction.steps if not s.op.across and any(parts[s.it.slot])
    )


def _left(step: Step, taken: tuple[Parts, ...]) -> Parts:
    op, size = step.op, _size(step.op.leaves)
    if op.across:
        return (op.name in ALONG,) * size
    if not any(map(any, taken)):
        return (False,) * size
    if op.name not in OPERATIONS:  # it owns a construction of its own
        return (True,) * size
    return _asked(OPERATIONS[op.name], taken, tuple(sorted(step.choice.items())))


@lru_cache(maxsize=4096)
def _asked(op: Operation, taken: tuple[Parts, ...], choice: Choice) -> Parts:
    values = [_ones(kind, parts) for kind, parts in zip(op.takes, taken, strict=True)]
    with np.errstate(all="ignore"):
        left = op.run(*values, **dict(choice))
    return tuple(array.shape[1] > 1 for array in arrays(left))


def _ones(kind: Kind, parts: Parts) -> Any:
    if kind is Curve:
        knots = np.arange(4.0)[None, :].astype(np.complex128)
        return Curve(knots, np.ones((1, 4), np.complex128), False)
    sized = [np.ones((1, 2 if varies else 1)) for varies in parts]
    if kind is Arc:
        return Arc(sized[0].astype(np.complex128), sized[1])
    if kind is Line:
        return Line(*(part.astype(np.complex128) for part in sized))
    return sized[0].astype(np.complex128 if kind is Point else np.float64)


def _size(kind: Kind) -> int:
    """Return how many arrays a value of a kind is made of."""
    return 2 if kind in (Line, Arc, Curve) else 1
