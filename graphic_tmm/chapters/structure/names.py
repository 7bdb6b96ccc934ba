"""The view and the place of a structure by its parts."""

from __future__ import annotations

VIEW = "structure"
PARTS = "groups of structure"
"""The place of the parts by themselves."""
