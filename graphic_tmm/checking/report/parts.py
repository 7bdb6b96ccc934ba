"""What a report shows of its readings: the steps that are blamed, with their lessons, and tables."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

from graphic_tmm.checking.cells import segment_text
from graphic_tmm.checking.records import (
    DOUBTFUL,
    FINE,
    INSTRUMENT,
    MISTAKE,
    WRONG,
    Judged,
    Lesson,
    PlanPicture,
    Report,
)
from graphic_tmm.checking.report.findings import finding, idle, sure, where
from graphic_tmm.checking.report.rows import (
    LEGEND,
    LONGEST_SENTENCE,
    WORDS,
    Grid,
    by_plan,
    figure_of,
    own_error,
    plan_name,
    printable_text,
    reading_grid,
    unit_name,
)
from graphic_tmm.language.numbers import number
from graphic_tmm.scene.captions import captions

LONG = 12
"""A table of more rows that follow from a mistake is folded: twelve positions of a segment are not."""
KNOWN = ("farther",)
"""What is so of every reading that is wrong: no drawing of the hand is farther off."""


class Part(NamedTuple):
    """A part of a report: its heading, what is told in paragraphs, its readings, a picture and what it shows.

    ``grid`` is None where no reading is of it; ``folded``: what it is folded under, a long table of what
    follows from a mistake.
    """

    heading: str
    told: tuple[str, ...] = ()
    grid: Grid | None = None
    picture: PlanPicture | None = None
    caption: str = ""
    folded: str = ""


def wrong_parts(report: Report) -> tuple[Part, ...]:
    """Return the steps that are blamed, in the order of the log; then the wrong readings of no step.

    The steps of the findings stand before the others, the first one's first. Behind that of a mistake stand the
    other readings that it explains: they are wrong for it, and have no lesson of their own. Where a mistake is
    that of no step its readings stand alone.
    """
    language, words = report.language, WORDS[report.language]
    rows = [one for one in report.readings if one.verdict == WRONG]
    named = _named(report)
    follows = {line for _, lines in named.values() for line in lines}
    found: list[Part] = []
    told = set[int]()

    def follow(mistake: int) -> None:
        lesson, lines = named[mistake]
        its = [n for n, one in enumerate(rows) if one.taken.line in lines and n not in told]
        says = (
            ()
            if lesson is not None or not mistake
            else (finding(report.mistakes[mistake], language),)
        )
        found.extend(_tables([rows[n] for n in its], words["for that"], language, says, LONG))
        told.update(its)

    last = len(report.mistakes)
    turns = [(min(one.names, default=last), k) for k, one in enumerate(report.lessons)]
    if report.mistakes and idle(report):
        turns = [(mistake or last + 1, k) for mistake, k in turns]
    turns += [(mistake, -1) for mistake, (lesson, _) in named.items() if lesson is None]
    for mistake, k in sorted(turns):
        if k < 0:
            follow(mistake)
            continue
        lesson, names = report.lessons[k], [one for one, its in named.items() if its[0] == k]
        own = [n for n, one in enumerate(rows) if _blames(lesson, one)]
        left = [n for n in own if names or rows[n].taken.line not in follows]
        left = [n for n in left if n not in told]
        if left or not own or names:
            found.append(_lesson(lesson, [rows[n] for n in left], language))
            told.update(left)
        for one in names:
            follow(one)
    rest = [one for n, one in enumerate(rows) if n not in told]
    return (*found, *_tables(rest, words["wrong ones"], language))


def _tables(
    rows: Sequence[Judged],
    heading: str,
    language: str,
    says: tuple[str, ...] = (),
    most: float = math.inf,
) -> list[Part]:
    """Return the tables of readings without a lesson, plan by plan, each folded if longer than ``most`` rows.

    ``says`` stands over the first.
    """
    found: list[Part] = []
    for plan, readings in by_plan(rows).items():
        head = heading.format(plan=plan_name(plan, language))
        grid = reading_grid(readings, language, head, KNOWN)
        fold = (
            WORDS[language]["so many"].format(count=len(readings)) if len(readings) > most else ""
        )
        found.append(Part(head, () if found else says, grid, folded=fold))
    return found


def _named(report: Report) -> dict[int, tuple[int | None, frozenset[int]]]:
    """Return of each mistake that is sure (by number) its lesson, None for none, and the lines it explains."""
    found: dict[int, tuple[int | None, frozenset[int]]] = {}
    for k, one in enumerate(report.mistakes):
        lesson = next((n for n, its in enumerate(report.lessons) if k in its.names), None)
        if sure(one) and (one.kind == MISTAKE or (one.kind == INSTRUMENT and lesson is None)):
            found[k] = lesson, frozenset(one.lines) - {0}
    return found


def doubtful_parts(report: Report) -> tuple[Part, ...]:
    """Return what is doubtful, plan by plan."""
    words, found = WORDS[report.language], []
    for plan, readings in by_plan(_of(report, DOUBTFUL)).items():
        heading = words["doubtful ones"].format(plan=plan_name(plan, report.language))
        found.append(Part(heading, (), reading_grid(readings, report.language, heading)))
    return tuple(found)


def verdict_parts(report: Report) -> list[tuple[str, Part]]:
    """Return what is wrong, then what is doubtful, each part with its verdict."""
    found = ((WRONG, wrong_parts(report)), (DOUBTFUL, doubtful_parts(report)))
    return [(verdict, part) for verdict, parts in found for part in parts]


def fine_grids(report: Report) -> tuple[Grid, ...]:
    """Return the tables of what is fine, plan by plan."""
    return tuple(
        reading_grid(readings, report.language, plan_name(plan, report.language))
        for plan, readings in by_plan(_of(report, FINE)).items()
    )


def fine_ones(report: Report) -> str:
    """Return how many readings are fine; "" if none is."""
    count = len(_of(report, FINE))
    return WORDS[report.language]["fine ones"].format(count=count) if count else ""


def grids(report: Report) -> tuple[Grid, ...]:
    """Return all tables of a report, in order."""
    there = (part.grid for _, part in verdict_parts(report))
    return (*(grid for grid in there if grid is not None), *fine_grids(report))


def legend(report: Report, grids: Sequence[Grid]) -> str:
    """Return what the columns of tables mean; "" if there are none."""
    shown_ones = {key for grid in grids for key in grid.columns}
    texts = LEGEND[report.language]
    return " ".join(texts[key] for key in texts if key in shown_ones)


def _of(report: Report, verdict: str) -> list[Judged]:
    return [one for one in report.readings if one.verdict == verdict]


def _blames(lesson: Lesson, one: Judged) -> bool:
    if lesson.segment:
        return (one.taken.plan, one.taken.segment, one.step) == (lesson.plan, lesson.segment, "")
    return (one.taken.plan, one.step) == (lesson.plan, lesson.step)


def _lesson(lesson: Lesson, rows: Sequence[Judged], language: str) -> Part:
    heading = WORDS[language]["found wrong"].format(**where(lesson, language))
    caption = _caption(lesson, language)
    grid = reading_grid(rows, language, heading, (*KNOWN, "step")) if rows else None
    return Part(heading, tuple(_lesson_paragraphs(lesson, language)), grid, lesson.picture, caption)


def _caption(lesson: Lesson, language: str) -> str:
    """Return what the picture of a lesson shows."""
    picture = lesson.picture
    if picture is None:
        return ""
    key = "drawn due"
    if picture.mistaken is not None:
        key = "drawn amiss"
    elif picture.found:
        key = "drawn" if len(picture.found) == 1 else "drawn length"
    return WORDS[language][key].format(position=printable_text(lesson.position))


def _lesson_paragraphs(lesson: Lesson, language: str) -> list[str]:
    """Return the paragraphs of a lesson: what is done, why, the due calculation with what was found."""
    words = WORDS[language]
    says, why, calculation = (
        printable_text(text, LONGEST_SENTENCE)
        for text in (lesson.says, lesson.why, lesson.calculation)
    )
    position = printable_text(lesson.position)
    at = words["at"].format(position=position) if position else ""
    last = []
    if calculation:
        by = words["own numbers" if lesson.own else "due numbers"]
        last.append(f"{', '.join(filter(None, (by, at)))}: {calculation}.")
    elif at:
        last.append(f"{at[:1].upper()}{at[1:]}.")
    if lesson.shown is not None:
        last.append(_yours(lesson.shown, language, calculation))
    if lesson.shows is not None:
        last.append(_yours(lesson.shows, language, "", words["it shows"]))
    reason = f"{captions(language)['why']}: {why}" if why else ""
    seen = lesson.shown is not None or lesson.shows is not None
    numbers = " ".join(last) if calculation or seen else ""
    steps = " ".join(printable_text(text, LONGEST_SENTENCE) for text in lesson.drawn)
    drawn = words["drawn so"].format(steps=steps) if steps.strip() else ""
    return [text for text in (says, reason, drawn, numbers) if text]


def _yours(one: Judged, language: str, calculation: str, both: str = "") -> str:
    """Return what was found, and what is due where no calculation has told it in the same unit.

    ``both``: how these are told, if not as usual.
    """
    words = WORDS[language]
    if one.taken.pointed:
        own = own_error(one)
        key, off = ("off", one.deviation) if own is None else ("off itself", abs(own))
        return words[key].format(
            segment=printable_text(segment_text(one.taken.segment, language)),
            off=figure_of(off, 1, language),
        )
    unit = unit_name(one.unit, language)

    def figure_text(value: float) -> str:
        text = figure_of(value, 1, language) if one.unit == "mm" else number(value, language)
        return f"{text} {unit}".rstrip()

    if one.verdict == FINE and not both:
        return words["yours fine"].format(found=figure_text(one.found))
    if calculation and calculation.endswith(unit):
        return words["yours"].format(found=figure_text(one.found))
    segment = printable_text(segment_text(one.taken.segment, language))
    template = both or words["yours for"]
    return template.format(segment=segment, found=figure_text(one.found), due=figure_text(one.due))
