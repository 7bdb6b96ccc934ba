"""What a sheet shows: velocities with the pivots held, accelerations by substitution."""

from __future__ import annotations

import numpy as np

from graphic_tmm.chapters.kinematics.ink_plans import Place, draw_plan
from graphic_tmm.chapters.kinematics.table import UNITS
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, VELOCITIES
from graphic_tmm.chapters.substitution import words as why
from graphic_tmm.chapters.substitution.record import SUBSTITUTION_PLAN
from graphic_tmm.chapters.substitution.task import SUBSTITUTION
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject, with_caption
from graphic_tmm.fitting.views import Views
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.units import unit
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.views import mu_text


def substitution_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return both plans; none where they cannot be drawn."""
    made, language, found = SUBSTITUTION_PLAN.of(drawn), drawn.scene.language, list[Drawing]()
    if made is None:
        return found
    scale = drawn.scales[ACCELERATIONS]
    name, speech = drawn.names[made.at], speaking(language)
    for view, title in ((why.HELD, why.HELD_TITLE), (SUBSTITUTION, why.TITLE)):
        reading = drawn.of(view)
        if reading is None or not np.isfinite(reading.figure(made.gap)).all():
            return []
        on = subject(drawn, speech(title, position=name), SUBSTITUTION, name=view.replace(" ", "-"))
        own = view == SUBSTITUTION
        plan = draw_plan(
            on._replace(reading=reading),
            view,
            [Place(0)],
            scale.value if own else 1.0,
            UNITS[ACCELERATIONS if own else VELOCITIES],
        )
        long = number(float(np.ravel(reading.figure(made.first))[0]), language)
        told = (
            mu_text(scale, language)
            if own
            else f"{made.first.name} = {long} {unit('mm', language)}"
        )
        found.append(with_caption(plan, on, lettered, told))
    return found


SHOWN = Views(draw={SUBSTITUTION: substitution_views})
