"""What people call the views of a pair of gears."""

from __future__ import annotations

from graphic_tmm.language.said import said

CAPTIONS: dict[str, str] = {
    "gear": said("Meshing of the gears"),
    "gear-dimensions": said("Dimensions of the gear pair"),
    "gear-rolling-1": said("Construction of a tooth of wheel 1"),
    "gear-rolling-2": said("Construction of a tooth of wheel 2"),
    "sliding": said("Specific sliding"),
}
