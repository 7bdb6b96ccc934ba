"""Cams whose laws are tables of displacements, drawn by themselves; differences of such tables by numpy."""

from __future__ import annotations

import numpy as np

from graphic_tmm.chapters.cam.kinds import Follower, RollerFollower
from graphic_tmm.chapters.cam.task import CamTask
from graphic_tmm.chapters.cam.task_motion import Law
from support.cams import Made, made

RISE, FALL, STROKE = 120.0, 90.0, 0.02


def table(heights: np.ndarray, angle: float, stroke: float = STROKE) -> list[tuple[float, float]]:
    """Lines of a table, of displacements 0 … 1."""
    steps = np.linspace(0.0, angle, len(heights))
    return [(float(a), float(stroke * y)) for a, y in zip(steps, heights, strict=True)]


def cam_of(rise: Law, fall: Law, follower: Follower | None = None, stroke: float = STROKE) -> Made:
    order = CamTask(
        stroke, RISE, 30.0, FALL, 120.0, rise_law=rise, return_law=fall, pressure=50.0,
        follower=follower or RollerFollower(), turns="clockwise",
    )  # fmt: skip
    return made(order)


def read_off(of: Made, phase: int) -> list[np.ndarray]:
    """S, dS/dφ, d²S/dφ² (SI) at the positions of a phase."""
    diagrams = of.cam.diagrams
    one = diagrams.turn.phases[phase]
    return [
        of.reading[d.readings[phase]][0, one.first : one.last + 1] * of.one(d.axes.mu)
        for d in (diagrams.S, diagrams.V, diagrams.A)
    ]


def by_differences(heights: np.ndarray, angle: float) -> list[np.ndarray]:
    """Differences of a table by numpy; at both ends at rest, by a cubic that is level there."""
    step = np.radians(angle) / (len(heights) - 1)
    first = STROKE * np.gradient(heights, step)
    first[[0, -1]] = 0.0
    inner = STROKE * np.convolve(heights, [1.0, -2.0, 1.0], "valid") / step**2
    ends = [
        STROKE * np.linalg.solve([[1 / 2, 1 / 6], [2, 8 / 6]], line[1:] - line[0])[0] / step**2
        for line in (heights[:3], heights[:-4:-1])
    ]
    return [STROKE * heights, first, np.array([ends[0], *inner, ends[1]])]
