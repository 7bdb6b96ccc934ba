"""How well motion is passed on: over a turn, and in the position that shows a mechanism best."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.chapters.kinematics.bodies import Closing, GuideLeg, PinLeg
from graphic_tmm.chapters.kinematics.survey import Survey

POOR = 0.35
"""Where motion is passed on worse than this at all of some positions, another is looked for."""
DIGITS = 9
"""Decimals of what is compared that are not rounding."""


def best(tried: Survey, angles: Reals, wanted: Sequence[int], all: Sequence[int]) -> int:
    """Return the position (index) that shows the mechanism best: the first in which motion is passed on best.

    It is one of those ``wanted`` (with plans of their own); where motion is passed on poorly in all of these,
    one of ``all``. ``angles``: of the crank in every position, degrees.
    """
    passed = np.nan_to_num(transmission(tried, angles), nan=-1.0)
    rows = np.round(passed, DIGITS)
    found = [max(places, key=lambda k: rows[k]) for places in (wanted, all) if places]
    return found[0] if rows[found[0]] >= POOR else found[-1]


def least_angle(tried: Survey) -> float:
    """Return the least transmission angle of a mechanism over a turn, degrees; NaN where there is none.

    The transmission angle of a group is the acute one of both lines of its velocities at its closing point: of
    a four-bar that between coupler and rocker, of a slider that between its rod and what is square to its
    guide, of a stone that between its guide and what is square to the arm of the link that it slides on.
    """
    closings = tried.positions.closings
    _, reading = tried.turn([leg.line for closing in closings for leg in closing.legs])
    with np.errstate(all="ignore"):
        sines = [float(np.nanmin(_sine(reading, one), initial=np.inf)) for one in closings]
    least = min(sines, default=1.0)
    return float(np.degrees(np.arcsin(min(least, 1.0)))) if np.isfinite(least) else np.nan


def transmission(tried: Survey, angles: Reals) -> Reals:
    """Return how well motion is passed on at crank angles (degrees): 1 at its best, 0 at a dead centre.

    The smallest over all groups of the sine of the angle at which both lines of its velocities meet, of the
    speed of its closing point as a share of the largest, and of the sine of the angle between the crank and
    what hangs on its pin, which else lies on the crank.
    """
    body = tried.positions.bodies[tried.structure.driver]
    crank = (body.marks[tried.structure.pivot], body.marks[tried.structure.pin])
    groups = [(c, tried.velocities.closed[c.group.name]) for c in tried.positions.closings]
    lines = [leg.line for closing, _ in groups for leg in closing.legs]
    row = angles.astype(np.float64)[None, :]
    reading = tried.at(row, [*crank, *lines, *(image for _, image in groups)])
    arm = reading[crank[1]] - reading[crank[0]]
    found = [np.ones(row.shape)]
    for closing, image in groups:
        found += [_sine(reading, closing), _speed(reading, image)]
        pinned = (leg for leg in closing.legs if isinstance(leg, PinLeg) or leg.inner)
        hung = [leg.line for leg in pinned if leg.body == body.link.number]
        found += [np.abs((np.conj(arm) * reading[line].along).imag) / np.abs(arm) for line in hung]
    shares = np.stack([np.broadcast_to(one, row.shape) for one in found])
    return np.asarray(np.min(shares, axis=0)[0])


def _sine(reading: Reading, closing: Closing) -> Reals:
    first, second = (_way(reading, leg) for leg in closing.legs)
    return np.asarray(np.abs((np.conj(first) * second).imag))


def _way(reading: Reading, leg: PinLeg | GuideLeg) -> Complexes:
    """The direction of the velocity that a leg leaves free: square to a link, along a guide."""
    along = np.asarray(reading[leg.line].along)
    return along * 1j if isinstance(leg, PinLeg) else along


def _speed(reading: Reading, image: Mark) -> Reals:
    speed = np.asarray(np.abs(reading[image]))
    there = speed[np.isfinite(speed)]
    most = float(there.max()) if there.size else 0.0
    return speed / most if most > 0.0 else np.ones_like(speed)
