"""The force triangles of an engine at any angle of its crank."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.engine.ink import draw_triangles
from graphic_tmm.chapters.engine.plan import ENGINE_PLAN
from graphic_tmm.chapters.engine.task import ENGINE, VIEW
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.page.strands import Moving, MovingFigures
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.views import mu_text


def moving(drawn: Drawn) -> Iterator[Moving]:
    """Yield the triangles of the forces at crosshead and pin."""
    made, language, scale = ENGINE_PLAN.on(drawn), drawn.scene.language, drawn.scales[VIEW]
    plans, on = KINEMATICS_PLAN.on(drawn), subject(drawn, "", ENGINE)
    pivot = plans.positions.point(plans.structure.origin)

    def at(place: int) -> Drawing:
        return draw_triangles(on, made, pivot, place, scale.value)

    title = speaking(language)("Force triangles")
    told = mu_text(scale, language)
    yield Moving(VIEW, title, told, at, lambda name: f"engine-{name}")


FIGURES = MovingFigures(moving)
