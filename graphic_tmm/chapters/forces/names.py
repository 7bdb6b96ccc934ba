"""What others call what there is of forces: views, places, what was made."""

from __future__ import annotations

FORCES = "forces"
LOADS = "load diagram"
"""The place of the diagrams of loads."""
