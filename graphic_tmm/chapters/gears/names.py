"""Where what was made of a pair of gears is held."""

from __future__ import annotations

from typing import TYPE_CHECKING

from graphic_tmm.scene.chapter import Made

if TYPE_CHECKING:
    from graphic_tmm.chapters.gears.plan import Gear

GEARS: Made[Gear] = Made("gears")
