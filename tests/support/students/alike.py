"""Whether what a finding tells gives the figures of what was planted, by the student's own drawing of it."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np

from support.students.drawing import Student
from support.students.kinds import AtStep, Kind
from support.students.places import own_places
from support.students.planting import Planted, mind_of, numbers, scatter
from support.students.records import Hand
from support.students.told import Told
from support.students.writing import ALL, rows_of


def same_given(told: Told, one: Planted) -> bool:
    """Whether a given, taken so many times as large as the finding tells, reads the same within a scatter."""
    by = re.search(r"taken ([\d.]+) times", told.says)
    names = {name for _, name in told.places} & ALL[one.machine].given.keys()
    if told.family != "given" or not by or not names:
        return False
    given = {name: ALL[one.machine].given[name] * float(by[1]) for name in names}
    student = Student(ALL[one.machine], Hand(ruler=one.ruler), one.seed, given=given)
    return _alike(one, student, scatter(one.machine, one.mode, one.ruler), 1.0)


def same_figures(told: Told, one: Planted, kinds: Sequence[Kind]) -> bool:
    """Whether a mistake of the family told, at the place told, reads the same within two scatters.

    Rays that another mistake draws elsewhere have slips of their own.
    """
    by = scatter(one.machine, one.mode, one.ruler)
    honest = Student(ALL[one.machine], Hand(ruler=one.ruler), one.seed).draw()
    for kind in kinds:
        if not isinstance(kind, AtStep) or told.family not in kind.families:
            continue
        for step in honest.steps:
            if step.kind not in kind.of or own_places(step).isdisjoint(told.places):
                continue
            if told.position not in ("", str(step.position)):
                continue
            position = step.position if told.position else None
            for takes, _ in kind.variants(step, honest):
                mind = mind_of(step, takes, position)
                if _alike(one, Student(ALL[one.machine], honest.hand, one.seed, mind), by):
                    return True
    return False


def _alike(
    one: Planted, student: Student, by: dict[tuple[str, str, str], np.ndarray], share: float = 2.0
) -> bool:
    try:
        with np.errstate(all="ignore"):
            rows = rows_of(student.draw(), one.mode)
    except (KeyError, ArithmeticError):  # nothing can be drawn so
        return False
    if rows.keys() != one.rows.keys():
        return False
    return all(
        not np.any(np.abs(numbers(rows[key]) - numbers(cells)) > share * by[key])
        for key, cells in one.rows.items()
    )
