"""Formulas as TeX: what a tree says is what is written, so that a reader who computes it finds the same."""

from __future__ import annotations

import pytest

from graphic_tmm.board.formula_text import FUNCTIONS, tree_of
from graphic_tmm.note.document import Formula, Number, Source, Symbol, Tree
from graphic_tmm.note.tex import spelt, tex
from graphic_tmm.note.widths import broken, packed

HERE = Source("mark", "mechanism", "0")


def told(text: str, **put: str | float) -> str:
    """A formula as TeX, its names put in: mark-up or a value."""
    leaves = {
        name: Symbol(value)
        if isinstance(value, str)
        else Number(f"{value:g}".replace("-", "−").replace(".", ","), "", HERE, value)
        for name, value in put.items()
    }
    return tex(Tree(tree_of(text, FUNCTIONS), leaves), "ru", spelt)


@pytest.mark.parametrize(
    ("text", "put", "due"),
    [
        ("{a}·{b}", {"a": "v_A", "b": "l_{AB}"}, r"v_{A} \cdot l_{AB}"),
        ("{a}/{b}", {"a": 1.5, "b": 2.0}, r"\frac{1{,}5}{2}"),
        ("({a} + {b})/{c}", {"a": "a", "b": "b", "c": "c"}, r"\frac{a + b}{c}"),
        ("({a} + {b})·{c}", {"a": "a", "b": "b", "c": "c"}, r"\left(a + b\right) \cdot c"),
        ("{a} − ({b} − {c})", {"a": "a", "b": "b", "c": "c"}, r"a - \left(b - c\right)"),
        ("{a}·{b}", {"a": 2.0, "b": -3.0}, r"2 \cdot \left(-3\right)"),
        ("{a}²", {"a": -3.0}, r"{\left(-3\right)}^{2}"),
        ("({a}·{b})²", {"a": "a", "b": "b"}, r"{\left(a \cdot b\right)}^{2}"),
        ("{a}/{b}/{c}", {"a": "a", "b": "b", "c": "c"}, r"\frac{a}{b \cdot c}"),
        ("|{a}|", {"a": "a"}, r"\left| a \right|"),
        ("√{a}", {"a": "a"}, r"\sqrt{a}"),
        ("sin({a})", {"a": "α"}, r"\sin \alpha"),
        ("tan({a})", {"a": "α"}, r"\operatorname{tg} \alpha"),
        ("arctan({a}/{b})", {"a": "a", "b": "b"}, r"\operatorname{arctg} \left(\frac{a}{b}\right)"),
    ],
)
def test_a_tree_is_written_with_the_brackets_that_it_needs(
    text: str, put: dict[str, str | float], due: str
) -> None:
    assert told(text, **put) == due


@pytest.mark.parametrize(
    ("markup", "due"),
    [
        ("ω_1", r"\omega _{1}"),
        ("pa3", "pa_{3}"),
        ("P_{ур}", r"P_{\text{ур}}"),
        (r"\uu{\bar{v}_A}", r"\underline{\underline{\bar{v}_{A}}}"),
        ("y-y", r"y\text{-}y"),
        ("M′", "M'"),
    ],
)
def test_letters_are_written_as_on_sheets(markup: str, due: str) -> None:
    assert tex(Symbol(markup), "ru") == due


@pytest.mark.parametrize("sign", list("{}$%#&_^~\\"))
def test_no_sign_of_a_scene_acts_in_a_formula(sign: str) -> None:
    """A letter may be anything that a scene writes: a sign that TeX knows stands for itself."""
    from graphic_tmm.paper.lettering.letters import escape

    written = tex(Symbol(escape(sign)), "ru")
    assert written.startswith(r"\text{\text") or written == rf"\text{{\{sign}}}"


def test_a_long_sum_is_broken_at_its_terms_and_keeps_all_of_them() -> None:
    names = [f"x{k}" for k in range(30)]
    put = {name: Symbol(f"M_{{{k}}}") for k, name in enumerate(names)}
    node = tree_of(" + ".join(f"{{{name}}}" for name in names), FUNCTIONS)
    lines = broken(Formula((Symbol("ΣM"), Tree(node, put), Symbol("0"))))
    assert len(lines) > 1
    assert all(line.follows for line in lines[1:])
    whole = " ".join(tex(line, "en") for line in lines)
    assert [whole.count(f"M_{{{k}}}") for k in range(30)] == [1] * 30


def test_short_formulas_stand_beside_one_another() -> None:
    short = Formula((Symbol("a"), Symbol("b"), Symbol("c")))
    long = Formula((Symbol("a"), Symbol("b" * 60)))
    assert [len(row) for row in packed((short, short, long, short))] == [2, 1, 1]
