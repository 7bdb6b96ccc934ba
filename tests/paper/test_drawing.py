"""Ink that is moved is the same ink elsewhere: whatever a record holds, or comes to hold, goes with it."""

from __future__ import annotations

import pytest

from graphic_tmm.paper.drawing import Bezier, Drawing, Ink, Label, Stroke, Symbol, Wanted, shifted

BY = 3.0 - 2.0j
TOLD = {"title": "AB", "data": (("mm", "60"),), "of": (1, 2), "position": 4, "part": "link"}
LINE = Stroke(
    pen="main",
    path=((0.0, 0.0, 0.5), (1.0, 2.0, 0.0)),
    closed=True,
    filled=True,
    symbol=Symbol("pivot", 1j, 30.0),
    **TOLD,
)
CURVE = Bezier(pen="thin", controls=(0j, 1j, 2j, 3 + 1j), **TOLD)


@pytest.mark.parametrize("ink", [LINE, CURVE])
def test_an_example_has_all_that_ink_can_have(ink: Ink) -> None:
    plain = Stroke("", ()) if isinstance(ink, Stroke) else Bezier("", ())
    assert all(value != usual for value, usual in zip(ink, plain, strict=True))


def test_a_stroke_moves_with_its_symbol_and_keeps_all_else() -> None:
    assert LINE.symbol is not None
    path = ((3.0, -2.0, 0.5), (4.0, 0.0, 0.0))
    due = LINE._replace(path=path, symbol=LINE.symbol._replace(at=3.0 - 1.0j))
    assert shifted(LINE, BY) == due


def test_a_curve_moves_and_keeps_all_else() -> None:
    assert shifted(CURVE, BY) == CURVE._replace(controls=tuple(c + BY for c in CURVE.controls))


def test_a_drawing_moves_with_all_that_stands_in_it() -> None:
    view = Drawing(
        "plan",
        "",
        (LINE,),
        (Label("A", 1j),),
        cell=(0.0, 1.0, 2.0, 3.0),
        rubbed=(CURVE,),
        shows=("positions",),
        wanted=(Wanted("B", 2j, 5.0),),
    )
    there = view.moved(BY)
    assert there.strokes == (shifted(LINE, BY),)
    assert there.rubbed == (shifted(CURVE, BY),)
    assert there.labels[0].at == 1j + BY
    assert there.wanted[0].at == 2j + BY
    assert there.cell == (3.0, -1.0, 5.0, 1.0)
    assert there.origin("positions") == BY
