"""A report on a terminal: tables of rich."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from graphic_tmm.checking.records import DOUBTFUL, FINE, VERDICTS, WRONG, Report
from graphic_tmm.checking.report.rows import FIGURES, Grid, grids, notes, summary, title, who, worst
from graphic_tmm.checking.report.words import WORDS

STYLES = {FINE: "green", DOUBTFUL: "yellow", WRONG: "bold red", "": ""}
"""How a row looks on a terminal."""

LISTED = 500
"""So many rows of a table are printed on a terminal."""
RANKS = {verdict: rank for rank, verdict in enumerate(("", *VERDICTS))}


def text_report(report: Report) -> list[Any]:
    """Return what rich prints of a report on a terminal, in order: the summary first, then tables and notes.

    Of more than `LISTED` readings of a plan the worst are listed, and it is said how many are not; the other
    forms of the report have all of them.
    """
    from rich.text import Text

    words = WORDS[report.language]
    made: list[Any] = [
        Text(title(report), style="bold"),
        Text(summary(report), style=STYLES[worst(report)]),
        Text(who(report)),
        Text(""),
    ]
    for grid in grids(report):
        made.append(Fitting(_worst(grid), words))
        if (left := len(grid.rows) - LISTED) > 0:
            made.append(Text(words["not listed"].format(count=left)))
        made.append(Text(""))
    made += [Text(words["legend"], style="dim")] if report.readings else []
    return [*made, *(Text(f"• {note}") for note in notes(report))]


def _worst(grid: Grid) -> Grid:
    """Return the table with no more rows than a terminal is given: those of the worst verdicts, in order."""
    if len(grid.rows) <= LISTED:
        return grid
    order = sorted(range(len(grid.rows)), key=lambda k: -RANKS[grid.verdicts[k]])
    kept = sorted(order[:LISTED])
    rows, verdicts = tuple(grid.rows[k] for k in kept), tuple(grid.verdicts[k] for k in kept)
    return grid._replace(rows=rows, verdicts=verdicts)


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
        title=Text(grid.title, style="bold"),
        title_justify="left",
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
    """Return the columns that are not folded: figures and verdicts, if the terminal has room for them."""
    whole = {key for key in grid.columns if key in FIGURES or key == "verdict"}
    for column, key in enumerate(grid.columns):
        cells = [row[column] for row in grid.rows] if key in whole else []
        room -= 1 + max(map(len, [*words[key].split(), *cells]))
    return whole if room >= -1 else set()
