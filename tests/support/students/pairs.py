"""Drawings with two mistakes at once, at different steps; each shows by itself, and beside the other."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from support.another_hand import Rows
from support.students.drawing import Student
from support.students.kinds import AtStep
from support.students.places import own_places
from support.students.planting import TRIES, Planted, Truth, choose, mind_of, moved
from support.students.records import Hand, Mind, Operands, Step
from support.students.writing import ALL, rows_of


def two(
    a: AtStep, b: AtStep, machine: str, seed: int, mode: str, ruler: float = 0.5
) -> Planted | None:
    """Draw with two mistakes at once, each of which shows by itself, and some reading beside the other."""
    rng = np.random.default_rng(seed)
    honest = Student(ALL[machine], Hand(ruler=ruler), seed).draw()
    due = rows_of(honest, mode)
    for _ in range(TRIES):
        minds: list[Mind] = []
        truths: list[Truth] = []
        for kind in (a, b):
            chosen = choose(kind, rng, honest)
            if chosen is None:
                return None
            step, takes, words, position, every = chosen
            minds.append(mind_of(step, takes, position, kind if every else None))
            truths += _alone(
                kind, machine, seed, mode, minds[-1], step, position, words, due, ruler
            )
        if len(truths) < 2 or truths[0].places & truths[1].places:
            continue

        def both(step: Step, minds: list[Mind] = minds) -> Operands:
            return {**minds[0](step), **minds[1](step)}

        with np.errstate(all="ignore"):
            drawn = Student(ALL[machine], Hand(ruler=ruler), seed, both).draw()
        rows = rows_of(drawn, mode)
        if rows.keys() != due.keys():
            continue
        found = Planted(machine, mode, seed, rows, (), ruler)
        beside = [
            len(moved(found, _rows(machine, mode, seed, ruler, other) or {}))
            for other in reversed(minds)
        ]
        if all(beside):
            told = zip(truths, beside, strict=True)
            return found._replace(truths=tuple(one._replace(moved=n) for one, n in told))
    return None


def _rows(machine: str, mode: str, seed: int, ruler: float, mind: Mind) -> Rows | None:
    """Return what is read of a drawing with one mistake; None if it cannot be drawn to its end."""
    try:
        with np.errstate(all="ignore"):
            return rows_of(Student(ALL[machine], Hand(ruler=ruler), seed, mind).draw(), mode)
    except (KeyError, ArithmeticError):
        return None


def _alone(
    kind: AtStep, machine: str, seed: int, mode: str, mind: Mind, step: Step, position: int | None,
    words: tuple[str, ...], due: Rows, ruler: float,
) -> Iterator[Truth]:  # fmt: skip
    rows = _rows(machine, mode, seed, ruler, mind)
    if rows is None or rows.keys() != due.keys():
        return
    at = "" if position is None else str(position)
    first = moved(Planted(machine, mode, seed, rows, (), ruler), due)
    if first:
        shown = [(key[0], key[2]) for key in first if key[1] == (at or first[0][1])][:1]
        yield Truth(
            kind.name, kind.families, frozenset({*own_places(step), *shown}), at, words, len(first)
        )
