"""What the readings tell, in sentences and parts: what is wrong first, what is doubtful, what is fine."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from graphic_tmm.checking.records import (
    DOUBTFUL,
    FINE,
    MISTAKE,
    SLIP,
    UNKNOWN,
    WRONG,
    Judged,
    Lesson,
    Likely,
    PlanPicture,
    Report,
    Sight,
)
from graphic_tmm.checking.report.rows import (
    LEGEND,
    LONGEST_SENTENCE,
    WORDS,
    Grid,
    by_plan,
    counts,
    figure_of,
    plan_name,
    printable_text,
    reading_grid,
    runs,
    unit_name,
)
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.scene.captions import captions, view_name

NAMED = 5
"""So many findings are told; the JSON has all of them."""
LEAST_LEFT = 0.005
"""What rounds to 0 % is nothing left."""
ENOUGH = 0.8
"""From here on a mistake is named; below it may be: of names so sure 19 of 20 are to be right."""
SURE = 0.995
"""From here on a finding is said to be sure to 99 %: it is never said to be certain."""


RAREST = 0.1
"""%: of honest drawings so few are told to be as far off; fewer are not."""


def headline(report: Report) -> str:
    """Return what matters, in one sentence."""
    if report.sight is None:
        return _verdict(report)
    return f"{_verdict(report)} {_seen(report.sight, report.language)}"


def _verdict(report: Report) -> str:
    words = WORDS[report.language]
    if not report.readings:
        return words["none"]
    if report.mistakes:
        return finding(report.mistakes[0], report.language)
    if report.wrong:
        return _begin(report)
    if report.whole is not None:
        return words["only whole"]
    if report.sight is not None and not report.sight.whole:
        return words["seen right"]
    doubtful = any(one.verdict == DOUBTFUL for one in report.readings)
    return words["look again" if doubtful else "all right"]


def _seen(sight: Sight, language: str) -> str:
    """Return what a photograph showed: of how many points how many, of which plans nothing is said."""
    words = WORDS[language]
    plans = []
    for one in sight.plans:
        seen = one.asked - len(one.unseen) - len(one.partly)
        told = words["plans seen"].format(
            name=view_name(one.plan, language), seen=seen, of=one.asked
        )
        if len(one.unseen) == one.asked:
            told += words["nothing said"]
        elif one.unseen:
            told += words["unseen plans"].format(positions=", ".join(one.unseen))
        if one.partly:
            told += words["not whole"].format(positions=", ".join(one.partly))
        plans.append(told)
    counted = words["points seen"].format(points=sight.points, of=sight.of)
    return f"{counted} {'; '.join(plans)}."


def summary(report: Report) -> str:
    """Return how many readings are fine, doubtful, wrong; the whole; how many wrong no finding explains."""
    words = WORDS[report.language]
    if not report.readings:
        return ""
    said = [words["counts"].format(all=len(report.readings), **counts(report))]
    if (whole := report.whole) is not None:
        due = fixed(whole.due, 1, report.language)
        key = "whole" if whole.doubtful > whole.due else "whole alone"
        said.append(words[key].format(doubtful=whole.doubtful, of=whole.of, due=due))
    left = unexplained(report)
    if 0 < len(left) < report.wrong:
        lines = runs([one.taken.line for one in left])
        told = words["left over"].format(count=len(left), lines=words["at lines"])
        said.append(told.format(lines=lines) if lines else told.partition(" (")[0] + ".")
    return " ".join(said)


def finding(one: Likely, language: str) -> str:
    """Return a finding as a sentence; what a slip or something unknown says is a sentence by itself."""
    speech, words = speaking(language), WORDS[language]
    says = [one.says or speech(one.name), *map(speech, one.like)]
    told = "; ".join(
        filter(None, (printable_text(text, LONGEST_SENTENCE).rstrip(".") for text in says))
    )
    if one.kind in (SLIP, UNKNOWN):
        return f"{told[:1].upper()}{told[1:]}."
    kind = one.kind if one.kind in words else MISTAKE
    if kind == MISTAKE and one.like:
        kind = "alike" if sure(one) else "perhaps alike"
    elif kind == MISTAKE and not sure(one):
        kind = "perhaps"
    return words[kind].format(says=told)


def sure(one: Likely) -> bool:
    """Whether a finding is as good as sure, or nobody has told how sure it is."""
    return one.chance <= 0.0 or one.chance >= ENOUGH


def finding_rows(report: Report) -> tuple[str, ...]:
    """Return what the headline leaves: of the first finding its details, of the others all."""
    found = []
    for k, one in enumerate(report.mistakes[:NAMED]):
        told = [] if k == 0 else [finding(one, report.language)]
        more = details(report, one)
        told += [more[:1].upper() + more[1:] + "."] if more else []
        found += [" ".join(told)] if told else []
    if (left := len(report.mistakes) - NAMED) > 0:
        found.append(WORDS[report.language]["more"].format(count=left))
    return tuple(found)


def details(report: Report, one: Likely) -> str:
    """Return what a finding explains, how sure it is: for who asks; "" if nothing is to be told."""
    words, language = WORDS[report.language], report.language
    told = []
    if count := explained(report, one):
        told.append(words["explains"].format(count=count, wrong=report.wrong))
        if one.rest >= LEAST_LEFT:
            told.append(words["leaves"].format(rest=fixed(100 * one.rest, 0, language)))
    if lines := runs(one.lines):
        told.append(words["at lines"].format(lines=lines))
    if one.chance > 0.0 and one.kind == UNKNOWN:
        most = fixed(max(100 * (1.0 - one.chance), RAREST), 1, language)
        told.append(words["rare"].format(percent=most))
    elif one.chance > 0.0:
        percent = fixed(100 * min(one.chance, SURE), 0, language) if one.chance < SURE else "99"
        told.append(words["sure"].format(percent=percent))
    return "; ".join(told)


def explained(report: Report, mistake: Likely) -> int:
    """Return how many of the wrong readings a mistake explains."""
    lines = set(mistake.lines)
    return sum(one.verdict == WRONG and one.taken.line in lines for one in report.readings)


def unexplained(report: Report) -> tuple[Judged, ...]:
    """Return the wrong readings that no mistake of the report explains."""
    lines = {line for mistake in report.mistakes for line in mistake.lines}
    wrong = (one for one in report.readings if one.verdict == WRONG)
    return tuple(one for one in wrong if one.taken.line not in lines)


def where(lesson: Lesson, language: str) -> dict[str, str]:
    """Return the words that tell a step: the view it is drawn in, its number, its letter."""
    number = printable_text(lesson.step.partition(" ")[0])
    called = lesson.title or view_name(lesson.view, language)
    view = printable_text(called) or plan_name(lesson.plan, language)
    return {"plan": view, "number": number, "letter": printable_text(lesson.letter)}


def _begin(report: Report) -> str:
    """Return that no known mistake explains the wrong readings, and what is first to be looked at."""
    words = WORDS[report.language]
    wrong = [one for one in report.readings if one.verdict == WRONG]
    if report.lessons:
        return words["begin"].format(**where(report.lessons[0], report.language))
    return words["begin at"].format(
        segment=printable_text(wrong[0].taken.segment),
        plan=plan_name(wrong[0].taken.plan, report.language),
    )


KNOWN = ("farther",)
"""What is so of every reading that is wrong: no drawing of the hand is farther off."""


class Part(NamedTuple):
    """A part of a report: its heading, what is told in paragraphs, its readings, a picture and what it shows.

    ``grid`` is None where no reading is of it.
    """

    heading: str
    told: tuple[str, ...] = ()
    grid: Grid | None = None
    picture: PlanPicture | None = None
    caption: str = ""


def wrong_parts(report: Report) -> tuple[Part, ...]:
    """Return the steps that are blamed, in the order of the log; then the wrong readings of no step.

    The steps of the findings stand before the others, the first one's first. Behind that of a mistake stand the
    other readings that it explains: they are wrong for it, and have no lesson of their own.
    """
    language, words = report.language, WORDS[report.language]
    rows = [one for one in report.readings if one.verdict == WRONG]
    named = _named(report)
    follows = {line for lines in named.values() for line in lines}
    found, told = [], set[int]()
    for k, lesson in sorted(
        enumerate(report.lessons), key=lambda row: min(row[1].names, default=len(report.mistakes))
    ):
        own = [n for n, one in enumerate(rows) if _blames(lesson, one)]
        left = [n for n in own if k in named or rows[n].taken.line not in follows]
        left = [n for n in left if n not in told]
        if left or not own or k in named:
            found.append(_lesson(lesson, [rows[n] for n in left], language))
            told |= set(left)
        its = [n for n, one in enumerate(rows) if one.taken.line in named.get(k, ())]
        its = [n for n in its if n not in told]
        found += _tables([rows[n] for n in its], words["for that"], language)
        told |= set(its)
    rest = [one for n, one in enumerate(rows) if n not in told]
    return (*found, *_tables(rest, words["wrong ones"], language))


def _tables(rows: Sequence[Judged], heading: str, language: str) -> list[Part]:
    """Return the tables of readings that have no lesson, plan by plan."""
    found = []
    for plan, readings in by_plan(rows).items():
        head = heading.format(plan=plan_name(plan, language))
        found.append(Part(head, (), reading_grid(readings, language, head, KNOWN)))
    return found


def _named(report: Report) -> dict[int, frozenset[int]]:
    """Return the lessons (by number) on the steps of mistakes that are sure, with the lines these explain."""
    found: dict[int, frozenset[int]] = {}
    for k, one in enumerate(report.mistakes):
        lesson = next((n for n, its in enumerate(report.lessons) if k in its.names), None)
        if lesson is not None and one.kind == MISTAKE and sure(one):
            found[lesson] = found.get(lesson, frozenset()) | (frozenset(one.lines) - {0})
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
        key, off = ("off", one.deviation) if one.own is None else ("off itself", abs(one.own))
        return words[key].format(
            segment=printable_text(one.taken.segment), off=figure_of(off, 1, language)
        )
    unit = unit_name(one.unit, language)

    def figure_text(value: float) -> str:
        text = figure_of(value, 1, language) if one.unit == "mm" else number(value, language)
        return f"{text} {unit}".rstrip()

    if one.verdict == FINE and not both:
        return words["yours fine"].format(found=figure_text(one.found))
    if calculation and calculation.endswith(unit):
        return words["yours"].format(found=figure_text(one.found))
    segment = printable_text(one.taken.segment)
    template = both or words["yours for"]
    return template.format(segment=segment, found=figure_text(one.found), due=figure_text(one.due))
