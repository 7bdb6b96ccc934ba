"""A report as Markdown: headings, pipe tables, small plans, lists; all text of others is escaped.

Written without a template: what a line of Markdown escapes depends on where in the line it stands, and the
whole is shorter than the template and its filters would be.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from graphic_tmm.checking.records import FINE, Report
from graphic_tmm.checking.report.charts import small_plan
from graphic_tmm.checking.report.findings import finding_rows, headline, summary
from graphic_tmm.checking.report.parts import fine_grids, fine_ones, grids, legend, verdict_parts
from graphic_tmm.checking.report.rows import FIGURES, SIGNS, WORDS, Grid, notes, title, who

ENTITIES = str.maketrans({"&": "&amp;", "<": "&lt;", ">": "&gt;", "|": "&#124;"})
ACTIVE = re.compile(r"[\\`*\[\]{}#~$]|:(?=\S)|(?<![^\W_])_|_(?![^\W_])|(?<=www)\.", re.IGNORECASE)
"""Signs that Markdown acts upon inside a line; not an underline between letters."""
OPENING = re.compile(r"^(\d*)([-+.)])(?=[\s-]|$)")
"""Signs that Markdown acts upon where a line begins."""


def markdown_report(report: Report) -> str:
    """Return the report as Markdown; all text of others is escaped.

    What matters first, then the wrong steps with their lessons, what is doubtful, what is fine (folded), notes.
    """
    words = WORDS[report.language]
    blocks = [f"# {marked(title(report))}", *map(opened, report.head)]
    blocks.append(f"**{marked(headline(report))}**")
    if found := finding_rows(report):
        blocks.append("\n".join(f"- {opened(row)}" for row in found))
    blocks += [opened(text) for text in (summary(report), who(report)) if text]
    for verdict, part in verdict_parts(report):
        blocks += [f"## {SIGNS[verdict]} {marked(part.heading)}", *map(opened, part.told)]
        if part.picture is not None:
            blocks.append(str(small_plan(part.picture, part.caption)).rstrip())
            blocks.append(opened(part.caption))
        blocks += [_pipes(part.grid, words)] if part.grid is not None else []
    if told := fine_ones(report):
        blocks.append(f"<details><summary>{SIGNS[FINE]} {marked(told)}</summary>")
        for grid in fine_grids(report):
            blocks += [f"### {marked(grid.title)}", _pipes(grid, words)]
        blocks.append("</details>")
    blocks += [marked(told)] if (told := legend(report, grids(report))) else []
    if listed := notes(report):
        blocks += [f"## {words['notes']}", "\n".join(f"- {opened(note)}" for note in listed)]
    return "\n\n".join(blocks) + "\n"


def marked(text: str) -> str:
    r"""Return text as Markdown shows it unchanged, inside a line or a cell.

    >>> marked("a|b <i> *c* J_fly _d_")
    'a&#124;b &lt;i&gt; \\*c\\* J_fly \\_d\\_'
    """
    return ACTIVE.sub(r"\\\g<0>", text).translate(ENTITIES)


def opened(text: str) -> str:
    r"""Return text as Markdown shows it unchanged where a line begins.

    >>> opened("1. a"), opened("- b"), opened("-1.5")
    ('1\\. a', '\\- b', '-1.5')
    """
    return OPENING.sub(r"\1\\\2", marked(text))


def _pipes(grid: Grid, words: Mapping[str, str]) -> str:
    rules = ["---:" if key in FIGURES else "---" for key in grid.columns]
    heads = [marked(words[key]) for key in grid.columns]
    rows = [heads, rules, *(map(marked, row) for row in grid.rows)]
    return "\n".join(f"| {' | '.join(row)} |" for row in rows)
