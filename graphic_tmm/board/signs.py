"""What is known of the sign of a number on a tape, whatever it comes to: passes are spared by it.

A sum with nothing changes the sign of a zero at most, and so does a sum with −0 not even that.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from enum import IntEnum


class Sign(IntEnum):
    """What is known: nothing; that no zero of it is −0; that, and that nothing of it is below 0."""

    FREE = 0
    UNSIGNED = 1
    POSITIVE = 2


_KEEPING = frozenset({"floor", "ceil", "rint", "choose"})
"""Passes that leave nothing below 0, and no −0, where what they take is so."""


def of_known(number: float) -> Sign:
    """Return the sign of a number that is known."""
    if number == 0.0:
        return Sign.FREE if math.copysign(1.0, number) < 0.0 else Sign.POSITIVE
    return Sign.POSITIVE if number > 0.0 else Sign.UNSIGNED


def of_pass(does: str, takes: Sequence[Sign], *, alike: bool) -> Sign:
    """Return the sign of what a pass leaves; ``alike``: it takes one number twice."""
    if does in ("absolute", "length") or (does == "multiply" and alike):
        return Sign.POSITIVE
    if does == "add":
        # two zeros make −0 only where both are
        return Sign.POSITIVE if min(takes) == Sign.POSITIVE else min(max(takes), Sign.UNSIGNED)
    if does == "subtract":
        return min(takes[0], Sign.UNSIGNED)
    if does in ("multiply", "divide"):
        return Sign.POSITIVE if min(takes) == Sign.POSITIVE else Sign.FREE
    if does == "sqrt":
        # of what is below 0 it is NaN, of −0 it is −0
        return Sign.POSITIVE if takes[0] else Sign.FREE
    if does == "copysign":
        return Sign.POSITIVE if takes[1] == Sign.POSITIVE else Sign.FREE
    if does in _KEEPING:
        least = min(takes)
        return least if does == "choose" or least == Sign.POSITIVE else Sign.FREE
    return Sign.FREE
