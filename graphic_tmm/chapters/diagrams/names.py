"""What others call what there is of the diagrams: views, places, what was made."""

from __future__ import annotations

DIAGRAMS = "diagrams"
VIEWS = {"S": "diagram S", "V": "diagram V", "a": "diagram a"}
BASE_VIEW = "base"
"""Under which the scale of the common base is told."""
CALCULATED = "diagrams-calculation"
"""The view of what is calculated beside."""
