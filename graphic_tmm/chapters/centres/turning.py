"""Instantaneous centres at any angle of the crank."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.board.record import segment_name
from graphic_tmm.board.scales import Scale
from graphic_tmm.chapters.centres.ink_turning import TurningScheme
from graphic_tmm.chapters.centres.record import CENTRES_PLAN
from graphic_tmm.chapters.centres.table import columns_at
from graphic_tmm.chapters.centres.task import ASKED, CENTRES, CentresTask
from graphic_tmm.chapters.kinematics.plan import ALL, KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.scales import reaches
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject
from graphic_tmm.page.strands import Moving, MovingFigures
from graphic_tmm.paper.views import mu_text
from graphic_tmm.project import Project
from graphic_tmm.readers.any_angles.turn import Turning, TurnQuantity
from graphic_tmm.scene.captions import captions


def quantities(project: Project) -> Iterator[TurnQuantity]:
    """Yield the centres that do not always lie at infinity."""
    made, plans = CENTRES_PLAN.on(project), KINEMATICS_PLAN.on(project)
    origin = plans.mechanism.frame.points[plans.structure.origin]
    for one in made.centres:
        if not one.far:
            key = segment_name(one.name)
            yield TurnQuantity(CENTRES, "centres", key, one.mark, made.mu, origin=origin)


def moving(drawn: Drawn) -> Iterator[Moving]:
    """Yield the scheme of centres, and what is found by them."""
    made, language = CENTRES_PLAN.of(drawn), drawn.scene.language
    if made is None:
        return
    scale = Scale(made.mu.name, drawn.value(made.mu), made.mu.unit)
    on, mu_l = subject(drawn, "", CENTRES), KINEMATICS_PLAN.on(drawn).mu_l
    yield Moving(
        CENTRES,
        captions(language)[CENTRES],
        mu_text(scale, language),
        TurningScheme(on, made, reaches(drawn), mu_l).at,
        lambda name: f"{CENTRES}-{name}",
        columns=lambda: columns_at(drawn, drawn.all),
    )


TURNING = Turning(
    told=quantities, free=lambda scene: ASKED.put(scene, CentresTask(ALL)), plan=CENTRES
)
FIGURES = MovingFigures(moving)
