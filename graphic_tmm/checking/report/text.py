"""A report on a terminal: tables of rich."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from graphic_tmm.checking.records import DOUBTFUL, FINE, WRONG, Report
from graphic_tmm.checking.report.findings import finding_rows, headline, summary
from graphic_tmm.checking.report.parts import fine_ones, legend, verdict_parts
from graphic_tmm.checking.report.rows import FIGURES, SIGNS, WORDS, Grid, notes, title, who, worst

STYLES = {FINE: "green", DOUBTFUL: "yellow", WRONG: "bold red", "": ""}
"""How a row looks on a terminal."""

LISTED = 40
"""So many rows of a table are printed on a terminal."""


def text_report(report: Report) -> list[Any]:
    """Return what rich prints of a report on a terminal, in order.

    What matters first, the wrong steps with their lessons, what is doubtful; of what is fine how much. Of more
    than `LISTED` readings of a part the first are listed, and it is said how many are not; the other forms of
    the report have all of them.
    """
    from rich.text import Text

    words = WORDS[report.language]
    made: list[Any] = [
        Text(title(report), style="bold"),
        *map(Text, report.head),
        Text(headline(report), style=STYLES[worst(report)]),
    ]
    made += [Text(f"• {row}") for row in finding_rows(report)]
    made += [Text(text) for text in (summary(report), who(report)) if text]
    parts = verdict_parts(report)
    for verdict, part in parts:
        made += [Text(""), Text(f"{SIGNS[verdict]} {part.heading}", style=STYLES[verdict])]
        made += [Text(text) for text in part.told]
        if part.grid is not None:
            made.append(Fitting(_first(part.grid), words))
            if (left := len(part.grid.rows) - LISTED) > 0:
                made.append(Text(words["not listed"].format(count=left)))
    if told := fine_ones(report):
        made += [Text(""), Text(f"{SIGNS[FINE]} {told}", style=STYLES[FINE])]
    if told := legend(report, [part.grid for _, part in parts if part.grid is not None]):
        made += [Text(""), Text(told, style="dim")]
    return [*made, *(Text(f"• {note}") for note in notes(report))]


def _first(grid: Grid) -> Grid:
    """Return the table with no more rows than a terminal is given."""
    return grid._replace(rows=grid.rows[:LISTED], verdicts=grid.verdicts[:LISTED])


class Fitting(NamedTuple):
    """A table that is laid out when the width of the terminal is known, so that nothing of it is cut off."""

    grid: Grid
    words: Mapping[str, str]

    def __rich_console__(self, _: Any, options: Any) -> Iterator[Any]:
        """Yield what rich prints."""
        yield _table(self.grid, self.words, options.max_width)


def _table(grid: Grid, words: Mapping[str, str], room: int) -> Any:
    from rich.box import SIMPLE_HEAD
    from rich.table import Table
    from rich.text import Text

    out = Table(
        box=SIMPLE_HEAD,
        show_edge=False,
        padding=0,
    )
    whole = _whole(grid, words, room)
    for key in grid.columns:
        out.add_column(
            Text(words[key].replace(" ", "\n")),
            justify="right" if key in FIGURES else "left",
            overflow="fold",
            no_wrap=key in whole,
        )
    for row, verdict in zip(grid.rows, grid.verdicts, strict=True):
        out.add_row(*map(Text, row), style=STYLES[verdict])
    return out


def _whole(grid: Grid, words: Mapping[str, str], room: int) -> set[str]:
    """Return the columns that are not folded: figures, if the terminal has room for them."""
    whole = {key for key in grid.columns if key in FIGURES}
    for column, key in enumerate(grid.columns):
        cells = [row[column] for row in grid.rows] if key in whole else []
        room -= 1 + max(map(len, [*words[key].split(), *cells]))
    return whole if room >= -1 else set()
