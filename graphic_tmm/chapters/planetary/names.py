"""Where what was made of a planetary train is held."""

from __future__ import annotations

from typing import TYPE_CHECKING

from graphic_tmm.scene.chapter import Made

if TYPE_CHECKING:
    from graphic_tmm.chapters.planetary.plan import Planetary

PLANETARY_TRAIN: Made[Planetary] = Made("planetary")
