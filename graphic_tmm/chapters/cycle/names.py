"""Where what was made of a cycle of moments is held."""

from __future__ import annotations

CYCLE = "cycle"
