"""Lessons on the steps that readings or mistakes blame: the log's own sentence, reason and calculation."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from graphic_tmm.checking.judging.reader import Reader
from graphic_tmm.checking.lessons.by_figure import step_of_figure
from graphic_tmm.checking.lessons.small_plans import SmallPlans
from graphic_tmm.checking.lessons.steps import Numbers, Steps, Told
from graphic_tmm.checking.records import FINE, WRONG, Judged, Lesson, Likely
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.language.symbols import spoken
from graphic_tmm.readers.narration import defined
from graphic_tmm.readers.sentences import calculation, reason, sentence

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
    ) -> Mapping[Told, _Blame]:
        """Return what is blamed, and by what."""
        blamed: dict[Told, _Blame] = {}
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
        told: Told,
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

    def _sentences(self, told: Told, numbers: Numbers, place: int) -> Iterator[str]:
        """Yield the sentences of the steps that drew what a step measures, with their numbers."""
        assert self._steps is not None
        for one in self._steps.drawn_by(told):
            reading, at = numbers.reading(one, place)
            says = sentence(one.step, self.language, reading, at)
            yield f"{one.label.partition(' ')[0]}. {says}"

    def _nearest(self, told: Told, judged: Sequence[Judged], blame: _Blame) -> Judged | None:
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
