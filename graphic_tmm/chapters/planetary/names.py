"""Where what was made of a planetary train is held."""

from __future__ import annotations

PLANETARY_TRAIN = "planetary"
