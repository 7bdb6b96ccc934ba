"""Mechanisms found from a task: recorded as calculated steps, so that the note can print them.

The rocker (coulisse) mechanism from K_v, the stroke and the centre distance: the angle of swing of the rocker
is θ = 180°·(K_v − 1)/(K_v + 1), the crank OA = OB·sin(θ/2), the rocker's arm BC = S/(2·sin(θ/2)).
"""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.board.execute import execute
from graphic_tmm.board.operations.formulas import half_chord, sine_of_half, swing_angle
from graphic_tmm.board.record import Board, Construction, Mark
from graphic_tmm.board.values import Number


class SynthesisLog(NamedTuple):
    """A synthesis: its log, the values given, and the marks of the lengths it finds."""

    construction: Construction
    given: dict[Mark, object]
    lengths: dict[str, Mark]

    def values(self) -> dict[str, float]:
        """Return the lengths found (m), by letters."""
        reading = execute(self.construction, self.given, self.lengths.values())
        return {name: float(reading[mark][0, 0]) for name, mark in self.lengths.items()}


def rocker(K_v: float, stroke: float, OB: float) -> SynthesisLog:
    """Record the synthesis of the rocker mechanism; K_v > 1, ``stroke`` and ``OB`` in metres."""
    board = Board()
    board.open("synthesis")
    ratio = board.take(Number, "K_v")
    travel = board.take(Number, "S", "m")
    centres = board.take(Number, "l_{OB}", "m")
    theta = board.draw(swing_angle, "θ", ratio)
    crank = board.draw(sine_of_half, "l_{OA}", centres, theta, unit="m")
    arm = board.draw(half_chord, "l_{BC}", travel, theta, unit="m")
    given: dict[Mark, object] = {ratio: K_v, travel: stroke, centres: OB}
    return SynthesisLog(board.construction(), given, {"OA": crank, "BC": arm, "OB": centres})


def rocker_lengths(K_v: float, stroke: float, OB: float) -> dict[str, float]:
    """Return OA, BC and OB (m) of the rocker mechanism found from the task.

    >>> {name: round(value, 5) for name, value in rocker_lengths(1.45, 0.095, 0.48).items()}
    {'OA': 0.13657, 'BC': 0.16694, 'OB': 0.48}
    """
    return rocker(K_v, stroke, OB).values()
