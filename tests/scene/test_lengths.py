"""Sums of named lengths: what is understood, and nothing more."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from graphic_tmm.scene.lengths import evaluate

NAMES = {"OA": 0.1, "BC": 0.2, "OB": 0.48, "r": 1.0, "l2": 2.0, "длина": 3.0, "bad": math.nan}


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("OA", 0.1),
        ("-BC", -0.2),
        ("+ BC", 0.2),
        ("-OB - 1.25 BC", -0.48 - 1.25 * 0.2),
        ("−OB−1,25BC", -0.48 - 1.25 * 0.2),
        ("0.5*OA", 0.05),
        ("2 · r", 2.0),
        ("1e-1 l2", 0.2),
        ("10 mm + 0.5 BC", 0.01 + 0.1),
        ("1e-3 m - 5 мм", 0.001 - 0.005),
        ("2 длина", 6.0),
        (0.3, 0.3),
        ("34 mm", 0.034),
    ],
)
def test_reads(text, value):
    assert evaluate(text, NAMES) == value


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("OD", "neither a named length.*did you mean.*named lengths are BC, OA"),
        ("5 OX", "neither a named length nor a unit.*units are mm"),
        ("95 mn", 'did you mean "mm"'),
        ("mm", "neither a named length"),
        ("BC/2", "no brackets, no division"),
        ("(OA + BC)", "no brackets"),
        ("OA OB", "is not a length"),
        ("--OA", "is not a length"),
        ("OA +", "is not a length"),
        ("2*", "has no unit|is not a length"),
        ("*OA", "is not a length"),
        ("10 mm + 5", "5 in .* has no unit and no name"),
        ("5", 'has no unit; write "5 mm"'),
        ("5 kg", "is a mass; a length is wanted"),
        ("OA + 5 kg", "is a mass; a length is wanted"),
        ("1 000 mm + OA", "two ways"),
        ("OA + 1 000 mm", "two ways"),
        ("1,000 mm + OA", "two ways"),
        ("1/2 OA", "fraction|not a length"),
        ("", "not a length"),
        ("__import__", "not a length"),
        ("1e300 r", "too large"),
    ],
)
def test_refuses(text, words):
    with pytest.raises(ValueError, match=words):
        evaluate(text, NAMES)


def test_without_names_the_section_is_named():
    with pytest.raises(ValueError, match=r"name them in a section \[lengths\]"):
        evaluate("OA", {})


def test_a_faulty_name_is_not_told_twice():
    assert math.isnan(evaluate("OA + 2 bad", NAMES))


TERMS = st.tuples(
    st.sampled_from("+-"), st.integers(0, 999), st.sampled_from([" ", "*", "·", ""]),
    st.sampled_from(["OA", "BC", "r", "mm", "m"]),
)  # fmt: skip


@given(st.lists(TERMS, min_size=1, max_size=6), st.sampled_from(["", " ", "\u00a0"]))
def test_sums(terms, space):
    text, due = "", 0.0
    for sign, number, times, name in terms:
        times = " " if name in ("m", "mm") else times
        text += f"{space}{sign}{space}{number}{times}{name}"
        factor = {"mm": 0.001, "m": 1.0}.get(name) or NAMES[name]
        due += (1 if sign == "+" else -1) * number * factor
    assert evaluate(text, NAMES) == pytest.approx(due, abs=1e-9)


@given(st.text("OABCr 0123456789.,+-*·/()emk", max_size=20))
def test_never_anything_but_a_value_error(text):
    try:
        found = evaluate(text, NAMES)
    except ValueError:
        return
    assert math.isfinite(found)
