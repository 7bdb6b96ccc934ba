"""A formula is its text: what is read, what is computed, what is refused at once."""

from __future__ import annotations

import ast
import importlib
import inspect
import math
import pkgutil
import re
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
from mpmath import mp  # type: ignore[import-untyped]
from support.declared import declared
from support.each import each
from support.examples import most
from support.formula_reader import (
    DIGITS,
    UNIT,
    Rounded,
    Undecided,
    degrees,
    expression,
    worked_out,
)

import graphic_tmm.mechanism.synthesis  # noqa: F401  has formulas
from graphic_tmm import chapters
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.formula import FORMULAS, Formula, formula
from graphic_tmm.board.grammar import OPERATIONS, Operation
from graphic_tmm.board.values import Angle, Length, Number
from graphic_tmm.errors import ConstructionError
from graphic_tmm.readers.sentences import calculation

for module in pkgutil.walk_packages(chapters.__path__, f"{chapters.__name__}."):
    importlib.import_module(module.name)

DRAWS = 3 * most(20)
ENOUGH = DRAWS // 6
IN_DEGREES_PER = {"on_protractor": "mu", "off_protractor": "mu", "angle_by_length": "ratio"}
"""Which argument is in °/mm, or in °/m."""
PER_DEGREE = {"length_by_angle": "ratio"}
"""Which is in m/°."""
DEGREES_PER_MM = ("degrees_per_mm",)
"""What are numbers in °/mm."""


# ---------------------------------------------------------------- the text and the number


def _drawn(made: Formula, rng: np.random.Generator, k: int) -> list[float]:
    """Values of the arguments: below one or of any size, of any sign or positive; at last each is zero once."""
    op = OPERATIONS[made.name]
    if "gcd" in made.text:
        return [float(rng.integers(10, 90)) for _ in op.takes]
    values = []
    for kind in op.takes:
        size = rng.uniform(0.05, 1.0) if k % 2 else 10.0 ** rng.uniform(-2, 2)
        sign = rng.choice((-1.0, 1.0)) if k % 3 == 0 else 1.0
        values.append(float(sign * (rng.uniform(1.0, 80.0) if kind is Angle else size)))
    if k >= DRAWS:
        values[k - DRAWS] = 0.0
    return values


def _due(made: Formula, values: list[float]) -> tuple[bool, Rounded | None]:
    """Whether the formula holds, and its value by its text."""
    op = OPERATIONS[made.name]
    marks = {}
    for name, kind, value in zip(op.arguments, op.takes, values, strict=True):
        turns = kind is Angle or (name == IN_DEGREES_PER.get(made.name))
        marks[name] = degrees(value) if turns else Rounded(value)
        if name == PER_DEGREE.get(made.name):
            marks[name] = marks[name] / degrees(1.0)
    if made.holds and not worked_out(made.holds, marks):
        return False, None
    due = worked_out(made.text, marks)
    return True, due / degrees(1.0) if op.leaves is Angle or made.name in DEGREES_PER_MM else due


def _found(op: Operation, values: list[float]) -> float:
    with np.errstate(all="ignore"):
        found = op.run(*[np.array([[value]]) for value in values])
    assert found.shape == (1, 1)
    return float(found[0, 0])


def _apart(made: Formula, factor: float = 1.0) -> tuple[int, list[object]]:
    """How many values were compared; which results, times a factor, are further off than roundings can be."""
    rng = np.random.default_rng(list(made.name.encode()))
    compared, wrong = 0, []
    for k in range(DRAWS + len(made.arguments)):
        values = _drawn(made, rng, k)
        try:
            holds, due = _due(made, values)
        except (Undecided, ZeroDivisionError):
            continue
        found = factor * _found(OPERATIONS[made.name], values)
        if due is None:
            wrong += [] if made.has_body or math.isnan(found) else [(values, found)]
            continue
        # a body goes another way, by a few roundings more or less
        allowed = due.off + 16 * UNIT * abs(due.value) * made.has_body
        wrong += [] if abs(found - due.value) <= allowed else [(values, found, due.value)]
        compared += holds
    return compared, wrong


@each("made", FORMULAS.values())
def test_a_formula_computes_what_it_says(made: Formula) -> None:
    """Its text, worked out on fifty digits by another reader, is its number to the roundings on the way."""
    with mp.workdps(DIGITS):
        compared, wrong = _apart(made)
    assert not wrong
    assert compared >= ENOUGH


BODIES = [made for made in FORMULAS.values() if made.has_body]


def _texts_with_a_sign_changed(text: str) -> Iterator[str]:
    for sign in re.finditer("[+−]", text):
        other = "−" if sign[0] == "+" else "+" if text[: sign.start()].strip() else ""
        yield text[: sign.start()] + other + text[sign.end() :]


def _bodies_with_a_sign_changed(op: Operation) -> Iterator[Callable[..., Any]]:
    """Yield the body with each + as −, each − as +, one at a time; a nought that is added has no sign."""
    tree = ast.parse(inspect.getsource(op.run))
    tree.body[0].decorator_list = []  # type: ignore[attr-defined]
    for node in ast.walk(tree):
        was = getattr(node, "op", None)
        nought = ast.unparse(node).endswith((" + 0.0", " - 0.0"))
        if nought or not isinstance(was, ast.Add | ast.Sub | ast.USub):
            continue
        node.op = {ast.Add: ast.Sub(), ast.Sub: ast.Add(), ast.USub: ast.UAdd()}[type(was)]  # type: ignore[attr-defined]
        space = dict(op.run.__globals__)
        exec(compile(ast.fix_missing_locations(tree), op.name, "exec"), space)
        yield space[op.name]
        node.op = was  # type: ignore[attr-defined]


def test_a_sign_changed_in_a_text_or_in_its_body_alone_would_be_found(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Each sign of each formula that has a body of its own: where only one of the two is changed they part."""
    planted = 0
    with mp.workdps(DIGITS):
        for made in BODIES:
            op = OPERATIONS[made.name]
            for text in _texts_with_a_sign_changed(made.text):
                assert _apart(made._replace(text=text))[1], text
                planted += 1
            for run in _bodies_with_a_sign_changed(op):
                monkeypatch.setitem(OPERATIONS, made.name, op._replace(run=run))
                assert _apart(made)[1], made.name
                planted += 1
            monkeypatch.undo()
    assert planted > len(BODIES)


@pytest.mark.slow
@each("made", FORMULAS.values(), turns=len(FORMULAS) // 4)
def test_a_formula_that_computed_something_else_would_be_found(made: Formula) -> None:
    with mp.workdps(DIGITS):
        assert _apart(made, 1.0 + 1e-13)[1]


CANCELLING: dict[str, list[float]] = {
    "polynomial_V": [1 - 2.0**-20, 3.0, 1.0, 1.0],
    "polynomial_A": [1 - 2.0**-20, 3.0, 1.0, 1.0],
    "ratio_alike": [101.0, 100.0, 99.0, 100.0],
    "involute": [0.5],
    "around_outer": [0.25 + 2.0**-20],
    "around_lowest": [2.0**-20],
    "half_around_outer": [0.5 + 2.0**-20],
}
"""Where the terms of a text cancel, or a function is steep: its body keeps the digits that are lost there."""
SILENT = {
    "with_motion": ([5.0, 1e-10, 1.0], 0.0),
    "against_turning": ([5.0, 1e-10, -1.0], 0.0),
    "pin_friction": ([5.0, -2.0, 1.0, 1.0], -10.0),
    "offset": ([0.0, 0.0, 1.0], 0.0),
    "place_of": ([3.0, -2.0, 1.0], 1.5),
    "still_open": ([1.3, 1.0, 0.9], math.inf),
    "efficiency": ([2.0, 1.0, 1.0], math.nan),
    "perceived_shift": ([1.0 + 2.0**-50, 1.0, 0.5], 0.0),
    "whole_mm_above": ([0.021 + 2.0**-56], 0.021),
    "whole_mm_below": ([0.021 - 2.0**-56], 0.021),
    "speed_of_ray": ([-(2.0**-50), 1.0, 1.0], 0.0),
}
"""Where a text is silent, or says what nobody means: what its body says."""


def test_every_body_has_its_reason() -> None:
    assert {name for name, made in FORMULAS.items() if made.has_body} == {*CANCELLING, *SILENT}


IN_FLOATS = {**vars(math), "degree": math.radians(1.0), "arcsin": math.asin, "arccos": math.acos}


@each("name", CANCELLING)
def test_a_body_keeps_the_digits_that_its_text_would_lose(name: str) -> None:
    made, values = FORMULAS[name], CANCELLING[name]
    op = OPERATIONS[name]
    marks = zip(op.arguments, op.takes, values, strict=True)
    with mp.workdps(DIGITS):
        _, due = _due(made, values)
        assert due is not None
        floats = {n: math.radians(v) if kind is Angle else v for n, kind, v in marks}
        as_printed = eval(expression(made.text), {**IN_FLOATS, "V": floats})
        as_printed /= math.radians(1.0) if op.leaves is Angle else 1.0
        allowed = 16 * UNIT * abs(due.value)
        assert abs(_found(op, values) - due.value) <= allowed
        assert abs(as_printed - due.value) > allowed


@each("name", SILENT)
def test_a_body_answers_where_its_text_does_not(name: str) -> None:
    values, due = SILENT[name]
    made = FORMULAS[name]
    assert _found(OPERATIONS[name], values) == pytest.approx(due, rel=1e-15, nan_ok=True)
    with mp.workdps(DIGITS):
        try:
            holds, said = _due(made, values)
        except (Undecided, ZeroDivisionError):
            return
        assert not holds or said is None or said.value != due


@each("made", FORMULAS.values())
def test_what_is_missing_leaves_nothing(made: Formula) -> None:
    """What is missing in any argument is missing in the result; other positions do not notice."""
    op = OPERATIONS[made.name]
    sizes = [np.array([[0.5, 0.6, 0.7]]) * (k + 1) for k in range(len(op.takes))]
    with np.errstate(all="ignore"):
        whole = op.run(*sizes)
        for k in range(len(sizes)):
            hurt = [
                np.where([[False, True, False]] if i == k else False, np.nan, size)
                for i, size in enumerate(sizes)
            ]
            found = op.run(*hurt)
            np.testing.assert_array_equal(found[:, [0, 2]], whole[:, [0, 2]])
            assert not np.isfinite(found[0, 1]), op.arguments[k]


# ---------------------------------------------------------------- what is read


@each(
    "text, due",
    [
        ("{a}·{b}/{c}", 7.0 * 3.0 / 2.0),
        ("{a}/{b}/{c}", 7.0 / 3.0 / 2.0),
        ("{a}/({b}·{c})", 7.0 / 6.0),
        ("{a} − {b} − {c}", 2.0),
        ("−{a}·{b} + {c}", -19.0),
        ("−{a}² + {b}·{c}", -43.0),
        ("{a} ± {b}·{c}", 7.0),
        ("({a} + {b})²/{c}³", 12.5),
        ("{c}^{b} + {a}", 15.0),
        ("{a}·({b}/{c})^(1 − {c})", 7.0 * (3.0 / 2.0) ** -1.0),
        ("2π/{a} + {b}·{c}", 2.0 * math.pi / 7.0 + 6.0),
        ("π²·{a} + {b} + {c}", math.pi**2 * 7.0 + 5.0),
        ("|{b} − {a}|/|{c}|", 2.0),
        ("{c}·|{b} − {a}|", 8.0),
        ("√({a} + {c}) + {b}", 6.0),
        ("max({a}, {b}) − min({b}, {c})", 5.0),
        ("⌈{a}/{c}⌉ − ⌊{a}/{b}⌋", 2.0),
        ("sgn({b} − {a})·{c}", -2.0),
        ("{a}·sin {t} + {b} + {c}", 7.0 * math.sin(math.radians(30.0)) + 5.0),
        ("{a}·sin² {t}/2 + {b} + {c}", 7.0 * math.sin(math.radians(30.0)) ** 2 / 2.0 + 5.0),
        ("{a}·cos({t}/2) + {b} + {c}", 7.0 * math.cos(math.radians(15.0)) + 5.0),
        ("tan({t}·π/180°) + {a} + {b} + {c}", math.tan(math.pi / 6.0) + 12.0),
        ("{a} + {b} + {c} + {t}/90°", 12.0 + 1.0 / 3.0),
        ("{a}·q², q = {b} + {c}", 175.0),
    ],
)
def test_a_text_is_worked_out_as_in_a_textbook(text: str, due: float, apart: None) -> None:
    found = declared(text)
    values = {"a": 7.0, "b": 3.0, "c": 2.0, "t": 30.0}
    assert _found(found, [values[name] for name in found.arguments]) == pytest.approx(
        due, rel=1e-15
    )


@each(
    "text, due",
    [
        ("arccos({a}/({b}·{c} + 8))", 60.0),
        ("arctan({a}/({b}·{c} + 1))", 45.0),
        ("2·arcsin({b}/({c}·{a} − 8)) + {t}/2", 75.0),
        ("180°·{a}/({b} + {c} + 2)", 180.0),
    ],
)
def test_an_angle_is_in_degrees(text: str, due: float, apart: None) -> None:
    found = declared(text, Angle)
    values = {"a": 7.0, "b": 3.0, "c": 2.0, "t": 30.0}
    assert _found(found, [values[name] for name in found.arguments]) == pytest.approx(
        due, rel=1e-14
    )


@each(
    "text, says",
    [
        ("{a}·{b", r"cannot read '\{b'"),
        ("({a} + {b}", r"'\)' is missing"),
        ("{a} + {b})", r"'\)' is out of place"),
        ("|{a} + {b}", r"'\|' is missing"),
        ("{a}·", "something is missing"),
        ("{a} {b}", "'b' is out of place"),
        ("{a}··{b}", "'·' is out of place"),
        ("sin {a}²", "a bracket is missing before the power"),
        ("sinh {a}", "'a' is out of place"),
        ("{a} > {b}", "'>' is out of place"),
        ("{a}·x", r"names \['x'\], which are no arguments"),
        ("", "something is missing"),
    ],
)
def test_what_cannot_be_read_is_a_mistake_at_once(text: str, says: str, apart: None) -> None:
    before = dict(OPERATIONS)
    with pytest.raises(TypeError, match=f"told: .*{says}"):
        declared(text)
    assert before == OPERATIONS


def test_an_argument_that_is_not_used_is_a_mistake_at_once(apart: None) -> None:
    with pytest.raises(TypeError, match=r"lost: the formula does not use \['b', 'c'\]"):

        @formula
        def lost(a: Number, b: Number, c: Number) -> Number:
            """2·{a}"""

    with pytest.raises(TypeError, match=r"stray: the formula names \['d'\]"):

        @formula(holds="{d} > 0", fails=("no", "нет"))
        def stray(a: Number) -> Number:
            """2·{a}"""

    with pytest.raises(TypeError, match="silent: where it does not hold it has to say why"):

        @formula(holds="{a} > 0")
        def silent(a: Number) -> Number:
            """2·{a}"""


def test_a_condition_says_where_there_is_an_answer(apart: None) -> None:
    found = declared("{a}/{b}", holds="{a} ≥ 0, {b} ≠ 0, {a} < 2·{b}", fails=("no", "нет"))
    given = [(3.0, 2.0), (4.0, 2.0), (-1.0, 2.0), (0.0, 0.0), (0.0, 2.0)]
    a, b = (np.array([row]) for row in zip(*given, strict=True))
    with np.errstate(all="ignore"):
        np.testing.assert_array_equal(found.run(a, b), [[1.5, math.nan, math.nan, math.nan, 0.0]])


def test_every_formula_of_the_board_is_its_text() -> None:
    assert list(FORMULAS) == [op.name for op in OPERATIONS.values() if op.formula]
    for name, made in FORMULAS.items():
        assert OPERATIONS[name].formula == " ".join(made.text.split())
        if not made.has_body:
            assert inspect.getsource(OPERATIONS[name].run).count("\n") == 2


# ---------------------------------------------------------------- one place


def test_a_formula_is_stated_once(apart: None) -> None:
    """What stands here is all there is to add one: it is drawn, run both ways, told and checked."""

    @formula(holds="{r} > 0", fails=("no radius", "нет радиуса"))
    def centripetal(mass: Number, v: Length, mu_v: Number, r: Length, mu_l: Number) -> Number:
        """{mass}·({v}·{mu_v})²/({r}·{mu_l})"""

    draft = Draft()
    draft.board.open("forces")
    turns = np.linspace(1.0, 9.0, 600)[None, :]
    given = (
        draft.take(Number, "m", 2.0, "kg"),
        draft.take(Length, "pv", turns),
        draft.take(Number, "μ_v", 0.5, "(m/s)/mm"),
        draft.take(Length, "OA", 40.0),
        draft.take(Number, "μ_l", 0.01, "m/mm"),
    )
    force = draft.board.draw(centripetal, "F", *given, unit="N")
    log = draft.board.construction()
    due = 2.0 * (turns * 0.5) ** 2 / 0.4
    for fast in (False, True):
        reading = execute(log, draft.given, fast=fast)
        np.testing.assert_allclose(reading[force], due, rtol=1e-15)
    told = calculation(log.steps[0], reading, 0, "en")
    assert told == "F = m·(pv·μ_v)²/(OA·μ_l) = 2·(1·0.5)²/(40·0.01) = 1.25 N"
    with pytest.raises(ConstructionError, match="leaves N, but 'J' is told"):
        draft.board.draw(centripetal, "W", *given, unit="J")
