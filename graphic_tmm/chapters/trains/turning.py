"""A train at any angle of what drives: how far every wheel and the carrier have turned, and how fast."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.trains.plan import PLANETARY_PLAN
from graphic_tmm.chapters.trains.record import BESIDE
from graphic_tmm.chapters.trains.rows import rows_of
from graphic_tmm.chapters.trains.task import PLANETARY_TRAIN
from graphic_tmm.drawn import Drawn
from graphic_tmm.project import Project
from graphic_tmm.readers.any_angles.turn import Between, Turn, Turning, TurnQuantity


def quantities(project: Project) -> Iterator[TurnQuantity]:
    """Yield the angle and the speed (rpm) of every body that moves, satellites against the frame."""
    turns, angles = BESIDE.on(project).turns, _angles(project)
    for body, mark in turns.items():
        if body in angles:
            yield TurnQuantity(PLANETARY_TRAIN, "columns", f"planetary_phi_{body}", angles[body])
        yield TurnQuantity(PLANETARY_TRAIN, "columns", f"planetary_n_{body}", mark)


def between(drawn: Drawn, turn: Turn) -> Between:
    """Return the angles: as many as what drives turns, as their speeds are; none of a train that stands."""
    assert turn.angles is not None
    turns, reading = BESIDE.on(drawn).turns, drawn.numbers.drawn
    first = reading[turns[_first(drawn)]]
    share = turn.angles / np.where(first == 0.0, np.nan, first)
    return {mark: reading[turns[body]] * share for body, mark in _angles(drawn).items()}


def _angles(holder: Project | Drawn) -> dict[str, Mark]:
    """Return marks of the angles by the body: no step draws them.

    A bevel satellite has none against the frame: it turns about an axis that is itself carried round.
    """
    bevel = PLANETARY_PLAN.on(holder).train.scheme.bevel
    return {
        body: Mark(-2 - k, f"φ_{body}", Number, PLANETARY_TRAIN)
        for k, body in enumerate(BESIDE.on(holder).turns)
        if not (bevel and body == "2")
    }


def _first(drawn: Drawn) -> str:
    """Return the body that drives, or the first of two; the outermost wheel before the train."""
    made = PLANETARY_PLAN.on(drawn)
    before = rows_of(made.order, made.train.scheme, "before")
    return before[-1].names[-1] if before else made.motion.first


TURNING = Turning(between=between, told=quantities, plan=PLANETARY_TRAIN)
