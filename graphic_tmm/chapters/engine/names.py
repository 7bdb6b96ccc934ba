"""What others call what there is of an engine: views, places, what was made."""

from __future__ import annotations

ENGINE = "engine"
VIEW = "engine"
CALCULATED = "engine-calculation"
"""The view of what is calculated beside."""
MASSES = "engine-masses"
"""The view of the sum of the masses that go to and fro."""
WORKS_VIEW = "engine-works"
"""The view of the works over a turn."""
HARMONICS = "harmonics"
TRANSFER = "engine-148"
TRANSFER_PLACE = "engine forces"
"""The place of the figure of all forces."""
