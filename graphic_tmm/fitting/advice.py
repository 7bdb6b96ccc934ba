"""What an author is told of a scale factor that his scene fixes: where it leaves the sheets half white."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.errors import TmmError
from graphic_tmm.fitting.search import Search
from graphic_tmm.fitting.sizes import Sizes
from graphic_tmm.fitting.tried import Mechanism
from graphic_tmm.language.said import Said, said

WHITE = 0.5
"""Sheets whose views take less of their free room are half white."""
WORTH = 1.2
"""So many times larger a plan has to come out for anybody to be told of it."""


def half_white(search: Search, own: Mechanism, sizes: Sizes) -> Iterator[Said]:
    """Yield, for each μ of a plan that the scene fixes, what would fill the sheets that it leaves half white.

    Everything else stays as large as it is, and the sheets are no more.
    """
    for name, size in own.sizes.items():
        key = size.fixed(search.scene)
        if not (key and size.in_mm and search.rooms.fill(name, sizes) < WHITE):
            continue
        now = own.mm(name, sizes)
        free = own.freed(size.freed(search.scene))
        tried = search.with_board(free)
        begin = {**sizes, name: now * (1 + 1e-9)}
        try:
            most = max(len(search.scene.sheets), tried.rooms.count(begin))
            found = tried.lettered(tried.lifted(begin, [name], most), most) or begin
            large = free.mm(name, found)
            if large < WORTH * now:
                continue
            section, _, short = key.rpartition(".")
            value = size.remedy(free.draw(found), short)
        except TmmError:
            continue
        yield said(
            '{name} in [{section}] leaves its sheet half white: {name} = "{value}" would draw the plan '
            "{large:.0f} mm large, not {now:.0f} mm",
            name=short,
            value=value,
            section=section,
            large=large,
            now=now,
        )
