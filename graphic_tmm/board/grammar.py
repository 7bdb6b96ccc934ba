"""What an operation is: an annotated function = geometry + kinds + sentence.

To add an operation: write a pure function of values, annotate every argument and the result with kinds of
`values`, let the docstring's first paragraph be the sentence with the arguments' names (and ``{it}``, the mark
it leaves) in braces; other languages have it in their catalogues. Arguments after ``*`` are choices: constants
of the construction, not marks. A calculated length or number gives a ``formula`` instead: its docstring is the
formula, and the same text serves all languages.

Beside its sentence an operation may say ``why`` it is done, with the same names in braces, wherever that does
not hang on the plan it is done in; and, where a figure similar to another is drawn, the ``proportion`` by which
a student calculates it.
"""

from __future__ import annotations

import inspect
import sys
from collections.abc import Callable
from importlib import import_module
from typing import Any, NamedTuple, TypeVar, get_type_hints

from graphic_tmm.board.values import KINDS, Kind, Reals
from graphic_tmm.errors import BareError

F = TypeVar("F", bound=Callable[..., Any])


WHOLE_ROW = "a position of the row is missing"
"""Why a step across positions has no answer that needs all of them."""


FREE, JOIN, RAY, SLIDE = "", "2R1 + R2", "P1 + P2 + 2R1 + R2", "E1 + E2 + R2"
READ, ANGLE, CURVE, SUPPORT = "M1 + R1 + M3", "P1 + P3", "nK1 + nK2", f"P1 + P2 + {SLIDE}"
"""Symbols of geometrography that several operations have: what is done with which instrument."""


class Gap(NamedTuple):
    """How far two figures are from not meeting: ``measure(*values)`` in mm, ≥ 0 where they meet.

    ``says``: what is wrong where it is negative, with the argument names in braces.
    """

    measure: Callable[..., Reals]
    says: str


class Operation(NamedTuple):
    """One operation of the drawing board, as read off its function."""

    name: str
    run: Callable[..., Any]
    takes: tuple[Kind, ...]
    arguments: tuple[str, ...]
    leaves: Kind
    choices: tuple[str, ...]
    sentence: str
    formula: str = ""
    across: bool = False
    reads: bool = False
    condition: Callable[..., Reals] | None = None
    fails: str = ""
    gaps: tuple[Gap, ...] = ()
    sides: tuple[str, str] = ("+", "−")
    why: str = ""
    proportion: str = ""
    symbol: str | None = None
    looked_up: bool = False
    kept: bool = False
    swings: bool = False
    everywhere: bool = False

    def __repr__(self) -> str:
        return self.name

    def __reduce__(self) -> tuple[Callable[..., Operation], tuple[Any, ...]]:
        """Return how another process finds it: by its name in the module that wrote it, if it was entered."""
        if OPERATIONS.get(self.name) is self:
            return entered, (self.run.__module__, self.name)
        return Operation, tuple(self)


def entered(module: str, name: str) -> Operation:
    """Return an operation by its name, from the module that wrote it."""
    import_module(module)
    return OPERATIONS[name]


OPERATIONS: dict[str, Operation] = {}
"""Every operation by its name, in the order of writing."""


def operation(
    *,
    formula: bool = False,
    across: bool = False,
    reads: bool = False,
    condition: Callable[..., Reals] | None = None,
    fails: str = "the figure cannot be drawn",
    gaps: tuple[Gap, ...] = (),
    sides: tuple[str, str] = ("+", "−"),
    why: str = "",
    proportion: str = "",
    symbol: str | None = None,
    looked_up: bool = False,
    kept: bool = False,
    swings: bool = False,
    everywhere: bool = False,
) -> Callable[[F], Operation]:
    """Turn an annotated function into an `Operation` and enter it into the table.

    ``reads``: the result is a reading of the ruler and is rounded as one. ``across``: works across positions.
    ``condition(*values)``: how many times the relative error of what comes in is magnified (∞: no answer).
    ``fails``: why there may be no answer. ``sides``: what +1 and −1 of an argument of the kind Side, or a
    choice that the sentence names, are called. ``why``: its reason, with the names of the arguments and {it}.
    ``proportion``: two ratios of segments that are equal, "{A}{it}/{A}{B} = {C}{E}/{C}{D}", of which the first
    segment is sought; a segment is two points.

    ``symbol``: of geometrography, such as "E1 + E2 + R2", "" for what costs no work; None: that of its sort.
    ``looked_up``: in a row of standard values. ``kept``: it names what stands there already, so no hand slips.
    ``swings``: a ray drawn with the square, the protractor or by eye, which a hand swings; a line through two
    points is as good as they are. ``everywhere``: it works across positions, and leaves a mark at each of them.
    """

    def enter(function: F) -> Operation:
        hints = get_type_hints(function)
        leaves = hints.pop("return")
        parameters = inspect.signature(function).parameters.values()
        marks = [p.name for p in parameters if p.kind is not p.KEYWORD_ONLY]
        unknown = [name for name in marks if hints[name] not in KINDS]
        if unknown or leaves not in KINDS:
            raise TypeError(
                f"{function.__name__}: {unknown or 'the result'} has no kind of the board"
            )
        if function.__doc__ is None and sys.flags.optimize > 1:
            raise BareError
        sentence = " ".join((inspect.getdoc(function) or "").split("\n\n")[0].split())
        made = Operation(
            function.__name__,
            function,
            tuple(hints[name] for name in marks),
            tuple(marks),
            leaves,
            tuple(p.name for p in parameters if p.kind is p.KEYWORD_ONLY),
            sentence,
            sentence if formula else "",
            across,
            reads,
            condition,
            fails,
            gaps,
            sides,
            why,
            proportion,
            symbol,
            looked_up,
            kept,
            swings,
            everywhere,
        )
        if OPERATIONS.setdefault(made.name, made) is not made:
            raise TypeError(f"the board has two operations called {made.name}")
        return made

    return enter
