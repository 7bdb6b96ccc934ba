"""Oracles of springs of followers: what closes the pair by the law; values of diagrams over the turn."""

from __future__ import annotations

import numpy as np

from graphic_tmm.chapters.cam.turn import TurnDiagram
from support.cams import Made, motion


def closing(of: Made, degrees: np.ndarray) -> np.ndarray:
    """What presses cam and follower together, N or N·m, from the law and the numbers of the spring."""
    order = of.cam.order
    S, _, A = motion(order, degrees)
    spring = of.one(of.cam.spring.preload) + of.one(of.cam.spring.rate) * S
    return spring + order.spring.load + order.spring.inertia * order.speed**2 * A


def values(of: Made, diagram: TurnDiagram) -> np.ndarray:
    """The ordinates of a diagram over the turn by stretch and position, in its unit."""
    rows = [of.reading[mark][0] for mark in diagram.chart.ordinates]
    return np.array(rows) * of.one(diagram.chart.mu)


def within(of: Made) -> np.ndarray:
    """The positions inside stretches: there the acceleration has one value."""
    rows = np.zeros((len(of.cam.diagrams.stretches), of.cam.diagrams.turn.positions), bool)
    for row, (_, first, last) in zip(rows, of.cam.diagrams.stretches, strict=True):
        row[first + 1 : last] = True
    return rows
