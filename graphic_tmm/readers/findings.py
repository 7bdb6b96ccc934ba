"""Findings as sentences: what could not be drawn, what is in doubt, other warnings."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import ClassVar

from graphic_tmm.board.findings import Finding
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.language.catalogue import SOURCE, Speech, speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import plain, spoken
from graphic_tmm.language.units import unit
from graphic_tmm.project import Project
from graphic_tmm.readers.position_count import told_off
from graphic_tmm.readers.protocol import title_of
from graphic_tmm.readers.sentences import letters_of
from graphic_tmm.scene.chapter import Answer
from graphic_tmm.scene.checks import unplaced

_WHY = {
    "touching": said("the figures touch"),
    "doubtful": said("the point is uncertain, digits that are sure: {digits}"),
    "lost": said("rounding leaves no digit that is sure; left out: {letters}"),
    "idle": said("all forces are zero: there is nothing to draw, and no scale"),
}


def reason(found: Finding, project: Project, language: str) -> str:
    """Return why something cannot be drawn: plan, step, letter, what is missing."""
    _ = speaking(language)
    return _(
        "{plan}, step {number} '{it}': {why}",
        plan=_in_sentence(project, found.step.it.view, language),
        number=found.number,
        it=spoken(found.step.it, language),
        why=why_of(found, _),
    )


def finding(found: Finding, project: Project, language: str) -> str:
    """Return a finding as a sentence: plan, step, letter, why, positions."""
    _ = speaking(language)
    return _(
        "{plan}, step {number} '{it}': {why}; positions {places}",
        plan=_in_sentence(project, found.step.it.view, language),
        number=found.number,
        it=spoken(found.step.it, language),
        why=why_of(found, _),
        places=", ".join(project.names[i] for i in found.positions),
    )


def why_of(found: Finding, speech: Speech) -> str:
    """Return why something cannot be drawn, or is in doubt."""
    if found.kind == "undrawn":
        return _undrawn(found, speech)
    sure = max(0, math.floor(-math.log10(found.amount))) if 0.0 < found.amount < 1.0 else 0
    return speech(_WHY[found.kind], digits=sure, letters=_letters_of(found))


def _undrawn(found: Finding, speech: Speech) -> str:
    why = speech(found.step.op.fails)
    if found.gap is None:
        return why
    language = speech.language
    words = letters_of(found.step, lambda mark: spoken(mark, language))
    text = speech(found.gap.says).format(**words)
    return f"{why} ({text}, {number(found.amount, language, 3)} {unit('mm', language)})"


def _in_sentence(project: Project, view: str, language: str) -> str:
    """Return what a view is called within a sentence: small, but for a man's name."""
    name = title_of(project, view, language)
    return name if name.partition(" ")[0].endswith("'s") else name[:1].lower() + name[1:]


def left_out(found: Sequence[Finding], project: Project, language: str) -> Iterator[str]:
    """Yield, as sentences, the figures of which no digit is sure, together those of the same positions."""
    _ = speaking(language)
    for places in dict.fromkeys(one.positions for one in found):
        some = [one for one in found if one.positions == places]
        told = []
        for plan in dict.fromkeys(one.step.it.view for one in some):
            own = dict.fromkeys(_letters_of(one) for one in some if one.step.it.view == plan)
            letters = ", ".join(own)
            told.append(f"{_in_sentence(project, plan, language)} {letters}")
        yield _(
            "rounding leaves no digit that is sure, left out are: {figures}; positions {places}",
            figures="; ".join(told),
            places=", ".join(project.names[i] for i in places),
        )


def _letters_of(found: Finding) -> str:
    """Return the letters that are left out, each once, however often it is primed."""
    return ", ".join(dict.fromkeys(plain(mark.name).rstrip("′") for mark in found.marks))


SILENT = ("touching", "lost")
"""Kinds of findings that are no warning, or that share a sentence."""


@dataclass(frozen=True)
class Warned(Answer):
    """A chapter's own warnings of a drawing, sentences in a language.

    ``covers``: views of which these say together why steps cannot be drawn, so that no line a step does.
    """

    stands: ClassVar[str] = "findings.WARNINGS"
    warnings: Callable[[Drawn, str], Iterable[str]] = lambda drawn, language: ()
    covers: Callable[[Drawn], Iterable[str]] = lambda drawn: ()


def all_warnings(made: DrawnScene, language: str, *, sheets: bool = False) -> tuple[str, ...]:
    """Return all warnings of a drawn scene, sentences; ``sheets``: also of what no sheet shows."""
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
    return tuple(dict.fromkeys(_sentences(drawn, language, remedies)))


def _sentences(drawn: Drawn, language: str, remedies: bool) -> Iterator[str]:
    project, names = drawn.project, drawn.names
    if drawn.undrawn:
        missing = ", ".join(names[i] for i in drawn.undrawn)
        over = project.ranges(remedies=remedies)
        _ = speaking(language)
        yield _("positions {missing} cannot be drawn{over}", missing=missing, over=over)
    findings = drawn.findings()
    covered = {view for chapter in project.chapters for view in Warned.of(chapter).covers(drawn)}
    for one in findings:
        if one.kind not in SILENT and not (one.kind == "undrawn" and one.step.it.view in covered):
            yield finding(one, project, language)
    yield from left_out([f for f in findings if f.kind == "lost"], project, language)
    if off := told_off(drawn, language):
        yield plain("; ".join(off))
    for chapter in project.chapters:
        yield from map(speaking(language), Warned.of(chapter).warnings(drawn, language))
    yield from map(speaking(language), drawn.advice())
