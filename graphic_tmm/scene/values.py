"""The kinds of values of a scene file: how each is checked, how it is described to an editor."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from itertools import pairwise

from graphic_tmm.board.bounds import POSITIVE, Bound
from graphic_tmm.language.said import Said, joined, said
from graphic_tmm.scene import lengths, letters, misfits, quantities
from graphic_tmm.scene.declare import Kind, Names, Schema
from graphic_tmm.scene.misfits import stands
from graphic_tmm.scene.units import Dimension

COUNTERCLOCKWISE, CLOCKWISE = "counterclockwise", "clockwise"
MU_L_OMEGA = "mu_l*omega1"


def quantity(dimension: Dimension, bound: Bound | None = None) -> Kind:
    """Return the kind of a quantity of a dimension: a number in SI (degrees), or a text with its unit."""

    def read(value: object, names: Names) -> float:
        number = quantities.parse(value, dimension)
        if bound is not None and not bound.holds(number):
            text, least = _show(value), bound.least
            if bound.above:
                raise ValueError(
                    said("{text} is not greater than {least:g}", text=text, least=least)
                )
            raise ValueError(said("{text} is less than {least:g}", text=text, least=least))
        return number

    return Kind(read, quantity_schema(dimension), bound, dimension)


def quantity_schema(dimension: Dimension) -> Schema:
    """Return what an editor is told of a quantity."""
    bare = "degrees" if dimension == "angle" else "SI units (scales: SI unit/mm)"
    return {
        "anyOf": [{"type": "number"}, {"type": "string"}],
        "description": f"{quantities.article(dimension)}: a number in {bare}, or a text with unit",
    }


def _show(value: object) -> str:
    if isinstance(value, (int, float)):
        return misfits.digits_of(value)
    return f'"{value}"'


def choice(*words: str, **synonyms: str) -> Kind:
    """Return the kind of one of some words; a synonym (_ for a space) answers with its word."""
    meant = {word: word for word in words} | {
        other.replace("_", " "): word for other, word in synonyms.items()
    }

    def read(value: object, names: Names) -> str:
        if isinstance(value, str) and value in meant:
            return meant[value]
        raise ValueError(no_choice(value, list(words), list(meant)))

    return Kind(read, {"type": "string", "enum": list(meant)})


def choice_of(words: Callable[[], dict[str, str]]) -> Kind:
    """Return the kind of one of some words that are asked for when a scene is read, and what each means."""

    def read(value: object, names: Names) -> str:
        meant = words()
        if isinstance(value, str) and value in meant:
            return meant[value]
        raise ValueError(no_choice(value, list(dict.fromkeys(meant.values())), list(meant)))

    return Kind(read, lambda: {"type": "string", "enum": list(words())})


def no_choice(value: object, words: list[str], known: list[str]) -> Said:
    """Return why a value is none of some words, the one of all ``known`` that was probably meant, the words."""
    listed = ", ".join(f'"{word}"' for word in words)
    one = len(words) == 1
    only = (
        said("it can only be {listed}", listed=listed)
        if one
        else said("it is one of {listed}", listed=listed)
    )
    told = str(value)[:40]
    several = sum(word.startswith(told) for word in words) > 1
    return stands(value, "" if several else misfits.meant(told, known, 0.6), only)


def _text(value: object, names: Names) -> str:
    if not isinstance(value, str):
        raise ValueError(stands(value, said("a text in quotes is wanted")))
    if fault := letters.text_fault(value):
        raise ValueError(fault)
    return value


def _title(value: object, names: Names) -> str:
    if not _text(value, names).strip():
        raise ValueError(said("the title is empty; write what the mechanism is"))
    return str(value)


def number(bound: Bound, dimension: Dimension | None = None) -> Kind:
    """Return the kind of a number within bounds; of a dimension it may also be a text with its unit."""

    def read(value: object, names: Names) -> float:
        found = value
        if dimension is not None and (isinstance(value, str) or dimension != "ratio"):
            found = quantities.parse(value, dimension)
        elif bound.whole and (isinstance(value, bool) or not isinstance(value, int)):
            raise ValueError(stands(value, said("a whole number is wanted, without quotes")))
        if not bound.holds(found):
            raise ValueError(stands(value, said("{bound} is wanted", bound=bound.wanted)))
        assert isinstance(found, int | float)
        return found if bound.whole else float(found)

    return Kind(read, bounded(bound, dimension), bound, dimension or "")


def bounded(bound: Bound, dimension: Dimension | None = None) -> Schema:
    """Return what an editor is told of a number within bounds."""
    if dimension is None:
        return dict(bound.schema)
    made = quantity_schema(dimension) if dimension != "ratio" else {}
    return {**made, "anyOf": [dict(bound.schema), {"type": "string"}]}


def follows(places: Sequence[float]) -> bool:
    """Return whether the places of a table follow one after the other; two equal ones are a jump."""
    jumps = any(a >= c for a, c in zip(places, places[2:], strict=False))
    return not jumps and all(a <= b for a, b in pairwise(places))


def follow(places: Sequence[float]) -> None:
    """Refuse, with a ValueError, places of a table that do not follow one after the other."""
    if not follows(places):
        raise ValueError(
            said(
                "the points of the table do not follow one after the other; put them in order, two at a jump"
            )
        )


def within(value: object) -> float:
    """Return a share of a stroke, 0 … 1; ValueError if it is none."""
    found = quantities.parse(value, "ratio") if isinstance(value, str) else value
    if not _WITHIN.holds(found):
        raise ValueError(stands(value, said("a share of the stroke is between 0 and 1")))
    return float(found)  # type: ignore[arg-type]


def _point(value: object, names: Names) -> complex:
    if not isinstance(value, list) or len(value) != 2:
        remedy = said('a point is a list of two lengths, ["95 mm", 0]')
        if not isinstance(value, list):
            raise ValueError(stands(value, remedy))
        here = said("a list of {n} stands here", n=len(value))
        raise ValueError(joined("; ", (here, remedy)))
    numbers: list[float] = []
    faults: list[str] = []
    for axis, item in zip("xy", value, strict=True):
        try:
            numbers.append(lengths.evaluate(item, names))
        except ValueError as error:
            faults.append(joined(": ", (axis, error.args[0])))
    if faults:
        raise ValueError(joined("; ", faults))
    return complex(numbers[0], numbers[1])


def _angles(value: object, names: Names) -> tuple[float, ...]:
    if not isinstance(value, list):
        raise ValueError(stands(value, said('a list of angles is wanted, ["90 deg"]')))
    return tuple(quantities.parse(item, "angle") for item in value)


def _speed(value: object, names: Names, *, turns: bool = False) -> float:
    number = quantities.parse(value, "angular speed")
    if number == 0:
        raise ValueError(
            said(
                "{text}: what stands still moves nothing; write a speed so small that nothing comes of it, "
                '"0.001 rad/s"',
                text=_show(value),
            )
        )
    if number < 0 and not turns:
        raise ValueError(said("{text} is negative; write it positive", text=_show(value)))
    return not_negative(number, value)


def not_negative(number: float, value: object) -> float:
    """Return a speed; refuse one that is negative where a key ``turns`` stands beside it."""
    if number < 0:
        raise ValueError(
            said('{text} is negative; write it positive and turns = "clockwise"', text=_show(value))
        )
    return number


def _ratio(value: object, names: Names) -> float:
    if isinstance(value, str):
        raise ValueError(stands(value, said("K_v is a plain number, without quotes")))
    if not SPEED_RATIO.holds(value):
        remedy = said("K_v is {bound}, such as 1.45", bound=SPEED_RATIO.wanted)
        raise ValueError(stands(value, remedy))
    return float(value)  # type: ignore[arg-type]


def _mu_l(value: object, names: Names) -> float:
    drawn = re.fullmatch(r"\s*([0-9]+(?:[.,][0-9]+)?)\s*:\s*([0-9]+(?:[.,][0-9]+)?)\s*", str(value))
    if isinstance(value, str) and drawn:
        paper, real = (float(part.replace(",", ".")) for part in drawn.groups())
        number = quantities.kept(real / paper / 1000, "scale of lengths") if paper else 0.0
    else:
        number = quantities.parse(value, "scale of lengths")
    return _positive_scale(number, value)


def _mu_v(value: object, names: Names) -> float | str:
    if isinstance(value, str) and re.fullmatch(
        r"(?:mu|μ|µ)_?l\s*[*·⋅]?\s*(?:omega|ω)_?1", value.strip()
    ):
        return MU_L_OMEGA
    return _positive_scale(quantities.parse(value, "scale of velocities"), value)


def mu(dimension: Dimension) -> Kind:
    """Return the kind of a scale factor of a dimension."""

    def read(value: object, names: Names) -> float:
        return _positive_scale(quantities.parse(value, dimension), value)

    return Kind(read, SCALE, _MU, dimension)


def _positive_scale(number: float, value: object) -> float:
    if not _MU.holds(number):
        raise ValueError(
            said(
                "{text} cannot be a scale factor; it is what 1 mm of paper stands for",
                text=_show(value),
            )
        )
    return number


def _drawn(value: object, names: Names) -> float:
    metres = quantities.in_si(value, "length")
    if not _PAPER.holds(metres * 1000):
        raise ValueError(
            said(
                '{text} is {metres:g} m on the sheet (a number is in metres); write "60 mm"',
                text=_show(value),
                metres=metres,
            )
        )
    return metres * 1000


def _ruler(value: object, names: Names) -> float | str:
    if value == "exact":
        return "exact"
    metres = quantities.in_si(value, "length", "0.1 mm")
    if not _DIVISION.holds(metres * 1000):
        raise ValueError(
            said('{text} is no ruler; write "0.1 mm", "0.5 mm" or "exact"', text=_show(value))
        )
    return metres * 1000


def _target(value: object, names: Names) -> int | str:
    if value == "frame" or (isinstance(value, int) and not isinstance(value, bool)):
        return value
    raise ValueError(stands(value, said('write the number of a link, or "frame"')))


def link_side(value: object) -> tuple[int, tuple[str, str]]:
    """``"left of AC"`` -> (+1, ("A", "C")); ValueError if it cannot be read."""
    match = re.fullmatch(r"\s*(left of|right of|слева от|справа от)\s+(\S+)\s*", str(value))
    pair = letters.split(match.group(2)) if match else None
    if not isinstance(value, str) or match is None or pair is None:
        raise ValueError(
            stands(
                value,
                said(
                    'write "left of AC" or "right of AC": where the inner pin lies when one goes from A '
                    'to C; for a sliding pair the side stands in "slides"'
                ),
            )
        )
    return (1 if match.group(1) in ("left of", "слева от") else -1), pair


def _accelerations(value: object, names: Names) -> tuple[str, ...]:
    if value in ("all", "все", ["all"], ["все"]):
        return ("all",)
    if not isinstance(value, list):
        raise ValueError(stands(value, said('write a list of positions, [2, 6, "6*"], or "all"')))
    return tuple(_position(item, misfits.fault_in_list) for item in value)


def _position(value: object, wrong: Callable[[object, str], Said] = stands) -> str:
    whole = isinstance(value, int) and not isinstance(value, bool) and 0 <= value <= 10**6
    if not whole and not (isinstance(value, str) and re.fullmatch(r"[0-9]{1,6}\*{0,9}", value)):
        raise ValueError(wrong(value, said('a position is a number, 6, or a text, "6*"')))
    return str(value)


def _letters(value: object, names: Names) -> tuple[str, ...]:
    if not isinstance(value, list) or not all(isinstance(item, str) for item in value):
        raise ValueError(stands(value, said('a list of letters is wanted, ["C", "S2"]')))
    return tuple(value)


_MM: Schema = {
    "anyOf": [{"type": "string"}, {"type": "number"}],
    "description": 'a length on the sheet, "60 mm"',
}


def _switch(value: object, names: Names) -> bool:
    if isinstance(value, bool):
        return value
    raise ValueError(stands(value, misfits.truth_wanted(value)))


_LENGTH: Schema = {
    "anyOf": [{"type": "number"}, {"type": "string"}],
    "description": 'a length: metres, "95 mm", a named length, or a sum such as "-OB - 1.25 BC"',
}
SCALE: Schema = {"anyOf": [{"type": "number", "exclusiveMinimum": 0}, {"type": "string"}]}
ROW: Schema = {"type": "array", "items": {"anyOf": [{"type": "number"}, {"type": "string"}]}}
_PAIR: Schema = {"type": "array", "minItems": 2, "maxItems": 2}
PAIRS: Schema = {"type": "array", "items": _PAIR, "minItems": 2}
_WORDS: Schema = {"type": "array", "items": {"type": "string"}}

SWITCH = Kind(_switch, {"type": "boolean"})
TEXT = Kind(_text, {"type": "string", "maxLength": letters.LONGEST_TEXT})
TITLE = Kind(_title, {"type": "string", "minLength": 1, "maxLength": 200})
LETTER = replace(TEXT, renamed=letters.renamed)
"""Of a point, of two, or of a guide."""
LINK_NUMBER = replace(number(Bound(0, 999, whole=True)), renamed=letters.renamed)
POINT = Kind(
    _point,
    {"type": "array", "items": _LENGTH, "minItems": 2, "maxItems": 2, "description": "x and y"},
    each="length",
    renamed=lambda value, names: (
        value if isinstance(value, list) else letters.renamed(value, names)
    ),
)
PLAIN_LENGTH = quantity("length")
POSITIVE_LENGTH = quantity("length", POSITIVE)
LENGTH = Kind(lengths.evaluate, _LENGTH, unit="length")
ANGLE = quantity("angle")
ANGLES = Kind(_angles, ROW, unit="angle")
SPEED = Kind(_speed, quantity_schema("angular speed"), unit="angular speed")
SPEED_OF_CAM = replace(SPEED, read=partial(_speed, turns=True))
ACCELERATION = quantity("acceleration", POSITIVE)
MASS = quantity("mass", Bound(0))
INERTIA = quantity("moment of inertia", Bound(0))
POSITIVE_INERTIA = quantity("moment of inertia", POSITIVE)
SPEED_RATIO = Bound(1, 100, above=True, below=True)
RATIO = Kind(_ratio, bounded(SPEED_RATIO), SPEED_RATIO)
TARGET = Kind(_target, {"anyOf": [{"type": "integer"}, {"type": "string", "const": "frame"}]},
              renamed=letters.renamed)  # fmt: skip
SENSE = choice("+", "-", "right", "left", "above", "below", **{
    "−": "-", "справа": "right", "слева": "left", "выше": "above", "ниже": "below",
})  # fmt: skip
LINK_SIDE = Kind(
    lambda value, names: link_side(value),
    {"type": "string", "pattern": "^(left of|right of|слева от|справа от) \\S+$"},
    renamed=letters.last_renamed,
)
TURNS = choice(COUNTERCLOCKWISE, CLOCKWISE, против_часовой_стрелки=COUNTERCLOCKWISE,
               по_часовой_стрелке=CLOCKWISE)  # fmt: skip
AT = choice("left", "right", "top", "bottom", слева="left", справа="right", сверху="top",
            снизу="bottom")  # fmt: skip
POSITIONS = Kind(_accelerations, {"anyOf": [ROW, {"type": "string", "const": "all"}]})
POSITION = Kind(lambda value, names: _position(value), {"type": ["integer", "string"]})
LETTERS = Kind(_letters, _WORDS, renamed=letters.renamed)
_MU = Bound(1e-9, 1e9)
_PAPER, _DIVISION = Bound(0.1, 2000), Bound(0.001, 10)
"""Of a drawn length, and of the division of a ruler, mm."""
MU_L = Kind(_mu_l, SCALE, _MU, "scale of lengths")
MU_V = Kind(_mu_v, SCALE, _MU, "scale of velocities")
MU_A = mu("scale of accelerations")
DRAWN = Kind(_drawn, _MM, _PAPER, quantities.PAPER)
RULER = Kind(_ruler, _MM, _DIVISION, quantities.PAPER)

SHARE, _WITHIN = Bound(0, 1, above=True, below=True), Bound(0, 1)
WITHIN = Kind(lambda value, names: within(value), bounded(_WITHIN, "ratio"), _WITHIN, "ratio")
RACK = number(Bound(0, 45, above=True, below=True), "angle")
"""Of the basic rack of wheels: its angle, the factors of its addendum and of its clearance."""
ADDENDUM, CLEARANCE = number(Bound(0, 5, above=True)), number(Bound(0, 5))
