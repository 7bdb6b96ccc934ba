"""A cam given by arcs at any angle: the follower is drawn anew on its arc, graphs by chords are read off."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.arc_cam.geometry import TURN
from graphic_tmm.chapters.arc_cam.plan import ARC_CAM_PLAN, ArcCam, marks
from graphic_tmm.chapters.arc_cam.record import BESIDE, Aside
from graphic_tmm.chapters.arc_cam.task import ARC_CAM
from graphic_tmm.drawn import Drawn
from graphic_tmm.project import Project
from graphic_tmm.readers.any_angles.turn import ENDS, Between, Turn, Turning, TurnQuantity


def quantities(project: Project) -> Iterator[TurnQuantity]:
    """Yield S, its derivatives by chords and by the replacing linkage, speeds, the pressure angle, B and K."""
    made, beside = ARC_CAM_PLAN.on(project), BESIDE.on(project)
    for (name, mark), chart in zip(marks(made).items(), made.charts.values(), strict=True):
        yield TurnQuantity(ARC_CAM, "columns", name, mark, chart.mu)
    for name, mark in (_moving(made, beside) | _resting(made)).items():
        yield TurnQuantity(ARC_CAM, "columns", name, mark)
    for name, one in _points(made).items():
        yield TurnQuantity(ARC_CAM, "profile", name, one, made.contour.mu)


def _moving(made: ArcCam, beside: Aside) -> dict[str, Mark]:
    """Return what is zero while the follower rests, by the names of columns; at a change of arcs before it."""
    found = {"dS_K": beside.plans.first, "ddS_K": beside.plans.second[0]}
    if beside.velocity is not None and beside.acceleration is not None:
        names = ("omega", "eps") if made.order.rocks else ("v", "a")
        found |= dict(zip(names, (beside.velocity, beside.acceleration[0]), strict=True))
    return found


def _resting(made: ArcCam) -> dict[str, Mark]:
    """Return what while the follower rests is as at the end of its way."""
    pressure = made.follower.pressure
    return {} if pressure is None else {"pressure": pressure}


def _points(made: ArcCam) -> dict[str, Mark]:
    points, contacts = made.follower.points, made.follower.contacts
    return {"B": points} if contacts is None else {"B": points, "K": contacts}


def between(drawn: Drawn, turn: Turn) -> Between:
    """Return all of it: on the base circle the follower rests, and goes round the cam as the frame does."""
    made, log = ARC_CAM_PLAN.on(drawn), drawn.construction
    assert turn.angles is not None
    phi = np.mod(turn.angles, TURN)
    shares = np.minimum(phi / made.lie.work, 1.0)
    numbers, rests = shares * made.order.parts, phi > made.lie.work + ENDS
    known: dict[Mark, Any] = {m: numbers for m in log.given if m.role == roles.STATION}
    known |= {m: row(numbers) for m, row in made.follower.rows.items()}
    known |= {m: row(shares) for m, row in BESIDE.on(drawn).plans.rows.items()}
    still = {**marks(made), **_moving(made, BESIDE.on(drawn))}
    turned, points = (_resting(made), _points(made))
    reading = turn.read((*still.values(), *turned.values(), *points.values()), known)
    found: dict[Mark, object] = {m: np.where(rests, 0.0, reading[m]) for m in still.values()}
    back = np.exp(-1j * made.sense * np.radians(np.maximum(phi - made.lie.work, 0.0)))
    found |= {mark: reading[mark] for mark in turned.values()}
    return found | {mark: reading[mark] * back for mark in points.values()}


TURNING = Turning(between=between, told=quantities, plan=ARC_CAM)
