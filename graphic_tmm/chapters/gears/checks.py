"""Is the pair a good one? Named results, each a value against the least it may be."""

from __future__ import annotations

from dataclasses import dataclass

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import Reading
from graphic_tmm.board.geometry import EPS
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.gears.dimensions import VIEW, GearSizes

ROUNDING = 64 * EPS
"""A value that is short of its limit by less than this share of what it is made of stands on it."""


@dataclass(frozen=True)
class Check:
    """``value`` shall not be less than ``least`` (both Number); ``scale``: the size of what they are made of.

    ``name``: "pointed tooth" (tip thickness against 0), "tip thickness" (against its usual limit), "undercut"
    (shift against the least one), "interference" (the lowest working radius of curvature against that at which
    the flank begins), "clearance" (at the root), "contact ratio". ``wheel``: 0 for the pair.
    """

    name: str
    wheel: int
    value: Mark
    least: Mark
    scale: float


@dataclass(frozen=True)
class Verdict:
    """A check with its numbers (m, or a coefficient): does it hold?"""

    name: str
    wheel: int
    value: float
    least: float
    unit: str
    holds: bool


def record_checks(draft: Draft, sizes: GearSizes) -> tuple[Check, ...]:
    """Record the limits of the checks."""
    draft.open(VIEW)
    zero = draft.take(Number, "0", 0.0, "m")
    one = draft.take(Number, "[ε_{α}]", 1.0)
    teeth, found = float(sizes.order.z1 + sizes.order.z2), []
    size = sizes.order.m * teeth
    for wheel in sizes.wheels:
        i = wheel.number
        found += [
            Check("pointed tooth", i, wheel.s_a, zero, size),
            Check("tip thickness", i, wheel.s_a, sizes.least_tip, size),
            Check("undercut", i, wheel.x, wheel.x_min, teeth),
            Check("interference", i, wheel.lowest, wheel.free, size),
            Check("clearance", i, wheel.clearance, zero, size),
        ]
    return (*found, Check("contact ratio", 0, sizes.contact_ratio, one, teeth))


def verdicts(checks: tuple[Check, ...], reading: Reading) -> tuple[Verdict, ...]:
    """Return the checks with their numbers, in their order."""
    found = []
    for check in checks:
        value, least = (float(reading[mark][0, 0]) for mark in (check.value, check.least))
        holds = value >= least - ROUNDING * check.scale
        found.append(Verdict(check.name, check.wheel, value, least, check.value.unit, holds))
    return tuple(found)
