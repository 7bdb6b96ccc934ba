"""Words, Russian and English: the protocol of a plan, the calculation note, captions, findings.

The sentences live on the operations; here letters and numbers are put into them.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.execute import Reading
from graphic_tmm.board.findings import Finding
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Angle, Curve, Length, Side, undefined
from graphic_tmm.language.captions import CAPTIONS, UNITS_RU
from graphic_tmm.language.captions.symbols import symbol
from graphic_tmm.readers.equations import equations

_RAISED = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


class Line(NamedTuple):
    """One line of the protocol: its number (0 for a remark), its text, its calculation ("" if none).

    ``first``: the number of the first of the steps that the line tells, where it tells several.
    """

    number: int
    text: str
    calculation: str = ""
    first: int = 0

    @property
    def label(self) -> str:
        """The number of the step, or the numbers of the steps: 8, 8–9."""
        return f"{self.first}–{self.number}" if 0 < self.first < self.number else str(self.number)


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


def spoken(mark: Mark, language: str) -> str:
    """Return what a mark is called in a language, as plain text."""
    return plain(symbol(mark.name, language))


def _letters(step: Step, name: Callable[[Mark], str]) -> dict[str, str]:
    letters = {
        argument: name(mark) for argument, mark in zip(step.op.arguments, step.uses, strict=True)
    }
    return letters | {"it": name(step.it)}


_JOINED = re.compile(r"\{(\w+)\}(?=\{)")


def _segments(text: str, words: Mapping[str, str]) -> str:
    """Return a sentence with a dash in each segment whose ends would run into one another: 5–1, i–i+1.

    Letters of one sign and their figures are told apart as they are: OA, aa3.
    """

    def dashed(found: re.Match[str]) -> str:
        behind = text[found.end() + 1 :].partition("}")[0]
        ends = words[found[1]], words[behind]
        return found[0] + ("" if all(_END.fullmatch(end) for end in ends) else "–")

    return _JOINED.sub(dashed, text)


_END = re.compile(r"[^\W\d_]\d*′?")


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
        called = spoken(mark, language) or _with_unit(mark, reading, place, language)
        if mark.view != step.it.view and mark.name in elsewhere:
            called += CAPTIONS[language]["of view"].format(view=view_name(mark.view, language))
        return called

    here = [mark for mark in (step.it, *step.uses) if mark.view == step.it.view]
    elsewhere = {mark.name for mark in here if mark.kind is not Side}
    text = step.op.ru if russian else step.op.en
    words = _letters(step, name)
    if step.op.formula:
        return f"{CAPTIONS[language]['calculate']} {words['it']}."
    words |= {
        key: step.op.sides[1 if russian else 0][0 if choice > 0 else 1]
        for key, choice in step.choice.items()
    }
    return _segments(text, words).format(**words)


def flywheel_title(view: str, constant: str, language: str) -> str:
    """Return what a graph of the flywheel is called; that of the moment by which of the moments varies."""
    varying = view == "moment" and constant == "driving"
    return CAPTIONS[language]["moment driving" if varying else view]


def view_name(view: str, language: str, point: str = "") -> str:
    """Return what a view is called, as plain text; figures and polygons of forces by their group.

    ``point``: of which the diagrams are.
    """
    words = CAPTIONS[language]
    kind, _, name = view.partition(" ")
    keys = {
        "group": ("group of forces", "link of forces"),
        "forces": ("polygon of group", "polygon of link"),
    }
    if kind in keys and name:
        name, _, tried = name.partition(" ")
        title = words[keys[kind][0 if "-" in name else 1]].format(name=name)
        return title + (words["pass"].format(number=tried) if tried else "")
    title = words.get(f"diagram {view}", words.get(view, view))
    return plain(title.replace("{point}", point)).strip()


def calculation(
    step: Step, reading: Reading, place: int, language: str, summed: tuple[Mark, ...] = ()
) -> str:
    """Return a formula with its numbers put in, v_A = ω_1·l_OA = 39,79·0,1366 = 5,434 м/с, or a reading.

    ``summed``: all terms of a sum that was added up in several steps.
    """
    if not (step.op.reads or step.op.formula):
        return ""
    it = spoken(step.it, language)
    if not np.isfinite(_value(reading, step.it, place)):
        return f"{it}: {CAPTIONS[language]['undrawn']}"
    result = _with_unit(step.it, reading, place, language)
    if step.op.reads:
        return f"{it} = {result}"

    def put(mark: Mark) -> str:
        text = number(_value(reading, mark, place), language)
        text += "°" if mark.kind is Angle else ""
        return f"({text})" if text.startswith("−") else text

    letters = _letters(step, lambda mark: spoken(mark, language) or put(mark))
    numbers = _letters(step, put)
    formula = step.op.formula
    if summed:
        terms = [spoken(m, language) for m in summed], [put(m) for m in summed]
        formulas = [" + ".join(of) for of in terms]
    else:
        formulas = [formula.format(**letters), formula.format(**numbers)]
    return " = ".join(dict.fromkeys([it, *formulas, result]))


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
    elsewhere: Sequence[tuple[int, str]] = (),
) -> Iterator[Line]:
    """Yield the numbered protocol of one plan in one position, with equations and the calculation note.

    ``place``: the index of the position in ``reading``; ``turned``: the plan is turned by 90°. ``elsewhere``:
    other positions by index and name; what has no value in the first is told in one of them.
    """
    told, own = place, {place: "", **dict(elsewhere)}
    solved = {e.group: e for e in equations(construction, plan, turned=turned)}
    steps = [step for step in construction.steps if step.it.view == plan]
    sums = _sums(steps)
    first = 0
    for counted, step in enumerate(steps, 1):
        for note in filter(None, step.note.split("\n")):
            yield Line(0, _remark(note, language))
            if note in solved:
                yield Line(0, f"{solved[note].text};  {plain(solved[note].directions)}")
        first = first or counted
        terms = sums.get(step.it, ())
        if step.it in sums and not terms:
            continue  # told with the sum that it is a part of
        at = next((k for k in own if defined(reading, step.it, k)), place)
        if at != told and own.get(at) and not _still(reading, step.it):
            yield Line(0, f"{CAPTIONS[language]['position']} {own[at]}")
            told = at
        note = calculation(step, reading, at, language, terms)
        yield Line(counted, sentence(step, language, reading, at), note, first)
        first = 0


def defined(reading: Reading, mark: Mark, place: int) -> bool:
    """Whether a mark has a value in a position (an index); a curve is of all positions."""
    if mark.kind is Curve:
        return True
    row = undefined(reading[mark])[0]
    return not row[place if row.size > 1 else 0]


def _still(reading: Reading, mark: Mark) -> bool:
    """Whether a mark is the same in all positions."""
    return mark.kind is Curve or undefined(reading[mark]).shape[1] == 1


def _sums(steps: Sequence[Step]) -> dict[Mark, tuple[Mark, ...]]:
    """Return the terms of each sum that was added up in several steps; none for the sums on the way to it."""
    found: dict[Mark, tuple[Mark, ...]] = {}
    before: Step | None = None
    for step in steps:
        if before is not None and before.it.role == step.it.role == roles.SUM:
            if before.it == step.uses[0]:
                found[step.it] = (*(found.get(before.it) or before.uses), *step.uses[1:])
                found[before.it] = ()
        before = step
    return found


_EXTREMES = {
    "left": ("крайнее левое", "extreme left"),
    "right": ("крайнее правое", "extreme right"),
    "top": ("крайнее верхнее", "extreme upper"),
    "bottom": ("крайнее нижнее", "extreme lower"),
}


def _remark(note: str, language: str) -> str:
    """Return a remark of the log in words: "D: left" is the extreme left position of D."""
    words = CAPTIONS[language]
    if f"phase {note}" in words:
        return words[f"phase {note}"]
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
    words = _letters(found.step, lambda mark: spoken(mark, language))
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
    plan = _in_sentence(found.step.it.view, language)
    step = "шаг" if language == "ru" else "step"
    where = CAPTIONS[language]["at positions"]
    return f"{plan}, {step} {found.number} '{words['it']}': {why}; {where} {at}"


def _in_sentence(view: str, language: str) -> str:
    """Return what a view is called within a sentence: small, but for a man's name."""
    name = CAPTIONS[language].get(view, view)
    return name if name.startswith("Zhukovsky") else name[:1].lower() + name[1:]


def left_out(found: Sequence[Finding], names: tuple[str, ...], language: str) -> Iterator[str]:
    """Yield, as sentences, the figures of which no digit is sure, together those of the same positions."""
    for places in dict.fromkeys(one.positions for one in found):
        some = [one for one in found if one.positions == places]
        plans = dict.fromkeys(one.step.it.view for one in some)
        told = []
        for plan in plans:
            letters = ", ".join(_letters_of(one) for one in some if one.step.it.view == plan)
            told.append(f"{_in_sentence(plan, language)} {letters}")
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
    return ", ".join(dict.fromkeys(plain(mark.letter).rstrip("′") for mark in found.marks))
