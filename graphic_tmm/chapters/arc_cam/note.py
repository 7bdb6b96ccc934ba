"""The section of a cam given by arcs in a note: contour, reversed motion, diagrams; one position worked."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.operations.formulas import pole_distance, to_board
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.arc_cam import formulas as f
from graphic_tmm.chapters.arc_cam import note_words as words
from graphic_tmm.chapters.arc_cam.beside import BESIDE
from graphic_tmm.chapters.arc_cam.beside import VIEW as CALCULATED
from graphic_tmm.chapters.arc_cam.contour import VIEW
from graphic_tmm.chapters.arc_cam.note_conclusions import concludes
from graphic_tmm.chapters.arc_cam.plan import ARC_CAM_PLAN, VIEWS, ArcCam
from graphic_tmm.chapters.arc_cam.table import arc_columns
from graphic_tmm.chapters.arc_cam.task import FLAT, ROCKER
from graphic_tmm.chapters.arc_cam.views import arc_views
from graphic_tmm.drawn import Drawn
from graphic_tmm.note.bricks import columns, heading, referred
from graphic_tmm.note.chapter import Noted
from graphic_tmm.note.document import (
    Block,
    Item,
    Listed,
    Number,
    Run,
    Text,
)
from graphic_tmm.note.figures import is_figure, picture, readable
from graphic_tmm.note.page import Page
from graphic_tmm.note.steps import Told


def note(drawn: Drawn, language: str) -> Iterator[Block]:
    """Yield the section of a cam given by arcs."""
    made = ARC_CAM_PLAN.of(drawn)
    if made is not None:
        yield from _Page(drawn, made, language).blocks()


class _Page(Page):
    """A cam given by arcs, and the position that is worked: on the flank of the rise."""

    def __init__(self, drawn: Drawn, made: ArcCam, language: str) -> None:
        first, second, *_ = made.lie.changes
        at = max(1, round((second - first) / made.lie.work * made.order.parts / 2.0))
        super().__init__(drawn, language, at)
        self.made = made
        shown = [one for one in readable(drawn, arc_views) if is_figure(one)]
        self.contour, self.graphs = (picture(one, language) for one in shown)

    def blocks(self) -> Iterator[Block]:
        """Yield what is told: contour, follower, diagrams, the table."""
        order = self.made.order
        yield heading(self.speech(words.CONTOUR))
        straight = order.rise.radius is None and order.fall.radius is None
        yield self.says(words.TANGENTS if straight else words.CIRCLES)
        yield from self._formulas(VIEW, to_board)
        yield from self._formulas(VIEW, f.inside, f.outside)
        yield referred((self.contour,), self.language)
        yield self.contour
        yield heading(self.speech(words.MOTION))
        steps = {FLAT: words.FLAT, ROCKER: words.ROCKER}.get(order.follower, words.ROLLER)
        yield Listed(tuple(Item("", (self.says(one),)) for one in steps))
        told = self._read(VIEW)
        put: dict[str, Run] = {
            "position": Text(self.drawn.names[self.at]),
            "angle": self._angle(),
            "travel": told.number(self.made.follower.travel, unit=True),
        }
        yield self.says(words.WORKED, put)
        yield from self._diagrams(told)
        yield from columns(self.drawn, arc_columns(self.drawn), self.language)

    def _diagrams(self, told: Told) -> Iterator[Block]:
        yield heading(self.speech(words.DIAGRAMS))
        yield self.says(words.CHORDS)
        for view in (VIEWS["V"], VIEWS["A"]):
            yield from self._formulas(view, pole_distance)
        yield referred((self.graphs,), self.language)
        yield self.graphs
        rocks = self.made.order.follower == ROCKER
        where = {"position": Text(self.drawn.names[self.at])}
        yield self.says(words.PIVOTS if rocks else words.INSTANT, {**where})
        yield from self.worked_out(told, self.made.follower.rate)
        yield self.says(words.SECOND)
        beside, speeds = BESIDE.on(self.drawn), list[Mark]()
        if beside.velocity is not None and beside.acceleration is not None:
            speeds = [beside.velocity, beside.acceleration[0]]
        yield from self.worked_out(self._read(CALCULATED), beside.second[0], *speeds)

    def _angle(self) -> Number:
        """Return the angle of the cam in the position that is worked, as the table tells it."""
        steps = [step.it for step in self.drawn.construction.steps if step.op is f.part_of_work]
        return self._read(VIEW).number(next(mark for mark in steps if self._there(mark)))

    def _there(self, mark: Mark) -> bool:
        return math.isfinite(self._read(VIEW).value(mark))

    def _read(self, view: str) -> Told:
        found = self.of(view)
        assert found is not None
        return found

    def _formulas(self, view: str, *ops: Operation) -> Iterator[Block]:
        steps = self.drawn.construction.steps
        marks: Sequence[Mark] = [s.it for s in steps if s.it.view == view and s.op in ops]
        yield from self.worked_out(self._read(view), *marks)


NOTE = Noted(section=note, concludes=concludes)
