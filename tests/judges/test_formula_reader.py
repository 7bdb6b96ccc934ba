"""The reader of formulas that judges the package's: what it reads, and how far it lets a float be off."""

from __future__ import annotations

import pytest
from mpmath import mp  # type: ignore[import-untyped]
from support.each import each
from support.formula_reader import UNIT, Rounded, Undecided, degrees, expression, worked_out


@each(
    "text, python",
    [
        ("2·{a}/({b}²·{c})", '2*V["a"]/(V["b"]**2*V["c"])'),
        ("−{a}^{b}", '-V["a"]**V["b"]'),
        ("2π/{a}", '2*pi/V["a"]'),
        ("|{a} − {b}|/|{b}|", 'abs(V["a"] - V["b"])/abs(V["b"])'),
        ("sin² {a}/cos {a}", '(sin(V["a"]))**2/cos(V["a"])'),
        ("⌈1000·{a}⌉ + √({b})", 'ceil(1000*V["a"]) + sqrt(V["b"])'),
        ("360°·{a}", '(360*degree)*V["a"]'),
        ("{a} ± {b}", 'V["a"]'),
        ("{a}·q, q = {b}/{c}", 'V["a"]*(V["b"]/V["c"])'),
    ],
)
def test_a_text_becomes_python(text: str, python: str) -> None:
    assert expression(text) == python


def test_roundings_add_up() -> None:
    with mp.workdps(50):
        found = worked_out("{a}·{b} − {c}", {"a": Rounded(3), "b": Rounded(5), "c": Rounded(15.0)})
        assert found.value == 0
        assert found.off == pytest.approx(float(15 * UNIT), rel=1e-9)
        assert worked_out("sin {a}", {"a": degrees(30.0)}).value == pytest.approx(0.5, rel=1e-30)
        assert worked_out("{a} > 0, {b} ≤ 2", {"a": Rounded(1), "b": Rounded(2)}) is True
        assert worked_out("{a} ≠ 0", {"a": Rounded(0)}) is False


def test_what_rounding_decides_is_not_decided() -> None:
    third = Rounded(1) / 3
    for text in ("sgn(1 − 3·{a})", "⌈3·{a}⌉", "1/(1 − 3·{a})", "arcsin(3·{a})"):
        with pytest.raises(Undecided):
            worked_out(text, {"a": third})
