"""What a construction costs at the board: its work, counted off the log; which steps are done anew."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from math import isfinite
from types import MappingProxyType
from typing import Any, NamedTuple, cast

import numpy as np

from graphic_tmm.accuracy.geometrography import (
    ELEMENTARY,
    elements,
    exactitude,
    simplicity,
    symbol,
    written,
)
from graphic_tmm.board.execute import needed
from graphic_tmm.board.grammar import OPERATIONS, Operation
from graphic_tmm.board.operations.locus import PARTS, PASSES, REFINE
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Arc, Curve, Kind, Line, Point, arrays
from graphic_tmm.errors import ConstructionError

Parts = tuple[bool, ...]
"""For each array of a value: whether it varies with the position."""
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
        return (op.everywhere,) * size
    if not any(map(any, taken)):
        return (False,) * size
    if op.name not in OPERATIONS:  # it owns a construction of its own
        return (True,) * size
    return _parts_of(OPERATIONS[op.name], taken, tuple(sorted(step.choice.items())))


@lru_cache(maxsize=4096)
def _parts_of(op: Operation, taken: tuple[Parts, ...], choice: Choice) -> Parts:
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
    """Return the number of arrays of a value of a kind."""
    return 2 if kind in (Line, Arc, Curve) else 1


MINUTES: Mapping[str, float] = MappingProxyType({k: e.minutes for k, e in ELEMENTARY.items()})
"""Default minutes of each elementary operation."""


@dataclass(frozen=True)
class BoardWork:
    """Work at the board.

    ``operations``: counts by operation; ``elements``: counts by elementary operation; ``minutes`` they take;
    ``untold``: refinements whose smaller construction is unknown and therefore not counted.
    """

    operations: Mapping[str, int]
    elements: Mapping[str, int]
    minutes: float
    untold: tuple[Mark, ...] = ()

    @property
    def simplicity(self) -> int:
        """Lemoine's simplicity: the number of all elementary operations."""
        return simplicity(self.elements)

    @property
    def exactitude(self) -> int:
        """Lemoine's exactitude: the number of preparations; the fewer, the more exact."""
        return exactitude(self.elements)

    @property
    def symbol(self) -> str:
        """The work as Lemoine writes it."""
        return written(self.elements)

    def __add__(self, other: BoardWork) -> BoardWork:
        """Return the work of both, one after the other."""
        return BoardWork(
            dict(Counter(self.operations) + Counter(other.operations)),
            dict(Counter(self.elements) + Counter(other.elements)),
            self.minutes + other.minutes,
            tuple(dict.fromkeys((*self.untold, *other.untold))),
        )

    def __mul__(self, times: int) -> BoardWork:
        """Return the work of doing it ``times`` over."""
        return BoardWork(
            {name: n * times for name, n in self.operations.items()},
            {name: n * times for name, n in self.elements.items()},
            self.minutes * times,
            self.untold,
        )


NOTHING = BoardWork({}, {}, 0.0)


class Done(NamedTuple):
    """A step and how often it is done; ``row``: knots, intervals or trials that it goes through each time."""

    step: Step
    times: int
    row: int


def done(
    construction: Construction,
    varies: Iterable[Mark],
    wanted: Iterable[Mark] | None = None,
    *,
    positions: int = 1,
    only: Mapping[str, int] | None = None,
    passes: int = PASSES,
) -> tuple[Done, ...]:
    """Return the steps that the wanted marks need, in order, and how often each is done; see `count`."""
    steps = construction.steps if wanted is None else needed(construction, wanted)
    places = _places(construction, positions, only or {})
    again = repeated(construction, varies)
    return tuple(
        Done(s, places(s.it.view) if s.it.slot in again else 1, _row(s, passes)) for s in steps
    )


def count(
    construction: Construction,
    varies: Iterable[Mark],
    wanted: Iterable[Mark] | None = None,
    *,
    positions: int = 1,
    only: Mapping[str, int] | None = None,
    tried: Mapping[Mark, BoardWork] | None = None,
    passes: int = PASSES,
    minutes: Mapping[str, float] | None = None,
) -> BoardWork:
    """Return the work of drawing the wanted marks; nothing is run, no reading is needed.

    Parameters
    ----------
    construction
        The log.
    varies
        The given marks that are not the same at all positions; `varying` finds them.
    wanted
        The marks to draw; None for all of them.
    positions
        How many positions are drawn.
    only
        For views that are drawn at some positions only: at how many, by the view's name.
    tried
        For refinements: the work of one trial of the smaller construction, by the mark it leads to.
    passes
        How often a refinement narrows its bracket.
    minutes
        Minutes of elementary operations, in place of those of `MINUTES`.

    Raises
    ------
    ConstructionError
        If a varying mark is not given on this board, a view or an elementary operation does not exist, or a
        number is out of its range.
    """
    table = _minutes(minutes or {})
    own, operations = Counter[str](), Counter[str]()
    inner, told = NOTHING, tried or {}
    for step, times, row in done(
        construction, varies, wanted, positions=positions, only=only, passes=passes
    ):
        operations[step.op.name] += times
        for name, n in elements(symbol(step.op), row).items():
            own[name] += n * times
        if step.op.name == REFINE:
            one = told.get(step.it, BoardWork({}, {}, 0.0, (step.it,)))
            inner += one * (row * times)
    spent = sum(n * table[name] for name, n in own.items())
    return BoardWork(dict(operations), dict(own), spent) + inner


def _row(step: Step, passes: int) -> int:
    """Return how long the row is that a step goes through; the trials of a refinement.

    The first pass tries all divisions; of a later one, both ends have been tried already.
    """
    if step.op.name == REFINE:
        if passes < 1:
            raise ConstructionError(f"passes: at least one, not {passes}")
        return PARTS + 1 + (passes - 1) * (PARTS - 1)
    choice = step.choice
    if "first" in choice and "last" in choice:
        return choice["last"] - choice["first"] + 1
    return choice.get("row", 1)


def _places(
    construction: Construction, positions: int, only: Mapping[str, int]
) -> Callable[[str], int]:
    """Return at how many positions a view is drawn, as a function of its name."""
    views = dict.fromkeys(step.it.view for step in construction.steps)
    for name, number in (("positions", positions), *only.items()):
        if number < 1:
            raise ConstructionError(f"{name}: at least one position, not {number}")
    if unknown := [name for name in only if name not in views]:
        raise ConstructionError(f"there is no view {unknown[0]}; there are {', '.join(views)}")
    return lambda view: only.get(view, positions)


def _minutes(own: Mapping[str, float]) -> Mapping[str, float]:
    """Return the table of minutes with a user's own in it."""
    for name, value in own.items():
        if name not in ELEMENTARY:
            raise ConstructionError(
                f"minutes: there is no elementary operation {name}; there are {', '.join(ELEMENTARY)}"
            )
        if not (isfinite(value) and value >= 0.0):
            raise ConstructionError(f"minutes: {name} cannot take {value} minutes")
    return {**MINUTES, **own}
