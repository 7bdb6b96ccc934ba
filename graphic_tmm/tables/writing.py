"""Tables written down: as JSON and CSV for machines, for a terminal."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Mapping, Sequence
from typing import Any

from graphic_tmm.captions import CAPTIONS
from graphic_tmm.captions.symbols import symbol
from graphic_tmm.tables.columns import Column
from graphic_tmm.words import fixed, number, plain, unit


def as_json(
    scene: str,
    scales: dict[str, dict[str, Any]],
    positions: Sequence[tuple[str, float]],
    table: Sequence[Column],
    results: dict[str, Any],
) -> str:
    """Return the tables as one JSON object (see the README); null where a position cannot be drawn."""
    document = {
        "scene": scene,
        "scales": scales,
        "positions": [{"number": name, "angle_deg": angle} for name, angle in positions],
        "columns": [
            {
                "plan": c.plan,
                "segment": c.segment,
                "unit": c.unit,
                "mm": _tidy(c.mm),
                "value": _tidy(c.value),
            }
            for c in table
        ],
        "results": results,
    }
    return json.dumps(document, ensure_ascii=False, indent=1, allow_nan=False) + "\n"


def as_csv(positions: Sequence[tuple[str, float]], table: Sequence[Column]) -> str:
    """Return the tables as CSV: a line for each segment and position."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(["plan", "position", "angle_deg", "segment", "mm", "value", "unit"])
    for column in table:
        for (name, angle), mm, value in zip(
            positions, _tidy(column.mm), _tidy(column.value), strict=True
        ):
            if value is not None or mm is not None:
                cells = [column.plan, name, angle, column.segment, mm, value, column.unit]
                writer.writerow(["" if cell is None else cell for cell in cells])
    return out.getvalue()


def rich_tables(
    table: Sequence[Column], names: Sequence[str], language: str, title: str, decimals: int = 1
) -> list[Any]:
    """Return the tables for a terminal, one a plan; positions run across; mm with ``decimals``."""
    from rich.markup import escape
    from rich.table import Table
    from rich.text import Text

    words, made = CAPTIONS[language], []
    for plan in dict.fromkeys(column.plan for column in table):
        rows = [column for column in table if column.plan == plan]
        shown = [k for k in range(len(names)) if any(c.value[k] is not None for c in rows)]
        out = Table(title=escape(f"{title}. {words[plan]}"), title_justify="left")
        for head in (words["segment"], words["unit"], *(names[k] for k in shown)):
            out.add_column(Text(head), justify="right", no_wrap=True)
        for column in rows:
            letter = Text(plain(column_name(column, language)))
            if any(x is not None for x in column.mm):
                cells = [fixed(column.mm[k], decimals, language) for k in shown]
                out.add_row(letter, unit("mm", language), *cells)
            cells = [_figure(column.value[k], language) for k in shown]
            out.add_row(letter, unit(column.unit, language), *cells)
        made.append(out)
    return made


def result_tables(results: Mapping[str, tuple[float, str]], language: str, title: str) -> list[Any]:
    """Return the table of results by name for a terminal; none if there are none."""
    from rich.markup import escape
    from rich.table import Table
    from rich.text import Text

    if not results:
        return []
    words = CAPTIONS[language]
    out = Table(title=escape(f"{title}. {words['results']}"), title_justify="left")
    for head in ("results", "value", "unit"):
        out.add_column(words[head], no_wrap=True)
    for name, (value, of) in results.items():
        out.add_row(Text(name), number(value, language, 6), unit(of, language))
    return [out]


def column_name(column: Column, language: str) -> str:
    """Return what a column is called, as mark-up: a word of the catalogue, or its mark's name."""
    return CAPTIONS[language].get(column.letter) or symbol(column.letter, language)


def _figure(value: float | None, language: str) -> str:
    return "—" if value is None else number(value, language)


def _tidy(row: Sequence[float | None]) -> list[float | None]:
    """Return figures without the noise of the last bits: 12 significant digits, no -0."""
    return [None if x is None else float(f"{x:.12g}") + 0.0 for x in row]
