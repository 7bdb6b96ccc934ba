"""What people are told of a flywheel besides."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.flywheel.table import flywheel_results, rim_too_wide
from graphic_tmm.chapters.kinematics.findings import assumed
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.readers.findings import Warned


def _warnings(drawn: Drawn, language: str) -> Iterator[str]:
    if wide := rim_too_wide(single(flywheel_results(drawn)), language):
        yield wide
    yield from assumed(drawn)


WARNINGS = Warned(_warnings)
