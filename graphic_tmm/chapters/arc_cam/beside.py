"""What is calculated beside a cam given by arcs: how fast its follower moves."""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapter import Made, aside
from graphic_tmm.chapters.arc_cam.names import ARC_CAM
from graphic_tmm.chapters.arc_cam.task import ROCKER
from graphic_tmm.chapters.cam.formulas import follower_acceleration, follower_velocity
from graphic_tmm.project import Bench

VIEW = "arc_cam-calculation"
"""The view of what is calculated."""


class Beside(NamedTuple):
    """Velocity and acceleration of the follower at all positions (m/s, m/s²; of a lever 1/s, 1/s²)."""

    velocity: Mark
    acceleration: Mark


BESIDE: Made[Beside] = Made(aside(ARC_CAM.chapter))


def record_beside(bench: Bench) -> Beside | None:
    """Calculate velocity and acceleration from the ordinates of the diagrams; None without a speed."""
    made, draft = ARC_CAM.on(bench), bench.draft
    if made.order.speed is None:
        return None
    rocks = made.order.follower == ROCKER
    letters = ("ω_{B}", "ε_{B}") if rocks else ("v_{B}", "a_{B}")
    units = ("1/s", "1/s²") if rocks else ("m/s", "m/s²")
    draft.open(VIEW)
    omega = draft.take(Number, "ω_1", made.order.speed, "1/s")
    ops = (follower_velocity, follower_acceleration)
    velocity, acceleration = (
        draft.draw(op, letter, omega, made.charts[k].ordinates[0], made.charts[k].mu, unit=unit)
        for op, letter, unit, k in zip(ops, letters, units, ("V", "A"), strict=True)
    )
    return Beside(velocity, acceleration)
