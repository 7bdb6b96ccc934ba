"""Letters of a cam in a note: those of its drawing, one for each quantity, all of them explained."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterator

import pytest
from support.notes import noted

from graphic_tmm.note.document import (
    Display,
    Document,
    Formula,
    Number,
    Paragraph,
    Symbol,
    Text,
    Tree,
    leaves,
    runs_of,
    walk,
)
from graphic_tmm.note.tex import tex

PHASES, PLACE = {"1", "2", "3", "4"}, "k"
"""The indices that phases have in the data and on the drawing; that of a place on the base."""


def _formulas(document: Document) -> Iterator[Formula]:
    for block in walk(document.blocks):
        if isinstance(block, Display):
            yield from block.formulas


@pytest.mark.parametrize("language", ["ru", "en"])
def test_phases_are_called_as_on_the_drawing(language: str) -> None:
    letters = {
        leaf.markup
        for one in _formulas(noted("cam", language))
        for side in one.sides
        for leaf in leaves(side)
        if isinstance(leaf, Symbol)
    }
    indices = {found[1] for name in letters if (found := re.fullmatch(r"Δ?[φΦ]_\{?(\w+)\}?", name))}
    assert indices == PHASES | {PLACE}
    assert {"r_{0min}", "[α]"} <= letters
    assert not {"r_{min}", "[α_{r}]", "[α_{f}]"} & letters


def test_a_letter_is_calculated_by_one_formula() -> None:
    ways = defaultdict(set)
    for one in _formulas(noted("cam")):
        first, *others = one.sides
        trees = [side for side in others if isinstance(side, Tree)]
        if isinstance(first, Symbol) and trees:
            ways[first.markup].add(tex(Formula((trees[0],)), "ru"))
    assert len(ways) > 15
    assert {letter: told for letter, told in ways.items() if len(told) > 1} == {}


def test_the_letters_of_the_curvature_are_explained() -> None:
    document = noted("cam")
    (turning,) = (
        one for one in _formulas(document) if one.sides[0] == Symbol("τ") and len(one.sides) > 2
    )
    letters = {leaf for leaf in leaves(turning.sides[1]) if isinstance(leaf, Symbol)}
    explained = {
        run
        for block in walk(document.blocks)
        if isinstance(block, Paragraph)
        for run in runs_of(block)
        if isinstance(run, Symbol)
    }
    assert len(letters) == 4
    assert letters <= explained


def test_a_pressure_angle_that_is_read_has_the_digits_of_its_table() -> None:
    """A protractor tells no hundredth of a degree."""
    told = [
        run.text
        for block in noted("cam", "en").blocks
        if isinstance(block, Paragraph)
        and any(isinstance(run, Text) and "read between OQ" in run.text for run in block.runs)
        for run in block.runs
        if isinstance(run, Number)
    ]
    assert [len(angle.partition(".")[2]) for angle in told] == [1]
