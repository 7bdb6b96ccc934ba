"""What a check says of planted drawings, held against the truth.

What counts as right, of the finding that is told first:

- **place**: its plan and segment (or the letter of its step) is that of the step at which the mistake was made,
  or of what was first read that shows it; a finding of a whole plan or drawing (no segment) is right where its
  family is; its position, if it tells one, is not another. "Look at step k" counts.
- **family**: the planted one or what may be said for it as well (a component from the wrong end is a sense
  reversed); or what is told gives the same figures within half a scatter (a given that is fitted: within one);
  so does a slip of the only reading that shows a mistake.
- **member**: family and place, and the sentence (or one that no reading tells apart from it) has the words for
  what was taken.
- **wrong name**: a mistake at 80 % or more (a check that tells no chance is held to be sure) whose family or
  place is wrong; outside the grammar every one.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import groupby
from pathlib import Path
from typing import NamedTuple

import numpy as np

from graphic_tmm.checking.check import checks
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.records import MISTAKE, SLIP, UNKNOWN, Likely, Report, Taken
from graphic_tmm.scene.read import read
from support.gallery import CASES
from support.students.drawing import Student
from support.students.kinds import AtStep, Kind
from support.students.places import own_places
from support.students.planting import Planted, Truth, mind_of, numbers, scatter
from support.students.records import F, Hand
from support.students.writing import ALL, csv_of, rows_of

SURE = 0.8
VIEWS_OF_FORCES = ("loads", "group", "forces", "link", "lever", "couples")
TOLD = (MISTAKE, SLIP, UNKNOWN)


class Outcome(NamedTuple):
    """A drawing and its report: what is right of the finding told first, how many sure names are."""

    planted: Planted
    report: Report
    place: bool = False
    family: bool = False
    member: bool = False
    right: int = 0
    wrong: int = 0
    both: bool = False

    @property
    def named(self) -> bool:
        """Whether any mistake is named, however sure."""
        return any(one.kind == MISTAKE for one in self.report.mistakes)


def outcomes(
    planted: Sequence[Planted], folder: Path, kinds: Sequence[Kind] = ()
) -> Iterator[Outcome]:
    """Yield what a check says of drawings; ``kinds``: those by which names are held to say the same."""

    def of(one: Planted) -> tuple[str, str]:
        return one.machine, one.mode

    path = folder / "readings.csv"
    for (machine, _), group in groupby(sorted(planted, key=of), of):
        drawings = list(group)

        def readings(drawings: list[Planted] = drawings) -> Iterator[tuple[str, tuple[Taken, ...]]]:
            for one in drawings:
                path.write_text(csv_of(one.rows), "utf-8")
                yield str(one.seed), read_readings(path)

        found = checks(read(CASES / "check" / f"{machine}.toml"), readings())
        for one, report in zip(drawings, found, strict=True):
            yield outcome(one, report, kinds)


def outcome(one: Planted, report: Report, kinds: Sequence[Kind]) -> Outcome:
    """Hold a report against the truth."""
    told = [found for found in report.mistakes if found.kind in TOLD]
    sure = [found for found in told if found.kind == MISTAKE and is_sure(found)]
    good = [any(is_right(found, truth, one, kinds) for truth in one.truths) for found in sure]
    right, wrong = sum(good), len(good) - sum(good)
    if not told:
        return Outcome(one, report, right=right, wrong=wrong)
    first = told[0]
    place = any(at_place(first, truth) for truth in one.truths)
    family = any(of_family(first, truth, one, kinds) for truth in one.truths)
    member = any(
        is_right(first, truth, one, kinds) and has_words(first, truth) for truth in one.truths
    )
    both = all(any(is_right(found, truth, one, kinds) for found in told) for truth in one.truths)
    return Outcome(one, report, place, family, member, right, wrong, both and bool(one.truths))


def is_sure(found: Likely) -> bool:
    return found.chance >= SURE or found.chance == 0.0


def is_right(found: Likely, truth: Truth, one: Planted, kinds: Sequence[Kind]) -> bool:
    return at_place(found, truth) and of_family(found, truth, one, kinds)


def at_place(found: Likely, truth: Truth) -> bool:
    """Whether a finding tells where a mistake was made."""
    if truth.position and found.position not in ("", truth.position):
        return False
    plan, names = told_place(found)
    if not names or found.family == "crank":
        return found.family in truth.families
    if found.family == "given" and "given" in truth.families:
        return any(re.search(word, name) for word in truth.words for name in names)
    own = {(plan, name) for name in (*names, "")} | {("", name) for name in names}
    return ("", "") in truth.places or not own.isdisjoint(truth.places)


def told_place(found: Likely) -> tuple[str, set[str]]:
    """Return the plan and the names that a finding tells, as the student calls them.

    Lines stand in brackets; the views of forces are his plan of forces, their ordinates his forces.
    """
    plan = F if found.plan.split()[0:1] and found.plan.split()[0] in VIEWS_OF_FORCES else found.plan
    names = {name.strip("()") for name in (found.segment, found.step) if name}
    if plan == F:
        names |= {name[1:] for name in names if re.match("y[A-Z]", name)}
    if found.family == "given":
        names |= {name[1:] for name in names if re.match("l[A-Z]", name)}
    return plan, names


def of_family(found: Likely, truth: Truth, one: Planted, kinds: Sequence[Kind]) -> bool:
    """Whether a finding is of the family that was planted, or says what gives the same figures."""
    if found.kind == SLIP:
        return "slip" in truth.families or (truth.moved == 1 and bool(truth.families))
    if found.kind != MISTAKE or not truth.families:
        return False
    if found.family in truth.families:
        return True
    return same_given(found, one) or same_figures(found, one, kinds)


def same_given(found: Likely, one: Planted) -> bool:
    """Whether a given, taken so many times as large as the finding tells, reads the same within a scatter."""
    told = re.search(r"taken ([\d.]+) times", found.says)
    names = told_place(found)[1] & ALL[one.machine].given.keys()
    if found.family != "given" or not told or not names:
        return False
    given = {name: ALL[one.machine].given[name] * float(told[1]) for name in names}
    student = Student(ALL[one.machine], Hand(ruler=one.ruler), one.seed, given=given)
    return _alike(one, student, scatter(one.machine, one.mode, one.ruler), 1.0)


def has_words(found: Likely, truth: Truth) -> bool:
    sentences = (f"{found.name} {found.says}", *found.like)
    return any(all(re.search(word, says) for word in truth.words) for says in sentences)


def same_figures(found: Likely, one: Planted, kinds: Sequence[Kind]) -> bool:
    """Whether a mistake of the family told, at the place told, reads the same within half a scatter."""
    plan, names = told_place(found)
    at = {(plan, name) for name in names}
    by = scatter(one.machine, one.mode, one.ruler)
    honest = Student(ALL[one.machine], Hand(ruler=one.ruler), one.seed).draw()
    for kind in kinds:
        if not isinstance(kind, AtStep) or found.family not in kind.families:
            continue
        for step in honest.steps:
            if step.kind not in kind.of or own_places(step).isdisjoint(at):
                continue
            if found.position not in ("", str(step.position)):
                continue
            position = step.position if found.position else None
            for takes, _ in kind.variants(step, honest):
                mind = mind_of(step, takes, position)
                if _alike(one, Student(ALL[one.machine], honest.hand, one.seed, mind), by):
                    return True
    return False


def _alike(
    one: Planted, student: Student, by: dict[tuple[str, str, str], np.ndarray], share: float = 0.5
) -> bool:
    try:
        with np.errstate(all="ignore"):
            rows = rows_of(student.draw(), one.mode)
    except KeyError:
        return False
    if rows.keys() != one.rows.keys():
        return False
    return all(
        not np.any(np.abs(numbers(rows[key]) - numbers(cells)) > share * by[key])
        for key, cells in one.rows.items()
    )
