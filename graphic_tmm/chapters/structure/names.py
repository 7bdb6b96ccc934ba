"""What the structure of a mechanism is held by; its view, its places."""

from __future__ import annotations

from typing import TYPE_CHECKING

from graphic_tmm.scene.chapter import Made

if TYPE_CHECKING:
    from graphic_tmm.mechanism.structure import Structure

STRUCTURE = "structure"
STRUCTURE_PLAN: Made[Structure] = Made(STRUCTURE)

VIEW = "structure"
PARTS = "groups of structure"
"""The place of the parts by themselves."""
