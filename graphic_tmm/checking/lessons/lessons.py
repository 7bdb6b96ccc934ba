"""Lessons on the steps that readings or mistakes blame: sentence, reason, calculation, a small plan."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Arc, Length, Line, Point
from graphic_tmm.checking.cells import points
from graphic_tmm.checking.judging.own_errors import exact
from graphic_tmm.checking.judging.taken_marks import Reader, steps_of
from graphic_tmm.checking.lessons.steps import NamedStep, Numbers, Steps, step_of_figure
from graphic_tmm.checking.records import FINE, WRONG, Judged, Lesson, Likely, PlanPicture
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.language.symbols import spoken
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.readers.columns import Readings
from graphic_tmm.readers.narration import defined
from graphic_tmm.readers.sentences import calculation, reason, sentence

NOTHING = 1e-9
"""A vector shorter than so many mm has no direction."""


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
        ends = _ends(work, shown, place)
        if not ends:
            return None
        start, end = ends
        found = (
            () if not shown.due else (start, start + (end - start) * shown.found / abs(shown.due))
        )
        return picture._replace(due=ends, found=found)

    def _plan(self, work: Drawn, plan: str, place: int) -> PlanPicture | None:
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
                self._drawn[at] = PlanPicture(drawing, named=_named(work, drawing, place))
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


PICTURED = 8
"""So many lessons of a report have a picture. Chosen by eye: a page holds three."""


@dataclass
class _Blame:
    """What blames a step: wrong readings of a plan, findings by number, with the position that these tell.

    ``shows``: the plans and segments in which the findings show; ``segment``: of readings that name no step
    themselves.
    """

    plan: str
    rows: list[Judged] = field(default_factory=list)
    names: list[int] = field(default_factory=list)
    shows: list[tuple[str, str]] = field(default_factory=list)
    position: str = ""
    segment: str = ""


class Teacher:
    """Who tells the lessons of the drawings of one scene."""

    def __init__(self, made: DrawnScene) -> None:
        self.made = made
        self.language = made.scene.language
        self._steps: Steps | None = None
        self._plans = SmallPlans(made)

    def lessons(
        self, judged: Sequence[Judged], findings: Sequence[Likely], by: Reader
    ) -> tuple[Lesson, ...]:
        """Return a lesson on each step that wrong readings blame or a finding names, in turn."""
        wrong = [one for one in judged if one.verdict == WRONG]
        if not wrong and not any(one.step or one.segment for one in findings):
            return ()
        if self._steps is None:
            self._steps = Steps(self.made)
        blamed = self._blamed(self._steps, wrong, findings)
        if not blamed:
            return ()
        numbers = Numbers(self._steps, [one.taken for one in judged], by)
        told = [one for one in self._steps.in_turn if one in blamed]
        return tuple(
            self._lesson(one, blamed[one], numbers, judged, pictured=k < PICTURED)
            for k, one in enumerate(told)
        )

    def _blamed(
        self, steps: Steps, wrong: Sequence[Judged], findings: Sequence[Likely]
    ) -> Mapping[NamedStep, _Blame]:
        """Return what is blamed, and by what."""
        blamed: dict[NamedStep, _Blame] = {}
        for row in wrong:
            plan, segment = row.taken.plan, "" if row.step else row.taken.segment
            told = steps.labelled(plan, row.step) if row.step else step_of_figure(steps, row.taken)
            if told is not None:
                blamed.setdefault(told, _Blame(plan, segment=segment)).rows.append(row)
        for k, finding in enumerate(findings):
            told = steps.of(finding)
            if told is not None:
                plan = told.step.it.view
                blame = blamed.setdefault(told, _Blame(plan, position=finding.position))
                blame.names.append(k)
                blame.shows.append((finding.plan, finding.segment))
        return blamed

    def _lesson(
        self,
        told: NamedStep,
        blame: _Blame,
        numbers: Numbers,
        judged: Sequence[Judged],
        *,
        pictured: bool,
    ) -> Lesson:
        shown = max(blame.rows, key=_size) if blame.rows else self._nearest(told, judged, blame)
        shows = None if shown is not None else _off_most(judged, blame)
        seen = shown or shows
        names, row = told.board.names, told.board.row(told.step.it.view)
        wanted = seen.taken.position if seen is not None else blame.position
        place = names.index(wanted) if wanted in names else next(iter(row), 0)
        reading, at = numbers.reading(told, place)
        op = told.step.op
        there = bool(op.formula or op.proportion) and defined(reading, told.step.it, at)
        note = calculation(told.step, reading, at, self.language) if there else ""
        picture = self._plans.picture(told, shown, place) if pictured else None
        return Lesson(
            plan=blame.plan,
            step=told.label,
            letter=spoken(told.step.it, self.language),
            says=sentence(told.step, self.language, reading, at),
            why=reason(told.step, self.language, reading, at),
            calculation=note,
            position=names[place] if wanted in names or picture is not None else "",
            own=bool(note) and numbers.own(told, place),
            shown=shown,
            picture=picture,
            names=tuple(blame.names),
            segment=blame.segment,
            view=told.step.it.view,
            shows=shows,
            drawn=tuple(self._sentences(told, numbers, place)),
        )

    def _sentences(self, told: NamedStep, numbers: Numbers, place: int) -> Iterator[str]:
        """Yield the sentences of the steps that drew what a step measures, with their numbers."""
        assert self._steps is not None
        for one in self._steps.drawn_by(told):
            reading, at = numbers.reading(one, place)
            says = sentence(one.step, self.language, reading, at)
            yield f"{one.label.partition(' ')[0]}. {says}"

    def _nearest(self, told: NamedStep, judged: Sequence[Judged], blame: _Blame) -> Judged | None:
        """Return the reading of what a step leaves that is off the most, whatever its verdict; None if none.

        Where the finding tells a position, of that one.
        """
        assert self._steps is not None
        of = [
            one
            for one in judged
            if (step := self._steps.readable.get((one.taken.plan, one.taken.segment))) is not None
            and step.it == told.step.it
            and blame.position in ("", one.taken.position)
        ]
        return max(of, key=_size, default=None)


def _off_most(judged: Sequence[Judged], blame: _Blame) -> Judged | None:
    """Return the reading that is off the most of those in which a finding shows; None if it tells none."""
    of = [
        one
        for one in judged
        if (one.taken.plan, one.taken.segment) in blame.shows
        and blame.position in ("", one.taken.position)
        and one.verdict != FINE
    ]
    return max(of, key=_size, default=None)


def _size(one: Judged) -> float:
    """Return how far a reading is off: by the step's own error where it is known."""
    off = one.deviation if one.own is None else one.own
    return abs(off) if math.isfinite(off) else 0.0
