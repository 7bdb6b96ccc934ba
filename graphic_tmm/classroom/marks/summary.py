"""The summary of a class as rows of text: what its every form shows, before any escapes it for its medium."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import NamedTuple

from graphic_tmm.checking.report.rows import LONGEST_SENTENCE, shown
from graphic_tmm.classroom.marks.judging import REPORTS
from graphic_tmm.classroom.marks.marking import Entry, Marked
from graphic_tmm.classroom.marks.row import asked
from graphic_tmm.classroom.marks.rule import FIVE, decimal
from graphic_tmm.classroom.marks.rule_words import told
from graphic_tmm.language.catalogue import Tongues, speaking
from graphic_tmm.language.said import said

NAMED = 3
"""So many mistakes of a hand-in are told; its report has all."""
HEADS = {
    "name": said("handed in", context="class"),
    "variant": said("variant", context="class"),
    "mark": said("mark", context="class"),
    "points": said("points", context="class"),
    "readings": said("readings", context="class"),
    "fine": said("fine", context="class"),
    "doubtful": said("doubtful", context="class"),
    "wrong": said("wrong", context="class"),
    "plans": said("plans", context="class"),
    "asked": said("of asked", context="class"),
    "mistakes": said("mistakes", context="class"),
    "remarks": said("remarks", context="class"),
}
"""The columns, by their names."""
WORDS = Tongues(HEADS)
FIGURES = frozenset({"points", "readings", "fine", "doubtful", "wrong"})
"""Columns of numbers."""


class Line(NamedTuple):
    """A row of the summary: its cells by column; ``mark`` and points are numbers where they are any.

    ``worst``: "wrong", "doubtful", "fine"; ``report``: the file of its report in the folder of the summary.
    """

    cells: dict[str, str]
    worst: str
    report: str


def lines(marked: Marked) -> tuple[Line, ...]:
    """Return the rows of a class, in the order of its names."""
    remarks = _remarks(marked)
    return tuple(_line(marked, one, remarks[k]) for k, one in enumerate(marked.entries))


def _line(marked: Marked, one: Entry, remarks: list[str]) -> Line:
    row, plans = one.row, asked(marked.rule, one.row)
    count = Counter(plan.there for plan in plans)[True]
    wrong = len(row.wrong)
    cells = {
        "name": shown(one.hand_in.name),
        "variant": one.hand_in.variant,
        "mark": one.mark.text,
        "points": decimal(one.mark.points, 2),
        "readings": str(row.readings),
        "fine": str(row.fine),
        "doubtful": str(row.doubtful),
        "wrong": str(wrong),
        "plans": f"{count}/{len(plans)}",
        "asked": f"{sum(p.given for p in plans)}/{sum(p.asked for p in plans)}",
        "mistakes": " ".join(shown(c.says, LONGEST_SENTENCE) for c in row.causes[:NAMED]),
        "remarks": " ".join(remarks),
    }
    worst = "wrong" if wrong else "doubtful" if row.doubtful else "fine"
    return Line(cells, worst, f"{REPORTS}/{one.hand_in.file}.html")


def _remarks(marked: Marked) -> list[list[str]]:
    """Return what is told beside each row, and is no part of its mark."""
    speech = speaking(marked.language)
    found: list[list[str]] = [[] for _ in marked.entries]
    for k, one in enumerate(marked.entries):
        if one.other is not None:
            says = said(
                "Looks like variant {other}: {fits} of the {count} readings that tell them apart fit it.",
                other=one.other.variant,
                fits=one.other.fits,
                count=one.other.of,
            )
            found[k].append(speech(says))
    for pair in marked.pairs:
        for k, other in ((pair.one, pair.other), (pair.other, pair.one)):
            says = said(
                "Alike: {other}, {equal} of {count} readings equal.",
                other=shown(marked.entries[other].hand_in.name),
                equal=pair.equal,
                count=pair.of,
            )
            found[k].append(speech(says))
    return found


def skipped(marked: Marked) -> tuple[tuple[str, str], ...]:
    """Return what was skipped, each with why, on one line."""
    return tuple((shown(one.name), shown(one.why, LONGEST_SENTENCE)) for one in marked.skipped)


def rule(marked: Marked) -> tuple[str, ...]:
    """Return the rule in words, with how it came to be."""
    speech = speaking(marked.language)
    usual = marked.rule._replace(plans=()) == FIVE
    first = [speech(said("No rule was given: this is the usual one."))] if usual else []
    return (*first, *told(marked.rule, marked.language, marked.plans))


def pairs(marked: Marked) -> tuple[str, ...]:
    """Return the pairs that are alike, a sentence each."""
    return tuple(map(speaking(marked.language), _pairs(marked)))


def _pairs(marked: Marked) -> Iterator[str]:
    for pair in marked.pairs:
        one, other = (marked.entries[k].hand_in.name for k in (pair.one, pair.other))
        yield said(
            "Alike: {one} and {other}, {equal} of {count} readings equal.",
            one=shown(one),
            other=shown(other),
            equal=pair.equal,
            count=pair.of,
        )
