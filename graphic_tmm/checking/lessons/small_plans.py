"""Small plans: the exact plan of one position, with what was found of a step and what is due."""

from __future__ import annotations

import cmath

import numpy as np

from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Arc, Length, Line, Point
from graphic_tmm.checking.cells import points
from graphic_tmm.checking.judging.own_errors import exact
from graphic_tmm.checking.judging.taken_marks import steps_of
from graphic_tmm.checking.lessons.steps import Told
from graphic_tmm.checking.records import Judged, Picture
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.readers.columns import Readings

NOTHING = 1e-9
"""A vector shorter than so many mm has no direction."""


class SmallPlans:
    """The plans of a scene, each drawn once: what the readings of many drawings are shown upon."""

    def __init__(self, made: DrawnScene) -> None:
        self.made = made
        self._drawn: dict[tuple[str, int], Picture | None] = {}

    def picture(self, told: Told, shown: Judged | None, place: int) -> Picture | None:
        """Return the plan of a reading in a position (index); None where its plan has no picture.

        A point stands where it was read; of a length the due segment is as long as was found. Without a
        reading what the step draws is shown.
        """
        work = self.made.mechanism
        plan = told.step.it.view if shown is None else shown.taken.plan
        picture = None if work is None else self._plan(work, plan, place)
        if work is None or picture is None:
            return None
        picture = picture._replace(of=(told.step.it.slot,))
        if shown is None:
            ink = {slot for one in picture.drawing.strokes if not one.part for slot in one.of}
            due = _spot(work, told.step.it, place)
            return picture._replace(due=due) if due or told.step.it.slot in ink else None
        if shown.taken.pointed:
            goal = points(self.made).get(shown.taken.key)
            due = () if goal is None else (goal,)
            return picture._replace(due=due, found=(shown.taken.spot,))
        ends = _ends(work, shown, place)
        if not ends:
            return None
        start, end = ends
        found = (
            () if not shown.due else (start, start + (end - start) * shown.found / abs(shown.due))
        )
        return picture._replace(due=ends, found=found)

    def _plan(self, work: Drawn, plan: str, place: int) -> Picture | None:
        """Return the exact plan in a position; None where it is none, or not drawn there."""
        at = (plan, place)
        if at not in self._drawn:
            chapters = [one for one in work.project.chapters if plan in Readings.of(one).pointed]
            here = place in work.row(plan) and place not in work.undrawn
            if not chapters or not here or work.of(plan) is None:
                self._drawn[at] = None
            else:
                drawing = Readings.of(chapters[0]).plan_at(
                    work, plan, place, f"lesson-{plan}-{place}", "", ()
                )
                self._drawn[at] = Picture(drawing, named=_named(work, drawing, place))
        return self._drawn[at]


def _named(work: Drawn, drawing: Drawing, place: int) -> tuple[complex, ...]:
    """Return the point that each label names; of one that names none, where it stands."""
    log = work.construction
    marks = {mark.slot: mark for mark in (*log.given, *(step.it for step in log.steps))}
    found = []
    for label in drawing.labels:
        mark = next((marks[slot] for slot in label.of if slot in marks), None)
        spot = () if mark is None else _spot(work, mark, place)
        found.append(spot[0] if spot else label.at)
    return tuple(found)


def _spot(work: Drawn, mark: Mark, place: int) -> tuple[complex, ...]:
    """Return where a point is due in a position (index), mm; none where it is no point, or not drawn."""
    if mark.kind is not Point:
        return ()
    row = np.ravel(exact(work, mark))
    spot = complex(row[place if row.size > 1 else 0])
    return (spot,) if cmath.isfinite(spot) else ()


def _ends(work: Drawn, shown: Judged, place: int) -> tuple[complex, ...]:
    """Return where the segment of a length begins and ends as it is due, mm; none where it is no segment."""
    step = steps_of(work).get((shown.taken.plan, shown.taken.segment))
    if step is None or step.it.kind is not Length:
        return ()
    marks = _measured(step) or _laid(work, step.it)
    if not marks:
        return ()
    start, end = (complex(np.ravel(exact(work, mark))[place]) for mark in marks)
    there = cmath.isfinite(start) and cmath.isfinite(end) and abs(end - start) > NOTHING
    return (start, end) if there else ()


def _measured(step: Step) -> tuple[Mark, ...]:
    """Return the two points between which a length is measured."""
    found = tuple(mark for mark in step.uses if mark.kind is Point)
    return found if step.op.reads and len(found) == 2 else ()


def _laid(work: Drawn, length: Mark) -> tuple[Mark, ...]:
    """Return the points between which a length is laid off on a line, or stands as the opening of a compass."""
    steps = {step.it: step for step in work.construction.steps}
    for step in work.construction.steps:
        if step.it.kind is Point and step.it.view == length.view:
            for mark in step.uses:
                by = steps.get(mark)
                laid = length in step.uses and mark.kind is Line
                struck = by is not None and mark.kind is Arc and length in by.uses
                if by is not None and (laid or struck) and by.uses[0].kind is Point:
                    return by.uses[0], step.it
    return ()
