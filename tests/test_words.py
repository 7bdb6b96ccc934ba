"""Words and numbers for people: the calculation note is recomputed by an evaluator of its own."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.boards import drawn_of
from support.gallery import NAMES, SHEETS, drawn, scene

from graphic_tmm.board.execute import execute
from graphic_tmm.board.findings import Finding
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.language.units import unit
from graphic_tmm.project import record
from graphic_tmm.readers.findings import finding
from graphic_tmm.readers.narration import protocol
from graphic_tmm.readers.protocol import synthesis
from graphic_tmm.scene.read import read


@pytest.mark.parametrize(
    ("value", "due"),
    [
        (0.136571, "0,1366"),
        (-4.0, "−4"),
        (12345.0, "12345"),
        (2.5e-7, "2,5·10⁻⁷"),
        (-1.5e9, "−1,5·10⁹"),
        (0.0, "0"),
        (-0.0, "0"),
        (float("nan"), "—"),
    ],
)
def test_a_number(value: float, due: str) -> None:
    assert number(value, "ru") == due


def test_a_fixed_number_has_no_minus_zero() -> None:
    assert fixed(-0.04, 1, "en") == "0.0"
    assert fixed(-0.06, 1, "ru") == "−0,1"
    assert fixed(None, 1, "ru") == "—"


def test_units_speak_russian() -> None:
    assert unit("(m/s²)/mm", "ru") == "(м/с²)/мм"
    assert unit("m/s", "en") == "m/s"


class Span(NamedTuple):
    """What a printed figure may stand for: from ``low`` to ``high``."""

    low: float
    high: float


def _over(a: Span, b: Span, what: Callable[[float, float], float]) -> Span:
    ends = [what(x, y) for x in a for y in b]
    return Span(min(ends), max(ends))


def _each(a: Span, what: Callable[[float], float]) -> Span:
    low, high = sorted(map(what, a))
    return Span(low, high)


UNIT = re.compile(r"[\d⁰¹²³⁴-⁹]( мм| м²?| м/с²?| с⁻[¹²]|°)$")
NUMBER = re.compile(r"(\d+(?:,\d+)?)(?:·10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))?°?")
RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")


def printed(text: str) -> tuple[Span, int]:
    """Read a number at the start of a text, to four significant figures; return its length too."""
    found = NUMBER.match(text)
    assert found, text
    value = float(found[1].replace(",", ".")) * 10.0 ** int((found[2] or "0").translate(RAISED))
    half = 0.5001 * 10.0 ** min(math.floor(math.log10(value)) - 3, 0) if value else 0.0
    if value and found[2]:
        half = 0.5001 * 10.0 ** (math.floor(math.log10(value)) - 3)
    return Span(value - half, value + half), found.end()


class Reader:
    """A calculation by recursive descent, as a person would check it: spans in, a span out."""

    def __init__(self, text: str) -> None:
        self.text = text

    def take(self, sign: str) -> bool:
        here = self.text.startswith(sign)
        self.text = self.text[len(sign) :] if here else self.text
        return here

    def total(self) -> Span:
        value = self.product()
        while True:
            if self.take(" + "):
                value = _over(value, self.product(), lambda x, y: x + y)
            elif self.take(" − "):
                value = _over(value, self.product(), lambda x, y: x - y)
            else:
                return value

    def product(self) -> Span:
        value = self.factor()
        while True:
            if self.take("·"):
                value = _over(value, self.factor(), lambda x, y: x * y)
            elif self.take("/"):
                value = _over(value, self.factor(), lambda x, y: x / y)
            else:
                return value

    def factor(self) -> Span:
        if self.take("−"):
            return _each(self.factor(), lambda x: -x)
        value = self.atom()
        if self.take("²"):
            top = max(x * x for x in value)
            return Span(0.0 if value.low <= 0 <= value.high else min(x * x for x in value), top)
        return value

    def atom(self) -> Span:
        for start, end, what in (
            ("sin(", ")", lambda x: math.sin(math.radians(x))),
            ("cos(", ")", lambda x: math.cos(math.radians(x))),
            ("tg(", ")", lambda x: math.tan(math.radians(x))),
            ("√(", ")", lambda x: math.sqrt(max(x, 0.0))),
            ("(", ")", lambda x: x),
            ("|", "|", abs),
        ):
            if self.take(start):
                value = self.total()
                assert self.take(end), self.text
                return _each(value, what)
        value, length = printed(self.text)
        self.text = self.text[length:]
        return value


def evaluated(text: str) -> Span:
    reader = Reader(text)
    value = reader.total()
    assert not reader.text, text
    return value


def agrees(calculation: str) -> bool:
    """Whether the last two members of a calculation may be equal, to the digits printed."""
    *_, formula, result = calculation.split(" = ")
    due, found = evaluated(formula), Reader(result.split(" ")[0]).factor()
    return due.low <= found.high and found.low <= due.high


@pytest.mark.parametrize(
    ("text", "due"),
    [
        ("v = ω·l = 50·0,3 = 15 м/с", True),
        ("v = ω·l = 50·0,3 = 15,02 м/с", False),
        ("x = a = (−53,5)·0,25/(128·0,005) = −20,9 с⁻¹", True),
        ("x = a = (−53,5)·0,25/(128·0,005) = 20,9 с⁻¹", False),
        ("x = a = 180°·(1,45 − 1)/(1,45 + 1) = 33,06°", True),
        ("x = a = (2·3)²/|1 − 5|/2 = 4,5", True),
        ("x = a = 2,5·10⁻⁷·2 = 5·10⁻⁷", True),
        ("x = a = 2,5·10⁻⁷·2 = 5·10⁻⁶", False),
        ("x = a = 0,48·sin(33,06°/2) = 0,1366", True),
        ("x = a = 0,48·sin(33,06°/2) = 0,1367", False),
        ("x = a = √(2² + 3·tg(45°)) − cos(60°) = 2,146", True),
        ("x = a = √(2² + 3·tg(45°)) − cos(60°) = 2,16", False),
    ],
)
def test_the_evaluator_tells_right_from_wrong(text: str, due: bool) -> None:
    assert agrees(text) == due


def calculations(name: str) -> Iterator[str]:
    """Every calculation of a scene, of all plans in all their positions."""
    work = drawn(name)
    for plan in ("positions", "extremes", "velocities", "accelerations"):
        reading = work.of("accelerations") if plan == "accelerations" else work.reading
        if reading is None:
            continue
        count = len(
            KINEMATICS_PLAN.on(work).accelerated if plan == "accelerations" else work.project.names
        )
        for place in range(count):
            for line in protocol(work.project.construction, plan, reading, place, "ru"):
                if line.calculation:
                    yield line.calculation
    found = synthesis(work.scene)
    if found is not None:
        reading = execute(found.construction, found.given)
        for line in protocol(found.construction, "synthesis", reading, 0, "ru"):
            if line.calculation:
                yield line.calculation


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_the_numbers_of_a_calculation_give_its_result(name: str) -> None:
    every = [text for text in calculations(name) if text.count(" = ") > 1]
    wrong = [text for text in every if not agrees(text)]
    assert len(every) > 40
    assert not wrong, wrong


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_every_reading_and_result_has_its_unit(name: str) -> None:
    for text in calculations(name):
        # the ratio of two wheels is a number
        assert text.startswith("u_") or UNIT.search(text.rsplit(" = ", 1)[1]), text


@pytest.mark.parametrize("language", ["ru", "en"])
@pytest.mark.parametrize("name", NAMES)
def test_every_protocol_is_numbered_from_one_and_has_no_markup(name: str, language: str) -> None:
    work = drawn(name)
    for plan in ("positions", "extremes", "velocities", "accelerations"):
        reading = work.of("accelerations") if plan == "accelerations" else work.reading
        if reading is None:
            continue
        lines = list(protocol(work.project.construction, plan, reading, 0, language))
        numbers = [line.number for line in lines if line.number]
        assert numbers == list(range(1, len(numbers) + 1))
        assert len(numbers) == len(work.project.marks(plan))
        for line in lines:
            assert not set("{}") & set(line.text + line.calculation), line
            assert not line.calculation or line.number
            if line.number:
                assert line.text[0].isupper()
                assert line.text.endswith(".")
            cyrillic = re.search("[а-яё]", line.text + line.calculation)
            assert language == "ru" or not cyrillic, line


def protocol_text(name: str, plan: str, place: int, language: str) -> str:
    work = drawn(name)
    lines = protocol(work.project.construction, plan, work.reading, place, language)
    return "\n".join(line.text for line in lines)


def test_the_protocol_says_which_side() -> None:
    text = protocol_text("engine", "positions", 1, "en")
    assert "cuts (x), along it from the foot of the arc's centre, mark B" in text
    text = protocol_text("engine", "positions", 1, "ru")
    assert "вперёд по направлению прямой от основания перпендикуляра, отметить B" in text
    text = protocol_text("windrower", "extremes", 0, "en")
    left, right = text.split("extreme right position of D")
    assert "extreme left position of D" in left
    assert "to the right of the way to its centre" in left
    assert "to the left of the way to its centre" in right
    assert "draw (3) along (BA), against its sense" in protocol_text(
        "windrower", "positions", 1, "en"
    )


@pytest.mark.parametrize(
    ("value", "due"),
    [
        (99999.6, "100000"),
        (999999.6, "1000000"),
        (1e7, "1·10⁷"),
        (12345678.0, "1,235·10⁷"),
        (0.0001, "0,0001"),
        (0.00001234, "1,234·10⁻⁵"),
        (-2.5e-7, "−2,5·10⁻⁷"),
        (1 / 3, "0,3333"),
        (float("inf"), "—"),
    ],
)
def test_large_and_small_numbers(value: float, due: str) -> None:
    assert number(value, "ru") == due


@given(st.floats(-1e12, 1e12, allow_nan=False, allow_subnormal=False))
def test_a_number_reads_back_to_four_figures(value: float) -> None:
    text = number(value, "ru")
    assert "-" not in text
    back = Reader(text).factor()
    assert back.low - 1e-12 * abs(value) <= value <= back.high + 1e-12 * abs(value)


@given(st.floats(-1e6, 1e6, allow_nan=False), st.integers(0, 4))
def test_a_fixed_number_keeps_its_decimals(value: float, places: int) -> None:
    text = fixed(value, places, "en")
    assert re.fullmatch(r"−?\d+" + (rf"\.\d{{{places}}}" if places else ""), text)
    back = float(text.replace("−", "-"))
    assert abs(back - value) <= 0.5001 * 10**-places + 1e-9
    assert not (back == 0 and text.startswith("−"))


def test_every_unit_of_a_log_has_a_russian_name() -> None:
    for name in NAMES:
        log = record(scene(name)).construction
        for mark in (*log.given, *(step.it for step in log.steps)):
            assert unit(mark.unit, "en") == mark.unit
            assert not re.search("[a-z]", unit(mark.unit, "ru")), mark


def test_a_doubtful_point_tells_how_many_of_its_digits_are_sure() -> None:
    work = drawn("engine")
    step = next(s for s in work.project.construction.steps if s.it.view == "velocities")
    for share, digits in ((3e-5, 4), (1e-6, 6), (0.5, 0), (20.0, 0), (math.inf, 0)):
        one = Finding("doubtful", step, 1, (2,), share)
        english, russian = (finding(one, work.project, language) for language in ("en", "ru"))
        assert f"the point is uncertain, digits that are sure: {digits}; positions" in english
        assert f"точка ненадёжна, верных цифр: {digits};" in russian


def test_a_finding_names_plan_step_reason_amount_and_positions(tmp_path: Path) -> None:
    text = (SHEETS / "engine" / "scene.toml").read_text(encoding="utf-8")
    short = tmp_path / "scene.toml"
    short.write_text(text.replace('l  = "0.64 m"', 'l  = "0.25 m"'), encoding="utf-8")
    work = drawn_of(read(short))
    found = next(f for f in work.findings() if f.kind == "undrawn")
    names = work.project.names
    # at position 4 the crank stands up: OA - AB = 60 - 50 mm; at 3 and 5 it is 60·sin 60° - 50
    assert math.isclose(abs(found.amount), 10.0, abs_tol=1e-9)
    assert [names[k] for k in found.positions] == ["3", "4", "5", "9", "10", "11"]
    english, russian = (finding(found, work.project, language) for language in ("en", "ru"))
    assert english.startswith("plan of positions, step ")
    assert "the arc does not reach the line" in english
    assert "10 mm" in english
    assert english.endswith("positions 3, 4, 5, 9, 10, 11")
    assert "дуга не достигает прямой" in russian
    assert "10 мм" in russian
