"""How many examples Hypothesis takes: a few every day, more in the whole run, all when measured."""

from __future__ import annotations

from hypothesis import settings

from support.turns import Wanted

FEW = 10
"""So many examples a property takes in the everyday run."""
SHARE = 3
"""Of the examples that a property asks for one of so many is taken in the whole run, and no fewer than `FEW`:
all with ``--measured``."""


def most(many: int) -> int:
    """Return so many examples if all are wanted, else a share of them, in the everyday run few.

    The profile of the run is loaded before any test is.
    """
    if Wanted.all:
        return many
    return min(many, FEW if settings.default.max_examples <= FEW else max(FEW, many // SHARE))
