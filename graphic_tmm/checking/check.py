"""A check from readings to a report: draw exactly, judge by the hand, look for mistakes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking.cells import cells
from graphic_tmm.checking.judging.comparison import Comparison, worse_of
from graphic_tmm.checking.judging.groups import groups
from graphic_tmm.checking.judging.judge import judge
from graphic_tmm.checking.judging.scatter import Limits
from graphic_tmm.checking.judging.yardstick import Yardstick, Yardsticks
from graphic_tmm.checking.known import known
from graphic_tmm.checking.lessons.lessons import Teacher
from graphic_tmm.checking.mutations.diagnosis import diagnosed
from graphic_tmm.checking.mutations.mistakes import Mistakes
from graphic_tmm.checking.mutations.telling import told
from graphic_tmm.checking.mutations.unseen import Unseen
from graphic_tmm.checking.mutations.unseen import told as told_unseen
from graphic_tmm.checking.records import Judged, Report, Taken
from graphic_tmm.fitting.composition import Composition
from graphic_tmm.scene.packaged import scene_name
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make

TRIALS = 400
"""How often the hand draws to tell how far it scatters. A standard deviation is then known to 3.5 % of itself,
1/√800."""


class Checked(NamedTuple):
    """A report, and what its verdicts were found by: the readings beside the scene and the hand's drawings."""

    report: Report
    compared: Comparison


class _Judgement(NamedTuple):
    """Readings as the scene knows them, what is told of that, by what they were judged, and their verdicts."""

    rows: tuple[Taken, ...]
    notes: tuple[str, ...]
    by: Yardstick
    verdicts: tuple[Judged, ...]


class Checker:
    """A scene drawn exactly, with all that its drawings are checked by: the hand draws once for them."""

    def __init__(
        self,
        scene: Scene,
        *,
        hand: str = "student",
        points: str = "paper",
        trials: int = TRIALS,
        limits: Limits = Limits(),  # noqa: B008
        given: Composition | None = None,
    ) -> None:
        """Draw a scene; for the rest see `check`."""
        self.scene, self._hand = scene, hand
        self.made = make(scene, exact=True, given=given)
        self._mistakes, self._teacher = Mistakes(self.made), Teacher(self.made)
        drawing = HANDS[hand]._replace(trials=trials, seed=scene.seed)
        self._yardsticks = Yardsticks(self.made, drawing, limits, points)
        self._unseen = Unseen(self._mistakes)

    def verdicts(self, readings: Sequence[Taken], source: str = "readings") -> tuple[Judged, ...]:
        """Return the verdicts on the readings of a drawing, and look for no mistake; raises as `check`."""
        return self._judged(readings, source).verdicts

    def _judged(self, readings: Sequence[Taken], source: str) -> _Judgement:
        rows, notes = known(self.made, readings, source)
        by = self._yardsticks.of(rows)
        return _Judgement(tuple(rows), tuple(notes), by, judge(self.made, rows, by))

    def of(self, readings: Sequence[Taken], source: str = "readings") -> Checked:
        """Return what there is to say of the readings of a drawing; raises as `check`."""
        made, language = self.made, self.scene.language
        rows, notes, by, judged = self._judged(readings, source)
        parts = [part for taken in rows for part in taken.parts()]
        compared = Comparison(made, parts, by, worse_of([one.times for one in judged]))
        found = told(diagnosed(self._mistakes, compared, judged), compared, language)
        found = found or groups(made, judged, by)
        notes = (*notes, *told_unseen(self._unseen.of(compared), language))
        lessons = self._teacher.lessons(judged, found, by.reader)
        name, title = scene_name(self.scene.source), self.scene.title
        report = Report(name, title, language, self._hand, judged, found, notes, lessons)
        return Checked(report, compared)


def check(
    scene: Scene,
    readings: Sequence[Taken],
    *,
    hand: str = "student",
    points: str = "paper",
    trials: int = TRIALS,
    limits: Limits = Limits(),  # noqa: B008
    given: Composition | None = None,
    source: str = "readings",
) -> Report:
    """Return the report on readings of a hand-made drawing of a scene.

    ``hand``: by whose drawings they are judged; ``points``: how x and y were read, one of ``POINTS``;
    ``given``: the composition that the drawing's sheets have, as for `make`; ``source``: the file of the
    readings, for messages.

    Raises
    ------
    SceneError
        If readings name what the scene does not have.
    """
    checker = Checker(scene, hand=hand, points=points, trials=trials, limits=limits, given=given)
    return checker.of(readings, source).report


def checks(
    scene: Scene,
    drawings: Iterable[tuple[str, Sequence[Taken]]],
    *,
    hand: str = "student",
    points: str = "paper",
    trials: int = TRIALS,
    limits: Limits = Limits(),  # noqa: B008
) -> Iterator[Report]:
    """Yield the reports on the readings of many drawings of a scene, each with its source.

    The hand draws once for all of them. Otherwise as `check`.
    """
    checker = Checker(scene, hand=hand, points=points, trials=trials, limits=limits)
    for source, readings in drawings:
        yield checker.of(readings, source).report


def figures(scene: Scene) -> int:
    """Return how many figures of a scene can be read."""
    return len(cells(make(scene, exact=True)))
