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
    own = drawn.of(SUBSTITUTION)
    if made is None or own is None or not np.isfinite(own.figure(made.gap)).all():
        return found
    scale, name, speech = drawn.scales[ACCELERATIONS], drawn.names[made.at], speaking(language)
    told = mu_text(scale, language)
    for view, title, mu, plan in (
        (why.HELD, why.HELD_TITLE, 1.0, VELOCITIES),
        (SUBSTITUTION, why.TITLE, scale.value, ACCELERATIONS),
    ):
        reading, key = drawn.of(view), view.replace(" ", "-")
        assert reading is not None
        on = subject(drawn, speech(title, position=name), SUBSTITUTION, name=key)
        on = on._replace(reading=reading)
        caption = told
        if view == why.HELD:
            long = number(float(np.ravel(reading.figure(made.first))[0]), language)
            caption = f"{made.first.name} = {long} {unit('mm', language)}"
        ink = draw_plan(on, view, [Place(0)], mu, UNITS[plan])
        found.append(with_caption(ink, on, lettered, caption))
    return found


SHOWN = Views(draw={SUBSTITUTION: substitution_views})
