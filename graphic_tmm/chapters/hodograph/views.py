"""What a sheet shows of hodographs: each of them, the tables of angles and of analogues."""

from __future__ import annotations

from graphic_tmm.chapters.hodograph.ink import draw_hodograph
from graphic_tmm.chapters.hodograph.record import HODOGRAPH_PLAN, Hodograph
from graphic_tmm.chapters.hodograph.table import analogue_columns, tangent_columns
from graphic_tmm.chapters.hodograph.task import HODOGRAPH, TABLE
from graphic_tmm.chapters.hodograph.words import ACCELERATION, ANALOGUES, VELOCITY
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.table import UNITS
from graphic_tmm.chapters.kinematics.task import VELOCITIES
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject, with_caption
from graphic_tmm.fitting.views import Views
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.views import mu_text
from graphic_tmm.readers.result_table import result_table


def hodograph_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the hodographs."""
    made = HODOGRAPH_PLAN.of(drawn)
    found = [_view(drawn, one, lettered) for one in made.curves] if made is not None else []
    return [view for view in found if view is not None]


def title(one: Hodograph, language: str) -> str:
    """Return what a hodograph is called."""
    return speaking(language)(VELOCITY if one.plan == VELOCITIES else ACCELERATION, point=one.point)


def _view(drawn: Drawn, one: Hodograph, lettered: bool) -> Drawing | None:
    if one.plan not in drawn.scales:
        return None
    language, scale = drawn.scene.language, drawn.scales[one.plan]
    left_out = {*drawn.undrawn, *KINEMATICS_PLAN.on(drawn).repeated}
    held = HODOGRAPH_PLAN.on(drawn).held
    every = drawn.all if one.plan == VELOCITIES else held
    places = [k for k in every if k not in left_out]
    on = subject(drawn, title(one, language), HODOGRAPH, name=one.view.replace(" ", "-"))
    view = draw_hodograph(on, one, drawn.names, places, held, scale.value, UNITS[one.plan])
    return with_caption(view, on, lettered, mu_text(scale, language))


def table_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the tables of angles and of analogues."""
    high, found = heights(drawn.scene, TABLE, HODOGRAPH), list[Drawing]()
    left_out = {*drawn.undrawn, *KINEMATICS_PLAN.on(drawn).repeated}
    for name, columns in ((HODOGRAPH, tangent_columns), (ANALOGUES, analogue_columns)):
        rows = [one.without(sorted(left_out)) for one in columns(drawn)]
        if rows:
            found.append(result_table(name, rows, drawn.names, drawn.scene.language, heights=high))
    return found


SHOWN = Views(draw={HODOGRAPH: hodograph_views, TABLE: table_views})
