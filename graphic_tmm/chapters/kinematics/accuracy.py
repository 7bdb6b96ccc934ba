"""How accurate plans are: vectors as read; what another row of positions changes; where extremes are tried."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from graphic_tmm.accuracy.quantities import Accuracy, Effect, Quantity, Trial, Value
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length
from graphic_tmm.chapters.kinematics.extremes import Velocity
from graphic_tmm.chapters.kinematics.plan import ALL, KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, POSITIONS, VELOCITIES
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Row
from graphic_tmm.project import Project
from graphic_tmm.readers.position_count import FinerRow
from graphic_tmm.scene.records import Scales, Scene
from graphic_tmm.scene.tasks import SectionKey


def _quantities(project: Project) -> Iterator[Quantity]:
    made = KINEMATICS_PLAN.on(project)
    for name, unit, plan in (("v", "m/s", VELOCITIES), ("a", "m/s²", ACCELERATIONS)):
        motion = made.motion(plan)
        if motion is None:
            continue
        steps = project.construction.steps
        read = [s.it for s in steps if s.it.view == plan and s.op.reads and s.it.kind is Length]
        values = tuple(Value(mark, motion.mu) for mark in read)
        if values:
            yield Quantity(name, unit, values, made.count, due=values, places=(plan,))


def _whole(scene: Scene) -> Scene:
    return replace(scene, row=replace(scene.row, accelerations=ALL), main=None)


def _at_count(scene: Scene, count: int) -> Scene | None:
    row = scene.row
    accelerations = renamed(row.accelerations, row, count)
    main = renamed((scene.main,) if scene.main is not None else (), row, count)
    if accelerations is None or main is None:
        return None
    row = replace(row, accelerations=accelerations)
    return replace(scene, row=row, main=main[0] if main else None)


def renamed(names: Sequence[str], row: Row, count: int) -> tuple[str, ...] | None:
    """Return how positions are called in a row of another count; None if one of them is not there."""
    if tuple(names) == ALL:
        return ALL
    found = []
    for name in names:
        if not name.isdigit():
            return None
        place = (int(name) - row.first) * count
        if place % row.count:
            return None
        found.append(str(place // row.count + row.first))
    return tuple(found)


def same_place(asked: SectionKey[Any]) -> Callable[[Scene, int], Scene | None]:
    """Return what keeps the position ``at`` of a section where it is in a row of another count."""

    def at_count(scene: Scene, count: int) -> Scene | None:
        order = asked.of(scene)
        if order is None or order.at is None:
            return scene
        places = renamed((order.at,), scene.row, count)
        return None if places is None else asked.put(scene, replace(order, at=places[0]))

    return at_count


def resampled(values: Sequence[float], count: int) -> tuple[float, ...]:
    """Return values of a closed row at ``count`` even positions, straight between those given.

    >>> resampled((0.0, 2.0), 4)
    (0.0, 1.0, 2.0, 1.0)
    """
    closed = [*values, values[0]]
    at = np.arange(count) * (len(values) / count)
    return tuple(float(x) for x in np.interp(at, np.arange(len(closed)), closed))


def _tried(project: Project) -> dict[Mark, Trial]:
    """Return what is tried where an extreme position is found by trying."""
    found = dict[Mark, Trial]()
    for step in project.construction.steps:
        speed = getattr(step.op.run, "tried", None)
        if isinstance(speed, Velocity):
            small = speed.survey
            found[step.it] = Trial(small.construction, small.positions.row[0], speed.axis)
    return found


def _effects(scene: Scene) -> Iterator[Effect]:
    if scene.mechanism is not None and scene.mechanism.drive.acceleration:
        drive = scene.mechanism.drive
        turns = not drive.slides and not drive.rack
        yield Effect(
            said("ε of the crank") if turns else said("acceleration of the drive"), _steady
        )


def _steady(scene: Scene) -> Scene:
    mechanism = scene.mechanism
    if mechanism is None:
        return scene
    drive = replace(mechanism.drive, acceleration=0.0)
    return replace(scene, mechanism=replace(mechanism, drive=drive))


def _enlarged(scene: Scene, drawn: Drawn, times: float) -> Scene:
    mu = {plan: scale.value / times for plan, scale in drawn.scales.items()}
    own = Scales(mu_l=mu.get(POSITIONS), mu_v=mu.get(VELOCITIES), mu_a=mu.get(ACCELERATIONS))
    return replace(scene, scales=own)


WORDS = {
    "v": said("v by plans"),
    "a": said("a by plans"),
}
"""What is told of by name, in English."""

ACCURACY = Accuracy(
    quantities=_quantities,
    places=(VELOCITIES, ACCELERATIONS),
    tried=_tried,
    effects=_effects,
    enlarged=_enlarged,
    words=WORDS,
)


FINER = FinerRow(
    whole=_whole,
    at_count=_at_count,
)
