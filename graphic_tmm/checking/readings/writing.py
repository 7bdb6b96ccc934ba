"""Readings written down as CSV, and a template of all that a scene lets one measure."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from graphic_tmm.checking.cells import RESULTS
from graphic_tmm.checking.readings.csv_cells import heads
from graphic_tmm.checking.records import Taken
from graphic_tmm.drawn import Results
from graphic_tmm.language.numbers import decimal_sign
from graphic_tmm.readers.columns import Column, empty, row_of

SIGNS = {".": (",", ""), ",": (";", "\ufeff")}
"""By the decimal sign: separator and what a file begins with, so that spreadsheets take it as it is."""
_QUOTED = frozenset('"\r\n#')


def write_readings(rows: Iterable[Taken], *, language: str = "en") -> str:
    """Return readings as CSV, which ``read_readings`` reads back to the last bit.

    Parameters
    ----------
    rows : iterable of Taken
        Their lines are not written: a row's line is its own.
    language : str
        "en": separated by commas, decimal points; "ru": Russian titles, semicolons, decimal commas, and a
        byte order mark, as spreadsheets set to Russian want them.
    """
    return _text((_row(one, language) for one in rows), language)


def template(
    columns: Sequence[Column],
    names: Sequence[str],
    points: Sequence[tuple[str, str]] = (),
    *,
    language: str = "en",
) -> str:
    """Return a CSV file to be filled in: a row for all that can be measured, its figures empty.

    Parameters
    ----------
    columns : sequence of Column
        With a figure for each of the positions; columns of the plan "results" have one figure and no position.
        There is no row where a column holds neither mm nor value.
    names : sequence of str
        The names of the positions.
    points : sequence of (plan, letter)
        Points of plans, with a row for each position at which a column of that plan holds a figure; for every
        position if the plan has no columns, and one without position if there are no positions.
    language : str
        As in ``write_readings``.
    """
    places: dict[str, set[int]] = {}
    asked: list[Taken] = []
    for column in columns:
        given = _given(column)
        places.setdefault(column.plan, set()).update(given)
        unit = column.unit or "1"
        positions = [""] if column.plan == RESULTS else [name for name, _ in column.at] or names
        asked += [Taken(column.plan, positions[k], column.segment, unit=unit) for k in given]
    for plan, letter in points:
        drawn = sorted(places.get(plan, range(len(names))))
        positions = [names[k] for k in drawn] if names else [""]
        asked += [Taken(plan, position, letter) for position in positions]
    return _text((_row(one, language) for one in asked), language)


def result_columns(results: Results) -> tuple[Column, ...]:
    """Return results by name as columns of the plan "results" of one figure each."""
    return tuple(
        Column(RESULTS, name, name, unit, empty(1), row_of(figures[:, None], [0], 1))
        for name, (figures, unit) in results.items()
    )


def _given(column: Column) -> list[int]:
    pairs = zip(*column.told, strict=True)
    return [k for k, pair in enumerate(pairs) if pair != (None, None)]


def _row(one: Taken, language: str) -> Iterator[str]:
    point = decimal_sign(language)
    unit = one.unit if one.value is None else one.unit or "1"
    cells = (one.mm, one.value, unit, one.x, one.y)
    yield from (one.plan, one.position, one.segment)
    for cell in cells:
        if isinstance(cell, str):
            yield cell
        else:
            yield "" if cell is None else repr(float(cell)).replace(".", point)


def _text(rows: Iterable[Iterable[str]], language: str) -> str:
    separator, start = SIGNS[decimal_sign(language)]
    table = (heads(language), *rows)
    lines = (separator.join(_quoted(cell, separator) for cell in row) for row in table)
    return start + "".join(f"{line}\n" for line in lines)


def _quoted(cell: str, separator: str) -> str:
    """Return a cell in quotes if it could be taken for several, or its row for a comment."""
    if separator in cell or not _QUOTED.isdisjoint(cell):
        return '"{}"'.format(cell.replace('"', '""'))
    return cell
