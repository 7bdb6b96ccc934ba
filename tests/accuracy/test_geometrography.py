"""Lemoine's coefficients: every operation of the board has some, and his own figures come out."""

from __future__ import annotations

import importlib
import pkgutil

import pytest
from support.each import each

import graphic_tmm
from graphic_tmm.accuracy.geometrography import (
    ELEMENTARY,
    elements,
    exactitude,
    simplicity,
    symbol,
    written,
)
from graphic_tmm.board.grammar import JOIN, OPERATIONS, READ, Operation
from graphic_tmm.board.operations.locus import refinement

for module in pkgutil.walk_packages(graphic_tmm.__path__, "graphic_tmm."):
    if not module.name.endswith("__main__"):
        importlib.import_module(module.name)

BOARD = list(OPERATIONS.values())
DRAWN = [op for op in BOARD if not op.formula]
REFINE = refinement(lambda row: row, "")


def test_every_operation_that_is_no_formula_says_its_symbol() -> None:
    silent = [op for op in DRAWN if op.symbol is None]
    assert not [op.name for op in silent if not (op.reads or op.looked_up or op.kept)]
    assert len(DRAWN) > 60


def test_no_formula_says_a_symbol() -> None:
    assert not [op.name for op in BOARD if op.formula and op.symbol is not None]


@each("op", [*BOARD, REFINE])
def test_every_symbol_can_be_read_and_prepares_no_more_than_there_is(op: Operation) -> None:
    found = elements(symbol(op), 3)
    assert set(found) <= set(ELEMENTARY)
    assert 0 <= exactitude(found) <= simplicity(found)
    if op.formula:
        assert found == {"N1": 1}


def test_every_elementary_operation_is_used_by_some() -> None:
    used = {name for op in [*BOARD, REFINE] for name in elements(symbol(op), 1)}
    assert used == set(ELEMENTARY)


def test_only_what_goes_through_a_row_depends_on_its_length() -> None:
    for op in BOARD:
        of_row = elements(symbol(op), 1) != elements(symbol(op), 2)
        knows = "row" in op.choices or {"first", "last"} <= set(op.choices)
        assert not of_row or (op.across and knows), op.name


def test_what_is_read_off_the_ruler_reads_some_scale() -> None:
    scales = {"M3", "P3", "A2"}
    for op in DRAWN:
        if op.reads:
            assert scales & set(elements(symbol(op))), op.name


LEMOINE = [
    # a line through two points; a circle of a given radius about a given centre; the two circles and the
    # line that halve a segment; the point symmetrical to another about a line, by two circles
    (["join"], {"R1": 2, "R2": 1}, 3, 2),
    (["strike"], {"C1": 3, "C3": 1}, 4, 3),
    (["halve"], {"R1": 2, "R2": 1, "C1": 2, "C3": 2}, 7, 4),
    (["reflect"], {"C1": 2, "C2": 2, "C3": 2}, 6, 4),
    (["meet"], {}, 0, 0),
    # the parallel through a point with the square
    (["parallel"], {"E1": 1, "E2": 1, "R2": 1}, 3, 2),
    # a triangle on a drawn base from the lengths of two sides
    (["strike", "strike", "cross", "join", "join"], {"C1": 6, "C3": 2, "R1": 4, "R2": 2}, 14, 10),
]


@pytest.mark.parametrize(("names", "due", "simple", "exact"), LEMOINE)
def test_what_a_textbook_draws_is_counted_by_lemoines_rules(
    names: list[str], due: dict[str, int], simple: int, exact: int
) -> None:
    found = sum((elements(symbol(OPERATIONS[name])) for name in names), elements(""))
    assert found == due
    assert (simplicity(found), exactitude(found)) == (simple, exact)


def test_lines_drawn_and_circles_drawn_are_simplicity_less_exactitude() -> None:
    for op in BOARD:
        found = elements(symbol(op))
        if set(found) <= {"R1", "R2", "C1", "C2", "C3"}:
            assert simplicity(found) - exactitude(found) == found["R2"] + found["C3"]


def test_an_operation_that_says_no_symbol_has_that_of_its_sort() -> None:
    new = OPERATIONS["join"]._replace(name="new", symbol=None)
    assert symbol(new) == JOIN
    assert symbol(new._replace(formula="{a}")) == symbol(new._replace(looked_up=True)) == "N1"
    assert symbol(new._replace(reads=True)) == READ


@pytest.mark.parametrize("text", ["2Q1", "R1+R2", "R", "n", "R1 + ", " ", "-R1"])
def test_what_is_no_symbol_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match="no elementary operation"):
        elements(text)


def test_a_symbol_is_written_as_it_is_read() -> None:
    found = elements("nK1 + K2 + 2R1 + nK2", 4)
    assert written(found) == "2R1 + 4K1 + 5K2"
    assert elements(written(found)) == found
    assert elements("nK1", 0) == {}
    assert written({}) == ""
