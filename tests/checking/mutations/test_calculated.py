"""Formulas calculated otherwise: what is told of them is what is computed."""

from __future__ import annotations

import math

import numpy as np
import pytest

from graphic_tmm.board.formula import FORMULAS
from graphic_tmm.board.formula_text import FUNCTIONS, tree_of, tree_text
from graphic_tmm.board.grammar import OPERATIONS
from graphic_tmm.checking.mutations.calculated import is_product, otherwise, with_sense
from graphic_tmm.checking.mutations.mutation import FACTOR, LEFT_OUT, POWER, SENSE
from graphic_tmm.scene.chapter import whole_book


def value(text: str, **names: float) -> float:
    """Return what a text says, by Python's own reading of it: nothing of the package."""
    for power, sign in (("²", "**2"), ("·", "*"), ("−", "-"), ("π", "math.pi")):
        text = text.replace(power, sign)
    return float(eval(text.format(**{k: f"({v!r})" for k, v in names.items()}), {"math": math}))


def test_texts_are_read_back() -> None:
    whole_book()
    for name, formula in FORMULAS.items():
        tree = tree_of(formula.text, FUNCTIONS)
        assert tree_of(tree_text(tree), FUNCTIONS) == tree, name


@pytest.mark.parametrize("name", ["normal", "coriolis", "rate", "product_of_squares", "total"])
def test_what_is_told_is_what_is_computed(name: str) -> None:
    op = OPERATIONS[name]
    figures = [1.7, 0.31, 2.3, 0.77, 1.21][: len(op.arguments)]
    found = otherwise(op)
    assert len({one.op.formula for one in found}) == len(found) >= 3
    for one in found:
        told = value(one.op.formula, **dict(zip(op.arguments, figures, strict=True)))
        computed = one.op.run(*(np.full((1, 1), figure) for figure in figures))
        assert float(np.ravel(computed)[0]) == pytest.approx(told, rel=1e-12), one.op.formula
        assert told != pytest.approx(
            value(op.formula, **dict(zip(op.arguments, figures, strict=True)))
        )


def test_the_usual_ones_are_there() -> None:
    def of(name: str) -> dict[str, str]:
        return {one.op.formula: one.family for one in otherwise(OPERATIONS[name])}

    assert of("normal")["{segment}·{mu_v}/({link}·{mu_l})/{mu_a}"] == POWER
    assert of("normal")["{segment}²·{mu_v}/({link}·{mu_l})/{mu_a}"] == POWER
    assert of("normal")["({segment}·{mu_v})²/({link}·{mu_l})²/{mu_a}"] == POWER
    assert of("rate")["{segment}·{mu}/({link}·{mu_l})²"] == POWER
    assert of("coriolis")["{omega}·{segment}·{mu_v}/{mu_a}"] == FACTOR
    assert of("product_of_squares")["{omega}·{length}"] == POWER
    assert of("rate")["{link}·{mu_l}/({segment}·{mu})"] == POWER
    assert of("total") == {
        "{first}": LEFT_OUT,
        "{second}": LEFT_OUT,
        "{first} − {second}": SENSE,
    } | {text: family for text, family in of("total").items() if family == POWER}
    assert otherwise(OPERATIONS["lay_off"]) == ()


def test_a_product_keeps_the_sense_of_the_right_one() -> None:
    right = OPERATIONS["coriolis"]
    assert is_product(right)
    assert not is_product(OPERATIONS["total"])
    squared = next(one.op for one in otherwise(right) if one.op.formula.startswith("2·{omega}²"))
    given = [np.array([[x]]) for x in (-2.0, 3.0, 0.5, 0.25)]
    assert with_sense(squared, right).run(*given)[0, 0] == pytest.approx(-2 * 4 * 3 * 0.5 / 0.25)
