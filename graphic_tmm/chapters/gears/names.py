"""Where what was made of a pair of gears is held."""

from __future__ import annotations

GEARS = "gears"
