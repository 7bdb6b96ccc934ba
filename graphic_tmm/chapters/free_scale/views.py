"""What a sheet shows: the plan to a free scale, what its first vector and its scale are."""

from __future__ import annotations

import numpy as np

from graphic_tmm.chapters.free_scale.record import FREE_SCALE_PLAN
from graphic_tmm.chapters.free_scale.task import FREE_SCALE
from graphic_tmm.chapters.free_scale.words import TITLE
from graphic_tmm.chapters.kinematics.ink_plans import Place, draw_plan
from graphic_tmm.chapters.kinematics.table import UNITS
from graphic_tmm.chapters.kinematics.task import VELOCITIES
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject, with_caption
from graphic_tmm.fitting.views import Views
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.units import unit
from graphic_tmm.paper.drawing import Drawing


def free_scale_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the plan; none where it cannot be drawn."""
    made, reading, language = FREE_SCALE_PLAN.of(drawn), drawn.of(FREE_SCALE), drawn.scene.language
    if made is None or reading is None:
        return []
    mu = float(np.ravel(reading.figure(made.mu))[0])
    if not np.isfinite(mu):
        return []
    title = speaking(language)(TITLE, link=made.link, position=drawn.names[made.at])
    on = subject(drawn, title, FREE_SCALE)._replace(reading=reading)
    view = draw_plan(on, FREE_SCALE, [Place(0)], mu, UNITS[VELOCITIES])
    long = float(np.ravel(reading.figure(made.first))[0])
    first = f"{made.first.name} = {number(long, language)} {unit('mm', language)}"
    scale = f"μ_v = {number(mu, language)} {unit('(m/s)/mm', language)}"
    speeds = [(one.value.letter, reading.figure(one.value)) for one in made.results]
    listed = ", ".join(f"{k} = {number(float(np.ravel(v)[0]), language)}" for k, v in speeds)
    results = f"{listed} {unit('m/s', language)}"
    return [with_caption(view, on, lettered, f"{first}, {scale}", results)]


SHOWN = Views(draw={FREE_SCALE: free_scale_views})
