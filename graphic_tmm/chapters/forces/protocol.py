"""What protocols tell of forces."""

from __future__ import annotations

from collections.abc import Mapping

from graphic_tmm.chapters.forces.names import FORCES
from graphic_tmm.chapters.forces.pins import told as pins_told
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.names import plain
from graphic_tmm.language.symbols import symbol
from graphic_tmm.project import Project
from graphic_tmm.readers.titles import Protocols


def _views(project: Project) -> Mapping[str, list[str]]:
    """Return the views that forces are drawn in, in the order of the log."""
    made = FORCES_PLAN.on(project)
    there = dict.fromkeys(step.it.view for step in project.construction.steps)
    return {FORCES: [view for view in there if made.owns(view)]}


def polygon_equation(drawn: Drawn, view: str, language: str) -> list[str]:
    """Return the vector equation of a polygon, in plain text; before it, in the first view, the shared pins."""
    equations = [
        " + ".join(plain(symbol(letter, language)) for letter, _, _ in polygon.sides) + " = 0"
        for polygon in FORCES_PLAN.on(drawn).polygons
        if polygon.view == view
    ]
    first = view == FORCES_PLAN.on(drawn).polygons[0].view
    return [*(map(plain, pins_told(drawn, language)) if first else ()), *equations]


PROTOCOL = Protocols(views=_views, equations=polygon_equation)
