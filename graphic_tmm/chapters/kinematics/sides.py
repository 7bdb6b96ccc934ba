"""On which side, or near which place, each group stands at an angle of the crank: as told, or carried on."""

from __future__ import annotations

from typing import Protocol

import numpy as np

from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.kinematics.bodies import Positions
from graphic_tmm.chapters.kinematics.positions import side_record
from graphic_tmm.mechanism.records import Drive, Mechanism, Side

LAST = 12
"""Decimals of an angle in degrees that are not rounding."""


class Plans(Protocol):
    """Plans of a mechanism whose groups have sides."""

    @property
    def mechanism(self) -> Mechanism:
        """The mechanism that they are of."""

    @property
    def positions(self) -> Positions:
        """The plan of positions, whose marks of sides are given."""


def standing(plans: Plans, angles: Reals, *, carried: bool = False) -> dict[Mark, object]:
    """Return what the groups that flip are given at crank angles, degrees (trial, position).

    ``carried``: on from the first of the angles in the sense of the drive; else as the scene says of each. A
    side that holds for the whole turn was given when the group was drawn.
    """
    given: dict[Mark, object] = {}
    for closing in plans.positions.closings:
        given |= closing.placed(angles)
        side = side_record(plans.mechanism, closing.group)
        if side is not None and side.flips_at:
            drive = plans.mechanism.drive
            values = sides_at(side, angles, drive) if carried else side_values(side, angles)
            given[plans.positions.sides[closing.group.name]] = values
    return given


def side_values(side: Side, degrees: object) -> object:
    """Return the sign at crank angles (degrees): constant, or changed at each of ``flips_at``.

    The scene's sign is the one just behind the angle 0°; in the range from 0° to the next flip.
    """
    if not side.flips_at:
        return float(side.sign)
    angles = np.asarray(degrees, dtype=np.float64) % 360.0
    flips = np.sort(np.asarray(side.flips_at, dtype=np.float64) % 360.0)
    flips = flips[flips > 0.0]
    return side.sign * np.where(np.searchsorted(flips, angles, side="right") % 2 == 0, 1.0, -1.0)


def sides_at(side: Side, angles: Reals, drive: Drive) -> object:
    """Return the side in every position, carried on from the zero position in the sense of the drive.

    With an odd number of flips (a pin that passes over another once a turn) the mechanism comes back to
    its zero position only after two turns; the one turn drawn then ends on the other side.
    """
    if len(side.flips_at or ()) % 2 == 0:
        return side_values(side, angles)
    sense = float(drive.sense)
    start = angles[0, 0]
    travelled = np.round((angles - start) * sense, LAST) % 360.0
    flips = np.round((np.asarray(side.flips_at, dtype=np.float64) - start) * sense, LAST) % 360.0
    passed = (flips[:, None, None] <= travelled[None]) & (travelled[None] > 0.0)
    if sense > 0:
        passed &= flips[:, None, None] > 0.0
    return side_values(side, start) * np.where(passed.sum(axis=0) % 2 == 0, 1.0, -1.0)
