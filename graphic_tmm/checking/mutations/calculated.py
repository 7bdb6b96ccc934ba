"""A calculation made otherwise: by another formula, with a factor, another scale factor, in other units."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cache
from typing import Any

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.record import Step
from graphic_tmm.board.values import Length, Number
from graphic_tmm.checking.mutations import words
from graphic_tmm.checking.mutations.formulas import is_product, otherwise, with_sense
from graphic_tmm.checking.mutations.mutation import (
    FACTOR,
    LEFT_OUT,
    POWER,
    SCALE,
    SENSE,
    UNUSUAL,
    Change,
    Key,
    Mutation,
    at_step,
    using,
)
from graphic_tmm.checking.mutations.scope import Scope, is_scale

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
        key = (family, step.op.name, one.op.formula)
        told = {"formula": one.op.formula, "usual": usual}
        yield key, at_step(step, family, words.FORMULA, change, **told)
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
    key: Key = (roles.INERTIA,) if step.it.role == roles.INERTIA else (SENSE, step.op.name)
    yield key, at_step(step, SENSE, words.SENSE, Change(step, factor=-1.0))


def units(step: Step, scope: Scope) -> Iterator[tuple[Key, Mutation]]:
    """What is given is taken in another unit in one formula: turns a minute for rad/s, kilograms for N."""
    if not step.op.formula or step.op.across:
        return
    for k, was in enumerate(step.uses):
        if was.kind is Number and was.slot in scope.given:
            for factor in BY_UNIT.get(was.unit, ()):
                change = Change(step._replace(op=_used_times(step.op, k, factor)))
                told = {"was": was, "times": factor, "usual": 2.0}
                key = (FACTOR, step.op.name, was.name, factor)
                yield key, at_step(step, FACTOR, words.USED_TIMES, change, **told)


@cache
def _used_times(op: Operation, k: int, factor: float) -> Operation:
    run: Callable[..., Any] = op.run
    return op._replace(run=lambda *v, **c: run(*v[:k], factor * v[k], *v[k + 1 :], **c))
