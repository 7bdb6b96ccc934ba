"""A calculation made otherwise: by another formula, with a factor, another scale factor, in other units."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.formula import FORMULAS, computed
from graphic_tmm.board.formula_text import Node, names_of, tree_text
from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.record import Step
from graphic_tmm.board.values import Length, Number
from graphic_tmm.checking.mutations import words
from graphic_tmm.checking.mutations.mutation import (
    FACTOR,
    LEFT_OUT,
    OPERAND,
    POWER,
    SCALE,
    SENSE,
    UNUSUAL,
    Change,
    Key,
    Mutation,
    Scope,
    at_step,
    is_scale,
    using,
)

OTHERS = {"sin": "cos", "cos": "sin", "tan": "sin", "min": "max", "max": "min"}
"""Functions that are taken for one another."""
FORCE = "N"
"""The unit of forces: what has another one and is an inertia load is a couple."""


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
        text = tree_text(tree)
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


POWERS_OF_TEN = (10.0, 0.1, 100.0, 0.01, 1000.0, 0.001)
BY_UNIT: Mapping[str, tuple[float, ...]] = {
    "1/s": (
        *(np.pi / 30.0, 30.0 / np.pi, np.pi / 180.0, 180.0 / np.pi),
        *(2.0 * np.pi, 0.5 / np.pi, np.pi, 1.0 / np.pi),
    ),
    "1/s²": (np.pi / 180.0, 180.0 / np.pi),
    "°": (np.pi / 180.0, 180.0 / np.pi),
    "N": (9.81, 1.0 / 9.81),
    "N·m": (9.81, 1.0 / 9.81),
}
"""Factors that units are mistaken by: turns a minute (π left out, too), degrees, kilograms of force."""


def formulas(step: Step, scope: Scope) -> Iterator[tuple[Key, Mutation]]:
    """It is calculated by another formula."""
    by = dict(zip(step.op.arguments, step.uses, strict=True))
    for one in otherwise(step.op):
        marks = [by[name] for name in one.touched]
        only_scales = bool(marks) and all(map(is_scale, marks))
        family = SCALE if only_scales else one.family
        squared = one.op.formula.count("²") > step.op.formula.count("²")
        odd = family == LEFT_OUT and len(one.touched) > 1
        turned = only_scales or (any(map(is_scale, marks)) and family == POWER)
        usual = UNUSUAL if squared or odd or turned else 1.0
        change = Change(step._replace(op=one.op))
        if is_product(step.op) and one.family != SENSE:
            change = Change(step._replace(op=with_sense(one.op, step.op)))
        key: Key = (family, step.op.name, one.op.formula)
        if only_scales and step.it.role and one.family == LEFT_OUT:
            key = (family, step.it.role, *(mark.slot for mark in marks))
        text = one.op.formula
        if FORMULAS[step.op.name].tree.head == "+" and family in words.OF_SUM and len(marks) == 1:
            usual = UNUSUAL if marks[0].role else 1.0  # what was summed up before
            says, was = words.OF_SUM[family], marks[0]
            yield (), at_step(step, family, says, change, was=was, usual=usual)
            continue
        yield key, at_step(step, family, words.FORMULA, change, formula=text, usual=usual)
    scales = [(k, m) for k, m in enumerate(step.uses) if is_scale(m)]
    for k, was in scales:
        for now in scope.scales:
            if now.unit != was.unit and now.name != was.name and step.op.formula:
                change = Change(using(step, k, now))
                yield (
                    (SCALE, was.slot, now.slot),
                    at_step(step, SCALE, words.ANOTHER_SCALE, change, was=was, now=now),
                )


def factors(step: Step, scope: Scope) -> Iterator[tuple[Key, Mutation]]:
    """What is calculated is so many times too large; nothing of it is left; its sign is the other one."""
    if step.it.kind not in (Length, Number) or not step.op.formula or step.op.across:
        return
    unit = step.it.unit
    for factor in (2.0, 0.5, *POWERS_OF_TEN, *BY_UNIT.get(unit, ())):
        usual = 1.0 if factor in (2.0, 0.5) else 2.0
        change = Change(step, factor=factor)
        of = (FACTOR, step.op.name, factor)
        yield of, at_step(step, FACTOR, words.FACTOR, change, times=factor, usual=usual)
    yield (
        (LEFT_OUT, step.op.name),
        at_step(step, LEFT_OUT, words.LEFT_OUT, Change(step, factor=0.0)),
    )
    key: Key = (SENSE, step.op.name)
    if step.it.role == roles.INERTIA and step.it.unit != FORCE:
        key = (roles.INERTIA, Number)  # of a couple; a force is turned with its line
    yield key, at_step(step, SENSE, words.SENSE, Change(step, factor=-1.0))


def units(step: Step, scope: Scope) -> Iterator[tuple[Key, Mutation]]:
    """What is given is taken in another unit in one formula: turns a minute for rad/s, mm for m."""
    if not step.op.formula or step.op.across:
        return
    for k, was in enumerate(step.uses):
        if was.kind is Number and was.slot in scope.given:
            for factor in BY_UNIT.get(was.unit, ()):
                change = Change(step._replace(op=_used_times(step.op, k, factor)))
                one = at_step(step, FACTOR, words.USED_TIMES, change, was=was, times=factor)
                yield (FACTOR, step.op.name, was.name, factor), one._replace(usual=2.0)
        measured = any(mark.kind is Length for mark in step.uses)
        if measured and is_scale(was) and was.unit == "m/mm":
            change = Change(step._replace(op=_on_paper(step.op, k)))
            one = at_step(step, SCALE, words.ON_PAPER, change, was=was, usual=UNUSUAL)
            yield (SCALE, step.op.name, "on paper"), one


MILLIMETRE = 0.001
"""In m: what a millimetre of the paper stands for where nobody has drawn to scale."""


@cache
def _on_paper(op: Operation, k: int) -> Operation:
    run: Callable[..., Any] = op.run
    return op._replace(run=lambda *v, **c: run(*v[:k], 0.0 * v[k] + MILLIMETRE, *v[k + 1 :], **c))


@cache
def _used_times(op: Operation, k: int, factor: float) -> Operation:
    run: Callable[..., Any] = op.run
    return op._replace(run=lambda *v, **c: run(*v[:k], factor * v[k], *v[k + 1 :], **c))
