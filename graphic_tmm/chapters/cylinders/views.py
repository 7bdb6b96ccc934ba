"""What a sheet shows of an engine's inertia: its cranks, the polygons of both orders, tables."""

from __future__ import annotations

from graphic_tmm.chapters.cylinders.ink import draw_shaft, draw_star
from graphic_tmm.chapters.cylinders.plan import CYLINDERS_PLAN
from graphic_tmm.chapters.cylinders.table import cylinder_table, rest_table
from graphic_tmm.chapters.cylinders.task import CYLINDERS
from graphic_tmm.chapters.cylinders.words import SHAFT, STAR
from graphic_tmm.chapters.rotors.ink_polygon import draw_polygon_ink
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject, with_caption
from graphic_tmm.fitting.views import Views
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.views import mu_text
from graphic_tmm.readers.task_sheet import given_views
from graphic_tmm.scene.captions import captions


def cylinder_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the cranks from both sides, the polygons, the tables."""
    made = CYLINDERS_PLAN.of(drawn)
    if made is None:
        return []
    language = drawn.scene.language
    words, found = captions(language), list[Drawing]()
    for view, draw in ((SHAFT, draw_shaft), (STAR, draw_star)):
        on = subject(drawn, words[view], CYLINDERS, name=view)
        told = mu_text(drawn.scales[view], language)
        found.append(with_caption(draw(on, made), on, lettered, told))
    for view, polygon in made.polygons.items():
        on = subject(drawn, words[view], CYLINDERS, name=view)
        scale = drawn.scales[view]
        ink = draw_polygon_ink(on, polygon, scale.value)
        found.append(with_caption(ink, on, lettered, mu_text(scale, language)))
    return [*found, cylinder_table(drawn), rest_table(drawn)]


SHOWN = Views(draw={CYLINDERS: cylinder_views, **given_views(CYLINDERS)})
