"""Whether a log is executed step by step or compiled.

It depends on what is asked for and on nothing that went before: the same scene gives the same bytes. The few
positions of sheets are executed step by step always.
"""

from __future__ import annotations

from functools import cache
from importlib.util import find_spec

PAYS = 20_000_000
"""Steps times positions that take numpy as long as it takes to load the translator and to compile."""


def compiles(fast: bool | None, steps: int, count: int) -> bool:
    """Return whether so many steps are compiled to run at so many positions.

    ``fast``: what is asked for; None: where it pays and the translator is there.
    """
    return steps * count >= PAYS and translator() if fast is None else fast


@cache
def translator() -> bool:
    """Whether that is installed which logs are compiled with."""
    return find_spec("llvmlite") is not None
