"""Which road a log takes to its numbers: executed step by step, in lines of passes, or compiled.

It hangs on what is asked for and on nothing that went before: the same scene gives the same bytes. The few
positions of sheets are executed step by step always.
"""

from __future__ import annotations

from enum import Enum
from functools import cache
from importlib.util import find_spec

PAYS = 20_000_000
"""Steps times positions that take numpy as long as it takes to load the translator and to compile."""


MANY = 1 << 16
"""Positions from which on it pays to write executed steps as one line of passes."""


class Road(Enum):
    """How steps come to their numbers."""

    STEPS = "one by one, in blocks of positions"
    LINES = "as lines of passes"
    LOOPS = "compiled"


def road(fast: bool | None, steps: int, count: int) -> Road:
    """Return the road of so many steps at so many positions.

    ``fast``: whether they are to be compiled; None where that pays.
    """
    if steps * count >= PAYS and translator() if fast is None else fast:
        return Road.LOOPS
    return Road.LINES if count >= MANY else Road.STEPS


@cache
def translator() -> bool:
    """Whether that is installed which logs are compiled with."""
    return find_spec("llvmlite") is not None
