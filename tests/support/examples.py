"""How many examples Hypothesis takes: a few every day, more in CI."""

from __future__ import annotations

from hypothesis import settings

FEW = 10
"""So many examples a property takes in the everyday run."""


def most(many: int) -> int:
    """Return so many examples, but in the everyday run, whose profile is loaded before any test is, few."""
    return min(many, FEW) if settings.default.max_examples <= FEW else many
