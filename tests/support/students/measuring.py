"""What a check says of planted drawings, held against the truth.

What counts as right, of the finding that is told first:

- **place**: its plan and segment (or the letter of its step) is that of the step at which the mistake was made,
  or of what was first read that shows it; a finding of a whole plan or drawing (no segment) is right where its
  family is; its position, if it tells one, is not another. "Look at step k" counts, and so does "begin with" of
  a report that tells no more.
- **family**: the planted one or what may be said for it as well (a component from the wrong end is a sense
  reversed); or what gives the same figures: what no reading tells apart from the name, as the finding says;
  what reads the same in the student's own drawing of it, within two scatters (a given within one); a slip of
  the only reading that shows a mistake.
- **member**: family and place, and the sentence (or one that no reading tells apart from it) has the words for
  what was taken.
- **wrong name**: a mistake at 80 % or more (a check that tells no chance is held to be sure) whose family or
  place is wrong; outside the grammar every one.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import groupby, product
from pathlib import Path
from typing import NamedTuple

from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.records import MISTAKE, SLIP, UNKNOWN, WRONG, Likely, Report, Taken
from graphic_tmm.scene.read import read
from support.gallery import CASES
from support.students.alike import same_figures, same_given
from support.students.kinds import Kind
from support.students.planting import Planted, Truth
from support.students.told import Told, alternatives
from support.students.writing import csv_of
from support.trials import checks

SURE = 0.8
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
        place = any(begun_with(report, truth) for truth in one.truths)
        return Outcome(one, report, place, right=right, wrong=wrong)
    first = told[0]
    ways = list(product(alternatives(first), one.truths))
    place = any(at_place(way, truth) for way, truth in ways)
    family = any(of_family(way, truth, one, kinds) for way, truth in ways)
    member = any(
        is_right(first, truth, one, kinds) and has_words(first, truth) for truth in one.truths
    )
    both = all(any(is_right(found, truth, one, kinds) for found in told) for truth in one.truths)
    return Outcome(one, report, place, family, member, right, wrong, both and bool(one.truths))


def begun_with(report: Report, truth: Truth) -> bool:
    """Whether a report without a finding lets begin where the mistake was made."""
    wrong = [row for row in report.readings if row.verdict == WRONG]
    shown = report.lessons[0].shown if report.lessons else next(iter(wrong), None)
    if not wrong or shown is None:
        return False
    plan, name = shown.taken.plan, shown.taken.segment
    return not {(plan, name), (plan, ""), ("", name)}.isdisjoint(truth.places)


def is_sure(found: Likely) -> bool:
    return found.chance >= SURE or found.chance == 0.0


def is_right(found: Likely, truth: Truth, one: Planted, kinds: Sequence[Kind]) -> bool:
    return any(
        at_place(way, truth) and of_family(way, truth, one, kinds) for way in alternatives(found)
    )


def has_words(found: Likely, truth: Truth) -> bool:
    sentences = (f"{found.name} {found.says}", *found.like)
    return any(all(re.search(word, says) for word in truth.words) for says in sentences)


def at_place(told: Told, truth: Truth) -> bool:
    """Whether a finding tells where a mistake was made."""
    if truth.position and told.position not in ("", truth.position):
        return False
    if not told.places or told.family == "crank":
        return told.family in truth.families
    if told.family == "given" and "given" in truth.families:
        names = [name for _, name in told.places]
        if any(re.search(word, name) for word in truth.words for name in names):
            return True
    own = {
        *told.places,
        *((plan, "") for plan, _ in told.places),
        *(("", name) for _, name in told.places),
    }
    return ("", "") in truth.places or not own.isdisjoint(truth.places)


def of_family(told: Told, truth: Truth, one: Planted, kinds: Sequence[Kind]) -> bool:
    """Whether a finding is of the family that was planted, or says what gives the same figures."""
    if told.kind == SLIP:
        return "slip" in truth.families or (truth.moved == 1 and bool(truth.families))
    if told.kind != MISTAKE or not truth.families:
        return False
    return told.family in truth.families or same_given(told, one) or same_figures(told, one, kinds)
