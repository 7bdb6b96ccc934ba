"""Words, Russian and English: the protocol of a plan, the calculation note, captions, findings.

The sentences live on the operations; here letters and numbers are put into them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.findings import Finding
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Angle, Length, Side
from graphic_tmm.captions import CAPTIONS, UNITS_RU
from graphic_tmm.equations import equations

_RAISED = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


class Line(NamedTuple):
    """One line of the protocol: its number (0 for a remark), its text, its calculation ("" if none)."""

    number: int
    text: str
    calculation: str = ""


def unit(name: str, language: str) -> str:
    """Return a unit in the language of the sheet."""
    return UNITS_RU[name] if language == "ru" else name


def number(value: float, language: str, digits: int = 4) -> str:
    """Return a number to ``digits`` significant figures, with the decimal sign of the language.

    >>> number(0.136571, "ru"), number(-4.0, "en"), number(2.5e-07, "en")
    ('0,1366', '−4', '2.5·10⁻⁷')
    """
    if not np.isfinite(value):
        return "—"
    text = f"{value:.{digits}g}"
    mantissa, _, exponent = text.partition("e")
    if exponent:
        power = int(exponent)
        text = f"{value:.0f}" if 0 < power < 7 else f"{mantissa}·10{str(power).translate(_RAISED)}"
    text = "0" if text in ("-0", "0") else text.replace("-", "−", 1)
    return text.replace(".", ",") if language == "ru" else text


def fixed(value: float | None, places: int, language: str) -> str:
    """Return a number with a fixed count of decimals; a dash where there is none."""
    if value is None or not np.isfinite(value):
        return "—"
    text = f"{value:.{places}f}"
    text = text.lstrip("-") if float(text) == 0 else text.replace("-", "−")
    return text.replace(".", ",") if language == "ru" else text


def plain(letter: str) -> str:
    """Return a letter of the log as plain text: l_{OA} -> l_OA."""
    return letter.replace("{", "").replace("}", "")


def _letters(step: Step, name: Callable[[Mark], str]) -> dict[str, str]:
    letters = {
        argument: name(mark) for argument, mark in zip(step.op.arguments, step.uses, strict=True)
    }
    return letters | {"it": name(step.it)}


def _value(reading: Reading, mark: Mark, place: int) -> float:
    row = reading.figure(mark)[0]
    return float(row[place if row.size > 1 else 0])


def sentence(step: Step, language: str, reading: Reading, place: int) -> str:
    """Return what is done in a step in one position (its index in ``reading``), as a sentence."""
    russian = language == "ru"

    def name(mark: Mark) -> str:
        if mark.kind is Side:
            plus, minus = step.op.sides[1 if russian else 0]
            return plus if _value(reading, mark, place) > 0 else minus
        return plain(mark.letter)

    text = step.op.ru if russian else step.op.en
    words = _letters(step, name)
    if step.op.formula:
        return f"{CAPTIONS[language]['calculate']} {words['it']}."
    return text.format(**words)


def calculation(step: Step, reading: Reading, place: int, language: str) -> str:
    """Return a formula with its numbers put in, v_A = ω_1·l_OA = 39,79·0,1366 = 5,434 м/с, or a reading."""
    if not (step.op.reads or step.op.formula):
        return ""
    result = _with_unit(step.it, reading, place, language)
    if step.op.reads:
        return f"{plain(step.it.letter)} = {result}"

    def put(mark: Mark) -> str:
        text = number(_value(reading, mark, place), language)
        text += "°" if mark.kind is Angle else ""
        return f"({text})" if text.startswith("−") else text

    letters = _letters(step, lambda mark: plain(mark.letter))
    numbers = _letters(step, put)
    formulas = (step.op.formula.format(**letters), step.op.formula.format(**numbers))
    return " = ".join([letters["it"], *formulas, result])


def _with_unit(mark: Mark, reading: Reading, place: int, language: str) -> str:
    figure = number(_value(reading, mark, place), language)
    if mark.kind is Angle:
        return f"{figure}°"
    return f"{figure} {_unit_of(mark, language)}".rstrip()


def _unit_of(mark: Mark, language: str) -> str:
    if mark.kind is Length:
        return unit("mm", language)
    return unit("°" if mark.kind is Angle else mark.unit, language)


def protocol(
    construction: Construction,
    plan: str,
    reading: Reading,
    place: int,
    language: str,
    *,
    turned: bool = False,
) -> Iterator[Line]:
    """Yield the numbered protocol of one plan in one position, with equations and the calculation note.

    ``place``: the index of the position in ``reading``; ``turned``: the plan is turned by 90°.
    """
    counted = 0
    solved = {e.group: e for e in equations(construction, plan, turned=turned)}
    for step in construction.steps:
        if step.it.view != plan:
            continue
        for note in filter(None, step.note.split("\n")):
            yield Line(0, _remark(note, language))
            if note in solved:
                yield Line(0, f"{solved[note].text};  {plain(solved[note].directions)}")
        counted += 1
        yield Line(
            counted,
            sentence(step, language, reading, place),
            calculation(step, reading, place, language),
        )


_EXTREMES = {
    "left": ("крайнее левое", "extreme left"),
    "right": ("крайнее правое", "extreme right"),
    "top": ("крайнее верхнее", "extreme upper"),
    "bottom": ("крайнее нижнее", "extreme lower"),
}


def _remark(note: str, language: str) -> str:
    """Return a remark of the log in words: "D: left" is the extreme left position of D."""
    letter, _, way = note.partition(": ")
    if way not in _EXTREMES:
        return plain(note)
    russian, english = _EXTREMES[way]
    return (
        f"{russian} положение точки {letter}"
        if language == "ru"
        else f"{english} position of {letter}"
    )


def finding(found: Finding, names: tuple[str, ...], language: str) -> str:
    """Return a finding as a sentence: plan, step, letter, why, positions."""
    op = found.step.op
    words = _letters(found.step, lambda mark: plain(mark.letter))
    at = ", ".join(names[i] for i in found.positions)
    why = {
        "undrawn": op.fails_ru if language == "ru" else op.fails_en,
        "touching": "касание: оба решения совпадают" if language == "ru" else "the figures touch",
        "doubtful": "точка ненадёжна, верных цифр: {}"
        if language == "ru"
        else "the point is uncertain, digits that are sure: {}",
        "lost": "округление не оставляет верных цифр; опущены: {}"
        if language == "ru"
        else "rounding leaves no digit that is sure; left out: {}",
        "idle": "все силы равны нулю: строить нечего, масштаба нет"
        if language == "ru"
        else "all forces are zero: there is nothing to draw, and no scale",
    }[found.kind]
    if found.kind == "undrawn" and found.gap is not None:
        text = (found.gap.ru if language == "ru" else found.gap.en).format(**words)
        why += f" ({text}, {number(found.amount, language, 3)} {unit('mm', language)})"
    if found.kind == "lost":
        why = why.format(_letters_of(found))
    if found.kind == "doubtful":
        why = why.format(max(0, math.floor(-math.log10(found.amount))) if found.amount < 1.0 else 0)
    plan = CAPTIONS[language].get(found.step.it.view, found.step.it.view).lower()
    step = "шаг" if language == "ru" else "step"
    where = CAPTIONS[language]["at positions"]
    return f"{plan}, {step} {found.number} '{words['it']}': {why}; {where} {at}"


def left_out(found: Sequence[Finding], names: tuple[str, ...], language: str) -> Iterator[str]:
    """Yield, as sentences, the figures of which no digit is sure, together those of the same positions."""
    for places in dict.fromkeys(one.positions for one in found):
        some = [one for one in found if one.positions == places]
        plans = dict.fromkeys(one.step.it.view for one in some)
        told = []
        for plan in plans:
            letters = ", ".join(_letters_of(one) for one in some if one.step.it.view == plan)
            told.append(f"{CAPTIONS[language].get(plan, plan).lower()} {letters}")
        where = CAPTIONS[language]["at positions"]
        why = (
            "округление не оставляет верных цифр, опущены"
            if language == "ru"
            else "rounding leaves no digit that is sure, left out are"
        )
        at = ", ".join(names[i] for i in places)
        yield f"{why}: {'; '.join(told)}; {where} {at}"


def _letters_of(found: Finding) -> str:
    """Return the letters that are left out, each once, however often it is primed."""
    return ", ".join(dict.fromkeys(plain(letter).rstrip("′") for letter in found.letters))
