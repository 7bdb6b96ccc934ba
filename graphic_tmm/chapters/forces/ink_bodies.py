"""The links of a detached group in ink: those of the plan of positions, drawn to the figure's own scale."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Figure, Mark
from graphic_tmm.board.values import Line
from graphic_tmm.chapters.kinematics.ink_links import MAIN, LinksInk
from graphic_tmm.chapters.kinematics.reaches import VIEW as POSITIONS
from graphic_tmm.chapters.kinematics.reaches import Reach
from graphic_tmm.paper.drawing import Ink, Wanted
from graphic_tmm.paper.finish import Named, lettered, shared
from graphic_tmm.paper.lettering.heights import Heights
from graphic_tmm.paper.lettering.indices import (
    markup,
)
from graphic_tmm.paper.seen import Seen


class Bodies:
    """The links of a figure: those of the plan of positions, drawn to another scale."""

    def __init__(
        self,
        seen: Seen,
        reaches: Mapping[Figure, Reach],
        links: Sequence[int],
        points: Mapping[Mark, Mark],
        times: float,
    ) -> None:
        """``points``: by those of the plan of positions; ``times``: how much larger than there."""
        construction, reading = seen.construction, seen.reading
        figures = [one for one in construction.figures if one.view == POSITIONS]
        marks = dict.fromkeys(mark for one in figures for mark in one.marks)
        values = {mark.slot: _larger(reading[mark], times) for mark in marks}
        larger = {one: reach.times(times) for one, reach in reaches.items()}
        self.ink = LinksInk(construction, Reading(values, reading.positions), larger)
        self.names = [str(number) for number in links]
        self.points, self.index = points, seen.positions[0]

    def strokes(self) -> Iterator[Ink]:
        """The links, and what slides on them; they stand on the points of the figure."""
        found = [s for name in self.names for s in self.ink.lines(name, self.index, MAIN)]
        found += self.ink.symbols(self.names, self.index)
        own = {of.slot: mark.slot for of, mark in self.points.items()}
        for stroke in found:
            of = tuple(own[slot] for slot in stroke.of if slot in own)
            yield stroke._replace(of=of or tuple(own.values()))

    def letters(self, high: Heights) -> list[Wanted]:
        """The letters of the points of the links."""
        marks = dict.fromkeys(
            mark
            for name in self.names
            for told in self.ink.of(name, "link", "centre")
            for mark in told.marks
        )
        named = [
            Named(self.ink.at(m, self.index), markup(m.name), (self.points[m].slot,), self.index)
            for m in marks
            if m in self.points
        ]
        return lettered(shared(named), high.point, 2.2)

    @property
    def middle(self) -> complex:
        """The middle of the points of all links."""
        return complex(np.mean([end for name in self.names for end in self.ends(name)]))

    def ends(self, name: str) -> tuple[complex, complex]:
        """Between which of its points couples on a link are drawn: those farthest apart."""
        pins = [*self.ink.spots(name, self.index)]
        pins += [one.foot for one in self.ink.bars(name, self.index)]
        if len(pins) < 2:
            return (pins[0], pins[0]) if pins else (0j, 0j)
        return max(((a, b) for a in pins for b in pins), key=lambda ends: abs(ends[1] - ends[0]))


def _larger(value: Any, times: float) -> Any:
    if isinstance(value, Line):
        return value._replace(at=value.at * times)
    return value * times if np.iscomplexobj(value) else value
