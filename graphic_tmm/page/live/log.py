"""The log of a mechanism as its page runs it: straight, at every angle, with whatever is given.

Values stand in an array M by the slots of their marks: what is given, then what each step leaves. Steps are
three rows: ``still``, those that are alike at all angles; ``turn``, those that are not; ``sheet``, those that
hang on what was drawn across the positions of the sheet: known only as long as all is given as in the scene.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from graphic_tmm.board.execute import needed
from graphic_tmm.board.record import Mark, Step, again
from graphic_tmm.board.script import Script
from graphic_tmm.board.source import NotCompiled
from graphic_tmm.board.values import KINDS, Angle, Curve, arrays, places
from graphic_tmm.board.values import given as as_value
from graphic_tmm.page.dense import Dense
from graphic_tmm.page.strands import Moving, MovingFigures

STRAIGHT = 1e-13
"""A row of givens that is off a straight line by no more, as a share of its largest, is told by two numbers;
those of the scenes of the package are off by 1.5e-16."""


def turned_figure(found: Dense) -> Moving | None:
    """Return the figure of the mechanism itself; None where nothing is turned."""
    chapters = found.drawn.project.chapters
    figures = (one for c in chapters for one in MovingFigures.of(c).figures(found.drawn))
    return next((one for one in figures if one.crank), None)


class LiveLog:
    """The log of a mechanism that turns, in rows of steps that the page's program can run."""

    def __init__(
        self,
        found: Dense,
        script: Script,
        wanted: Collection[int] | None = None,
        over: Collection[int] = (),
    ) -> None:
        """``wanted``: the marks that are looked at, by their slots; None for all.

        ``over``: those of them that are at all angles at once.
        """
        self.found, self.script, self.over = found, script, frozenset(over)
        steps = found.log.steps
        if wanted is not None:
            steps = needed(found.log, (step.it for step in steps if step.it.slot in wanted))
            some = {mark for step in steps for mark in step.uses}
            found = replace(found, given={m: v for m, v in found.given.items() if m in some})
        following = found.log._replace(steps=steps)
        recorded = set(found.sheet.construction.given)
        self.own = {mark: value for mark, value in found.given.items() if mark in recorded}
        live = self._written(again(following, self.own).steps, set(self.own))
        if held := self._held(live):
            self.own |= held
            live = self._written(again(following, self.own).steps, set(self.own))
        turning = {mark for mark, value in self.own.items() if _many(value, mark)}
        self.still: list[Step] = []
        self.turn: list[Step] = []
        for step in live:
            if turning.isdisjoint(step.uses):
                self.still.append(step)
            else:
                turning.add(step.it)
                self.turn.append(step)
        left = {step.it for step in live}
        rest = [step for step in steps if step.it not in left]
        self.kept = {
            mark: value
            for mark, value in found.given.items()
            if mark not in recorded and not isinstance(value, Curve)
        }
        self.sheet = self._written(rest, {*self.own, *self.kept, *left})

    def _held(self, live: Sequence[Step]) -> dict[Mark, Any]:
        """Return what the crank's angle is counted from, where no step of a page finds it, as on the sheet.

        An extreme that is sought by trial is none of its operations; plans at an angle do not hang on where
        positions are counted from.
        """
        there = {*self.own, *(step.it for step in live)}
        figure = turned_figure(self.found)
        crank = () if figure is None or figure.crank is None else figure.crank
        return {
            step.it: self.found.drawn.reading[step.it]
            for step in needed(self.found.log, crank)
            if step.it.kind is Angle and step.it not in there and there.issuperset(step.uses)
        }

    def _written(self, steps: Iterable[Step], there: set[Mark]) -> list[Step]:
        """Return the steps that can be written down and follow from what is there, or from one another."""
        found = []
        for step in steps:
            if not there.issuperset(step.uses):
                continue
            try:
                self.script.add(step.op.run)
            except NotCompiled:
                continue
            there.add(step.it)
            found.append(step)
        return found

    @property
    def logs(self) -> dict[str, Sequence[Step]]:
        """The rows of steps by their names; ``way``: the first of those that vary, needed at all angles."""
        over = (step.it for step in self.turn if step.it.slot in self.over)
        first = {step.it for step in needed(self.found.log, over)}
        way = [step for step in self.turn if step.it in first]
        turn = [step for step in self.turn if step.it not in first]
        return {"still": self.still, "way": way, "turn": turn, "sheet": self.sheet}

    @cached_property
    def used(self) -> frozenset[Mark]:
        """What is given and used by a step that follows."""
        return (
            frozenset(m for step in (*self.still, *self.turn) for m in step.uses) & self.own.keys()
        )

    def data(self) -> dict[str, Any]:
        """Return what is given, by slots; what the sheet alone knows; how many slots there are.

        ``more``: the steps of positions that are between two angles, exactly.
        """
        return {
            "size": self.found.log.size,
            "more": [float(x) for x in self.found.frames[self.found.whole :]],
            "given": {str(mark.slot): self._numbers(mark, v) for mark, v in self.own.items()},
            "kept": {str(mark.slot): self._numbers(mark, v) for mark, v in self.kept.items()},
        }

    def _numbers(self, mark: Mark, value: object) -> dict[str, Any]:
        """Return the kind and the numbers of a mark: one after the other for each angle, or a straight row."""
        held = as_value(value, mark.kind)
        kind = KINDS[mark.kind].lower()
        flat: list[Any] = []
        for part in arrays(held):
            flat += [part[0].real, part[0].imag] if np.iscomplexobj(part) else [part[0]]
        if len(flat) == 1 and flat[0].size > 1:
            frames, row = self.found.frames, flat[0]
            by = (row[1] - row[0]) / (frames[1] - frames[0])
            line = row[0] + by * (frames - frames[0])
            if np.abs(row - line).max() <= STRAIGHT * np.abs(row).max():
                return {"k": kind, "row": [float(row[0]), float(by)]}
        rows = np.stack(np.broadcast_arrays(*flat), axis=1)
        return {"k": kind, "v": [x if math.isfinite(x) else None for x in rows.ravel().tolist()]}


def _many(value: object, mark: Mark) -> bool:
    return places(as_value(value, mark.kind)) > 1
