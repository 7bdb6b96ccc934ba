"""What protocols tell of forces."""

from __future__ import annotations

from collections.abc import Mapping

from graphic_tmm.chapters.forces.names import FORCES
from graphic_tmm.chapters.forces.views import polygon_equation
from graphic_tmm.project import Project
from graphic_tmm.readers.titles import Protocols


def _views(project: Project) -> Mapping[str, list[str]]:
    """Return the views that forces are drawn in, in the order of the log."""
    made = FORCES.on(project)
    there = dict.fromkeys(step.it.view for step in project.construction.steps)
    return {FORCES.chapter: [view for view in there if made.owns(view)]}


PROTOCOL = Protocols(views=_views, equations=polygon_equation)
