"""What others call what there is of a cam: views, places, what was made."""

from __future__ import annotations

CAM = "cam"
GRAPHS = "cam graphs"
"""The size of a cam's diagrams; that of its other views is called as the chapter is."""
