"""A plan as it may have been drawn instead: views by the grammar's mutations, of which the pencil chooses.

A mutation moves the places of a view; lines go with them. Those that the pencil agrees with best are inked from
their own log, with the lines that this mistake draws, and the best of these is the plan that is read.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cached_property
from types import MappingProxyType
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.hand import Hand
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Complexes, Length, Line, Point, Reals
from graphic_tmm.checking.cells import pointed
from graphic_tmm.checking.mutations.execution import Executed, as_drawn, executed
from graphic_tmm.checking.mutations.grammar import mutations
from graphic_tmm.checking.mutations.mistakes import free, misread, mistaken
from graphic_tmm.checking.mutations.mutation import (
    FACTOR,
    Change,
    Mutation,
    at_step,
    changed_log,
    measured_last,
)
from graphic_tmm.checking.pencil.darkness import Flat
from graphic_tmm.checking.pencil.expected import Stood, View, scatter_of, view_of
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.errors import TmmError
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.readers.columns import Readings

FACTORS = tuple(round(0.1 * k, 1) for k in range(-20, 31) if k not in (0, 10))
"""A length may have been laid off so many times as long, or the other way."""
SIZES = tuple(round(0.05 * k, 2) for k in range(8, 45) if k != 20)
"""A given may have been taken so many times as large."""
SAMPLES = 48
"""So many places of a line are looked at."""
MISSED = 1.5
"""A millimetre of a line that is not drawn weighs so many that are."""
MORE = 8.0
"""A mistake is read if the pencil agrees with so much more of it than of what is due, mm."""
MOVED = 1.5
"""A mutation that moves every place of a plan less, mm, is no other plan."""
SHORT = 1e-3
"""A shorter line has no direction, mm."""
LARGEST = 1.6
"""A plan so many times as large as it is due is another one's pencil."""
READ = 4
"""So many of these are read."""
SHAPELESS = 3.0
"""Points no farther from one line, mm (root of their squares), make no shape."""
NOTHING: Mapping[int, Mapping[int, Mapping[int, complex]]] = MappingProxyType({})
TRIED = 8
"""So many mutations are inked by their own logs."""


def roughly(flat: Flat, starts: Complexes, ends: Complexes) -> Reals:
    """Return roughly how the pencil agrees with straight lines, (rows, lines), in mm."""
    share = (np.arange(SAMPLES) + 0.5) / SAMPLES
    places = starts[..., None] + (ends - starts)[..., None] * share
    length = abs(ends - starts)[..., None] / SAMPLES
    there = np.isfinite(places)
    near = flat.near(np.where(there, places, 0.0))
    worth = np.where(there, length * (near - MISSED * (1 - near)), 0.0)
    return np.asarray(worth.sum(axis=(1, 2)), dtype=np.float64)


class Alternatives:
    """The mutations of a mechanism's board, executed once for all of its plans."""

    def __init__(self, board: Drawn, hand: Hand) -> None:
        self.board, self._hand = board, hand
        self._made = DrawnScene(board.scene, (board,))
        self._plans = pointed()
        self.log = measured_last(board.construction)
        self._known: dict[tuple[int, ...], Executed] = {}
        self._steps = {step.it.slot: step for step in self.log.steps}

    @cached_property
    def mutations(self) -> tuple[Mutation, ...]:
        """All that the pencil may show: the grammar's, and lengths and givens so many times as large."""
        given = self.board.given
        steps = [step for step in self.log.steps if step.it.view in self._plans]
        laid = [
            at_step(step, FACTOR, "", Change(step, factor=factor))
            for step in steps
            if step.it.kind is Length and not step.op.reads
            for factor in FACTORS
        ]
        sizes = [misread(m, factor) for m in free(self.log, given) for factor in SIZES]
        return (*mutations(self.log, steps), *mistaken(self.log, given), *laid, *sizes)

    @cached_property
    def scatter(self) -> Reading:
        """How the hand scatters the board's points."""
        return scatter_of(self.board, self._hand)

    def drawing(self, plan: str, position: str) -> Drawing:
        """Return a plan as it is due, drawn about 0."""
        return plan_drawing(self.board, plan, position)

    def due(self, plan: str, position: str) -> View:
        """Return a plan as it is due, its pole at 0."""
        return single_view(self.board, plan, position, self.scatter)

    def near(
        self, flat: Flat, due: View, plan: str, position: str, pole: complex
    ) -> Iterator[tuple[int, View]]:
        """Yield mutations that the pencil about a ``pole`` agrees with, the best first, and their views.

        ``due``: what the plan is due, as it is turned on the sheet.
        """
        found = []
        for row in self._nearest(flat, due, pole):
            view = self.view(row, plan, position, due.turn)
            if view is not None:
                found.append((agreement(flat, *(pole + view.ends)).worth, row, view))
        for _, row, view in sorted(found, key=lambda one: -one[0])[:READ]:
            yield row, view

    def view(self, row: int, plan: str, position: str, turn: complex) -> View | None:
        """Return a plan as a mutation draws it, turned on the sheet; None if nothing can be drawn."""
        view = self._inked(row, plan, position)
        return view.turned(turn) if view is not None and view.lines else None

    def _nearest(self, flat: Flat, due: View, pole: complex) -> Iterator[int]:
        """Yield the mutations that the pencil about a pole agrees with best as far as places tell."""
        spots = self._spots(due)
        rows = np.arange(len(spots))
        most = LARGEST * abs(due.at).max()
        with np.errstate(invalid="ignore"):
            drawn = np.isfinite(spots).all(axis=1) & (abs(spots) < most).all(axis=1)
            rows = rows[drawn & (abs(spots - due.at).max(axis=1) > MOVED)]
        # of those that put the places alike the one that changes most says which lines go with them
        rows = rows[np.argsort([-len(self.mutations[row].changes) for row in rows], kind="stable")]
        _, once = np.unique(np.round(spots[rows]), axis=0, return_index=True)
        rows = rows[once]
        if not len(rows):
            return
        started = {
            n: self._starts(self.mutations[row], due, spots[row]) for n, row in enumerate(rows)
        }
        worth = roughly(flat, *(pole + ends for ends in moved(due, spots[rows], started)))
        for k in np.argsort(-worth)[:TRIED]:
            yield int(rows[k])

    def _spots(self, due: View) -> Complexes:
        """Return where mutations have the places of a view, (mutations, places)."""
        beside = self._executed(tuple(one[0] for one in due.marks if one is not None))
        found = np.empty((len(self.mutations), len(due.places)), np.complex128)
        for n, one in enumerate(due.marks):
            if one is None:
                found[:, n] = due.places[n].at
            else:
                value = beside.whole(one[0].slot)
                with np.errstate(invalid="ignore"):
                    found[:, n] = due.turn * value[:, one[1] if value.shape[1] > 1 else 0]
        return found

    def _executed(self, wanted: tuple[Mark, ...]) -> Executed:
        """Return all mutations executed as far as some marks need it; once for all positions of a plan."""
        key = tuple(mark.slot for mark in wanted)
        if key not in self._known:
            self._known[key] = executed(self.log, self.board.given, self.mutations, wanted)
        return self._known[key]

    def _starts(self, what: Mutation, due: View, spots: Complexes) -> dict[int, dict[int, complex]]:
        """Return by line of a view which of its places a mutation draws it from instead: where that is."""
        slots = {one[0].slot: n for n, one in enumerate(due.marks) if one is not None}
        found: dict[int, dict[int, complex]] = {}
        for slot, change in what.changes.items():
            step = self._steps.get(slot)
            if step is None or step.it.kind is not Line or len(step.uses) != len(change.step.uses):
                continue
            for was, now in zip(step.uses, change.step.uses, strict=True):
                if was is not now and was.kind is Point and now.kind is Point:
                    # a pole is no place of its own: it stands at 0
                    at = complex(spots[slots[now.slot]]) if now.slot in slots else 0j
                    lines = (n for n, line in enumerate(due.lines) if slot in line.of)
                    found |= {n: {slots.get(was.slot, 0): at} for n in lines}
        return found

    def _inked(self, row: int, plan: str, position: str) -> View | None:
        """Return a plan as a mutation draws it, by the ink of its own log; None if it cannot be drawn."""
        what = self.mutations[row]
        marks = [step.it for step in self.log.steps if step.it.view in self._plans]
        beside = executed(self.log, self.board.given, [what], marks)
        (board,) = as_drawn(self._made, self.board, beside, np.zeros(1, np.intp)).boards
        log, _ = changed_log(self.board.construction, self.board.given, what)
        project = replace(board.project, construction=log)
        try:
            with np.errstate(all="ignore"):
                return single_view(replace(board, project=project), plan, position, self.scatter)
        except (TmmError, KeyError, ValueError):
            return None  # what the mistake leaves of the plan cannot be inked


class Agreement(NamedTuple):
    """How pencil agrees with lines: the share of them that is drawn; mm explained, less what is missed."""

    covered: float
    worth: float


def agreement(flat: Flat, starts: Complexes, ends: Complexes) -> Agreement:
    """Return how the pencil of a sheet agrees with straight lines; of NaN, nowhere, nothing counts."""
    lines = [(a, b) for a, b in zip(starts, ends, strict=True) if np.isfinite(a + b)]
    some = [a + (b - a) * np.arange(0.0, 1.0, 1.0 / max(abs(b - a), 1.0)) for a, b in lines]
    if not some:
        return Agreement(0.0, -np.inf)
    ink = np.concatenate(some)
    near = flat.near(ink)
    return Agreement(float(near.mean()), flat.strokes(ink) - MISSED * float((1 - near).sum()))


def shapeless(view: View) -> bool:
    """Whether all points of a plan lie on one line, as at a dead centre: such a shape tells no mistake."""
    off = view.at - view.at.mean()
    parts = np.stack([off.real, off.imag])
    return float(np.linalg.svd(parts, compute_uv=False)[-1]) < SHAPELESS


Starts = Mapping[int, Mapping[int, Mapping[int, complex]]]
"""By row and line of a view: places (indices) that the line goes through elsewhere, mm."""


def moved(due: View, spots: Complexes, started: Starts = NOTHING) -> tuple[Complexes, Complexes]:
    """Return where the lines of a view are if its places are elsewhere, (rows, lines); NaN: nowhere."""
    starts = np.empty((len(spots), len(due.lines)), np.complex128)
    ends = starts.copy()
    for n, line in enumerate(due.lines):
        order = sorted(line.places, key=lambda k: line.share(due.places[k].at))
        first, last = order[0], order[-1]
        before, after = due.places[first].at - line.start, line.end - due.places[last].at
        one, other = spots[:, first].copy(), spots[:, last].copy()
        for row, lines in started.items():
            one[row] = lines.get(n, {}).get(first, one[row])
            other[row] = lines.get(n, {}).get(last, other[row])
        turned = np.ones(len(spots), np.complex128)
        if first != last:
            way = other - one
            size = abs(way)
            turned = np.where(size > SHORT, way / np.maximum(size, SHORT) / line.way, np.nan)
        starts[:, n], ends[:, n] = one - before * turned, other + after * turned
    return starts, ends


def single_view(work: Drawn, plan: str, position: str, drawn: Reading) -> View:
    """Return what a plan should show in one position, its pole at 0; ``drawn``: by a hand."""
    drawing = plan_drawing(work, plan, position)
    return view_of(Stood(work, drawing, [plan]), drawing, drawn)


def plan_drawing(work: Drawn, plan: str, position: str) -> Drawing:
    """Return a plan in one position, its pole at 0."""
    (chapter,) = (one for one in work.project.chapters if plan in Readings.of(one).pointed)
    place = work.names.index(position)
    return Readings.of(chapter).plan_at(work, plan, place, f"{plan}-{position}", "", ())
