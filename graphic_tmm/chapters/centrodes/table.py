"""The columns of centrodes: coordinates of the instantaneous centres, arcs of both curves; the protocol."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.centrodes.record import CENTRODES_PLAN, Centrodes
from graphic_tmm.chapters.centrodes.task import CENTRODES
from graphic_tmm.drawn import Drawn, Results, results_of
from graphic_tmm.project import Project
from graphic_tmm.readers.columns import Column, Tabled, row_of
from graphic_tmm.readers.protocol import Protocols


def lengths(made: Centrodes) -> dict[str, Mark]:
    """Return by name what is read in every position: P on the frame, P in the link, both arcs."""
    (fixed, moving), index = made.sides, made.index
    return {
        f"xP{index}": fixed.x,
        f"yP{index}": fixed.y,
        f"ξP{index}": moving.x,
        f"ηP{index}": moving.y,
        f"s{index}": fixed.arc,
        f"s′{index}": moving.arc,
    }


def link_columns(drawn: Drawn, made: Centrodes) -> Iterator[Column]:
    """Yield the columns of one link's centrodes; arcs are there only between the positions of a sheet."""
    count, reading = len(drawn.names), drawn.reading
    for name, mark in lengths(made).items():
        if mark not in reading:
            continue
        mm, value = (reading.figure(mark, by) for by in (None, made.mu))
        rows = row_of(mm, range(count), count), row_of(value, range(count), count)
        yield Column(made.view, name, mark.name, "m", *rows)


def _columns(drawn: Drawn) -> Iterator[Column]:
    for made in CENTRODES_PLAN.of(drawn) or ():
        yield from link_columns(drawn, made)


def marks(drawn: Drawn) -> dict[str, Mark]:
    """Return the angles between both tangents, by their names among the results."""
    return {
        f"centrodes_off_{made.moving.link}": made.off for made in CENTRODES_PLAN.of(drawn) or ()
    }


def _results(drawn: Drawn) -> Results:
    return results_of(drawn, marks(drawn))


def _views(project: Project) -> dict[str, tuple[str, ...]]:
    return {CENTRODES: tuple(made.view for made in CENTRODES_PLAN.of(project) or ())}


TABLE = Tabled(columns=_columns, results=_results, marks=marks)
PROTOCOL = Protocols(views=_views)
