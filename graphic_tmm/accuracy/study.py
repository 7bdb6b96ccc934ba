"""The study of a scene: its settings measured one after the other, and what they teach."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

from graphic_tmm.accuracy.cost import NOTHING, BoardWork, count
from graphic_tmm.accuracy.drawing import References, pinned
from graphic_tmm.accuracy.lessons import Fitted, Optimum, best_of, optima, slopes
from graphic_tmm.accuracy.machine import MachineTime, machine_times
from graphic_tmm.accuracy.measure import Measure, Measurement
from graphic_tmm.accuracy.quantities import Accuracy, quantities
from graphic_tmm.accuracy.settings import Setting, Varied, grid, hand_named, own_setting, singly
from graphic_tmm.accuracy.shares import Share, shares
from graphic_tmm.accuracy.timing import Load, Stopwatch
from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.errors import Fault, SceneError, TmmError
from graphic_tmm.fitting.choice import choices
from graphic_tmm.language.said import said
from graphic_tmm.language.units import unit_name
from graphic_tmm.project import Project
from graphic_tmm.readers.position_count import at_all_positions
from graphic_tmm.scene.chapter import chapters
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make

DRAWINGS = 100
"""Default number of drawings by a hand that slips at each setting."""
SLIPPING = ("student", "careful")
"""The hands whose best number of positions is reported, in addition to the scene's own."""
Tell = Callable[[int, int, str], None]
"""Called with the number of settings done, their total, and the next one."""


@dataclass(frozen=True)
class Steps:
    """The shares of the steps of a quantity, with the project they stand in and its exact numbers."""

    quantity: str
    shares: tuple[Share, ...]
    project: Project
    reading: Reading


@dataclass(frozen=True)
class Study:
    """All runs of a scene and what they teach.

    ``quantities``: their units by name. ``hand``: about whose setting axes vary. ``fronts``: runs on the Pareto
    front over minutes, ``fast``: over seconds. ``timed``: whether seconds were measured. ``left_out``: settings
    that could not be drawn, and why. ``choice``: the work of choosing all scale factors. ``machine``:
    seconds of what a user asks for, ``load``: what else the machine did then; None if nothing was timed.
    """

    scene: Scene
    hand: str
    trials: int
    quantities: Mapping[str, str]
    runs: tuple[Measurement, ...]
    fitted: tuple[Fitted, ...]
    optima: tuple[Optimum, ...]
    steps: tuple[Steps, ...]
    fronts: frozenset[Measurement]
    fast: frozenset[Measurement]
    timed: bool
    left_out: tuple[str, ...]
    choice: BoardWork
    machine: tuple[MachineTime, ...] = ()
    load: Load | None = None


def study(
    scene: Scene,
    *,
    hand: str | None = None,
    trials: int = DRAWINGS,
    minutes: Mapping[str, float] | None = None,
    clock: bool = True,
    tell: Tell | None = None,
) -> Study:
    """Measure a scene on all axes that it calls for.

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
        raise SceneError(scene.source, (Fault("", 0, _nothing(scene)),))
    runs: list[Measurement] = []
    left_out: list[str] = []
    for k, place in enumerate(along):
        told(k + 1, len(along) + 2, f"{place.axis} {place.value}")
        if place.only is not None and not set(place.only) & set(units):
            continue
        _measure(measure, place, runs, left_out)
    told(len(along) + 1, len(along) + 2, "")
    watch = Stopwatch()
    machine: tuple[MachineTime, ...] = ()
    if clock:
        runs, machine = measure.timed(runs, watch), machine_times(scene, measure, watch)
    hands = tuple(dict.fromkeys((*SLIPPING, own.hand)))
    return Study(
        scene,
        own.hand,
        trials,
        units,
        tuple(runs),
        slopes(runs),
        optima(runs, hands),
        _steps(measure, replace(own, scene=full).by("student", hand_named("student", full, 1))),
        best_of(runs),
        best_of(runs, machine=True),
        clock,
        tuple(left_out),
        _choice(made, minutes),
        machine,
        watch.load if clock else None,
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


def _steps(measure: Measure, setting: Setting) -> tuple[Steps, ...]:
    """Return the shares of the variance per step, by the student's slips at the scene's own setting."""
    found = []
    for drawing in measure.drawings(setting):
        exact = execute(drawing.construction, drawing.given)
        for name, row in shares(drawing, setting.who).items():
            found.append(Steps(name, row, drawing, exact))
    return tuple(found)


def _nothing(scene: Scene) -> str:
    shown = ", ".join(sorted(scene.called))
    *first, last = (place for one in chapters() for place in Accuracy.of(one).places)
    return said(
        "it calls for {shown}: nothing whose error can be told; place {first} or {last} on a [[sheet]]",
        shown=shown,
        first=", ".join(first),
        last=last,
    )
