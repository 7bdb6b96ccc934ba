"""What a sheet shows of a rotor: two views of it, its polygons, its tables."""

from __future__ import annotations

from graphic_tmm.chapters.rotors.ink import draw_end, draw_side
from graphic_tmm.chapters.rotors.ink_polygon import draw_polygon_ink
from graphic_tmm.chapters.rotors.plan import END, ROTOR_PLAN, SIDE
from graphic_tmm.chapters.rotors.table import reaction_rows, weight_table
from graphic_tmm.chapters.rotors.task import ROTOR
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject, with_caption
from graphic_tmm.fitting.views import Views
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.views import mu_text
from graphic_tmm.readers.result_table import results
from graphic_tmm.readers.task_sheet import given_views
from graphic_tmm.scene.captions import captions


def rotor_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the rotor from the side and along its axis, its polygons, its tables."""
    rotor = ROTOR_PLAN.of(drawn)
    if rotor is None:
        return []
    language = drawn.scene.language
    words, found = captions(language), list[Drawing]()
    for view, draw in ((SIDE, draw_side), (END, draw_end)):
        if view in rotor.scales:
            on = subject(drawn, words[view], ROTOR, name=view)
            told = mu_text(drawn.scales[view], language)
            found.append(with_caption(draw(on, rotor), on, lettered, told))
    for view, polygon in rotor.polygons.items():
        on = subject(drawn, words[view], ROTOR, name=view)
        scale = drawn.scales[view]
        made = draw_polygon_ink(on, polygon, scale.value)
        found.append(with_caption(made, on, lettered, mu_text(scale, language)))
    found.append(weight_table(drawn))
    if rotor.reactions:
        high = heights(drawn.scene, ROTOR)
        rows = reaction_rows(drawn)
        found.append(results("table-bearings", words["rotor bearings"], rows, language, high))
    return found


SHOWN = Views(draw={ROTOR: rotor_views, **given_views(ROTOR)})
