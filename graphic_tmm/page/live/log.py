"""The log of a mechanism as its page runs it: straight, at every angle, with whatever is given.

Values stand in an array M by the slots of their marks: what is given, then what each step leaves. Steps are
rows: ``still``, those that are alike at all angles; ``turn``, those that are not. A second table, ``across``,
runs in all positions of the sheet at once: what is drawn across them, and what hangs on that. Of the latter
``after`` runs at every angle, too. ``sheet`` hangs on what cannot be written down: it is known only as long as
all is given as in the scene.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from graphic_tmm.board.execute import needed
from graphic_tmm.board.operations.graphs import erect
from graphic_tmm.board.record import Construction, Mark, Step, again
from graphic_tmm.board.script_rows import RowScript
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
        script: RowScript,
        wanted: Collection[int] | None = None,
        over: Collection[int] = (),
        charted: Collection[int] = (),
    ) -> None:
        """``wanted``: the marks that are looked at, by their slots; None for all.

        ``over``: those of them that are at all angles at once; ``charted``: in the positions of the sheet.
        """
        self.found, self.script, self.over = found, script, frozenset(over)
        whole = found.sheet.construction
        if wanted is None:
            wanted = charted = range(found.log.size)
        # what is looked at hangs across positions on more than the log has at every angle
        deep = _behind(whole, {*wanted, *charted})
        uses = {mark for step in deep for mark in step.uses}
        steps = _behind(found.log, {*wanted, *charted, *(mark.slot for mark in uses)})
        some = uses | {mark for step in steps for mark in step.uses}
        found = replace(found, given={m: v for m, v in found.given.items() if m in some})
        following = found.log._replace(steps=steps)
        drawn = {step.it for step in whole.steps}
        self.own = {mark: value for mark, value in found.given.items() if mark not in drawn}
        live = self._written(again(following, self.own).steps, set(self.own), rows=False)
        if held := self._held(live):
            self.own |= held
            live = self._written(again(following, self.own).steps, set(self.own), rows=False)
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
        used = {mark for step in (*deep, *live) for mark in step.uses}
        self.rowed = {
            mark: value
            for mark, value in found.sheet.given.items()
            if mark in used and mark.kind is not Curve
            if mark not in self.own or _many(value, mark) or mark in turning
        }
        at_angles = {step.it for step in _behind(found.log, {*wanted})}
        rest = [step for step in steps if step.it in at_angles - left]
        there = {*self.own, *self.rowed, *left}
        able = self._written((s for s in deep if s.it not in there), set(there), script=RowScript())
        known = {s.it for s in able if s.it in found.given and not _many(found.given[s.it], s.it)}
        self.after = self._written(rest, {*self.own, *known, *left})
        self.known = sorted(known & {mark for step in self.after for mark in step.uses})
        asked = {mark.slot for mark in self.known} | {*charted}
        across = {step.it for step in _behind(whole, asked)}
        self.across = self._written((s for s in able if s.it in across), there)
        self.carried = [mark.slot for mark in self.known]
        left |= {step.it for step in self.after}
        rest = [step for step in rest if step.it not in left]
        used = {mark for step in rest for mark in step.uses}
        self.kept = {
            mark: value
            for mark, value in found.given.items()
            if mark in used and mark in drawn and mark.kind is not Curve
        }
        self.sheet = self._written(rest, {*self.own, *self.kept, *left}, rows=False)

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

    def _written(
        self,
        steps: Iterable[Step],
        there: set[Mark],
        *,
        script: RowScript | None = None,
        rows: bool = True,
    ) -> list[Step]:
        """Return the steps that can be written down and follow from what is there, or from one another."""
        found, by = [], script or self.script
        for step in steps:
            if there.issuperset(step.uses) and by.written(step, rows=rows):
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

    @property
    def functions(self) -> dict[str, str]:
        """All rows of steps written down, by their names; of the second table first what angles need."""
        first = {step.it for step in needed(self.found.sheet.construction, self.known)}
        tables = {
            "across": [step for step in self.across if step.it in first],
            "charts": [step for step in self.across if step.it not in first],
            "after": self.after,
        }
        erected = {"erect": self.script.add_rows(erect.run)} if self.across else {}
        return (
            {name: self.script.log(steps) for name, steps in self.logs.items()}
            | {name: self.script.across(steps) for name, steps in tables.items() if steps}
            | erected
        )

    @property
    def live(self) -> tuple[Step, ...]:
        """The steps that follow at every angle, whatever is given."""
        return (*self.still, *self.turn, *self.after)

    @cached_property
    def used(self) -> frozenset[Mark]:
        """What is given and used by a step that follows."""
        steps = (*self.live, *self.across)
        return frozenset(m for step in steps for m in step.uses) & self.own.keys()

    def data(self) -> dict[str, Any]:
        """Return what is given, by slots; what the sheet alone knows; how many slots there are.

        ``more``: the steps of positions that are between two angles, exactly. ``positions``:
        how many the sheet has, ``rowed``: what is given in these; ``carried``: marks that all angles have from
        there.
        """
        return {
            "size": self.found.log.size,
            "more": [float(x) for x in self.found.frames[self.found.whole :]],
            "given": {str(mark.slot): self._numbers(mark, v) for mark, v in self.own.items()},
            "kept": {str(mark.slot): self._numbers(mark, v) for mark, v in self.kept.items()},
            "positions": len(self.found.at),
            "rowed": {str(mark.slot): self._numbers(mark, v) for mark, v in self.rowed.items()},
            "carried": self.carried,
        }

    def _numbers(self, mark: Mark, value: object) -> dict[str, Any]:
        """Return the kind and the numbers of a mark: one after the other for each angle, or a straight row."""
        held = as_value(value, mark.kind)
        kind = KINDS[mark.kind].lower()
        flat: list[Any] = []
        for part in arrays(held):
            flat += [part[0].real, part[0].imag] if np.iscomplexobj(part) else [part[0]]
        frames = self.found.frames
        if len(flat) == 1 and flat[0].size == frames.size > 1:
            row = flat[0]
            by = (row[1] - row[0]) / (frames[1] - frames[0])
            line = row[0] + by * (frames - frames[0])
            if np.abs(row - line).max() <= STRAIGHT * np.abs(row).max():
                return {"k": kind, "row": [float(row[0]), float(by)]}
        rows = np.stack(np.broadcast_arrays(*flat), axis=1)
        return {"k": kind, "v": [x if math.isfinite(x) else None for x in rows.ravel().tolist()]}


def _behind(log: Construction, slots: set[int]) -> tuple[Step, ...]:
    """Return the steps that some marks of a log need, by their slots."""
    return needed(log, [step.it for step in log.steps if step.it.slot in slots])


def _many(value: object, mark: Mark) -> bool:
    return places(as_value(value, mark.kind)) > 1
