"""A check from readings to a report: draw exactly, judge by the hand, look for mistakes."""

from __future__ import annotations

from collections.abc import Sequence

from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking.cells import cells
from graphic_tmm.checking.judge import judge, refuse_unknown, yardstick
from graphic_tmm.checking.mistakes import likely
from graphic_tmm.checking.records import Report, Taken
from graphic_tmm.checking.scatter import Limits
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make, scene_name

TRIALS = 400
"""How often the hand draws to tell what is usual."""


def check(
    scene: Scene,
    readings: Sequence[Taken],
    *,
    hand: str = "student",
    trials: int = TRIALS,
    limits: Limits = Limits(),  # noqa: B008
    source: str = "readings",
) -> Report:
    """Return the report on readings of a hand-made drawing of a scene.

    ``hand``: by whose drawings they are judged; ``source``: the file of the readings, for messages.

    Raises
    ------
    SceneError
        If readings name what the scene does not have.
    """
    made = make(scene, exact=True)
    drawing = HANDS[hand]._replace(trials=trials, seed=scene.seed)
    refuse_unknown(made, readings, source)
    by = yardstick(made, readings, drawing, limits)
    judged = judge(made, readings, by)
    found = likely(made, judged, by.spread, scene.language)
    name = scene_name(scene.source)
    return Report(name, scene.title, scene.language, hand, judged, found)


def figures(scene: Scene) -> int:
    """Return how many figures of a scene can be read."""
    return len(cells(make(scene, exact=True)))
