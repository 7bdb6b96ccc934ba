"""What people are told of a flywheel besides."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.flywheel.table import rim_too_wide
from graphic_tmm.chapters.kinematics.findings import assumed
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.symbols import plain
from graphic_tmm.readers.findings import Warned


def _warnings(drawn: Drawn, language: str) -> Iterator[str]:
    if wide := rim_too_wide(drawn, language):
        yield f"flywheel: {plain(wide)}"
    yield from assumed(drawn)


WARNINGS = Warned(_warnings)
