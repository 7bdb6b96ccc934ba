"""The vector equations of a plan in lettering: group by group, lines under what is known, then directions."""

from __future__ import annotations

from collections.abc import Sequence

from graphic_tmm.board.record import Construction
from graphic_tmm.language.symbols import symbol
from graphic_tmm.paper.drawing import Drawing, Label
from graphic_tmm.paper.lettering.heights import HEIGHTS, Heights
from graphic_tmm.paper.lettering.letters import (
    letter,
)
from graphic_tmm.readers.equations import Equation, Term, heading

LEAD = 0.45
"""Clear height between two lines of lettering, of the height of their capitals."""


def draw_equations(
    construction: Construction,
    plan: str,
    title: str,
    found: Sequence[Equation],
    heights: Heights = HEIGHTS["A1"],
    language: str = "en",
) -> Drawing:
    """Return the equations of a plan under their title, each group's with its directions below it.

    What the log says of the crank stands first.
    """
    large, small = heights.point, heights.number
    told = [(text, large) for text in _crank(construction, plan)]
    for equation in found:
        told.append((f"{heading(equation.group, language)}:", small))
        told.append((equation.markup, large))
        told.append((f"({equation.directions})", small))
    rows = [(title, heights.title), *((symbol(text, language), size) for text, size in told)]
    labels, base = list[Label](), 0.0
    for text, size in rows:
        made = letter(text, size=size)
        base -= made.ascent + (0.0 if not labels else LEAD * size)
        labels.append(Label(text, complex(0.0, base), size))
        base -= made.descent
    return Drawing(f"equations-{plan}", title, labels=tuple(labels))


def _crank(construction: Construction, plan: str) -> list[str]:
    """Return what was said before the crank's vector was laid off; of two, that it is their sum."""
    notes = [step.note for step in construction.steps if step.it.view == plan and step.note]
    told = [note for note in notes if "=" in note]
    parts = [Term(note.partition(" = ")[0], known=True) for note in told]
    if len(parts) > 1:
        whole = Term(parts[0].symbol.partition("^")[0], known=True)
        told.append(" = ".join([whole.barred, " + ".join(map(str, parts))]))
    return told
