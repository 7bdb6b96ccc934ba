"""What tables tell of a flywheel for a cycle."""

from __future__ import annotations

from graphic_tmm.chapters.cycle.views import cycle_columns, cycle_results
from graphic_tmm.readers.measured import Tabled

TABLE = Tabled(columns=cycle_columns, results=cycle_results)
