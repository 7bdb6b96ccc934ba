"""A board as drawn: its log, what was given, its numbers by a hand, its scale factors, what went wrong."""

from __future__ import annotations

from collections.abc import Callable, Container, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

import numpy as np

from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.execute import Reading, execute, needed
from graphic_tmm.board.findings import Finding, examine
from graphic_tmm.board.hand import HANDS, Hand
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.scales import Scale
from graphic_tmm.board.values import Angle, Length, Reals
from graphic_tmm.language.numbers import percent_decimals
from graphic_tmm.project import Project
from graphic_tmm.scene.chapter import MECHANISM, Answer
from graphic_tmm.scene.records import Scene

if TYPE_CHECKING:
    pass

Results = Mapping[str, tuple[Reals, str]]
"""Results by name: figures, (trial,), NaN where there is none, and their unit."""
MEASURED: Mapping[Any, str] = {Angle: "°", Length: "mm"}
"""The units of what is measured on the sheet."""


class Numbers(NamedTuple):
    """What an execution gave: ``whole`` at all positions, ``own`` of the views that have rows of their own.

    ``drawn``: all that was executed, at all positions, what is lost among it.
    """

    whole: Reading
    own: Mapping[str, Reading]
    drawn: Reading

    def trial(self, k: int) -> Numbers:
        """Return the numbers of one trial."""
        own = {view: one.trial(k) for view, one in self.own.items()}
        return Numbers(self.whole.trial(k), own, self.drawn.trial(k))


@dataclass(frozen=True)
class Drawn:
    """A board as drawn: the mechanism's, or that of a part which needs none.

    ``advice``: sentences to the author on sizes that the scene fixes, computed on first use.
    """

    project: Project
    given: Mapping[Mark, object]
    scales: Mapping[str, Scale]
    numbers: Numbers
    hand: Hand
    doubts: Doubts
    undrawn: tuple[int, ...]
    sizes: Mapping[str, float]
    reach: Mapping[str, Any]
    advice: Callable[[], Iterable[str]] = tuple

    @property
    def board(self) -> str:
        """The board: that of the mechanism, or of a part."""
        return self.project.board

    @property
    def scene(self) -> Scene:
        """The scene that was drawn."""
        return self.project.scene

    @property
    def construction(self) -> Construction:
        """The log."""
        return self.project.construction

    @property
    def recorded(self) -> Mapping[str, Any]:
        """What the chapters recorded."""
        return self.project.recorded

    @property
    def names(self) -> tuple[str, ...]:
        """The numbers of the positions."""
        return self.project.names

    @property
    def reading(self) -> Reading:
        """The numbers at all positions."""
        return self.numbers.whole

    @property
    def all(self) -> tuple[int, ...]:
        """All positions (indices)."""
        return tuple(range(len(self.names)))

    @cached_property
    def main(self) -> int:
        """The main position (index): drawn heavy, and the first to be described, played and practised.

        The scene's own, else the one that shows the board best; if neither is drawn, the first in which a plan
        is drawn by itself, or the second.
        """
        own = [place for places in self.project.rows.values() for place in places]
        wanted = [*own, *self.all[1:2], *self.all]
        if self.project.best is not None:
            wanted = [self.project.best(), *wanted]
            if self.scene.main in self.names:
                wanted = [self.names.index(self.scene.main), *wanted]
        return next((k for k in wanted if k not in self.undrawn), wanted[0])

    @property
    def sheet_lengths(self) -> dict[Mark, object]:
        """What is given on this sheet instead of what the log was recorded with: bases, pole distances, mm."""
        usual = self.project.given
        return {m: v for m, v in self.given.items() if m in usual and v is not usual[m]}

    @property
    def percent_decimals(self) -> int:
        """Decimals of a difference in %: as many as the ruler can show."""
        return percent_decimals(self.hand.ruler)

    def row(self, view: str) -> tuple[int, ...]:
        """Return the positions (indices) at which a view is drawn."""
        return self.project.rows.get(view, self.all)

    def of(self, view: str) -> Reading | None:
        """Return the numbers of a view at the positions of its row; None if it has no position."""
        if view in self.project.rows:
            return self.numbers.own.get(view)
        return self.numbers.whole

    @cached_property
    def cache(self) -> dict[str, Any]:
        """What chapters computed from this drawing and cache with it, by name."""
        return {}

    def __getstate__(self) -> dict[str, Any]:
        """Return what another process needs: advice as it is given, for what gives it stays here."""
        state = {name: value for name, value in self.__dict__.items() if name != "cache"}
        return {**state, "advice": partial(tuple, tuple(self.advice()))}

    def drawn_by(self, hand: Hand) -> Drawn:
        """Return the same drawing, to the same scales, by another hand."""
        return replace(
            self, numbers=read_log(self.project, self.given, hand, self.doubts), hand=hand
        )

    def trial(self, k: int) -> Drawn:
        """Return one of the drawings of a hand that drew several times."""
        return replace(self, numbers=self.numbers.trial(k))

    def value(self, mark: Mark) -> float:
        """Return a number, a length or an angle that does not vary, in the unit of its mark."""
        return float(self.reading[mark][0, 0])

    def findings(self) -> tuple[Finding, ...]:
        """Return what could not be drawn, or was drawn at the edge of its possibility, or is left out."""
        log, drawn = self.construction, self.numbers.drawn
        marks = [step.it for step in log.steps if not step.op.across and step.it in drawn]
        found = examine(log, self.given, marks, doubts=self.reading.doubts, drawn=drawn)
        own = [
            one for chapter in self.project.chapters for one in Findings.of(chapter).findings(self)
        ]
        return (*self._asked_for(found), *own)

    def _asked_for(self, found: tuple[Finding, ...]) -> Iterator[Finding]:
        """Yield findings of views only at the positions that are reported for them."""
        told = self.project.told
        for one in found:
            places, left = set(one.positions), one
            if one.step.it.view in told:
                places &= told[one.step.it.view]
                for chapter in self.project.chapters:
                    left = Findings.of(chapter).compared(self, left, places)
            if places and (left.marks or left.kind != "lost"):
                yield left._replace(positions=tuple(sorted(places)))


@dataclass(frozen=True)
class Findings(Answer):
    """What a chapter knows of failures.

    ``undrawn``: positions that cannot be drawn. ``nothing``: by slot, where a figure has no meaning;
    ``coarse``: by slot, what leaves fewer digits of it. ``compared``: a finding and its positions -> what to
    report; ``findings``: its own.
    """

    stands: ClassVar[str] = "findings.FINDINGS"
    undrawn: Callable[[Project, Reading], tuple[int, ...]] = lambda project, reading: ()
    nothing: Callable[[Project, Doubts], Mapping[int, np.ndarray]] = lambda project, doubts: {}
    coarse: Callable[[Project, Mapping[Mark, object], Hand], Mapping[int, Doubts]] = (
        lambda project, given, hand: {}
    )
    compared: Callable[[Drawn, Finding, set[int]], Finding] = lambda drawn, finding, places: finding
    findings: Callable[[Drawn], Iterable[Finding]] = lambda drawn: ()


class DrawnScene(NamedTuple):
    """A scene as drawn: its boards, that of its mechanism first if it has one."""

    scene: Scene
    boards: tuple[Drawn, ...]

    @property
    def mechanism(self) -> Drawn | None:
        """The mechanism's board."""
        return next((one for one in self.boards if one.board == MECHANISM), None)

    @property
    def trials(self) -> int:
        """How often everything is drawn."""
        return max((one.hand.trials for one in self.boards), default=1)

    @property
    def exact(self) -> bool:
        """Whether lengths are read without rounding."""
        return all(one.hand.ruler is None for one in self.boards)

    @property
    def division(self) -> float:
        """The division of the coarsest ruler that the scene is read with, mm."""
        rulers = [one.hand.ruler for one in self.boards if one.hand.ruler is not None]
        return max(rulers, default=0.1)


def hand_of(scene: Scene, trials: int = 1) -> Hand:
    """Return the hand that a scene names, with its ruler and its seed."""
    return HANDS[scene.hand]._replace(ruler=scene.ruler, seed=scene.seed, trials=trials)


def doubted(project: Project) -> Doubts:
    """Return how far rounding moves the marks of a project, with a scale factor of 1 for every plan.

    Where it leaves no digit of a mark does not depend on scale factors; they are chosen by the others.
    """
    log = project.construction
    return Doubts(log.steps, {**dict.fromkeys(log.given, 1.0), **project.given}, to_scale=False)


def read_log(project: Project, given: Mapping[Mark, object], hand: Hand, doubts: Doubts) -> Numbers:
    """Execute the log once and return its reading, without figures that lost all digits.

    Views with rows of their own are reported at their positions, everything else at all positions.
    """
    log, rows = project.construction, project.rows
    exact = hand.ruler is None and not hand.slips and hand.digits is None
    coarse: dict[int, Doubts] = {}
    for chapter in () if exact else project.chapters:
        coarse |= Findings.of(chapter).coarse(project, given, hand)
    same = doubts.coarsened(coarse) if doubts.to_scale else None
    own = same or Doubts(log.steps, given, doubts.lost, coarse=coarse)
    nothing: dict[int, Any] = {}
    for chapter in project.chapters:
        nothing |= Findings.of(chapter).nothing(project, doubts)
    idle = {view for view, places in rows.items() if not places}
    sliced = needed(log, _marks(log, idle))
    wanted = _marks(log, idle) | {mark for step in sliced for mark in (step.it, *step.uses)}
    drawn = execute(log, given, wanted, hand=hand)
    whole = drawn.only(_marks(log, rows)).doubted(own)
    whole = whole.without(doubts.lost).without(nothing)
    found = {}
    for view, places in rows.items():
        if places:
            steps = [step for step in log.steps if step.it.view == view]
            marks = {mark for step in steps for mark in (step.it, *step.uses)}
            planned = drawn.only(marks).cut(places)
            found[view] = planned.without(doubts.lost, places).doubted(own, places)
    return Numbers(whole, found, drawn)


def _marks(log: Construction, left_out: Container[str]) -> set[Mark]:
    """Return the marks given or drawn in views that are not left out, and those used there."""
    found = {mark for mark in log.given if mark.view not in left_out}
    steps = (step for step in log.steps if step.it.view not in left_out)
    return found | {mark for step in steps for mark in (step.it, *step.uses)}


def view_scales(project: Project, reading: Reading) -> dict[str, Scale]:
    """Return the scale factors of the views that have one, by view."""
    return {
        view.name: Scale(view.scale.name, float(reading[view.scale].ravel()[0]), view.scale.unit)
        for view in project.construction.views
        if view.scale is not None
    }


def results_of(drawn: Drawn, marks: Mapping[str, Mark]) -> dict[str, tuple[Reals, str]]:
    """Return marks that are one number in every drawing: by name the figures, (trial,), and their unit."""
    reading, decimals = drawn.reading, drawn.percent_decimals
    found = {}
    for name, mark in marks.items():
        figures = reading.figure(mark)[:, 0].copy()
        unit = MEASURED.get(mark.kind, mark.unit)
        found[name] = (np.round(figures, decimals) + 0.0 if unit == "%" else figures, unit)
    return found


def single(results: Results) -> dict[str, tuple[float, str]]:
    """Return the results of the first drawing: by name a figure and its unit."""
    return {name: (float(figures[0]), unit) for name, (figures, unit) in results.items()}
