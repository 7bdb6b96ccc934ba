"""A step in words: what is done, as a sentence, and why; its calculation with the numbers put in.

The sentences live on the operations and in the catalogues, reasons there or on the steps; here letters and
numbers are put into them.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.execute import Reading
from graphic_tmm.board.operations.instruments import ray
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Angle, Length, Number, Side
from graphic_tmm.drawn import MEASURED
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import EXACTLY, number
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import spoken, with_functions
from graphic_tmm.language.units import unit, unit_name
from graphic_tmm.scene.captions import captions, view_name


def letters_of(step: Step, name: Callable[[Mark], str]) -> dict[str, str]:
    """Return what stands for the arguments of a step, and for the mark that it leaves."""
    letters = {
        argument: name(mark) for argument, mark in zip(step.op.arguments, step.uses, strict=True)
    }
    return letters | {"it": name(step.it)}


_JOINED = re.compile(r"\{(\w+)\}(?=\{)")


def _segments(text: str, words: Mapping[str, str]) -> str:
    """Return a sentence with a dash in each segment whose ends would run together: 5–1, i–i+1.

    Letters of one sign with their figures need none: OA, aa3.
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


def phrase(step: Step, language: str, reading: Reading, place: int) -> tuple[str, dict[str, str]]:
    """Return the sentence of a step as a template, and what stands for its names, see `sentence`."""
    words = _words(step, language, reading, place)
    if step.op.formula:
        return f"{captions(language)['calculate']} {{it}}.", words
    told = speaking(language)(TO_THE_RIGHT if _level(step, reading, place) else step.op.sentence)
    return _segments(told, words), words


TO_THE_RIGHT = said("From {start} draw the ray {it} to the right.")


def _level(step: Step, reading: Reading, place: int) -> bool:
    """Whether a step draws an axis: a ray whose angle has no letter and is nothing."""
    angle = step.uses[-1] if step.op is ray else None
    return angle is not None and not angle.name and _value(reading, angle, place) == 0.0


def sentence(step: Step, language: str, reading: Reading, place: int) -> str:
    """Return what is done in a step in one position (its index in ``reading``), as a sentence."""
    template, words = phrase(step, language, reading, place)
    return template.format(**words)


def reason(step: Step, language: str, reading: Reading, place: int) -> str:
    """Return why a step is done, a sentence; "" without a reason."""
    if not step.reason:
        return ""
    words = _words(step, language, reading, place)
    return _segments(speaking(language)(step.reason), words).format(**words)


Phrase = tuple[str, Mapping[str, str]]
"""A sentence as a template, and what stands for its names."""


def grounds(step: Step, language: str, reading: Reading, place: int) -> Phrase | None:
    """Return why a step is done, a template with its words; None without a reason."""
    if not step.reason:
        return None
    words = _words(step, language, reading, place)
    return _segments(speaking(language)(step.reason), words), words


def _words(step: Step, language: str, reading: Reading, place: int) -> dict[str, str]:
    """Return what stands for the arguments of a step, for its choices and for the mark that it leaves."""
    _ = speaking(language)
    sides = _(step.op.sides[0]), _(step.op.sides[1])

    def name(mark: Mark) -> str:
        if mark.kind is Side:
            plus, minus = sides
            return plus if _value(reading, mark, place) > 0 else minus
        called = spoken(mark, language) or _with_unit(mark, reading, place, language)
        if mark.view != step.it.view and mark.name in elsewhere:
            called += captions(language)["of view"].format(view=view_name(mark.view, language))
        return called

    here = [mark for mark in (step.it, *step.uses) if mark.view == step.it.view]
    elsewhere = {mark.name for mark in here if mark.kind is not Side}
    chosen = {key: sides[0 if choice > 0 else 1] for key, choice in step.choice.items()}
    return letters_of(step, name) | chosen


def calculation(
    step: Step, reading: Reading, place: int, language: str, summed: tuple[Mark, ...] = ()
) -> str:
    """Return a formula with its numbers put in, v_A = ω_1·l_OA = 39,79·0,1366 = 5,434 м/с, or a reading.

    Of a figure drawn similar to another it is the proportion of its segments. ``summed``: all terms of a sum
    that was added up in several steps.
    """
    if step.op.proportion:
        return _proportion(step, reading, place, language)
    if not worth(step):
        return ""
    it = spoken(step.it, language)
    if not np.isfinite(_value(reading, step.it, place)):
        return f"{it}: {captions(language)['undrawn']}"
    result = _with_unit(step.it, reading, place, language)
    if not step.op.formula:
        return f"{it} = {result}"

    def put(mark: Mark) -> str:
        text = number(_value(reading, mark, place), language)
        text += "°" if mark.kind is Angle else ""
        return f"({text})" if text.startswith("−") else text

    formula = with_functions(step.op.formula, language)
    letters = letters_of(step, lambda mark: spoken(mark, language) or put(mark))
    numbers = _closed(formula, letters_of(step, put))
    if summed:
        terms = [spoken(m, language) for m in summed], [put(m) for m in summed]
        formulas = [" + ".join(of) for of in terms]
    else:
        formulas = [formula.format(**letters), formula.format(**numbers)]
    if not summed and any(spoken(mark, language) == it for mark in step.uses):
        del formulas[0]  # one letter on both sides says nothing
    if _APART in formula:
        return f"{it} = {formulas[-1]} {_unit_of(step.it, language)}".rstrip()
    return " = ".join(dict.fromkeys([it, *formulas, result]))


def _closed(formula: str, numbers: dict[str, str]) -> dict[str, str]:
    """Return numbers, in brackets where a product would come apart: behind a stroke, or raised."""
    bound = {found[1] or found[2] for found in _BOUND.finditer(formula)}
    return {
        name: f"({told})" if name in bound and _POWER in told and told[0] != "(" else told
        for name, told in numbers.items()
    }


def step_figure(
    step: Step, reading: Reading, place: int, language: str
) -> tuple[float | None, str]:
    """Return the figure that a step leaves in a position, and its unit; None where it leaves none."""
    if not worth(step) or step.it.kind not in (Length, Number, Angle):
        return None, ""
    value = _value(reading, step.it, place)
    of = unit_name(MEASURED.get(step.it.kind, step.it.unit), language)
    return (value if np.isfinite(value) else None), of


def worth(step: Step) -> bool:
    """Whether a step has a figure that its sentence does not state, as it states a value without a letter."""
    op = step.op
    if op.formula or op.reads or step.it.role == roles.READ_OFF:
        return True
    told = op.leaves is Number or (op.leaves is Angle and not op.kept)
    return told and all(mark.name for mark in step.uses)


_BOUND = re.compile(r"(?<=/)\{(\w+)\}|\{(\w+)\}(?=[²³^])")
_APART = "±"
"""What stands before how far a value may be off: it is no sum."""
_POWER = "·10"
"""A number with a power of ten is a product."""
NOTHING = 1e-9
"""A segment that is shorter, mm, is none: nothing is in a proportion to it."""
_SEGMENT = re.compile(r"\{(\w+)\}\{(\w+)\}")


def _proportion(step: Step, reading: Reading, place: int, language: str) -> str:
    """Return the proportion of a step, and the segment sought by it: pc/pb = AC/AB; pc = pb·AC/AB = …, mm."""
    marks = dict(zip(step.op.arguments, step.uses, strict=True)) | {"it": step.it}
    names = {key: spoken(mark, language) for key, mark in marks.items()}
    told = _segments(step.op.proportion, names).format(**names)
    left, _, right = told.partition(" = ")
    segment, _, known = left.partition("/")
    lengths = []
    for one, other in _SEGMENT.findall(step.op.proportion):
        ends = (reading[marks[end]][0] for end in (one, other))
        start, end = (row[place if row.size > 1 else 0] for row in ends)
        lengths.append(float(abs(end - start)))
    sought, base, part, whole = lengths
    if not (np.isfinite(sought) and base > NOTHING and whole > NOTHING):
        return ""
    upper, _, lower = right.partition("/")
    put = "·".join((number(base, language), number(part, language)))
    put += f"/{number(whole, language)}"
    result = f"{number(sought, language)} {unit('mm', language)}"
    return f"{told};  {segment} = {known}·{upper}/{lower} = {put} = {result}"


def _with_unit(mark: Mark, reading: Reading, place: int, language: str) -> str:
    value = _value(reading, mark, place)
    figure = number(round(value, EXACTLY) if mark.unit == "%" else value, language)
    if mark.kind is Angle:
        return f"{figure}°"
    return f"{figure} {_unit_of(mark, language)}".rstrip()


def _unit_of(mark: Mark, language: str) -> str:
    if mark.kind is Length:
        return unit("mm", language)
    return unit("°" if mark.kind is Angle else mark.unit, language)
