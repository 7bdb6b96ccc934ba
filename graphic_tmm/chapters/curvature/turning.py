"""Centres and radii of curvature, P and Π at any place of the drive."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.chapters.curvature.record import CURVATURE_PLAN
from graphic_tmm.chapters.curvature.task import CURVATURE
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.project import Project
from graphic_tmm.readers.any_angles.turn import Between, Turn, Turning, TurnQuantity


def quantities(project: Project) -> Iterator[TurnQuantity]:
    """Yield P, centres of curvature (m) and their radii, Π, J and Ball's point where they are drawn."""
    made, plans = CURVATURE_PLAN.on(project), KINEMATICS_PLAN.on(project)
    origin = plans.mechanism.frame.points[plans.structure.origin]
    marks = [(made.holding.pole, made.figure.mu)]
    marks += [(one.centre, made.figure.mu) for one in made.paths]
    marks += [(one, made.figure.mu) for one in made.centres]
    if (bresse := made.bresse) is not None:
        marks += [(one, bresse.figure.mu) for one in (bresse.rest, bresse.inflection.end)]
    if made.ball is not None:
        marks.append((made.ball.results[0], made.ball.mu))
    for mark, mu in marks:
        yield TurnQuantity(CURVATURE, "centres", mark.letter, mark, mu, origin=origin)
    for one in made.paths:
        yield TurnQuantity(CURVATURE, "columns", f"rho_{one.point}", one.radius)


def between(drawn: Drawn, turn: Turn) -> Between:
    """Return μ_l of the constructions, at all angles the finest of their positions."""
    rows = {one.mu: np.asarray(drawn.given[one.mu]) for one in CURVATURE_PLAN.on(drawn).figures}
    alike = (1, turn.turned.size)
    return {mu: np.full(alike, row.min()) for mu, row in rows.items() if row.size > 1}


TURNING = Turning(told=quantities, between=between, plan=CURVATURE)
