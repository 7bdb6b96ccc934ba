"""Tables as people lay them out: segments down, positions across, or the other way round; a block a plan.

They are written out as rows under the usual titles, each with the line where its figure stands.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from types import MappingProxyType
from typing import NamedTuple

from graphic_tmm.checking.readings.csv_cells import HEADS, CellRow, Head, column_of, head_of
from graphic_tmm.checking.readings.figures import SHEET, is_nothing, unit_behind
from graphic_tmm.checking.readings.grid import too_many
from graphic_tmm.checking.readings.names import plan_meant
from graphic_tmm.checking.readings.position_names import is_position
from graphic_tmm.language.catalogue import languages
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import captions
from graphic_tmm.scene.units import UNITS, plain_unit

UNNAMED = "?"
"""The plan of a figure where none is named: that whose segment it is."""
_LABEL = re.compile(r"(.+?)\s*(?:[,(\[]\s*)([^\s,()\[\]]+)\s*[)\]]?")
_QUANTITY = re.compile(r"[vVв]_?[A-ZА-Я].*|a_?[A-ZА-Я].*|[vV][a-z]\d*")
"""A quantity by its name, not a segment: it may be given in mm or in its unit."""
_LETTER = re.compile(r"[^\W\d_]")
SHORT = 3
"""A name so short may be a segment's."""


class Layout(NamedTuple):
    """Figures written out as rows; what is wrong with some of them, by line."""

    head: Head
    rows: tuple[CellRow, ...]
    faults: tuple[tuple[int, str], ...] = ()


class _Across(NamedTuple):
    """Titles of a crosstab: by place the positions, or segments, there; ``own``: the place of a row's."""

    positions: bool
    titles: Mapping[int, str]
    own: int
    plan: int = -1
    unit: str = ""


class _Reader:
    """Rows read one after the other: the plan and the titles that hold for the next one."""

    def __init__(self, plan: str, separator: str) -> None:
        self.sheet = plan
        self.plan, self.separator = plan, separator
        self.titles: _Across | Head | None = None
        self.faults: list[tuple[int, str]] = []

    def of(self, row: CellRow) -> Iterator[CellRow]:
        """Yield the figures of a row, each as a row under `HEADS`."""
        cells = [" ".join(cell.split()) for cell in row.cells]
        while cells and not cells[-1]:
            cells.pop()
        if not cells:
            return
        if titles := self._titles(row, cells):
            self.titles = titles
        elif sum(map(bool, cells)) == 1 and named_plan(cells[0] or cells[-1]):
            self.plan = next(filter(None, cells))
        elif isinstance(self.titles, Head):
            yield from self._usual(row.line, cells, self.titles)
        elif self.titles is not None:
            yield from self._crossed(row.line, cells, self.titles)

    def _titles(self, row: CellRow, cells: Sequence[str]) -> _Across | Head | None:
        head = head_of(row, self.separator)
        there = set(head.places)
        if {"position", "segment"} <= there and (there & {"mm", "value"} or {"x", "y"} <= there):
            twice = said("this column stands twice; take one out, or rename it")
            self.faults += [(row.line, twice) for _ in head.twice[:1]]
            return head
        columns = [column_of(cell) for cell in cells]
        first = next(
            (k for k, c in enumerate(columns) if c not in ("plan", "segment", "position")), 0
        )
        corner, of = labelled("" if is_nothing(cells[0]) else cells[0])
        if first == 0:
            if not (corner == "" or named_plan(corner) or "\\" in corner or "/" in corner):
                return None
            first = 1
        across = {k: cell for k, cell in enumerate(cells) if k >= first and cell}
        if not across or len(set(across.values())) < len(across):
            return None
        if all(map(is_position, across.values())):
            positions = True
        elif all(_LETTER.search(cell) and not column_of(cell) for cell in across.values()):
            positions = False
        else:
            return None
        if corner and not columns[0] and named_plan(corner):
            self.plan = corner
        kept = columns[:first]
        plan = kept.index("plan") if "plan" in kept else -1
        wanted = "segment" if positions else "position"
        # "положение" in the corner may be the title of what stands across
        if set(kept) - {"", "plan", wanted} and len(kept) > 1:
            return None
        own = kept.index(wanted) if wanted in kept else first - 1
        return _Across(positions, across, own, plan, of) if own != plan else None

    def _usual(self, line: int, cells: list[str], head: Head) -> Iterator[CellRow]:
        if len(cells) > len(head.titles):
            self.faults.append((line, too_many(len(cells), len(head.titles), self.separator)))
            return
        wide = [*cells, *[""] * (len(head.titles) + 1 - len(cells))]
        wide[len(head.titles)] = ""
        chosen = [wide[place] for place in head.columns]
        if "plan" not in head.places:
            chosen[0] = self.plan or UNNAMED
        factors = [head.units.get(str(name), 1.0) for name in HEADS]
        for k, factor in enumerate(factors):
            if factor != 1.0 and chosen[k]:
                chosen[k] += f" {_unit_of(factor)}"
        yield CellRow(line, chosen)

    def _crossed(self, line: int, cells: Sequence[str], titles: _Across) -> Iterator[CellRow]:
        label = cells[titles.own] if titles.own < len(cells) else ""
        if titles.plan >= 0 and cells[titles.plan]:
            self.plan = cells[titles.plan]
        surplus = [cell for k, cell in enumerate(cells) if k > max(titles.titles) and cell]
        if surplus and (titles.own < len(cells)):
            self.faults.append((line, too_many(len(cells), max(titles.titles) + 1, self.separator)))
        for place, title in titles.titles.items():
            cell = cells[place] if place < len(cells) else ""
            if not cell or is_nothing(cell):
                continue
            segment, position = (label, title) if titles.positions else (title, label)
            yield self._figure(line, position, segment, cell, titles.unit)

    def _figure(self, line: int, position: str, label: str, cell: str, usual: str) -> CellRow:
        segment, unit = labelled(label)
        unit = unit or usual
        behind = unit_behind(cell)
        plan = self.plan or UNNAMED
        known = behind or unit
        if not known and _QUANTITY.fullmatch(segment):
            says = said(
                '"{cell}" of "{segment}" may be mm or a quantity; write the unit: "{segment}, mm" or '
                '"{segment}, m/s"',
                cell=cell[:20],
                segment=segment[:20],
            )
            self.faults.append((line, says))
        if known and known.casefold().rstrip(".") not in SHEET:
            return CellRow(
                line, [plan, position, segment, "", cell, "" if behind else unit, "", ""]
            )
        length = cell if behind or not unit else f"{cell} {unit}"
        return CellRow(line, [plan, position, segment, length, "", "", "", ""])


def laid_out(sheets: Sequence[tuple[str, Sequence[CellRow]]], separator: str) -> Layout | None:
    """Return tables of any layout as rows under the usual titles; None where they hold no figure.

    ``sheets``: the name of each, "" for a text, and its rows; a plan's name is that of the plan of its rows.
    """
    found: list[CellRow] = []
    faults: list[tuple[int, str]] = []
    before = 0
    for name, rows in sheets:
        reader = _Reader(name if named_plan(name) else "", separator)
        for row in rows:
            found += reader.of(row._replace(line=row.line + before))
        before += rows[-1].line if rows and len(sheets) > 1 else 0
        faults += reader.faults
    if not any(any(row.cells[3:5]) or any(row.cells[6:]) for row in found):
        return None
    places = MappingProxyType({str(name): k for k, name in enumerate(HEADS)})
    head = Head(1, separator, tuple(map(str, HEADS)), places)
    return Layout(head, tuple(found), tuple(faults))


def labelled(label: str) -> tuple[str, str]:
    """Return what a label names and the unit behind it, "" for none.

    >>> labelled("pd, мм"), labelled("V_D (м/с)"), labelled("pd")
    (('pd', 'мм'), ('V_D', 'м/с'), ('pd', ''))
    """
    found = _LABEL.fullmatch(label)
    if found is None:
        return label, ""
    unit = found[2]
    known = unit.casefold().rstrip(".") in SHEET or plain_unit(unit) in UNITS
    return (found[1], unit) if known else (label, "")


@cache
def _plans() -> tuple[str, ...]:
    return tuple(dict.fromkeys(name for one in languages() for name in captions(one)))


def named_plan(text: str) -> bool:
    """Whether a text names a plan, and no column; a letter or two are rather a segment."""
    return len(text) > SHORT and not column_of(text) and bool(plan_meant(text, _plans()).names)


def _unit_of(factor: float) -> str:
    return next(name for name, mm in SHEET.items() if mm == factor)
