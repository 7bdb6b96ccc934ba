"""Where what was made of a cycle of moments is held."""

from __future__ import annotations

from typing import TYPE_CHECKING

from graphic_tmm.scene.chapter import Made

if TYPE_CHECKING:
    from graphic_tmm.chapters.cycle.plan import Cycle

CYCLE: Made[Cycle] = Made("cycle")
