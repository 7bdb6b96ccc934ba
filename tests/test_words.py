"""Words and numbers for people: the calculation note is recomputed by an evaluator of its own."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest

from graphic_tmm.scene.read import read
from graphic_tmm.studio import fitted
from graphic_tmm.words import fixed, number, protocol, unit

HOME = Path(__file__).parent.parent / "sheets"


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


def _evaluated(text: str) -> float:
    """Evaluate the numbers of a calculation: 2·(−6,6)·47,5·0,1/2, powers, sin of degrees."""
    text = text.replace(",", ".").replace("−", "-").replace("·", "*").replace("°", "")
    text = text.replace("²", "**2")
    text = re.sub(r"\*10([⁻⁰¹²³⁴-⁹]+)", lambda m: "e" + _raised(m[1]), text)
    text = re.sub(r"\|([^|]+)\|", r"abs(\1)", text)
    assert re.fullmatch(r"[-+*/().0-9e abs]*|.*sin.*", text), text
    return float(
        eval(text, {"__builtins__": {}}, {"abs": abs, "sin": lambda x: math.sin(math.radians(x))})
    )


def _raised(signs: str) -> str:
    return signs.translate(str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-"))


@pytest.mark.parametrize("name", ["engine", "windrower", "accelerating-crank"])
def test_the_numbers_of_a_calculation_give_its_result(name: str) -> None:
    work = fitted(read(HOME / name))
    checked = 0
    for plan in ("positions", "velocities", "accelerations"):
        reading = work.accelerated if plan == "accelerations" else work.reading
        count = len(work.project.accelerated if plan == "accelerations" else work.project.names)
        for place in range(count):
            for line in protocol(work.project.construction, plan, reading, place, "ru"):
                parts = line.calculation.split(" = ")
                if len(parts) < 4:
                    continue
                found = float(
                    re.sub(r"·10([⁻⁰¹²³⁴-⁹]+)", lambda m: "e" + _raised(m[1]), parts[3])
                    .replace("−", "-").replace(",", ".").split(" ")[0].rstrip("°")
                )  # fmt: skip
                due = _evaluated(parts[2])
                # both sides are printed to four digits; up to five rounded factors
                assert abs(due - found) <= 4e-3 * max(abs(due), abs(found)) + 1e-9, line
                checked += 1
    assert checked > 50


def test_the_protocol_is_numbered_and_says_which_side() -> None:
    work = fitted(read(HOME / "engine"))
    lines = list(protocol(work.project.construction, "positions", work.reading, 1, "en"))
    numbers = [line.number for line in lines if line.number]
    assert numbers == list(range(1, len(numbers) + 1))
    assert any("along it from the foot of the arc's centre, mark B" in line.text for line in lines)
    assert not any("{" in line.text for line in lines)
