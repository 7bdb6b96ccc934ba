"""A formula: an operation whose text is its definition.

To add one: annotate a function's arguments and its result with kinds of `values`, let the docstring's first
paragraph be the formula, and write no body::

    @formula(fails=_ZERO_LENGTH)
    def rate(segment: Length, mu: Number, link: Length, mu_l: Number) -> Number:
        '''{segment}·{mu}/({link}·{mu_l})'''

From that text come what is computed (by numpy, and compiled), the line of the calculation note and the unit of
the result (`dimensions`). A function that has a body is computed by it: where the text as it stands would lose
digits, or where it is silent about an end that the body knows. Tests hold every body against its text.
"""

from __future__ import annotations

import linecache
import sys
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple, cast, get_type_hints, overload

import numpy as np

from graphic_tmm.board.formula_text import (
    FUNCTIONS,
    Node,
    condition_of,
    in_radians,
    names_of,
    tree_of,
    whole_power,
)
from graphic_tmm.board.grammar import Operation, operation
from graphic_tmm.board.values import Angle
from graphic_tmm.errors import BareError


class Formula(NamedTuple):
    """What the text of an operation says, where it holds, and whether a body computes it in other words.

    ``tree``, ``condition``: what ``text`` and ``holds`` say (None: it holds everywhere).
    """

    name: str
    arguments: tuple[str, ...]
    text: str
    holds: str
    tree: Node
    condition: Node | None
    has_body: bool


FORMULAS: dict[str, Formula] = {}
"""Every formula by the name of its operation."""


@overload
def formula(function: Callable[..., Any], /) -> Operation: ...


@overload
def formula(
    *, holds: str = "", fails: str | None = None, why: str = ""
) -> Callable[[Callable[..., Any]], Operation]: ...


def formula(
    function: Callable[..., Any] | None = None,
    /,
    *,
    holds: str = "",
    fails: str | None = None,
    why: str = "",
) -> Any:
    """Turn an annotated function whose docstring is a formula into an `Operation`.

    ``holds``: a condition on the arguments, in the same language ("{z1}·{z3} ≠ 0, {z2} > 0"). Elsewhere there
    is no answer (NaN), and ``fails`` says why; but a body answers in its own way. ``why``: the reason of the
    formula, see `operation`.

    Raises
    ------
    TypeError
        If the text cannot be read, its names are not those of the arguments, or nothing says why it may not
        hold.
    """

    def enter(function: Callable[..., Any]) -> Operation:
        if function.__doc__ is None and sys.flags.optimize > 1:
            raise BareError
        text = (function.__doc__ or "").split("\n\n")[0].strip()
        function.__annotations__ = kinds = get_type_hints(function)
        arguments = tuple(name for name in kinds if name != "return")
        has_body = function.__code__.co_code != _NO_BODY
        try:
            angles = frozenset(name for name, kind in kinds.items() if kind is Angle)
            tree = in_radians(tree_of(text, FUNCTIONS), angles)
            condition = in_radians(condition_of(holds, FUNCTIONS), angles) if holds else None
        except ValueError as error:
            raise TypeError(f"{function.__name__}: {error}") from error
        _check_names(function.__name__, tree, condition, set(arguments))
        made = Formula(function.__name__, arguments, text, holds, tree, condition, has_body)
        if holds and not has_body and fails is None:
            raise TypeError(f"{made.name}: where it does not hold it has to say why")
        run = function if has_body else _written(function, made)
        told = {} if fails is None else {"fails": fails}
        found = operation(formula=True, why=why, **told)(run)  # type: ignore[arg-type]
        FORMULAS[made.name] = made
        return found

    return enter if function is None else enter(function)


def _nothing() -> None:
    """A function without a body."""


_NO_BODY = _nothing.__code__.co_code


def _check_names(name: str, tree: Node, condition: Node | None, arguments: set[str]) -> None:
    used = names_of(tree)
    if unknown := sorted((used | (names_of(condition) if condition else set())) - arguments):
        raise TypeError(f"{name}: the formula names {unknown}, which are no arguments")
    if unused := sorted(arguments - used):
        raise TypeError(f"{name}: the formula does not use {unused}")


def _written(function: Callable[..., Any], made: Formula) -> Any:
    """Return the function that computes what the text says; its source can be asked for, as any other's."""
    body = _source(made.tree)
    if made.condition is not None:
        body = f"np.where({_source(made.condition)}, {body}, np.nan)"
    source = f"def {made.name}({', '.join(made.arguments)}):\n    return {body}\n"
    file = f"<formula {function.__module__}.{made.name}>"
    run = _compiled(made.name, source, file)
    linecache.cache[file] = (len(source), None, source.splitlines(True), file)
    run.__doc__, run.__module__ = function.__doc__, function.__module__
    run.__annotations__ = function.__annotations__
    return run


def computed(name: str, arguments: Sequence[str], tree: Node) -> Callable[..., Any]:
    """Return the function that computes a tree, as it is made of a formula; of angles in degrees."""
    source = f"def {name}({', '.join(arguments)}):\n    return {_source(tree)}\n"
    return cast("Callable[..., Any]", _compiled(name, source, f"<formula of {name}>"))


def _compiled(name: str, source: str, file: str) -> Any:
    space = {name: known.run for name, known in FUNCTIONS.items() if known.run} | {"np": np}
    exec(compile(source, file, "exec"), space)
    return space[name]


_SIGNS = {"−": "-", "·": "*", "^": "**", "≠": "!=", "≥": ">=", "≤": "<=", "=": "=="}


def _source(node: Node) -> str:
    """Return a tree as Python writes it."""
    if not node.parts:
        return _leaf(node)
    parts = [_source(part) for part in node.parts]
    if node.head == "neg":
        return f"(-{parts[0]})"
    if node.head == "±":
        return parts[0]
    if node.head == "and":
        return " & ".join(f"({part})" for part in parts)
    if node.head in FUNCTIONS:
        return f"{FUNCTIONS[node.head].written}({', '.join(parts)})"
    if node.head == "^" and whole_power(node):
        parts[1] = node.parts[1].word  # it stays whole: a square is then one product
    return f"({parts[0]} {_SIGNS.get(node.head, node.head)} {parts[1]})"


def _leaf(node: Node) -> str:
    if node.head == "π":
        return "np.pi"
    return node.word if node.head == "name" else repr(float(node.word))
