"""A scene that has been drawn: its log, its numbers, its scale factors, what went wrong."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

import numpy as np

from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.findings import Finding, examine
from graphic_tmm.board.hand import EXACT, HANDS, Hand
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import Scale
from graphic_tmm.board.values import Curve, undefined
from graphic_tmm.errors import Fault, SceneError, StructureError
from graphic_tmm.plans.project import Project, draw_project
from graphic_tmm.scaling import (
    chart_scale_values,
    chart_scales,
    choose_scales,
    engine_scales,
    force_scales,
)
from graphic_tmm.scene.records import ENGINE_PLACES, FORCE_PLACES, Scene

ROOM = {"A1": 230.0, "A4": 140.0}
"""For a format: room for the plan of positions, mm."""


@dataclass(frozen=True)
class Work:
    """A scene that has been drawn: its log, its numbers, its scale factors, what went wrong."""

    scene: Scene
    project: Project
    given: Mapping[Mark, object]
    scales: Mapping[str, Scale]
    reading: Reading
    accelerated: Reading | None
    hand: Hand
    undrawn: tuple[int, ...]

    def drawn_by(self, hand: Hand) -> Work:
        """Return the same drawing, to the same scales, by another hand."""
        reading, accelerated = _read(self.project, self.given, hand)
        return replace(self, reading=reading, accelerated=accelerated, hand=hand)

    def trial(self, k: int) -> Work:
        """Return one of the drawings of a hand that drew several times."""
        accelerated = self.accelerated.trial(k) if self.accelerated is not None else None
        return replace(self, reading=self.reading.trial(k), accelerated=accelerated)

    def findings(self) -> tuple[Finding, ...]:
        """Return what could not be drawn, or was drawn at the edge of its possibility."""
        log = self.project.construction
        plain = [s.it for s in log.steps if s.it.view != "accelerations" and not s.op.across]
        found = examine(log, self.given, plain, hand=self.hand)
        if self.project.forces is not None:
            found = tuple(_of_forces(found, self.project))
        if self.accelerated is None:
            return found
        marks = self.project.marks("accelerations")
        more = examine(log, self.given, marks, hand=self.hand, positions=self.project.accelerated)
        return (*found, *(f for f in more if f.step.it.view == "accelerations"))


def work(scene: Scene, *, exact: bool = False, vectors: tuple[float, float] = (80.0, 80.0)) -> Work:
    """Draw a scene: record its plans, choose the scale factors, execute.

    ``exact`` switches the rounding of the ruler off; ``vectors`` is the room, mm, for the
    longest vector of the plans of velocities and of accelerations.
    """
    return executed(scene, record(scene), exact=exact, vectors=vectors)


def record(scene: Scene) -> Project:
    """Record the plans that the scene's sheets ask for.

    Raises
    ------
    SceneError
        If the scene has no mechanism.
    StructureError
        If its mechanism cannot be drawn.
    """
    if scene.mechanism is None:
        says = (
            "this scene has no mechanism, only sheets to draw: write [frame], [[link]] and [drive]"
        )
        raise SceneError(scene.source, (Fault("", 0, says),))
    wanted = scene.shown
    try:
        return draw_project(
            scene.mechanism,
            scene.row,
            turned=scene.turned,
            trajectories=scene.trajectories,
            plans=[p for p in ("positions", "velocities", "accelerations") if p in wanted],
            diagrams=scene.diagrams if "diagrams" in wanted else None,
            flywheel=scene.flywheel if "flywheel" in wanted else None,
            engine=scene.engine if wanted & set(ENGINE_PLACES) else None,
            forces=scene.forces if wanted & _needing_forces(scene) else None,
        )
    except StructureError as error:
        raise StructureError(f"{scene.source}: {error}") from error


def _needing_forces(scene: Scene) -> set[str]:
    """Return the places of a sheet that show forces, or a flywheel that is found by loads."""
    by_loads = scene.flywheel is not None and scene.flywheel.indicator is None
    return {*FORCE_PLACES, "flywheel"} if by_loads else set(FORCE_PLACES)


def hand_of(scene: Scene, trials: int = 1) -> Hand:
    """Return the hand that a scene names, with its ruler and its seed."""
    return HANDS[scene.hand]._replace(ruler=scene.ruler, seed=scene.seed, trials=trials)


def executed(
    scene: Scene,
    project: Project,
    *,
    exact: bool,
    vectors: tuple[float, float],
) -> Work:
    """Choose the scale factors of a recorded project and execute it; see `work`."""
    formats = [sheet.format for sheet in scene.sheets]
    scales = choose_scales(
        project, scene.scales, ROOM["A4" if set(formats) == {"A4"} else "A1"], vectors
    )
    given = dict(project.given)
    for plan, scale in scales.items():
        given[project.scale(plan)] = scale.value
    given |= force_scales(project, given)
    given |= engine_scales(project, given)
    given |= chart_scales(project, given)
    hand = EXACT if exact else hand_of(scene)
    reading, accelerated = _read(project, given, hand)
    scales |= chart_scale_values(project, reading)
    if project.engine is not None:
        mu = project.engine.mu
        scales["engine"] = Scale("μ_F", float(reading[mu][0, 0]), mu.unit)
        mu = project.engine.harmonics.mu
        scales["harmonics"] = Scale("μ_F", float(reading[mu][0, 0]), mu.unit)
    if project.forces is not None:
        polygons = project.forces.polygons
        lever = project.forces.lever.mu
        scales["lever"] = Scale("μ_v", float(reading[lever][0, 0]), lever.unit)
        scales |= {p.view: Scale("μ_F", float(reading[p.mu][0, 0]), "N/mm") for p in polygons}
    undrawn = _undrawn(project, reading)
    if len(undrawn) == len(project.names):
        raise StructureError(
            f"{scene.source}: none of the positions can be drawn" + ranges(project)
        )
    return Work(scene, project, given, scales, reading, accelerated, hand, undrawn)


def _of_forces(found: tuple[Finding, ...], project: Project) -> Iterator[Finding]:
    """Yield findings; those of forces only at positions whose forces are asked for."""
    assert project.forces is not None
    for one in found:
        if not project.forces.owns(one.step.it.view):
            yield one
            continue
        places = tuple(k for k in one.positions if k in project.forced)
        if places:
            yield one._replace(positions=places)


def _read(
    project: Project, given: Mapping[Mark, object], hand: Hand
) -> tuple[Reading, Reading | None]:
    """Execute the log: everything but the plans of accelerations, and these at their positions."""
    log = project.construction
    still = {m for m in log.given if m.view != "accelerations"}
    still |= {m for s in log.steps if s.it.view != "accelerations" for m in (s.it, *s.uses)}
    reading = execute(log, given, still, hand=hand)
    if project.accelerations is None or not project.accelerated:
        return reading, None
    steps = [step for step in log.steps if step.it.view == "accelerations"]
    whole = {mark for step in steps for mark in (step.it, *step.uses)}
    return reading, execute(log, given, whole, hand=hand, positions=project.accelerated)


def ranges(project: Project) -> str:
    """Return, as the end of a sentence, over which ranges of the crank the mechanism assembles."""
    said = project.assembly.said
    return f": {said}" if said else ""


def _undrawn(project: Project, reading: Reading) -> tuple[int, ...]:
    bad = np.zeros((1, len(project.names)), dtype=bool)
    for mark in project.marks("positions"):
        if mark.kind is not Curve:
            bad = bad | undefined(reading[mark]).any(axis=0, keepdims=True)
    return tuple(int(i) for i in np.flatnonzero(bad[0]))
