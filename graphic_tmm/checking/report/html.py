"""A report as one HTML page: it holds all it needs, runs nothing, asks for nothing, and prints on A4.

The page is ``templates/page.html``, its style ``templates/style.css``.
"""

from __future__ import annotations

from graphic_tmm.checking.records import Report
from graphic_tmm.checking.report import rows
from graphic_tmm.checking.report.chart import COLOURS, chart
from graphic_tmm.checking.report.rendering import render
from graphic_tmm.checking.report.words import WORDS


def html_report(report: Report) -> str:
    """Return the report as a page of HTML: summary, a chart and a table a plan, mistakes, notes.

    Nothing outside the page is named in it, no script is in it, and all text of others is escaped.
    """
    language = report.language
    tables = [
        (rows.reading_grid(plan, readings, language), chart(plan, readings, language))
        for plan, readings in rows.by_plan(report.readings).items()
    ]
    if (mistakes := rows.mistake_grid(report)) is not None:
        tables.append((mistakes, ""))
    words = WORDS[language]
    page = render(
        "page.html", report=report, rows=rows, words=words, colours=COLOURS, tables=tables
    )
    return str(page)
