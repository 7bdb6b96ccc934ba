"""Formulas of a note read back as they are printed: a letter that is a sum stands in brackets as a factor."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator

import pytest
from support.laid_out import note_of_case
from support.notes import noted
from support.tex_sums import Unread, worked_out

from graphic_tmm.note.document import (
    Document,
    Formula,
    Leaf,
    Number,
    Source,
    Symbol,
    Tree,
    runs_of,
    walk,
)
from graphic_tmm.note.tex import spelt, tex

SUM = re.compile(r"(?<=[\w}\])′])[−+]")
"""A letter that is told as a sum or a difference: M_max−M_min."""
BRACKETED = re.compile(r"\(.*\)|\[.*\]")
AWAY = Source("scene", "", "")
FIGURE, SUMMED = Number("5", "", AWAY, 5.0), ("7−2", "(7−2)")


def _trees(document: Document) -> Iterator[tuple[Tree, bool]]:
    for block in walk(document.blocks):
        for run in runs_of(block):
            if isinstance(run, Formula):
                yield from ((side, run.flat) for side in run.sides if isinstance(side, Tree))


def _told(leaf: Leaf) -> Leaf:
    """A letter as a figure; one that is a sum as a sum of figures, in its brackets if it has them."""
    if not isinstance(leaf, Symbol) or not SUM.search(leaf.markup):
        return FIGURE
    return Symbol(SUMMED[bool(BRACKETED.fullmatch(leaf.markup))])


def _wrong(document: Document) -> Iterator[str]:
    for tree, flat in _trees(document):
        plain = Tree(tree.node, dict.fromkeys(tree.put, FIGURE))
        summed = Tree(tree.node, {name: _told(leaf) for name, leaf in tree.put.items()})
        try:
            due, found = (
                worked_out(tex(Formula((one,), flat=flat), "ru", spelt)).value
                for one in (plain, summed)
            )
        except (Unread, ZeroDivisionError, ValueError):
            continue
        if not math.isclose(due, found, rel_tol=1e-9, abs_tol=1e-12):
            yield tex(Formula((tree,), flat=flat), "ru", spelt)


@pytest.mark.parametrize("name", ["slotting", "project", "engine", "four-stroke"])
@pytest.mark.slow
def test_no_bracket_is_lacking(name: str) -> None:
    document = note_of_case(name) if name == "slotting" else noted(name)
    assert sum(1 for _ in _trees(document)) > 30
    assert list(_wrong(document)) == []


def test_some_letters_are_sums() -> None:
    """M_max − M_min, which stands above a stroke: the test above would be empty without it."""
    letters = {
        leaf.markup
        for tree, _ in _trees(note_of_case("slotting"))
        for leaf in tree.put.values()
        if isinstance(leaf, Symbol)
    }
    assert any(SUM.search(letter) for letter in letters)
