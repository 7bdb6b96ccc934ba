"""The study of a scene: its settings measured one after the other, and what they teach."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import ceil

from graphic_tmm.accuracy.answer import Answer, answer, nothing
from graphic_tmm.accuracy.budget import Tell
from graphic_tmm.accuracy.cost import NOTHING, BoardWork, count
from graphic_tmm.accuracy.drawing import References, pinned
from graphic_tmm.accuracy.lessons import Fitted, Optimum, best_of, optima, slopes
from graphic_tmm.accuracy.measure import Measure, Measurement
from graphic_tmm.accuracy.quantities import quantities
from graphic_tmm.accuracy.settings import Varied, grid, own_setting, singly
from graphic_tmm.accuracy.timing import Stopwatch
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.errors import Fault, SceneError, TmmError
from graphic_tmm.fitting.choice import choices
from graphic_tmm.language.units import unit_name
from graphic_tmm.readers.position_count import at_all_positions
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make

DRAWINGS = 100
"""Default number of drawings by a hand that slips at each setting."""
PASSES = 3
"""So often, while the settings are measured, what has been measured is timed."""
SLIPPING = ("student", "careful")
"""The hands whose best number of positions is reported, in addition to the scene's own."""


@dataclass(frozen=True)
class Study:
    """All runs of a scene and what they teach, and the ``answer`` in short.

    ``quantities``: their units by name. ``hand``: about whose setting axes vary. ``fronts``: runs on the Pareto
    front over minutes. ``timed``: whether seconds were measured. ``left_out``: settings
    that could not be drawn, and why. ``choice``: the work of choosing all scale factors.
    """

    answer: Answer
    hand: str
    trials: int
    quantities: Mapping[str, str]
    runs: tuple[Measurement, ...]
    fitted: tuple[Fitted, ...]
    optima: tuple[Optimum, ...]
    fronts: frozenset[Measurement]
    timed: bool
    left_out: tuple[str, ...]
    choice: BoardWork

    @property
    def scene(self) -> Scene:
        """The scene."""
        return self.answer.scene


def study(
    scene: Scene,
    *,
    hand: str | None = None,
    trials: int = DRAWINGS,
    minutes: Mapping[str, float] | None = None,
    clock: bool = True,
    tell: Tell | None = None,
    literal: bool = False,
) -> Study:
    """Measure a scene on all axes that it calls for.

    ``literal``: the answer is by the scene's own hand, too, whatever it is.

    Raises
    ------
    SceneError
        If the scene has no quantity whose error can be measured.
    """
    told = tell or (lambda done, of, name: None)
    full = at_all_positions(scene)
    own = own_setting(full, hand, trials)
    along = [*grid(own, trials), *singly(own, trials)]
    told(0, len(along) + 2, "")
    made = make(scene, exact=True)
    scales = pinned(made)
    measure = Measure(scales, References(full, scales), clock=clock, minutes=minutes)
    units = {
        q.name: unit_name(q.unit, scene.language)
        for d in measure.drawings(own)
        for q in quantities(d)
    }
    if not units:
        raise SceneError(scene.source, (Fault("", 0, nothing(scene)),))
    watch = Stopwatch() if clock else None
    runs: list[Measurement] = []
    left_out: list[str] = []
    for k, place in enumerate(along):
        told(k + 1, len(along) + 2, f"{place.axis} {place.value}")
        if place.only is not None and not set(place.only) & set(units):
            continue
        _measure(measure, place, runs, left_out)
        if watch is not None and (k + 1) % ceil(len(along) / PASSES) == 0:
            measure.keep(watch)
    told(len(along) + 1, len(along) + 2, "")
    weighed = answer(scene, minutes, watch, literal=literal)
    if watch is not None:
        runs = measure.timed(runs, watch)
        weighed = replace(weighed, load=watch.load)
    hands = tuple(dict.fromkeys((*SLIPPING, own.hand)))
    return Study(
        weighed,
        own.hand,
        trials,
        units,
        tuple(runs),
        slopes(runs),
        optima(runs, hands),
        best_of(runs),
        clock,
        tuple(left_out),
        _choice(made, minutes),
    )


def _choice(made: DrawnScene, minutes: Mapping[str, float] | None) -> BoardWork:
    """Return the work of choosing the scale factors of all boards; done once, for all positions."""
    logs = (choices(drawn).construction for drawn in made.boards)
    return sum((count(log, (), minutes=minutes) for log in logs), NOTHING)


def _measure(measure: Measure, place: Varied, runs: list[Measurement], left_out: list[str]) -> None:
    try:
        runs += measure.runs(place.setting, place.axis, place.value, place.only)
    except TmmError as error:
        text = f"{place.axis} {place.value}: {error}"
        if text not in left_out:
            left_out.append(text)
