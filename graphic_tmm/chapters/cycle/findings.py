"""What people are told of a cycle besides."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.cycle.table import cycle_results
from graphic_tmm.chapters.flywheel.table import rim_too_wide
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.readers.findings import Warned


def _warnings(drawn: Drawn, language: str) -> Iterator[str]:
    if wide := rim_too_wide(single(cycle_results(drawn)), language):
        yield wide


WARNINGS = Warned(_warnings)
