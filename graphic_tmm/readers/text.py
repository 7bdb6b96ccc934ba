"""Tables for a terminal: framed, in blocks of positions that fit its width, so that nothing of them is cut."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import chain, groupby
from typing import TYPE_CHECKING, NamedTuple

from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.language.symbols import plain, result_symbol, symbol
from graphic_tmm.language.units import unit
from graphic_tmm.readers.columns import Column, Positions, known_at
from graphic_tmm.readers.position_count import Finer
from graphic_tmm.readers.rounding import rounded, told_as
from graphic_tmm.readers.spread import QUANTILES
from graphic_tmm.scene.captions import captions
from graphic_tmm.scene.chapter import chapters

if TYPE_CHECKING:
    from rich.table import Table
    from rich.text import Text


_ACTS = re.compile("[\x00-\x1f\x7f]")
"""Signs that are not printed."""


class Framed(NamedTuple):
    """A table: its title, which may be longer than it is wide; its rows, heads first; ``left``: so aligned."""

    title: str
    rows: Sequence[Sequence[str]]
    left: bool = False

    def plain(self, width: int) -> str | None:
        """Return it without bold or italic letters, its title in one line; None if only rich can print it so.

        ``width``: of the terminal, characters; the table itself may be wider.
        """
        from rich.cells import cell_len

        if len(self.rows) < 2 or cell_len(self.title) > width:
            return None
        if any(_ACTS.search(text) for text in (self.title, *(c for row in self.rows for c in row))):
            return None
        wide = [[cell_len(cell) for cell in row] for row in self.rows]
        measured = zip(chain.from_iterable(self.rows), chain.from_iterable(wide), strict=True)
        if any(cell and (not own or cell[-1].isspace()) for cell, own in measured):
            return None
        room = [max(column) for column in zip(*wide, strict=True)]
        lines = [self.title, _rule("┏━┳┓", room)]
        for k, (row, lengths) in enumerate(zip(self.rows, wide, strict=True)):
            side = "│" if k else "┃"
            free = [" " * (most - own) for most, own in zip(room, lengths, strict=True)]
            cells = (
                f" {cell}{rest} " if self.left else f" {rest}{cell} "
                for cell, rest in zip(row, free, strict=True)
            )
            lines.append(f"{side}{side.join(cells)}{side}")
            if not k:
                lines.append(_rule("┡━╇┩", room))
        lines.append(_rule("└─┴┘", room))
        return "".join(f"{line}\n" for line in lines)

    def parts(self) -> tuple[Text, Table]:
        """Return its title and the table itself as rich prints them."""
        from rich.table import Table
        from rich.text import Text

        out = Table()
        for head in self.rows[0]:
            out.add_column(Text(head), justify="left" if self.left else "right", no_wrap=True)
        for row in self.rows[1:]:
            out.add_row(*map(Text, row))
        return Text(self.title, style="italic"), out

    def __rich_console__(self, console: object, options: object) -> Iterator[Text | Table]:
        """Yield what rich prints."""
        yield from self.parts()


def _rule(signs: str, room: Sequence[int]) -> str:
    first, rule, between, last = tuple(signs)
    return first + between.join(rule * (k + 2) for k in room) + last


FRAME = 3
"""What the frame and the room about a cell take beside its text, characters; one more for the whole table."""
Rows = list[list[str]]


def text_tables(
    table: Sequence[Column],
    positions: Positions,
    language: str,
    title: str,
    decimals: int,
    width: int,
) -> list[Framed]:
    """Return the tables for a terminal of so many characters, a plan after the other; positions run across.

    mm are told with ``decimals``. What does not fit beside one another stands in blocks below one another, each
    with its heads.
    """
    words = captions(language)
    made: list[Framed] = []
    for (plan, at), group in groupby(table, key=lambda column: (column.plan, column.at)):
        rows = table_rows(list(group), at or positions, language, decimals)
        told = f"{title}. {words.get(plan, plan)}"
        for k, block in enumerate(_blocks(rows, width)):
            made.append(Framed(told if k == 0 else f"{told} ({words['continued']})", block))
    return made


def table_rows(
    columns: Sequence[Column], positions: Positions, language: str, decimals: int
) -> Rows:
    """Return columns of the same positions as rows of cells, heads first: of each its mm, and its quantity."""
    words, names, shown = captions(language), [name for name, _ in positions], known_at(columns)
    heads = [words["segment"], words["unit"], *(names[k] for k in shown)]
    return [heads, *(row for one in columns for row in _rows(one, shown, decimals, language))]


def result_tables(
    results: Mapping[str, tuple[float, str]],
    fine: Mapping[str, Finer],
    language: str,
    title: str,
) -> list[Framed]:
    """Return the table of results for a terminal, and that of what finer rows tell of them (``fine``)."""
    words, head = captions(language), f"{title}. {captions(language)['results']}"
    rows = [[words["results"], words["value"], words["unit"]]]
    for name, (value, of) in results.items():
        rows.append([result_name(name, language), number(value, language, 6), unit(of, language)])
    finer_rows = [[words["results"], words["finer row"], words["off"]]]
    finer_rows += [_divided(name, fine[name], language) for name in results if name in fine]
    return [
        *([Framed(head, rows, left=True)] if results else []),
        *([Framed(f"{head} ({words['continued']})", finer_rows, left=True)] if fine else []),
    ]


def left_out(told: Mapping[str, str], language: str, title: str) -> list[Framed]:
    """Return the table of chapters that have no result, a sentence each; none if there are none."""
    speech = speaking(language)
    rows = [[speech("There is no result")], *([speech(says)] for says in told.values())]
    return [Framed(f"{title}.", rows, left=True)] if told else []


def _divided(name: str, fine: Finer, language: str) -> list[str]:
    """Return the name of a result, what a finer row gives for it, and how far it is off, %."""
    due, off = number(fine.due[name][0], language, 6), fixed(100.0 * fine.off[name], 1, language)
    return [result_name(name, language), due, off]


def column_name(column: Column, language: str) -> str:
    """Return what a column is called, as mark-up: a word of the catalogue, or its mark's name."""
    return captions(language).get(column.letter) or symbol(column.letter, language)


def result_name(name: str, language: str) -> str:
    """Return what a result is called, as plain text; of many drawings, behind it which of their quantiles.

    One that has no caption is called by its letter, without the name of its chapter before it.
    """
    stem, _, quantile = name.rpartition("_")
    if stem and quantile in QUANTILES:
        return f"{result_name(stem, language)} {quantile}"
    if caption := captions(language).get(name):
        return plain(symbol(caption, language))
    for one in chapters():
        name = name.removeprefix(f"{one.name}_")
    return plain(result_symbol(name, language))


def _rows(
    column: Column, shown: Sequence[int], decimals: int, language: str
) -> Iterator[list[str]]:
    """Yield the rows of a column: its mm, if it has any, and the quantity, if it is one."""
    letter, (mm, value) = plain(column_name(column, language)), column.first_figures
    if column.drawn:
        lengths = (one if one is None else rounded(one, decimals) for one in (mm[k] for k in shown))
        cells = [fixed(one, decimals, language) for one in lengths]
        yield [letter, unit("mm", language), *cells]
    figures = [told_as(mm[k], value[k], decimals) for k in shown]
    yield [
        letter,
        unit(column.unit, language),
        *("—" if x is None else number(x, language) for x in figures),
    ]


def _blocks(rows: Rows, width: int) -> Iterator[Rows]:
    """Yield parts of a table, so wide at the most: the two columns of heads, then as many others as fit."""
    needed = [max(len(row[k]) for row in rows) + FRAME for k in range(len(rows[0]))]
    heads, at = sum(needed[:2]) + 1, 2
    while True:
        end, used = at, heads
        while end < len(needed) and (end == at or used + needed[end] <= width):
            used += needed[end]
            end += 1
        yield [[*row[:2], *row[at:end]] for row in rows]
        at = end
        if at >= len(needed):
            return
