"""The notes of engines and of a cycle of moments: what the books derive, in their order."""

from __future__ import annotations

import math

import pytest
from support.notes import looked_up, noted, spoken, stands_for, worth_of_a_last_digit

from graphic_tmm.chapters.engine.table import engine_columns
from graphic_tmm.note.document import (
    Block,
    Formula,
    Heading,
    Number,
    Picture,
    Symbol,
    Table,
    Text,
    Tree,
    numbers,
    runs_of,
    walk,
)

NAMES = ["locomobile", "engine", "four-stroke", "moment-cycle"]


def told(name: str, language: str = "ru") -> str:
    """Everything that a note says in words, and the letters of its formulas."""
    return " ".join(_words(block) for block in walk(noted(name, language).blocks))


def _words(block: Block) -> str:
    return "".join(_word(run) for run in runs_of(block))


def _word(run: object) -> str:
    if isinstance(run, Text | Number):
        return run.text
    if isinstance(run, Symbol):
        return run.markup
    if isinstance(run, Formula):
        return "=".join("" if isinstance(side, Tree) else _word(side) for side in run.sides)
    return ""


def in_order(text: str, *parts: str) -> None:
    """Hold that parts stand in a text, each behind the one before it."""
    at = 0
    for part in parts:
        found = text.find(part, at)
        assert found >= 0, (part, text[at : at + 400])
        at = found


def begun(name: str) -> list[str]:
    """The letters that formulas begin with, in order: on lines of their own and among words."""
    formulas = [
        run
        for block in walk(noted(name).blocks)
        if not isinstance(block, Table)
        for run in runs_of(block)
        if isinstance(run, Formula) and not run.follows
    ]
    return [_word(one.sides[0]) for one in formulas]


@pytest.mark.parametrize(
    "name", ["moment-cycle", pytest.param("four-stroke", marks=pytest.mark.slow)]
)
@pytest.mark.parametrize("language", ["ru", "en"])
def test_every_number_stands_in_the_log(name: str, language: str) -> None:
    made, found = spoken(name, language), list(numbers(noted(name, language)))
    wrong = [
        (one.text, one.source)
        for one in found
        if not stands_for(one.text, looked_up(made, one), worth_of_a_last_digit(made, one))
    ]
    assert len(found) > 100
    assert not wrong, wrong[:5]


@pytest.mark.slow
def test_the_forces_are_told_in_the_order_of_the_book() -> None:
    """(338), the resolutions, both couples, what acts on the machine, inertia, both orders, P′, equal works."""
    in_order(
        told("locomobile"),
        "(338)",
        "только шатуну и направляющим",
        "внешний угол треугольника OAB",
        "−N поперёк",
        "(339)", "(340)", "(341)", "(342)", "(344)",
        "на цилиндр действует",
        "M′ = −M",
        "(345)", "(346)", "(347)",
        "(349)", "(350) и (351)",
        "(352)",
        "основание воспринимает",
        "Работы сил T и P за оборот",
    )  # fmt: skip


@pytest.mark.slow
def test_the_figure_of_all_forces_is_in_the_note_of_every_engine() -> None:
    pictures = [block for block in walk(noted("locomobile").blocks) if isinstance(block, Picture)]
    (found,) = [one for one in pictures if one.id == "fig-engine-148"]
    assert "положение 2" in _words(found)


@pytest.mark.slow
def test_the_book_s_example_stands_in_a_table() -> None:
    """At 0°, 90°, 180°: 134.2, −20.7, −92.9 m/s²; −292.5, 45, 202.5 kgf; the orders 247.5 and 45."""
    table = next(
        block
        for block in walk(noted("locomobile").blocks)
        if isinstance(block, Table) and block.id == "table-engine-quarters"
    )
    rows = [
        [run.value for cell in row for run in cell if isinstance(run, Number)] for row in table.rows
    ]
    due = [
        [134.2, 134.2, -292.5, -292.5, -247.5, -45.0],
        [-21.0, -20.7, 45.8, 45.0, 0.0, 45.0],
        [-92.9, -92.9, 202.5, 202.5, 247.5, -45.0],
    ]
    for row, expected in zip(rows, due, strict=True):
        for value, published in zip(row, expected, strict=True):
            assert value == pytest.approx(published, abs=0.15)


def test_the_masses_come_to_the_book_s_sum() -> None:
    """6.6 + 10.5 + 0.25·17.1 = 21.375 kg, 2.18 kgf·s²/m."""
    found = [one for one in numbers(noted("locomobile")) if one.unit == "kgf·s²/m"]
    assert any(one.value == pytest.approx(21.375 / 9.80665) for one in found)


def test_conclusions_of_the_engine_are_those_of_the_figures() -> None:
    made = spoken("locomobile", "ru").mechanism
    assert made is not None
    text = told("locomobile")
    columns = {one.segment: one.value[0] for one in engine_columns(made)}
    assert "В положениях 0, 6 давление на направляющую и вращающий момент равны нулю" in text
    assert abs(columns["N"]).argmax() == columns["M"].argmax() == 2
    assert "Наибольший вращающий момент — в положении 2: 208" in text
    assert "от 50° до 80°" in text
    assert (columns["M"] >= -1e-6).all()
    assert "Во всех положениях он направлен в сторону вращения" in text
    assert columns["a_B"][2] > 0 > columns["a_B"][3]
    assert "между положениями 2 и 3 оно меняет знак" in text


def test_the_flywheel_is_told_in_the_order_of_the_document() -> None:
    """M by the reduced force, readings, works, energies, J, the second method, the rim, its check."""
    in_order(
        told("engine"),
        "коэффициент неравномерности хода δ = 0,23",
        "приводят к пальцу кривошипа",
        "Индикаторная диаграмма",
        "Отрезки с планов скоростей",
        "Приведённый момент движущих сил",
        "Движущий момент отложен выше оси — в положениях 2, 3, 4, 5, 6",
        "прямая, соединяющая начало и конец",
        "в одних осях и в одном масштабе",
        "Диаграмма энергия–масса",
        "Средний момент, мощность",
        "Обод маховика",
        "не должна превышать 110",
        "0,45",
        "в целых миллиметрах",
        "даёт запас",
        "как и требуется",
    )  # fmt: skip
    formulas = begun("engine")
    in_order(" ".join(formulas), "D_{max}", "D_{ср}", "m_{м}", "b", "b′", "J′", "δ′")


def test_the_table_of_readings_is_the_published_one() -> None:
    """X = pb, S = ps2, H = ab in mm and the pressure, exact, by reference A2."""
    table = next(
        block
        for block in walk(noted("engine").blocks)
        if isinstance(block, Table) and block.id == "table-flywheel-readings"
    )
    rows = [
        [run.value for cell in row[1:] for run in cell if isinstance(run, Number)]
        for row in table.rows
    ]
    assert len(rows) == 12
    due = {0: (60, 0, 39.38, 3e5), 2: (32.83, 65.29, 59.87, 2.4e5), 5: (53.45, 17.47, 42.7, 87e3)}
    for k, expected in due.items():
        for value, exact in zip(rows[k], expected, strict=True):
            assert value == pytest.approx(exact, abs=0.06, rel=1e-6)


def test_the_rim_as_made_keeps_its_delta() -> None:
    """By plain arithmetic: 115 mm wide, 0.45 and 0.38 m across, steel."""
    found = {
        one.source.name: one for one in numbers(noted("engine")) if one.source.kind == "result"
    }
    middle = (0.45 + 0.38) / 2
    inertia = math.pi * 7800 * (0.45**2 - 0.38**2) * middle**2 * 0.115 / 16
    assert found["J_made"].value == pytest.approx(inertia, rel=1e-9)
    due = 0.23 * found["J_fly"].value / inertia
    assert found["delta_made"].value == pytest.approx(due, rel=1e-6)


@pytest.mark.slow
def test_four_strokes_are_told() -> None:
    in_order(told("four-stroke"), "Рабочий цикл занимает оборотов кривошипа: 2", "прямая", "Обод")


def test_a_cycle_of_moments_has_no_word_of_links() -> None:
    text = told("moment-cycle")
    in_order(
        text,
        "оборотов в цикле 3, положений 36",
        "Момент сил сопротивления за цикл",
        "Звеньев, обладающих энергией, нет",
        "Наибольшая избыточная работа",
    )
    assert "шатун" not in text


@pytest.mark.parametrize("name", ["moment-cycle", "locomobile", "engine"])
@pytest.mark.slow
def test_no_letter_stands_in_its_mark_up(name: str) -> None:
    """Words hold no raw index: T_м is a symbol, not text."""
    own = (Heading, Picture, Table)
    raw = [
        run.text
        for block in walk(noted(name).blocks)
        if not isinstance(block, own)
        for run in runs_of(block)
        if isinstance(run, Text) and not run.style and ("_" in run.text or "{" in run.text)
    ]
    assert not raw, raw[:5]
