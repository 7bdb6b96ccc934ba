"""A check from readings to a report: draw exactly, judge by the hand, look for mistakes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking.cells import cells
from graphic_tmm.checking.judging.comparison import Comparison, worse_of
from graphic_tmm.checking.judging.groups import groups
from graphic_tmm.checking.judging.judge import judge
from graphic_tmm.checking.judging.scatter import Limits
from graphic_tmm.checking.judging.yardstick import Yardsticks
from graphic_tmm.checking.known import known
from graphic_tmm.checking.lessons.lessons import Teacher
from graphic_tmm.checking.mutations.diagnosis import diagnosed
from graphic_tmm.checking.mutations.mistakes import Mistakes
from graphic_tmm.checking.mutations.telling import told
from graphic_tmm.checking.mutations.unseen import Unseen
from graphic_tmm.checking.mutations.unseen import told as told_unseen
from graphic_tmm.checking.records import Report, Taken
from graphic_tmm.scene.records import Scene
from graphic_tmm.scenes import scene_name
from graphic_tmm.studio import make

TRIALS = 400
"""How often the hand draws to tell how far it scatters. A standard deviation is then known to 3.5 % of itself,
1/√800."""


def check(
    scene: Scene,
    readings: Sequence[Taken],
    *,
    hand: str = "student",
    points: str = "paper",
    trials: int = TRIALS,
    limits: Limits = Limits(),  # noqa: B008
    source: str = "readings",
) -> Report:
    """Return the report on readings of a hand-made drawing of a scene.

    ``hand``: by whose drawings they are judged; ``points``: how x and y were read, one of ``POINTS``;
    ``source``: the file of the readings, for messages.

    Raises
    ------
    SceneError
        If readings name what the scene does not have.
    """
    one = ((source, readings),)
    return next(checks(scene, one, hand=hand, points=points, trials=trials, limits=limits))


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
    made = make(scene, exact=True)
    mistakes, teacher = Mistakes(made), Teacher(made)
    drawing = HANDS[hand]._replace(trials=trials, seed=scene.seed)
    yardsticks = Yardsticks(made, drawing, limits, points)
    unseen = Unseen(mistakes)
    for source, readings in drawings:
        rows, notes = known(made, readings, source)
        by = yardsticks.of(rows)
        judged = judge(made, rows, by)
        parts = [part for taken in rows for part in taken.parts()]
        compared = Comparison(made, parts, by, worse_of([one.times for one in judged]))
        found = told(diagnosed(mistakes, compared, judged), compared, scene.language)
        found = found or groups(made, judged, by)
        notes = (*notes, *told_unseen(unseen.of(compared), scene.language))
        lessons = teacher.lessons(judged, found, by.reader)
        name = scene_name(scene.source)
        yield Report(name, scene.title, scene.language, hand, judged, found, notes, lessons)


def figures(scene: Scene) -> int:
    """Return how many figures of a scene can be read."""
    return len(cells(make(scene, exact=True)))
