"""A table in a frame of box characters, for a terminal: as rich prints it, which is loaded only where it must.

Rich measures and wraps every cell anew, though none of them is wrapped here. Where no letters are to be bold or
italic the same text is put together at once.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import chain
from typing import TYPE_CHECKING, NamedTuple

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
