"""What could not be drawn, why, and what else people are told of a drawing."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import ClassVar

from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.language.catalogue import SOURCE, speaking
from graphic_tmm.language.names import plain
from graphic_tmm.readers.divided import told_off
from graphic_tmm.readers.findings import finding, left_out
from graphic_tmm.scene.chapter import Answer
from graphic_tmm.scene.remarks import unplaced

SILENT = ("touching", "lost")
"""Kinds of findings that are no warning, or are told together."""


@dataclass(frozen=True)
class Warned(Answer):
    """What people are told of a drawing by a chapter, in a language, besides what cannot be drawn."""

    stands: ClassVar[str] = "findings.WARNINGS"
    warnings: Callable[[Drawn, str], Iterable[str]] = lambda drawn, language: ()


def all_warnings(made: DrawnScene, language: str, *, sheets: bool = False) -> tuple[str, ...]:
    """Return what of a scene comes to nothing or could not be drawn; ``sheets``: and what no sheet shows."""
    told = (
        *made.scene.remarks,
        *made.scene.left_out.values(),
        *(unplaced(made.scene) if sheets else ()),
    )
    found = [text for drawn in made.boards for text in warnings(drawn, language)]
    return (*map(speaking(language), told), *found)


def warnings(drawn: Drawn, language: str = SOURCE, *, remedies: bool = True) -> tuple[str, ...]:
    """Return, for people, what could not be drawn, why, and over which range of the crank it could.

    ``remedies``: with what the scene's author may write instead, which no reader of a note can use.
    """
    return tuple(dict.fromkeys(_told(drawn, language, remedies)))


def _told(drawn: Drawn, language: str, remedies: bool) -> Iterator[str]:
    project, names = drawn.project, drawn.names
    if drawn.undrawn:
        missing = ", ".join(names[i] for i in drawn.undrawn)
        over = project.ranges(remedies=remedies)
        _ = speaking(language)
        yield _("positions {missing} cannot be drawn{over}", missing=missing, over=over)
    findings = drawn.findings()
    yield from (finding(f, project, language) for f in findings if f.kind not in SILENT)
    yield from left_out([f for f in findings if f.kind == "lost"], project, language)
    if off := told_off(drawn, language):
        yield plain("; ".join(off))
    for chapter in project.chapters:
        yield from map(speaking(language), Warned.of(chapter).warnings(drawn, language))
    yield from map(speaking(language), drawn.advice())
