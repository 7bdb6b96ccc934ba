"""What machines are told of the structure of a mechanism."""

from __future__ import annotations

from graphic_tmm.chapters.structure.names import STRUCTURE_PLAN
from graphic_tmm.readers.measured import Tabled

TABLE = Tabled(
    facts=lambda drawn: {
        "W": STRUCTURE_PLAN.on(drawn).mobility,
        "formula": STRUCTURE_PLAN.on(drawn).formula,
    }
)
