"""The summary of a class: its rows of text, and its files: CSV, xlsx, HTML, a learning platform's table."""

from __future__ import annotations

import csv
import io
from base64 import b64encode
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from functools import cache
from hashlib import sha256
from importlib.resources import files
from typing import TYPE_CHECKING, Any, NamedTuple
from urllib.parse import quote

from graphic_tmm.checking.readings.writing import workbook_of
from graphic_tmm.checking.report.charts import COLOURS
from graphic_tmm.checking.report.rows import LONGEST_SENTENCE, SIGNS, printable_text
from graphic_tmm.classroom.marks.judging import REPORTS
from graphic_tmm.classroom.marks.marking import Entry, Marked
from graphic_tmm.classroom.marks.row import plans_due
from graphic_tmm.classroom.marks.rule import FIVE, decimal, rule_sentences
from graphic_tmm.files import environment
from graphic_tmm.language.catalogue import Tongues, speaking
from graphic_tmm.language.numbers import decimal_sign
from graphic_tmm.language.said import said

if TYPE_CHECKING:
    from jinja2 import Environment


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


class SummaryRow(NamedTuple):
    """A row of the summary: its cells by column; ``mark`` and points are numbers where they are any.

    ``worst``: "wrong", "doubtful", "fine"; ``report``: the file of its report in the folder of the summary.
    """

    cells: dict[str, str]
    worst: str
    report: str


def lines(marked: Marked) -> tuple[SummaryRow, ...]:
    """Return the rows of a class, in the order of its names."""
    remarks = _remarks(marked)
    return tuple(_line(marked, one, remarks[k]) for k, one in enumerate(marked.entries))


def _line(marked: Marked, one: Entry, remarks: list[str]) -> SummaryRow:
    row, plans = one.row, plans_due(marked.rule, one.row)
    count = Counter(plan.there for plan in plans)[True]
    wrong = len(row.wrong)
    cells = {
        "name": printable_text(one.hand_in.name),
        "variant": one.hand_in.variant,
        "mark": one.mark.text,
        "points": decimal(one.mark.points, 2),
        "readings": str(row.readings),
        "fine": str(row.fine),
        "doubtful": str(row.doubtful),
        "wrong": str(wrong),
        "plans": f"{count}/{len(plans)}",
        "asked": f"{sum(p.given for p in plans)}/{sum(p.asked for p in plans)}",
        "mistakes": " ".join(printable_text(c.says, LONGEST_SENTENCE) for c in row.causes[:NAMED]),
        "remarks": " ".join(remarks),
    }
    worst = "wrong" if wrong else "doubtful" if row.doubtful else "fine"
    return SummaryRow(cells, worst, f"{REPORTS}/{one.hand_in.file}.html")


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
                other=printable_text(marked.entries[other].hand_in.name),
                equal=pair.equal,
                count=pair.of,
            )
            found[k].append(speech(says))
    return found


def skipped(marked: Marked) -> tuple[tuple[str, str], ...]:
    """Return what was skipped, each with why, on one line."""
    return tuple(
        (printable_text(one.name), printable_text(one.why, LONGEST_SENTENCE))
        for one in marked.skipped
    )


def rule(marked: Marked) -> tuple[str, ...]:
    """Return the rule in words, with how it came to be."""
    speech = speaking(marked.language)
    usual = marked.rule._replace(plans=()) == FIVE
    first = [speech(said("No rule was given: this is the usual one."))] if usual else []
    return (*first, *rule_sentences(marked.rule, marked.language, marked.plans))


def pairs(marked: Marked) -> tuple[str, ...]:
    """Return the pairs that are alike, a sentence each."""
    return tuple(map(speaking(marked.language), _pairs(marked)))


def _pairs(marked: Marked) -> Iterator[str]:
    for pair in marked.pairs:
        one, other = (marked.entries[k].hand_in.name for k in (pair.one, pair.other))
        yield said(
            "Alike: {one} and {other}, {equal} of {count} readings equal.",
            one=printable_text(one),
            other=printable_text(other),
            equal=pair.equal,
            count=pair.of,
        )


FORMULA = ("=", "+", "-", "@", "\t", "\r", "\n", "＝", "＋", "－", "＠")
"""What a formula may begin with, as wide letters too."""
TITLES = Tongues(
    {
        "class": said("Marks: {title}"),
        "count": said("Handed in: {all}. Read: {read}, skipped: {skipped}."),
        "skipped": said("Skipped"),
        "alike": said("Alike"),
        "not accused": said(
            "More readings are equal to the digit than two honest hands have by chance; it is no part of a "
            "mark."
        ),
        "rule": said("How marks are given"),
        "sort": said("A click on a title sorts."),
        "no": said("Nothing could be read."),
    }
)
_WIDTHS = (24.0, 10.0, 8.0, 8.0, 10.0, 8.0, 10.0, 8.0, 8.0, 12.0, 60.0, 60.0)


def summary_files(marked: Marked) -> dict[str, str | bytes]:
    """Return all files by name."""
    return {
        "gradebook.csv": gradebook(marked),
        "summary.csv": summary_csv(marked),
        "summary.html": summary_html(marked),
        "summary.xlsx": summary_xlsx(marked),
    }


def summary_csv(marked: Marked) -> str:
    """Return the summary as CSV; what was skipped follows, with why it was among the remarks."""
    words = WORDS[marked.language]
    rows = [[one.cells[key] for key in words] for one in lines(marked)]
    rows += [[name, *[""] * (len(words) - 2), why] for name, why in skipped(marked)]
    return _csv([list(words.values()), *rows])


def gradebook(marked: Marked) -> str:
    """Return identifier, mark and feedback of each hand-in; it is known by its student, if he has one only."""
    students = Counter(one.hand_in.student for one in marked.entries)
    rows = [("identifier", "mark", "feedback")]
    for one in marked.entries:
        student = one.hand_in.student
        name = student if student and students[student] == 1 else one.hand_in.name
        rows.append((printable_text(name, 200), one.mark.text, one.row.feedback))
    return _csv(rows)


def summary_xlsx(marked: Marked) -> bytes:
    """Return the summary as a workbook: numbers as numbers, all else as text; raises as `workbook_of`."""
    words = WORDS[marked.language]
    rows: list[list[str | float | None]] = [list(words.values())]
    for one in lines(marked):
        rows.append([_number(one.cells[key]) if key in _SUMS else one.cells[key] for key in words])
    for name, why in skipped(marked):
        rows.append([name, *[""] * (len(words) - 2), why])
    title = speaking(marked.language)(said("marks", context="sheet"))
    return workbook_of(title, rows, _WIDTHS, language=marked.language, frozen="B2")


_SUMS = FIGURES | {"mark"}


def _number(text: str) -> str | float:
    try:
        return float(text)
    except ValueError:
        return text


def summary_html(marked: Marked) -> str:
    """Return the summary as a page: it holds all it needs, asks for nothing, and prints on A4 across."""
    from markupsafe import Markup

    sign, titles = decimal_sign(marked.language), TITLES[marked.language]
    rows = lines(marked)
    script = _script()
    page = _environment().get_template("summary.html")
    return page.render(
        marked=marked,
        titles=titles,
        heading=titles["class"].format(title=printable_text(marked.title)),
        count=titles["count"].format(
            all=len(rows) + len(marked.skipped), read=len(rows), skipped=len(marked.skipped)
        ),
        words=WORDS[marked.language],
        figures=_SUMS,
        lines=rows,
        signs=SIGNS,
        colours=COLOURS,
        link=quote,
        told=lambda key, text: text.replace(".", sign) if key in _SUMS else text,
        skipped=skipped(marked),
        pairs=pairs(marked),
        rule=rule(marked),
        script=Markup(script),
        digest=b64encode(sha256(script.encode()).digest()).decode(),
    )


def text_summary(marked: Marked) -> list[Any]:
    """Return what rich prints of a class on a terminal, in order."""
    from rich.box import SIMPLE_HEAD
    from rich.table import Table
    from rich.text import Text

    titles, words = TITLES[marked.language], WORDS[marked.language]
    table = Table(box=SIMPLE_HEAD, show_edge=False, padding=0)
    keys = [key for key in words if key not in ("asked", "points")]
    for key in keys:
        right = key in _SUMS
        table.add_column(Text(words[key]), justify="right" if right else "left", overflow="fold")
    styles = {"fine": "green", "doubtful": "yellow", "wrong": "red"}
    rows = lines(marked)
    for one in rows:
        table.add_row(*(Text(one.cells[key]) for key in keys), style=styles[one.worst])
    made: list[Any] = [
        Text(titles["class"].format(title=printable_text(marked.title)), style="bold")
    ]
    made += [table] if rows else [Text(titles["no"])]
    made += [Text(f"• {one}") for one in pairs(marked)]
    made += [Text(f"• {titles['skipped']}: {name}: {why}") for name, why in skipped(marked)]
    made += [Text(""), *(Text(one, style="dim") for one in rule(marked))]
    return made


def _csv(rows: Iterable[Sequence[str]]) -> str:
    out = io.StringIO()
    writer = csv.writer(out, quoting=csv.QUOTE_ALL, lineterminator="\r\n")
    writer.writerows([_harmless(cell) for cell in row] for row in rows)
    return out.getvalue()


def _harmless(cell: str) -> str:
    """Return a text that no spreadsheet takes for a formula.

    >>> _harmless("=1+1"), _harmless(" @x"), _harmless("-1.5"), _harmless("Иванов")
    ("'=1+1", "' @x", '-1.5', 'Иванов')
    """
    begins = cell.lstrip(" \u00a0").startswith(FORMULA)
    return f"'{cell}" if begins and not _is_number(cell) else cell


def _is_number(text: str) -> bool:
    return text[1:].replace(".", "", 1).isdecimal() and text.isascii() and text[0] == "-"


@cache
def _script() -> str:
    place = files("graphic_tmm.classroom.marks") / "templates" / "sort.js"
    return place.read_text("utf-8")


@cache
def _environment() -> Environment:
    return environment("graphic_tmm.classroom.marks")
