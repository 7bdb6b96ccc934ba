"""How accurate radii of curvature are: by the plans, and by Bobillier's construction in the same positions."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from graphic_tmm.accuracy.quantities import Accuracy, Quantity, Value
from graphic_tmm.board.operations.instruments import measure
from graphic_tmm.chapters.curvature.record import CURVATURE_PLAN
from graphic_tmm.chapters.curvature.task import ASKED, CURVATURE
from graphic_tmm.chapters.kinematics.accuracy import renamed
from graphic_tmm.language.said import said
from graphic_tmm.project import Project
from graphic_tmm.readers.position_count import FinerRow
from graphic_tmm.scene.records import Scene

PLANS, BOBILLIER = "rho_plans", "rho_bobillier"


def _quantities(project: Project) -> Iterator[Quantity]:
    """Yield ρ by the plans, then by Bobillier, of the points that do not hold the link."""
    made = CURVATURE_PLAN.on(project)
    drawn = {
        one.uses[1]: Value(one.it, made.figure.mu)
        for one in project.construction.steps
        if one.op is measure and one.uses[1] in made.centres
    }
    both = {
        PLANS: tuple(Value(one.radius) for one in made.paths),
        BOBILLIER: tuple(drawn[one] for one in made.centres),
    }
    for name, values in both.items():
        if values:
            read = Quantity(name, "m", values, len(project.names), due=values, at=made.places)
            yield read._replace(places=(CURVATURE,))


def _at_count(scene: Scene, count: int) -> Scene | None:
    """Return the scene whose constructions stay where they are in a row of another count."""
    order = ASKED.of(scene)
    if order is None:
        return scene
    places = renamed(order.positions, scene.row, count)
    return None if places is None else ASKED.put(scene, replace(order, positions=places))


WORDS = {
    PLANS: said("ρ by plans"),
    BOBILLIER: said("ρ by Bobillier's construction"),
}
"""What is told of by name, in English."""

ACCURACY = Accuracy(quantities=_quantities, places=(CURVATURE,), words=WORDS)
FINER = FinerRow(at_count=_at_count)
