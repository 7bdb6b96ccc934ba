"""The scale factors of kinematic diagrams: of their base and their graphs."""

from __future__ import annotations

from collections.abc import Container

from graphic_tmm.board import roles
from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import Scale
from graphic_tmm.chapters.diagrams.names import BASE_VIEW, VIEWS
from graphic_tmm.chapters.diagrams.plan import DIAGRAMS_PLAN
from graphic_tmm.fitting.scales import ScaleFactors
from graphic_tmm.fitting.sizes import GRAPHS
from graphic_tmm.project import Project


def _named(project: Project, reading: Reading, given: Container[Mark]) -> dict[str, Scale]:
    """Return the scale of the base."""
    mu = DIAGRAMS_PLAN.on(project).base.mu
    return {BASE_VIEW: Scale(mu.name, float(reading[mu][0, 0]), mu.unit)}


SCALES = ScaleFactors(
    scales=lambda fitting: fitting.shorter(
        GRAPHS, [("diagrams.base", view, roles.BASE) for view in (VIEWS["S"], VIEWS["V"])]
    ),
    named=_named,
    key=lambda view: f"mu_{view.replace(' ', '_')}" if view in VIEWS.values() else "",
)
