"""Tables written down for machines: as JSON and as CSV."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Iterator, Sequence
from typing import Any

from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import decimals_of
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Sweep
from graphic_tmm.readers.columns import (
    Column,
    Positions,
    Row,
)

ANGLE, LENGTH = said("angle_deg", context="column"), said("length_m", context="column")
"""The title of the coordinate of a drive that turns, and of one that slides."""
HEADS = (
    said("plan", context="column"),
    said("position", context="column"),
    ANGLE,
    LENGTH,
    said("segment", context="column"),
    said("mm", context="column"),
    said("value", context="column"),
    said("unit", context="column"),
)
"""The titles of CSV's columns, of which a table has one of the coordinates; readings may have them, too."""
DIGITS = 4
"""Significant digits of a quantity that is not read off a length itself, as the protocol tells it."""


def as_json(
    scene: str,
    scales: dict[str, dict[str, Any]],
    positions: Positions,
    table: Sequence[Column],
    results: dict[str, Any],
    sweep: Sweep | None = None,
) -> str:
    """Return the tables as one JSON object (see scene/README.md); null where a position cannot be drawn.

    ``sweep``: what the drive of the positions goes through.
    """
    document = {
        "scene": scene,
        "scales": scales,
        "positions": [{"number": name, **_coordinate(at, sweep)} for name, at in positions],
        "columns": [_written(column, positions) for column in table],
        "results": results,
    }
    return json.dumps(document, ensure_ascii=False, indent=1, allow_nan=False) + "\n"


def _coordinate(value: float | None, sweep: Sweep | None) -> dict[str, Any]:
    if sweep is None or sweep.turns:
        return {"angle_deg": value}
    return {"parameter": {"name": sweep.name or sweep.letter, "unit": sweep.unit, "value": value}}


def _written(column: Column, positions: Positions) -> dict[str, Any]:
    mm, value = map(_tidy, column.first_figures)
    names = [name for name, _ in column.at or positions]
    told = {"plan": column.plan, "segment": column.segment, "unit": column.unit}
    return {**told, "positions": names, "mm": mm, "value": value}


def as_csv(
    positions: Positions,
    table: Sequence[Column],
    division: float | None = None,
    *,
    comma: bool = False,
    language: str = "en",
    sweep: Sweep | None = None,
) -> str:
    """Return the tables as CSV: a line for each segment and position, under titles in a language.

    The coordinate of the drive is an angle or a length; positions of a column's own are angles, and have a
    column of these beside one of lengths.

    Parameters
    ----------
    division
        Of the ruler, mm. A length is told to it, and a quantity to what it stands for; None: all digits.
    comma
        Decimal commas, and semicolons between the cells.
    sweep
        What the drive of the positions goes through; None: angles.
    """
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n", delimiter=";" if comma else ",")
    slides = sweep is not None and not sweep.turns
    angles = not slides or any(at is not None for column in table for _, at in column.at)
    coordinates = [*([ANGLE] if angles else []), *([LENGTH] if slides else [])]
    plan, position, *others = (head for head in HEADS if head not in (ANGLE, LENGTH))
    writer.writerow(map(speaking(language), (plan, position, *coordinates, *others)))

    def put(text: str) -> str:
        return text.replace(".", ",") if comma else text

    for column in table:
        figures = _figures(column, division)
        own = LENGTH if slides and not column.at else ANGLE
        for (name, at), (mm, value) in zip(column.at or positions, figures, strict=True):
            if value or mm:
                told = "" if at is None else put(_coordinate_of(at, own, division))
                where = [told if head == own else "" for head in coordinates]
                cells = (column.plan, name, *where, column.segment, put(mm), put(value))
                writer.writerow([*cells, column.unit])
    return out.getvalue()


def _figures(column: Column, division: float | None) -> Iterator[tuple[str, str]]:
    """Yield the figures of a column as text, mm and quantity of each position; "" for none."""
    told = column.first_figures
    known = [(mm, value) for mm, value in zip(*told, strict=True) if mm and value]
    mu = abs(known[0][1] / known[0][0]) if known else None
    for mm, value in zip(*map(_tidy, told), strict=True):
        if division is None:
            yield _plain(mm), _plain(value)
            continue
        length = "" if mm is None else _fixed(mm, decimals_of(division))
        if value is None:
            yield length, ""
        elif mm is None or mu is None:
            yield length, _plain(float(f"{value:.{DIGITS}g}"))
        else:
            yield length, _fixed(value, decimals_of(mu * division))


def _plain(value: float | None) -> str:
    """Return a number with the digits that it has: no decimals of a whole one, "" for none."""
    if value is None:
        return ""
    text = repr(float(f"{value:.12g}") + 0.0)
    return text.removesuffix(".0")


def _coordinate_of(value: float, head: str, division: float | None) -> str:
    return _plain(value if division is None else round(value, 6 if head == LENGTH else 3))


def _fixed(value: float, places: int) -> str:
    text = f"{value:.{places}f}"
    return text.lstrip("-") if float(text) == 0 else text


def _tidy(row: Row) -> Row:
    """Return figures without the noise of the last bits: 12 significant digits, no -0."""
    return [None if x is None else float(f"{x:.12g}") + 0.0 for x in row]
