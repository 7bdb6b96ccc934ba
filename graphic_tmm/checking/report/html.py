"""A report as one HTML page: it holds all it needs, runs nothing, asks for nothing, and prints on A4."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape

from graphic_tmm.checking.records import VERDICTS, Report
from graphic_tmm.checking.report.chart import COLOURS, chart
from graphic_tmm.checking.report.rows import (
    FIGURES,
    Grid,
    by_plan,
    mistake_grid,
    notes,
    reading_grid,
    summary,
    title,
    verdict_name,
    who,
    worst,
)
from graphic_tmm.checking.report.words import WORDS

POLICY = "default-src 'none'; style-src 'unsafe-inline'"
"""What the page may load: nothing; its own style stands in it."""
STYLE = (
    """
@page { size: A4; margin: 15mm; }
body { font: 10pt/1.35 "Helvetica Neue", Arial, "Liberation Sans", sans-serif; color: #111;
  background: #fff; max-width: 180mm; margin: 8mm auto; padding: 0 4mm; overflow-wrap: anywhere; }
h1 { font-size: 15pt; margin: 0 0 3mm; }
h2 { font-size: 12pt; margin: 6mm 0 2mm; break-after: avoid; }
.summary { font-size: 11pt; font-weight: bold; border-left: 1.2mm solid; padding: 1mm 3mm; margin: 0 0 2mm; }
.legend, .who { color: #444; font-size: 8.5pt; }
.chart { display: block; width: 100%; height: auto; break-inside: avoid; break-after: avoid; }
.chart text { font-family: inherit; }
table { border-collapse: collapse; width: 100%; font-size: 8.5pt; margin: 2mm 0; }
thead { display: table-header-group; }
th, td { border-bottom: 0.2mm solid #bbb; padding: 0.5mm 1.2mm; text-align: left; vertical-align: top; }
th { border-bottom: 0.4mm solid #444; overflow-wrap: normal; }
.figure { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
.verdict { white-space: nowrap; }
tr { break-inside: avoid; }
@media print { body { margin: 0; padding: 0; max-width: none; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; } }
"""
    + "".join(
        f".{verdict} .verdict, .key .{verdict} {{ color: {colour}; }}\n"
        f".summary.{verdict} {{ border-color: {colour}; }}\n"
        for verdict, colour in COLOURS.items()
    )
    + ".wrong td { font-weight: bold; background: #fdeff0; }\n.doubtful td { background: #fdf5ea; }\n"
)


def html_report(report: Report) -> str:
    """Return the report as a page of HTML: summary, a chart and a table a plan, mistakes, notes.

    Nothing outside the page is named in it, no script is in it, and all text of others is escaped.
    """
    language, words = report.language, WORDS[report.language]
    body = [
        f"<h1>{escape(title(report))}</h1>",
        f'<p class="summary {worst(report)}">{escape(summary(report))}</p>',
        f'<p class="who">{escape(who(report))}</p>',
    ]
    body += [_key(language)] if report.readings else []
    for plan, readings in by_plan(report.readings).items():
        grid = reading_grid(plan, readings, language)
        body += [_headed(grid), chart(plan, readings, language), _table(grid, words)]
    mistakes = mistake_grid(report)
    body += [_headed(mistakes), _table(mistakes, words)] if mistakes is not None else []
    body += [f'<p class="legend">{escape(words["legend"])}</p>'] if report.readings else []
    if told := notes(report):
        items = "\n".join(f"<li>{escape(note)}</li>" for note in told)
        body += [f"<h2>{escape(words['notes'])}</h2>", f"<ul>\n{items}\n</ul>"]
    head = [
        "<!DOCTYPE html>",
        f'<html lang="{escape(language)}">',
        "<head>",
        '<meta charset="utf-8">',
        f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        f"<title>{escape(title(report))}</title>",
        f"<style>{STYLE}</style>",
        "</head>",
        "<body>",
    ]
    return "\n".join(part for part in [*head, *body, "</body>", "</html>"] if part) + "\n"


def _key(language: str) -> str:
    """Return what the shapes and colours of the charts mean."""
    signs = " ".join(
        f'<span class="{verdict}">{escape(verdict_name(verdict, language))}</span>'
        for verdict in VERDICTS
    )
    words = WORDS[language]
    return (
        f'<p class="legend key">{escape(words["chart"])}: {signs}; {escape(words["beyond"])}.</p>'
    )


def _headed(grid: Grid) -> str:
    return f"<h2>{escape(grid.title)}</h2>"


def _table(grid: Grid, words: Mapping[str, str]) -> str:
    kinds = [_kind(key) for key in grid.columns]
    heads = zip(kinds, grid.columns, strict=True)
    lines = ["<table>", "<thead>", "<tr>"]
    lines += [f'<th scope="col"{kind}>{escape(words[key])}</th>' for kind, key in heads]
    lines += ["</tr>", "</thead>", "<tbody>"]
    for row, verdict in zip(grid.rows, grid.verdicts, strict=True):
        cells = zip(kinds, row, strict=True)
        told = "".join(f"<td{kind}>{escape(cell)}</td>" for kind, cell in cells)
        lines.append(f'<tr class="{verdict}">{told}</tr>' if verdict else f"<tr>{told}</tr>")
    return "\n".join([*lines, "</tbody>", "</table>"])


def _kind(key: str) -> str:
    if key in FIGURES:
        return ' class="figure"'
    return ' class="verdict"' if key == "verdict" else ""
