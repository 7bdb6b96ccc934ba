"""Scenes with some of the effects they name, and the steps that these record."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection
from dataclasses import replace

from graphic_tmm.project import record
from graphic_tmm.scene.records import ENGINE_PLACES, FORCE_PLACES, Scene, SheetOrder

Steps = Counter[tuple[str, str]]
"""How many steps each view has, by operation."""
PLACED = {
    "velocities": ("velocities",),
    "accelerations": ("accelerations",),
    "diagrams": ("diagrams",),
    "flywheel": ("flywheel",),
    "engine": ENGINE_PLACES,
    "forces": FORCE_PLACES,
}
"""What stands on the sheet of each effect that is a plan of its own."""
LOADS = ("gravity", "inertia", "friction")
"""Effects on the forces."""


def named(scene: Scene) -> list[str]:
    """Return the effects that a scene names, each behind those it needs."""
    found = ["velocities", *(["accelerations"] if scene.row.accelerations else [])]
    orders = {"diagrams": scene.diagrams, "engine": scene.engine, "forces": scene.forces}
    found += [name for name, order in orders.items() if order is not None]
    if scene.forces is not None:
        found += [name for name in LOADS if getattr(scene.forces, name)]
    return [*found, "flywheel"] if scene.flywheel is not None else found


def needs(scene: Scene, effect: str) -> set[str]:
    """Return the effects without which one cannot be drawn."""
    if effect == "velocities":
        return set()
    found = {"velocities"}
    by_loads = effect == "flywheel" and scene.forces is not None
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
        assert scene.forces is not None
        forces = replace(
            scene.forces,
            gravity="gravity" in effects,
            inertia="inertia" in effects,
            friction=scene.forces.friction if "friction" in effects else None,
            single=scene.forces.single if "inertia" in effects else (),
        )
    row = scene.row if "accelerations" in effects else replace(scene.row, accelerations=())
    diagrams = scene.diagrams if "diagrams" in effects else None
    return replace(
        scene,
        sheets=(SheetOrder("A1", tuple(places)),),
        row=row,
        diagrams=diagrams,
        flywheel=scene.flywheel if "flywheel" in effects else None,
        forces=forces,
        engine=scene.engine if "engine" in effects else None,
        trajectories=(),
    )


def steps(scene: Scene, effects: Collection[str]) -> Steps:
    """Return the steps that a scene records with these of its effects."""
    log = record(only(scene, effects)).construction
    return Counter((step.it.view, step.op.name) for step in log.steps)
