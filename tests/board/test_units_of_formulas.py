"""Units are checked when a step is recorded: what may be added, what follows, what has to be told."""

from __future__ import annotations

import pytest
from support.declared import declared
from support.each import each

from graphic_tmm.board.dimensions import UnitError, dimension, spoken
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.values import Number
from graphic_tmm.errors import ConstructionError


@each(
    "unit, due",
    [
        ("", "a plain number"),
        ("rad", "a plain number"),
        ("%", "a plain number"),
        ("mm", "mm"),
        ("N", "N"),
        ("N·m", "N·m"),
        ("J", "N·m"),
        ("Pa", "N/m²"),
        ("kg·m²", "kg·m²"),
        ("(m/s²)/mm", "m/(mm·s²)"),
        ("(1/s)/mm", "1/(mm·s)"),
        ("°/mm", "°/mm"),
        ("kg/m³", "kg/m³"),
        ("N/kgf", "N/kgf"),
    ],
)
def test_a_unit_has_a_dimension(unit: str, due: str) -> None:
    assert spoken(dimension(unit)) == due


@each("unit", ["furlong", "N·", "2·furlong", "m/(s"])
def test_what_is_no_unit_is_refused(unit: str) -> None:
    with pytest.raises(UnitError, match="is no unit of the board"):
        dimension(unit)


@each(
    "text, units, unit, says",
    [
        ("{a} + {b}", ("mm", "N"), "N", "adds mm and N"),
        ("{a} − {b}", ("m", "mm"), "m", "subtracts m and mm"),
        ("max({a}, {b})", ("m", "mm"), "m", "compares m and mm"),
        ("{a} ± {b}", ("N", "N·m"), "N", "adds N and N·m"),
        ("1 + {a}", ("m",), "m", "adds a plain number and m"),
        ("{a}·{b}", ("kg", "m/s²"), "N·m", "leaves N, but 'N·m' is told"),
        ("{a}/{b}", ("m", "m/mm"), "m", "leaves mm, but 'm' is told"),
        ("{a}·{b}", ("kg", "m"), "", "leaves kg·m: tell its unit"),
        ("{a}·{b}", ("kg", "stone"), "kg", "'stone' is no unit of the board"),
        ("sin {a}", ("m",), "", "takes sin of m"),
        ("sin {a}", ("°",), "", "takes sin of °"),
        ("sin({t}²)", ("°",), "", "takes radians of °²"),
        ("2^{a}", ("m",), "", "raises to a power"),
        ("{t}/2", ("°",), "rad", "leaves °, but 'rad' is told"),
    ],
)
def test_a_formula_of_wrong_units_is_a_mistake_when_recorded(
    text: str, units: tuple[str, ...], unit: str, says: str, apart: None
) -> None:
    op, draft = declared(text), Draft()
    draft.board.open("velocities")
    given = [
        draft.take(kind, f"x{k}", 1.0, told)
        for k, (kind, told) in enumerate(zip(op.takes, units, strict=True))
    ]
    with pytest.raises(ConstructionError) as told:
        draft.board.draw(op, "y", *given, unit=unit)
    assert str(told.value).startswith("velocities, step 1: told 'y' ")
    assert says in str(told.value)
    assert not draft.board.construction().steps


def test_a_condition_is_of_like_units_too(apart: None) -> None:
    op, draft = declared("{a}·{b}", holds="{a} > {b}", fails=("no", "нет")), Draft()
    given = [draft.take(Number, name, 1.0, name) for name in ("m", "s")]
    with pytest.raises(ConstructionError, match="compares m and s"):
        draft.board.draw(op, "y", *given, unit="m·s")


def test_a_zero_agrees_with_any_unit(apart: None) -> None:
    op, draft = declared("max({a}, 0)"), Draft()
    draft.board.draw(op, "y", draft.take(Number, "x", 1.0, "N·m"), unit="N·m")
