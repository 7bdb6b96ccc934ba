"""A report as one HTML page: it holds all it needs, runs nothing, asks for nothing, and prints on A4.

The page is ``templates/page.html``, its style ``templates/style.css``.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from graphic_tmm.checking.records import FINE, Report
from graphic_tmm.checking.report import rows
from graphic_tmm.checking.report.charts import COLOURS, chart, render, small_plan
from graphic_tmm.checking.report.findings import finding_rows, headline, summary
from graphic_tmm.checking.report.parts import (
    Part,
    fine_grids,
    fine_ones,
    grids,
    legend,
    verdict_parts,
)
from graphic_tmm.checking.report.rows import WORDS, plan_name

if TYPE_CHECKING:
    from markupsafe import Markup


def html_report(report: Report) -> str:
    """Return the report as a page of HTML.

    What matters first; then a section a wrong step, with its small plan, and what is doubtful; folded what is
    fine and a chart a plan; notes. Nothing outside the page is named in it, no script is in it, and all text of
    others is escaped.
    """
    language = report.language
    charts = [
        (plan_name(plan, language), drawn)
        for plan, readings in rows.by_plan(report.readings).items()
        if (drawn := chart(plan, readings, language))
    ]
    fine = fine_ones(report)
    page = render(
        "page.html",
        report=report,
        rows=rows,
        words=WORDS[language],
        colours=COLOURS,
        worst=rows.worst(report),
        headline=headline(report),
        findings=finding_rows(report),
        summary=summary(report),
        parts=verdict_parts(report),
        plan=_plan,
        fine=f"{rows.SIGNS[FINE]} {fine}" if fine else "",
        fine_grids=fine_grids(report),
        charts=charts,
        legend=legend(report, grids(report)),
    )
    return str(page)


def _plan(part: Part) -> Markup:
    assert part.picture is not None
    return small_plan(part.picture, part.caption)
