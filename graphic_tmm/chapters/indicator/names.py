"""What others call what there is of an indicator diagram: views, places, what was made."""

from __future__ import annotations

INDICATOR = "indicator"
VIEW = "indicator"
CALCULATED = "indicator-calculation"
"""The view of what is calculated beside."""
