"""What could not be drawn, why, and what else people are told of a drawing."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.drawn import Drawn
from graphic_tmm.language.words import finding, left_out

SILENT = ("touching", "lost")
"""Kinds of findings that are no warning, or are told together."""


def warnings(drawn: Drawn) -> tuple[str, ...]:
    """Return, for people, what could not be drawn, why, and over which range of the crank it could."""
    return tuple(dict.fromkeys(_told(drawn)))


def _told(drawn: Drawn) -> Iterator[str]:
    project, names = drawn.project, drawn.names
    if drawn.undrawn:
        missing = ", ".join(names[i] for i in drawn.undrawn)
        over = "".join(chapter.ranges(project) for chapter in project.chapters)
        yield f"positions {missing} cannot be drawn{over}"
    findings = drawn.findings()
    yield from (finding(f, names, "en") for f in findings if f.kind not in SILENT)
    yield from left_out([f for f in findings if f.kind == "lost"], names, "en")
    for chapter in project.chapters:
        yield from chapter.warnings(drawn, "en")
