"""A formula calculated otherwise: small changes of its text, as a student makes them.

A power left out or put on, a product for a quotient, a term left out or with the other sign, sin for cos, a
figure left out: each is a formula again, with a text that can be told.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.formula import FORMULAS, computed
from graphic_tmm.board.formula_text import Node, names_of, text_of
from graphic_tmm.board.grammar import Operation
from graphic_tmm.checking.mutations.mutation import FACTOR, LEFT_OUT, OPERAND, POWER, SENSE

OTHERS = {"sin": "cos", "cos": "sin", "tan": "sin", "min": "max", "max": "min"}
"""Functions that are taken for one another."""


class Otherwise(NamedTuple):
    """A formula calculated otherwise: what kind of mistake it is, as an operation, of which arguments."""

    family: str
    op: Operation
    touched: frozenset[str]


@cache
def otherwise(op: Operation) -> tuple[Otherwise, ...]:
    """Return a formula as it is calculated by mistake, each text once; none of what is no formula."""
    if op.name not in FORMULAS:
        return ()
    formula = FORMULAS[op.name]
    found: dict[str, Otherwise] = {}
    for family, tree, touched in _changed(formula.tree):
        if not names_of(tree) or tree == formula.tree:
            continue
        text = text_of(tree)
        run = computed(op.name, formula.arguments, tree)
        found.setdefault(text, Otherwise(family, op._replace(run=run, formula=text), touched))
    return tuple(found.values())


@cache
def with_sense(op: Operation, right: Operation) -> Operation:
    """Return an operation whose result has the sense of the right one, of the inputs that follow its own.

    A product is calculated without signs, and its sense told by a rule.
    """
    count = len(op.arguments)

    def run(*values: Any) -> Any:
        found, due = op.run(*values[:count]), right.run(*values[-count:])
        return np.abs(found) * np.where(due < 0.0, -1.0, 1.0)

    return op._replace(run=run)


def is_product(op: Operation) -> bool:
    """Whether a formula is of products, quotients and powers alone."""
    return op.name in FORMULAS and _heads(FORMULAS[op.name].tree) <= {
        *("·", "/", "^", "neg", "name", "figure", "π", "sqrt"),
    }


def _heads(node: Node) -> set[str]:
    return {node.head}.union(*(_heads(part) for part in node.parts))


def _changed(node: Node) -> Iterator[tuple[str, Node, frozenset[str]]]:
    """Yield a tree with one small change, its kind, and the names that stand in what is changed."""
    for family, other, touched in _here(node):
        yield family, other, touched
    for k, part in enumerate(node.parts):
        if node.head == "^" and k == 1:
            continue
        for family, other, touched in _changed(part):
            yield family, _with(node, k, other), touched


def _with(node: Node, k: int, part: Node) -> Node:
    return node._replace(parts=(*node.parts[:k], part, *node.parts[k + 1 :]))


def _here(node: Node) -> Iterator[tuple[str, Node, frozenset[str]]]:
    names = names_of(node)
    if node.head == "^":
        yield POWER, node.parts[0], names_of(node.parts[0])
        yield from _of_bracket(node)
    elif node.head == "name":
        yield POWER, _squared(node), names
    elif node.head in ("·", "/"):
        yield from _of_product(node)
    elif node.head in ("+", "−"):
        one, other = node.parts
        yield LEFT_OUT, one, names_of(other)
        yield LEFT_OUT, other if node.head == "+" else Node("neg", (other,)), names_of(one)
        yield SENSE, node._replace(head="−" if node.head == "+" else "+"), names_of(other)
    elif node.head == "neg":
        yield SENSE, node.parts[0], names
    elif node.head == "sqrt":
        yield POWER, node.parts[0], names
    elif node.head in OTHERS:
        yield OPERAND, node._replace(head=OTHERS[node.head]), names


def _of_product(node: Node) -> Iterator[tuple[str, Node, frozenset[str]]]:
    one, other = node.parts
    if names_of(other):
        turned = "·" if node.head == "/" else "/"
        yield POWER, node._replace(head=turned), names_of(other)
        if names_of(one):
            yield LEFT_OUT, one, names_of(other)
    else:
        yield FACTOR, one, frozenset()
    if names_of(other) and names_of(one) and node.head == "·":
        yield LEFT_OUT, other, names_of(one)
    if node.head == "/" and names_of(one) and names_of(other):
        yield POWER, Node("/", (other, one)), names_of(node)
    if not names_of(one) and names_of(other) and node.head == "·":
        yield FACTOR, other, frozenset()
    if one.head == other.head == "name" and node.head == "·":
        yield POWER, _squared(node), names_of(node)


def _of_bracket(node: Node) -> Iterator[tuple[str, Node, frozenset[str]]]:
    """Yield the square of a product of which one factor is left as it is."""
    inner, power = node.parts
    if inner.head == "·":
        one, other = inner.parts
        yield POWER, Node("·", (Node("^", (one, power)), other)), names_of(other)
        yield POWER, Node("·", (one, Node("^", (other, power)))), names_of(one)


def _squared(node: Node) -> Node:
    return Node("^", (node, Node("figure", (), "2")))
