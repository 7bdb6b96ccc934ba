"""Diagrams that follow what is given: their curves, the cursors on them, and the results that come of them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from itertools import combinations
from typing import Any

import numpy as np

from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Complexes, Line
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.language.numbers import number
from graphic_tmm.language.symbols import result_symbol, symbol
from graphic_tmm.page.cursors import Cursor
from graphic_tmm.page.dense import Dense
from graphic_tmm.page.sentences import indexed
from graphic_tmm.paper.drawing import Drawing, Sheet, Stroke
from graphic_tmm.paper.pens import pens
from graphic_tmm.paper.write.svg import ids
from graphic_tmm.readers.columns import Tabled
from graphic_tmm.readers.table import results_of
from graphic_tmm.scene.captions import captions

EVEN = 1e-9
"""The numbers of places in the row that are off a straight line by no more go on evenly."""
SHORT = 0.01
"""Ink ends in a mark if it is nearer, mm: the half of what a sheet tells."""


def live_cursor(one: Cursor, sheets: Sequence[Sheet]) -> dict[str, Any]:
    """Return of a cursor what finds it on a curve that is drawn anew; places in mm of the sheet, y downward."""
    found: dict[str, Any] = {
        "curve": one.curve,
        "of": one.chart.mu.slot,
        "at": [round(one.origin.real, 3), round(sheets[one.sheet].height - one.origin.imag, 3)],
        "behind": one.behind,
    }
    if one.point is not None:
        return found | {"point": one.point.slot}
    return found | {"base": [mark.slot for mark in one.base]}


def _straight(view: Drawing, plans: Mapping[int, str]) -> dict[tuple[int, float], Complexes]:
    """Return the ends of the straight lines of a view that come from one step each, by that and their width."""
    found: dict[tuple[int, float], list[tuple[complex, complex]]] = {}
    widths = {name: pen.width for name, pen in pens("A1").items()}
    for one in view.strokes:
        if isinstance(one, Stroke) and len(one.of) == 1 and len(one.path) == 2 and not one.part:
            plan = plans.get(one.of[0], "")
            if plan in view.shows:
                first, last = (complex(x, y) - view.origin(plan) for x, y, _ in one.path)
                found.setdefault((one.of[0], widths[one.pen]), []).append((first, last))
    return {key: np.array(ends) for key, ends in found.items()}


class LiveCharts:
    """The views of sheets that bear cursors: the marks that their ink is of, and the results."""

    def __init__(
        self, found: Dense, drawn: Drawn, cursors: Sequence[Cursor], sheets: Sequence[Sheet]
    ) -> None:
        """``drawn``: the board as the sheets show it."""
        self.found, self.drawn, self.cursors = found, drawn, cursors
        self.plans = {step.it.slot: step.it.view for step in drawn.construction.steps}
        self.views = {
            name: (sheet.height, view)
            for sheet in sheets
            for name, view in zip(ids(sheet), sheet.drawings, strict=True)
            if any(one.view == name for one in cursors)
        }

    @cached_property
    def results(self) -> list[tuple[str, str, float, str, Mark]]:
        """The results that a step leaves: the view that shows it or else the last, name, figure, unit, mark."""
        found, sheet = [], self.found.sheet
        left = {step.it for step in sheet.construction.steps}
        marks = {k: m for c in sheet.project.chapters for k, m in Tabled.of(c).marks(sheet).items()}
        for name, (value, of) in single(results_of(sheet)).items():
            mark = marks.get(name)
            if mark is not None and mark in left and value:
                shown = [key for key, (_, view) in self.views.items() if mark.view in view.shows]
                found.append(((shown or [*self.views])[-1], name, value, of, mark))
        return found

    @cached_property
    def inked(self) -> frozenset[int]:
        """The marks that ink of these views is of, and its letters."""
        every = (one for _, view in self.views.values() for one in (*view.strokes, *view.labels))
        return frozenset(slot for one in every for slot in one.of)

    @cached_property
    def hangs(self) -> dict[int, list[int]]:
        """The marks that ink of others hangs on, by slots: a line is drawn as far as what is marked on it.

        Axes are as long as the base.
        """
        log = self.found.sheet.construction
        axes = {mark for figure in log.figures if figure.kind == "axes" for mark in figure.marks}
        found: dict[int, set[int]] = {}
        for step in log.steps:
            for mark in step.uses if step.it not in axes else ():
                found.setdefault(step.it.slot, set()).add(mark.slot)
                if mark.kind is Line and mark not in axes and step.it.view == mark.view:
                    found.setdefault(mark.slot, set()).add(step.it.slot)
        return {slot: sorted(found[slot]) for slot in sorted(self.inked & found.keys())}

    @cached_property
    def segments(self) -> list[tuple[str, int, float, int, int, float, float]]:
        """The straight lines from mark to mark: of each its view, the mark that its ink is of, its width.

        Then both marks, and where their plan begins on the sheet. They are ink that stands exactly between the
        two in every position of the row in which these are apart.
        """
        found = []
        for name, (high, view) in self.views.items():
            for (slot, width), ends in _straight(view, self.plans).items():
                origin = view.origin(self.plans[slot])
                at = round(origin.real, 3), round(high - origin.imag, 3)
                pair = next(self._between(slot, ends), None)
                found += [] if pair is None else [(name, slot, width, *pair, *at)]
        return found

    def _between(self, slot: int, ends: Complexes) -> Iterator[tuple[int, int]]:
        """Yield the pairs of marks between which ink of a mark stands; ``ends``: of each line, mm of its view.

        Positions outside the row need have no line.
        """
        places, count = {}, self.drawn.project.count
        for one in {slot, *self.hangs.get(slot, ())}:
            value = self.drawn.numbers.drawn.values.get(one)
            at = value.at if isinstance(value, Line) else value
            if isinstance(at, np.ndarray) and np.iscomplexobj(at):
                places[one] = np.broadcast_to(at[0, :count], (count,))
        for first, last in combinations(sorted(places), 2):
            a, b = places[first], places[last]
            apart = np.isfinite(a) & np.isfinite(b) & (np.abs(a - b) > SHORT)
            off = [
                np.abs(ends - np.stack(pair, axis=1)[apart][:, None]).max(axis=2).min(axis=1)
                for pair in ((a, b), (b, a))
            ]
            if apart.any() and np.minimum(*off).max() < SHORT:
                yield first, last

    @property
    def slots(self) -> frozenset[int]:
        """The marks that ink of these views is of or hangs on, those that cursors need, and results."""
        found = {*self.inked, *(slot for some in self.hangs.values() for slot in some)}
        for one in self.cursors:
            found |= {one.curve, one.chart.mu.slot, *(mark.slot for mark in one.base)}
        return frozenset(found | {mark.slot for *_, mark in self.results})

    @property
    def moving(self) -> frozenset[int]:
        """The marks that cursors need at every angle."""
        return frozenset(one.point.slot for one in self.cursors if one.point is not None)

    def data(self) -> dict[str, Any]:
        """Return how numbers of the row go on along the angles, how many there are; the rest by its names."""
        numbers = self.found.numbers
        by = (numbers[1] - numbers[0]) / (self.found.frames[1] - self.found.frames[0])
        line = numbers[0] + by * (self.found.frames - self.found.frames[0])
        even = bool(np.abs(numbers - line).max() <= EVEN)
        data: dict[str, Any] = (
            {"numbers": [float(numbers[0]), float(by), self.found.drawn.project.count]}
            if even
            else {}
        )
        told = {
            "results": list(self._results_data()),
            "hangs": self.hangs,
            "segments": self.segments,
        }
        return data | told

    def _results_data(self) -> Iterator[dict[str, Any]]:
        language = self.found.drawn.scene.language
        for view, name, value, of, mark in self.results:
            caption = captions(language).get(name)
            yield {
                "view": view,
                "letter": indexed(
                    symbol(caption, language) if caption else result_symbol(name, language)
                ),
                "unit": of,
                "text": number(value, language),
                "slot": mark.slot,
            }
