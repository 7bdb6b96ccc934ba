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
TICK, FAR = 2.0, 10.5
"""A line goes on beyond its mark by more, and less, mm: a tangent by 10; a tick is no line."""


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
    """Return the ends of the straight lines of a view that come from one step each, by that and their width.

    Pieces between letters that stand on a line are one line.
    """
    found: dict[tuple[int, float], dict[object, list[complex]]] = {}
    widths = {name: pen.width for name, pen in pens("A1").items()}
    for one in view.strokes:
        if isinstance(one, Stroke) and len(one.of) == 1 and len(one.path) == 2 and not one.part:
            plan = plans.get(one.of[0], "")
            if plan in view.shows and not one.closed:
                ends = [complex(x, y) - view.origin(plan) for x, y, _ in one.path]
                lines = found.setdefault((one.of[0], widths[one.pen]), {})
                lines.setdefault(one.position, []).extend(ends)
    return {
        key: np.array([ends for some in lines.values() for ends in _whole_lines(some)])
        for key, lines in found.items()
    }


def _is_head(one: Stroke) -> bool:
    """Whether a stroke is the head of an arrow that a step left."""
    return one.filled and len(one.path) == 3 and len(one.of) == 1 and not one.part


def _whole_lines(pieces: Sequence[complex]) -> list[tuple[complex, complex]]:
    """Return the ends of lines whose pieces lie on one; of others the pieces."""
    ends = np.array(pieces)
    start = ends[np.argmax(np.abs(ends - ends[0]))]
    end = ends[np.argmax(np.abs(ends - start))]
    if np.abs(((ends - start) * np.conj(end - start)).imag).max() < SHORT * abs(end - start):
        return [(complex(start), complex(end))]
    return list(zip(pieces[::2], pieces[1::2], strict=True))


def _beyond(first: Complexes, last: Complexes, ends: Complexes) -> tuple[float, float] | None:
    """Return how far lines go on beyond both of two marks in all positions, mm; None where they do not.

    ``ends``: of each line, (line, 2).
    """
    long = np.abs(last - first)[:, None, None]
    along = (ends - first[:, None, None]) * np.conj(last - first)[:, None, None] / long
    far = np.stack([-along.real.min(axis=2), along.real.max(axis=2) - long[:, :, 0]], axis=2)
    ends_there = (np.abs(far) < SHORT) | ((far > TICK) & (far < FAR))
    there = (np.abs(along.imag).max(axis=2) < SHORT) & ends_there.all(axis=2)
    for own in far[0][there[0]]:
        if (there & (np.abs(far - own).max(axis=2) < SHORT)).any(axis=1).all():
            before, behind = (round(float(x), 2) + 0.0 for x in np.where(own < SHORT, 0.0, own))
            return before, behind
    return None


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

        Axes are as long as the base, or as the sheet has them: these have heads.
        """
        log = self.found.sheet.construction
        axes = {mark for figure in log.figures if figure.kind == "axes" for mark in figure.marks}
        strokes = (one for _, view in self.views.values() for one in view.strokes)
        headed = {one.of[0] for one in strokes if isinstance(one, Stroke) and _is_head(one)}
        axes |= {step.it for step in log.steps if step.it.slot in headed and step.it.kind is Line}
        found: dict[int, set[int]] = {}
        for step in log.steps:
            for mark in step.uses if step.it not in axes else ():
                found.setdefault(step.it.slot, set()).add(mark.slot)
                if mark.kind is Line and mark not in axes and step.it.view == mark.view:
                    found.setdefault(mark.slot, set()).add(step.it.slot)
        return {slot: sorted(found[slot]) for slot in sorted(self.inked & found.keys())}

    @cached_property
    def segments(self) -> list[tuple[str, int, float, int, int, *tuple[float, ...]]]:
        """The straight lines from mark to mark: of each its view, the mark that its ink is of, its width.

        Then both marks, where their plan begins on the sheet, and how far it goes on beyond both where it does.
        They are ink that stands so between the two in every position of the row in which these are apart.
        """
        found: list[tuple[str, int, float, int, int, *tuple[float, ...]]] = []
        for name, (high, view) in self.views.items():
            for (slot, width), ends in _straight(view, self.plans).items():
                origin = view.origin(self.plans[slot])
                at = round(origin.real, 3), round(high - origin.imag, 3)
                pairs = sorted(self._between(slot, ends), key=lambda one: sum(one[2:]))
                if pairs:
                    first, last, *beyond = pairs[0]
                    more = beyond if any(beyond) else ()
                    found.append((name, slot, width, int(first), int(last), *at, *more))
        return found

    def _between(self, slot: int, ends: Complexes) -> Iterator[tuple[int, int, float, float]]:
        """Yield the pairs of marks between which ink of a mark stands, how far it goes on beyond each.

        ``ends``: of each line, mm of its view. Positions outside the row need have no line.
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
            if apart.any() and (beyond := _beyond(a[apart], b[apart], ends)) is not None:
                yield first, last, *beyond

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
