"""Lessons on the steps that readings or mistakes blame: sentence, reason, calculation, a small plan."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from graphic_tmm.checking.judging.taken_marks import Reader
from graphic_tmm.checking.lessons.small_plans import SmallPlans
from graphic_tmm.checking.lessons.steps import NamedStep, Numbers, Steps, step_of_figure
from graphic_tmm.checking.mutations.mistaken_scene import MistakenScene
from graphic_tmm.checking.records import FINE, MISTAKE, WRONG, Judged, Lesson, Likely
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.language.symbols import spoken
from graphic_tmm.readers.narration import defined
from graphic_tmm.readers.protocol import title_of
from graphic_tmm.readers.sentences import calculation, reason, sentence

CLEAR = 0.9
"""A reading that is off by this share of the most is as good to show: better where what is due is no zero."""
PICTURED = 8
"""So many lessons of a report have a picture. Chosen by eye: a page holds three."""


@dataclass
class _Blame:
    """What blames a step: wrong readings of a plan, findings by number, with the position that these tell.

    ``shows``: the plans and segments in which the findings show, ``lines``: what they explain; ``segment``: of
    readings that name no step themselves.
    """

    plan: str
    rows: list[Judged] = field(default_factory=list)
    names: list[int] = field(default_factory=list)
    shows: list[tuple[str, str]] = field(default_factory=list)
    lines: set[int] = field(default_factory=set)
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
        self,
        judged: Sequence[Judged],
        findings: Sequence[Likely],
        by: Reader,
        wrongly: Sequence[MistakenScene | None] = (),
    ) -> tuple[Lesson, ...]:
        """Return a lesson on each step that wrong readings blame or a finding names, in turn.

        ``wrongly``: for each finding the scene as it is drawn with it, None where it is none of the drawing.
        """
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
        lessons = [self._lesson(one, blamed[one], numbers, judged) for one in told]
        for k, one in enumerate(told[:PICTURED]):
            lessons[k] = self._pictured(one, blamed[one], lessons[k], wrongly)
        return tuple(lessons)

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
                if finding.kind == MISTAKE:
                    blame.lines |= set(finding.lines) - {0}
        return blamed

    def _lesson(
        self,
        told: NamedStep,
        blame: _Blame,
        numbers: Numbers,
        judged: Sequence[Judged],
    ) -> Lesson:
        shown, shows = self._seen(told, blame, judged)
        place, there = _place(told, blame, shows or shown)
        reading, at = numbers.reading(told, place)
        op = told.step.op
        known = bool(op.formula or op.proportion) and defined(reading, told.step.it, at)
        note = calculation(told.step, reading, at, self.language) if known else ""
        return Lesson(
            plan=blame.plan,
            step=told.label,
            letter=spoken(told.step.it, self.language),
            says=sentence(told.step, self.language, reading, at),
            why=reason(told.step, self.language, reading, at),
            calculation=note,
            position=told.board.names[place] if there else "",
            own=bool(note) and numbers.own(told, place),
            shown=shown,
            names=tuple(blame.names),
            segment=blame.segment,
            view=told.step.it.view,
            title=title_of(told.board.project, told.step.it.view, self.language),
            shows=shows,
            drawn=tuple(self._sentences(told, numbers, place)),
        )

    def _pictured(
        self,
        told: NamedStep,
        blame: _Blame,
        lesson: Lesson,
        wrongly: Sequence[MistakenScene | None],
    ) -> Lesson:
        """Return a lesson with its picture: what its mistake draws, else what was read, beside what is due."""
        seen = lesson.shows or lesson.shown
        place, _ = _place(told, blame, seen)
        scenes = (wrongly[k] for k in lesson.names if k < len(wrongly))
        scene = next((one for one in scenes if one is not None), None)
        picture = scene and self._plans.mistaken(told, seen, scene, place)
        picture = picture or self._plans.picture(told, lesson.shown, place)
        return (
            lesson
            if picture is None
            else lesson._replace(picture=picture, position=told.board.names[place])
        )

    def _seen(
        self, told: NamedStep, blame: _Blame, judged: Sequence[Judged]
    ) -> tuple[Judged | None, Judged | None]:
        """Return the reading of what a step leaves, and of a mistake made in it the one in which it shows."""
        if blame.rows:
            return _clearest(blame.rows), None
        shows = _off_most(judged, blame)
        at = blame.position if shows is None else shows.taken.position
        shown = self._nearest(told, judged, at)
        if shows is None or (shown is not None and shown.verdict != FINE):
            return shown, None
        return shown, shows

    def _sentences(self, told: NamedStep, numbers: Numbers, place: int) -> Iterator[str]:
        """Yield the sentences of the steps that drew what a step measures, with their numbers."""
        assert self._steps is not None
        for one in self._steps.drawn_by(told):
            reading, at = numbers.reading(one, place)
            says = sentence(one.step, self.language, reading, at)
            yield f"{one.label.partition(' ')[0]}. {says}"

    def _nearest(self, told: NamedStep, judged: Sequence[Judged], position: str) -> Judged | None:
        """Return the reading of what a step leaves that is off the most, whatever its verdict; None if none.

        ``position``: in which; "" in any.
        """
        assert self._steps is not None
        of = [
            one
            for one in judged
            if (step := self._steps.readable.get((one.taken.plan, one.taken.segment))) is not None
            and step.it == told.step.it
            and position in ("", one.taken.position)
        ]
        return max(of, key=_size, default=None)


def _place(told: NamedStep, blame: _Blame, seen: Judged | None) -> tuple[int, bool]:
    """Return the position (index) in which a lesson is told, and whether a reading or a finding tells it."""
    names, row = told.board.names, told.board.row(told.step.it.view)
    wanted = seen.taken.position if seen is not None else blame.position
    return (names.index(wanted), True) if wanted in names else (next(iter(row), 0), False)


def _off_most(judged: Sequence[Judged], blame: _Blame) -> Judged | None:
    """Return the reading that is off the most of those in which a finding shows; None if it tells none.

    Of its own segment; where that is fine, of what it explains.
    """
    off = [
        one for one in judged if one.verdict != FINE and blame.position in ("", one.taken.position)
    ]
    its = [one for one in off if (one.taken.plan, one.taken.segment) in blame.shows]
    return max(
        its or [one for one in off if one.taken.line in blame.lines], key=_size, default=None
    )


def _clearest(rows: Sequence[Judged]) -> Judged:
    """Return the reading that shows best what is wrong: of those that are off the most the largest due."""
    most = CLEAR * max(map(_size, rows))
    return max((one for one in rows if _size(one) >= most), key=lambda one: abs(one.due))


def _size(one: Judged) -> float:
    """Return how far a reading is off: by the step's own error where it is known."""
    off = one.deviation if one.own is None else one.own
    return abs(off) if math.isfinite(off) else 0.0
