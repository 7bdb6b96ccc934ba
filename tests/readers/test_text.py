"""Framed tables: the same signs as rich prints, without rich."""

from __future__ import annotations

import io

from hypothesis import given
from hypothesis import strategies as st
from rich.console import Console

from graphic_tmm.readers.text import Framed

SIGNS = (
    st.lists(st.sampled_from([*"ab1,−′ωφ₁ 漢[/]\\", "v̄"]), max_size=8).map("".join).map(str.rstrip)
)
"""Letters of tables: with marks above them, of double width, what rich takes for mark-up."""


@st.composite
def tables(draw: st.DrawFn) -> Framed:
    wide = draw(st.integers(1, 5))
    rows = draw(st.lists(st.lists(SIGNS, min_size=wide, max_size=wide), min_size=2, max_size=5))
    return Framed(draw(SIGNS).strip(), rows, draw(st.booleans()))


def by_rich(table: Framed) -> str:
    console = Console(file=io.StringIO(), width=400, color_system=None)
    console.print(table)
    assert isinstance(console.file, io.StringIO)
    return console.file.getvalue()


@given(tables())
def test_a_table_is_framed_as_rich_frames_it(table: Framed) -> None:
    assert table.plain(400) == by_rich(table)


def test_what_only_rich_can_print_is_left_to_it() -> None:
    rows = [["head"], ["cell"]]
    assert Framed("a title", rows).plain(6) is None
    assert Framed("a title", rows).plain(7) is not None
    assert Framed("a\ntitle", rows).plain(80) is None
    assert Framed("a title", [["head"], ["ce\tll"]]).plain(80) is None
    assert Framed("a title", [["head"], ["\u0304"]]).plain(80) is None
    assert Framed("a title", [["head"], ["cell "]]).plain(80) is None
    assert Framed("a title", rows[:1]).plain(80) is None
