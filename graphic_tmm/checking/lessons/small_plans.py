"""Small plans: what a reading is of, or what a mistake draws, beside what is due."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from typing import Any

import numpy as np

from graphic_tmm.board.operations.instruments import lay_off
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Arc, Length, Line, Point
from graphic_tmm.checking.cells import points
from graphic_tmm.checking.judging.own_errors import exact
from graphic_tmm.checking.judging.taken_marks import steps_of
from graphic_tmm.checking.lessons.steps import NamedStep
from graphic_tmm.checking.mutations.mistaken_scene import MistakenScene
from graphic_tmm.checking.records import Judged, PlanPicture
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.paper.drawing import Bezier, Drawing, Ink
from graphic_tmm.readers.columns import Readings

NOTHING = 1e-9
"""A vector shorter than so many mm has no direction."""
APART = 1e-3
"""Ink that is moved by less than so many mm is the same."""
FAR = 1e4
"""Ink farther off, mm, is not drawn: a line that runs to where it hardly meets another."""


class SmallPlans:
    """The plans of a scene, each drawn once: what the readings of many drawings are shown upon."""

    def __init__(self, made: DrawnScene) -> None:
        self.made = made
        self._drawn: dict[tuple[str, int], PlanPicture | None] = {}

    def picture(self, told: NamedStep, shown: Judged | None, place: int) -> PlanPicture | None:
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
        ends = _ends(work, _read_step(work, shown), place)
        if not ends:
            return None
        start, end = ends
        found = (
            () if not shown.due else (start, start + (end - start) * shown.found / abs(shown.due))
        )
        return picture._replace(due=ends, found=found)

    def mistaken(
        self, told: NamedStep, seen: Judged | None, wrongly: MistakenScene, place: int
    ) -> PlanPicture | None:
        """Return what a mistake draws beside what is due, in a position (index); None where no plan shows it.

        The plan of its step, else that of the reading in which it shows.
        """
        work, board = self.made.mechanism, wrongly.drawn.mechanism
        if work is None or board is None:
            return None
        views = (told.step.it.view, *(() if seen is None else (seen.taken.plan,)))
        for view in dict.fromkeys(views):
            due, drawn = self._plan(work, view, place), _drawing(board, view, place)
            if due is None or drawn is None:
                continue
            step = told.step if view == told.step.it.view else _read_step(work, seen)
            ends = _ends_of(work, step, place) if step is not None else ()
            amiss = wrongly.steps.get(step.it.slot, step) if step is not None else None
            found = _ends_of(board, amiss, place) if amiss is not None else ()
            if step is not None and not ends and not _inked(due, step.it):
                ends, found = (_laid_on(one, step.it, place) for one in (work, board))
            moved = tuple(_moved(drawn, due.drawing))
            if moved or (found and not _same_ends(ends, found)):
                of = (told.step.it.slot,)
                return due._replace(due=ends, found=found, of=of, mistaken=moved)
        return None

    def _plan(self, work: Drawn, plan: str, place: int) -> PlanPicture | None:
        """Return the exact plan in a position; None where it is none, or not drawn there."""
        at = (plan, place)
        if at not in self._drawn:
            drawing = _drawing(work, plan, place)
            self._drawn[at] = drawing and PlanPicture(drawing, named=_named(work, drawing, place))
        return self._drawn[at]


def _drawing(work: Drawn, plan: str, place: int) -> Drawing | None:
    """Return a plan or another figure in a position (index); None where it is none, or not drawn there."""
    name = f"lesson-{plan.replace(' ', '-')}-{place}"
    chapters = [Readings.of(one) for one in work.project.chapters]
    if pointed := [one for one in chapters if plan in one.pointed]:
        here = place in work.row(plan) and place not in work.undrawn
        drawn = here and work.of(plan) is not None
        return pointed[0].plan_at(work, plan, place, name, "", ()) if drawn else None
    figures = (one.figure_at(work, plan, place, name) for one in chapters)
    return next((one for one in figures if one is not None), None)


def _moved(drawn: Drawing, due: Drawing) -> Iterator[Ink]:
    """Yield the ink of a plan that does not stand in the due one, too."""
    there = {_places(one) for one in due.strokes}
    for one in drawn.strokes:
        places = _places(one)
        if places not in there and all(abs(z) * APART < FAR for z in places):
            yield one


def _places(one: Ink) -> tuple[complex, ...]:
    """Return where ink stands, in thousandths of a mm; a line by its ends, whichever was drawn first."""
    spots = one.controls if isinstance(one, Bezier) else [complex(x, y) for x, y, _ in one.path]
    whole = [complex(round(z.real / APART), round(z.imag / APART)) for z in spots]
    return tuple(sorted(whole, key=lambda z: (z.real, z.imag)))


def _same_ends(due: tuple[complex, ...], found: tuple[complex, ...]) -> bool:
    return len(due) == len(found) and all(
        abs(z - w) < APART for z, w in zip(due, found, strict=True)
    )


def _read_step(work: Drawn, seen: Judged | None) -> Step | None:
    """Return the step of which a reading is; None where it is of none."""
    return None if seen is None else steps_of(work).get((seen.taken.plan, seen.taken.segment))


def _ends_of(work: Drawn, step: Step, place: int) -> tuple[complex, ...]:
    """Return the point that a step leaves in a position (index), or the ends of its length, mm."""
    return _spot(work, step.it, place) or _ends(work, step, place)


def _inked(picture: PlanPicture, mark: Mark) -> bool:
    return any(mark.slot in one.of for one in picture.drawing.strokes if not one.part)


def _laid_on(work: Drawn, on: Mark, place: int) -> tuple[complex, ...]:
    """Return the ends of what is laid off on a line of which nothing else is in ink, mm; none if nothing is."""
    lines = {step.it: step for step in work.construction.steps}
    for step in work.construction.steps:
        if step.op is lay_off and on in step.uses and on in lines:
            start = next((mark for mark in lines[on].uses if mark.kind is Point), None)
            ends = (
                () if start is None else (*_spot(work, start, place), *_spot(work, step.it, place))
            )
            return ends if len(ends) == 2 else ()
    return ()


def _named(work: Drawn, drawing: Drawing, place: int) -> tuple[complex, ...]:
    """Return the point that each label names, of a side the middle; of one that names none, where it stands."""
    log = work.construction
    marks = {mark.slot: mark for mark in (*log.given, *(step.it for step in log.steps))}
    found = []
    for label in drawing.labels:
        named = (marks[slot] for slot in label.of if slot in marks)
        spots = [spot for mark in named for spot in _spot(work, mark, place)]
        found.append(sum(spots) / len(spots) if spots else label.at)
    return tuple(found)


def _spot(work: Drawn, mark: Mark, place: int) -> tuple[complex, ...]:
    """Return where a point is due in a position (index), mm; none where it is no point, or not drawn."""
    if mark.kind is not Point:
        return ()
    spot = complex(_at(exact(work, mark), place))
    return (spot,) if cmath.isfinite(spot) else ()


def _at(row: Any, place: int) -> Any:
    flat = np.ravel(row)
    return flat[place if flat.size > 1 else 0]


def _ends(work: Drawn, step: Step | None, place: int) -> tuple[complex, ...]:
    """Return where the segment of a length begins and ends as it is drawn, mm; none where it is no segment."""
    if step is None or step.it.kind is not Length:
        return ()
    marks = _measured(step) or _laid(work, step.it)
    if not marks:
        return ()
    start, end = (complex(_at(exact(work, mark), place)) for mark in marks)
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
