"""Scenes with some of the effects they name, and the steps that these record."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection
from dataclasses import replace

from graphic_tmm.chapters.engine import CHAPTER as ENGINE
from graphic_tmm.chapters.forces import CHAPTER as FORCES
from graphic_tmm.project import record
from graphic_tmm.scene.records import Scene, SheetOrder

Steps = Counter[tuple[str, str]]
"""How many steps each view has, by operation."""
PLACED = {
    "velocities": ("velocities",),
    "accelerations": ("accelerations",),
    "diagrams": ("diagrams",),
    "flywheel": ("flywheel",),
    "engine": tuple(place.name for place in ENGINE.places),
    "forces": tuple(place.name for place in FORCES.places),
}
"""What stands on the sheet of each effect that is a plan of its own."""
LOADS = ("gravity", "inertia", "friction")
"""Effects on the forces."""


def named(scene: Scene) -> list[str]:
    """Return the effects that a scene names, each behind those it needs."""
    found = ["velocities", *(["accelerations"] if scene.row.accelerations else [])]
    found += [name for name in ("diagrams", "engine", "forces") if name in scene.tasks]
    if "forces" in scene.tasks:
        found += [name for name in LOADS if getattr(scene.tasks["forces"], name)]
    return [*found, "flywheel"] if "flywheel" in scene.tasks else found


def needs(scene: Scene, effect: str) -> set[str]:
    """Return the effects without which one cannot be drawn."""
    if effect == "velocities":
        return set()
    found = {"velocities"}
    by_loads = effect == "flywheel" and "forces" in scene.tasks
    if effect in LOADS or by_loads:
        found.add("forces")
    if effect in ("inertia", "engine") and scene.row.accelerations:
        found.add("accelerations")
    return found


def only(scene: Scene, effects: Collection[str]) -> Scene:
    """Return the scene with its plan of positions, and of its effects these only."""
    places = ["positions", *(place for name in PLACED if name in effects for place in PLACED[name])]
    forces = None
    if "forces" in effects:
        assert "forces" in scene.tasks
        forces = replace(
            scene.tasks["forces"],
            gravity="gravity" in effects,
            inertia="inertia" in effects,
            friction=scene.tasks["forces"].friction if "friction" in effects else None,
            single=scene.tasks["forces"].single if "inertia" in effects else (),
        )
    row = scene.row if "accelerations" in effects else replace(scene.row, accelerations=())
    kept = ("diagrams", "flywheel", "engine")
    tasks = {name: scene.tasks.get(name) if name in effects else None for name in kept}
    sheets = (SheetOrder("A1", tuple(places)),)
    return replace(scene, sheets=sheets, row=row, trajectories=()).asking(forces=forces, **tasks)


def steps(scene: Scene, effects: Collection[str]) -> Steps:
    """Return the steps that a scene records with these of its effects."""
    log = record(only(scene, effects)).construction
    return Counter((step.it.view, step.op.name) for step in log.steps)
