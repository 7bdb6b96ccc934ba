"""The kinds of values of a scene file: how each is checked, how it is described to an editor."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Annotated, Any

from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic_core import CoreSchema, core_schema

from graphic_tmm import bounds
from graphic_tmm.bounds import Bound
from graphic_tmm.language.catalogue import languages
from graphic_tmm.scene import lengths, letters, quantities
from graphic_tmm.scene.quantities import Dimension, kind_of
from graphic_tmm.scene.records import ALL_PLACES, FREE_PLACES

Names = Mapping[str, float]
Schema = dict[str, Any]

COUNTERCLOCKWISE, CLOCKWISE = "counterclockwise", "clockwise"
OTHER_EXTREME = "other extreme"
MU_L_OMEGA = "mu_l*omega1"


class Rule:
    """Annotation: a function of (value, named lengths) checks the value or raises ValueError."""

    def __init__(self, check: Callable[[object, Names], object], schema: Schema) -> None:
        self.check = check
        self.schema = schema

    def __get_pydantic_core_schema__(
        self, source: object, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        """Run the check with the named lengths that stand in the context."""
        return core_schema.with_info_plain_validator_function(
            lambda value, info: self.check(value, info.context or {})
        )

    def __get_pydantic_json_schema__(
        self, core: CoreSchema, handler: GetJsonSchemaHandler
    ) -> Schema:
        """Return the description given with the rule."""
        return dict(self.schema)


def _quantity(
    dimension: Dimension, *, least: float | None = None, above: float | None = None
) -> Rule:
    def check(value: object, names: Names) -> float:
        number = quantities.parse(value, dimension)
        if above is not None and number <= above:
            raise ValueError(f"{_said(value)} is not greater than {above:g}")
        if least is not None and number < least:
            raise ValueError(f"{_said(value)} is less than {least:g}")
        return number

    return Rule(check, _quantity_schema(dimension))


def _quantity_schema(dimension: Dimension) -> Schema:
    bare = "degrees" if dimension == "angle" else "SI units (scales: SI unit/mm)"
    return {
        "anyOf": [{"type": "number"}, {"type": "string"}],
        "description": f"{quantities.article(dimension)}: a number in {bare}, or a text with unit",
    }


def _said(value: object) -> str:
    if isinstance(value, (int, float)):
        return quantities.digits_of(value)
    return f'"{value}"'


def choice(*words: str, **synonyms: str) -> Rule:
    """Return the rule for one of some words; a synonym (_ for a space) answers with its word."""
    meant = {word: word for word in words} | {
        other.replace("_", " "): word for other, word in synonyms.items()
    }

    def check(value: object, names: Names) -> str:
        if isinstance(value, str) and value in meant:
            return meant[value]
        raise ValueError(_no_choice(value, list(words), list(meant)))

    return Rule(check, {"type": "string", "enum": list(meant)})


def _no_choice(value: object, words: list[str], known: list[str]) -> str:
    near = quantities.near(str(value)[:40], known, 0.6)
    hint = f'; did you mean "{near}"?' if near else ""
    listed = ", ".join(f'"{word}"' for word in words)
    only = "it can only be" if len(words) == 1 else "it is one of"
    return f"{kind_of(value)} stands here{hint}; {only} {listed}"


def _text(value: object, names: Names) -> str:
    if not isinstance(value, str):
        raise ValueError(f"{kind_of(value)} stands here; a text in quotes is wanted")
    if fault := letters.text_fault(value):
        raise ValueError(fault)
    return value


def _title(value: object, names: Names) -> str:
    if not _text(value, names).strip():
        raise ValueError("the title is empty; write what the mechanism is")
    return str(value)


def number(bound: Bound, dimension: Dimension | None = None) -> Rule:
    """Return the rule for a number within bounds; of a dimension it may also be a text with its unit."""

    def check(value: object, names: Names) -> float:
        found = value
        if dimension is not None and (isinstance(value, str) or dimension != "ratio"):
            found = quantities.parse(value, dimension)
        elif bound.whole and (isinstance(value, bool) or not isinstance(value, int)):
            raise ValueError(
                f"{kind_of(value)} stands here; a whole number is wanted, without quotes"
            )
        if not bound.holds(found):
            raise ValueError(f"{kind_of(value)} stands here; {bound.wanted} is wanted")
        assert isinstance(found, int | float)
        return found if bound.whole else float(found)

    return Rule(check, bounded(bound, dimension))


def bounded(bound: Bound, dimension: Dimension | None = None) -> Schema:
    """Return what an editor is told of a number within bounds."""
    if dimension is None:
        return dict(bound.schema)
    made = _quantity_schema(dimension) if dimension != "ratio" else {}
    return {**made, "anyOf": [dict(bound.schema), {"type": "string"}]}


def _point(value: object, names: Names) -> complex:
    if not isinstance(value, list) or len(value) != 2:
        found = f"a list of {len(value)}" if isinstance(value, list) else kind_of(value)
        raise ValueError(f'{found} stands here; a point is a list of two lengths, ["95 mm", 0]')
    numbers, faults = [], []
    for axis, item in zip("xy", value, strict=True):
        try:
            numbers.append(lengths.evaluate(item, names))
        except ValueError as error:
            faults.append(f"{axis}: {error}")
    if faults:
        raise ValueError("; ".join(faults))
    return complex(numbers[0], numbers[1])


def _angles(value: object, names: Names) -> tuple[float, ...]:
    if not isinstance(value, list):
        raise ValueError(f'{kind_of(value)} stands here; a list of angles is wanted, ["90 deg"]')
    return tuple(quantities.parse(item, "angle") for item in value)


def _speed(value: object, names: Names) -> float:
    number = quantities.parse(value, "angular speed")
    if number == 0:
        raise ValueError(
            f'{_said(value)}: a drive that stands still moves nothing; write "380 rpm"; at a start from rest '
            'no velocity can be drawn: write a speed as small as "0.001 rad/s" beside the acceleration'
        )
    if number < 0:
        raise ValueError(f'{_said(value)} is negative; write it positive and turns = "{CLOCKWISE}"')
    return number


def _ratio(value: object, names: Names) -> float:
    if isinstance(value, str):
        raise ValueError(f"{kind_of(value)} stands here; K_v is a plain number, without quotes")
    if not bounds.SPEED_RATIO.holds(value):
        raise ValueError(
            f"{kind_of(value)} stands here; K_v is {bounds.SPEED_RATIO.wanted}, such as 1.45"
        )
    return float(value)  # type: ignore[arg-type]


def _mu_l(value: object, names: Names) -> float:
    drawn = re.fullmatch(r"\s*([0-9]+(?:[.,][0-9]+)?)\s*:\s*([0-9]+(?:[.,][0-9]+)?)\s*", str(value))
    if isinstance(value, str) and drawn:
        paper, real = (float(part.replace(",", ".")) for part in drawn.groups())
        number = real / paper / 1000 if paper else 0.0
    else:
        number = quantities.parse(value, "scale of lengths")
    return _positive_scale(number, value)


def _mu_v(value: object, names: Names) -> float | str:
    if isinstance(value, str) and re.fullmatch(
        r"(?:mu|μ|µ)_?l\s*[*·⋅]?\s*(?:omega|ω)_?1", value.strip()
    ):
        return MU_L_OMEGA
    return _positive_scale(quantities.parse(value, "scale of velocities"), value)


def mu(dimension: Dimension) -> Rule:
    """Return the rule for a scale factor of a dimension."""

    def check(value: object, names: Names) -> float:
        return _positive_scale(quantities.parse(value, dimension), value)

    return Rule(check, SCALE)


def _positive_scale(number: float, value: object) -> float:
    if not 1e-9 <= number <= 1e9:
        raise ValueError(
            f"{_said(value)} cannot be a scale factor; it is what 1 mm of paper stands for"
        )
    return number


def _drawn(value: object, names: Names) -> float:
    metres = quantities.parse(value, "length")
    if not 0.0001 <= metres <= 2:
        raise ValueError(
            f'{_said(value)} is {metres:g} m on the sheet (a number is in metres); write "60 mm"'
        )
    return metres * 1000


def _ruler(value: object, names: Names) -> float | str:
    if value == "exact":
        return "exact"
    metres = quantities.parse(value, "length")
    if not 1e-6 <= metres <= 0.01:
        raise ValueError(f'{_said(value)} is no ruler; write "0.1 mm", "0.5 mm" or "exact"')
    return metres * 1000


def _target(value: object, names: Names) -> int | str:
    if value == "frame" or (isinstance(value, int) and not isinstance(value, bool)):
        return value
    raise ValueError(f'{kind_of(value)} stands here; write the number of a link, or "frame"')


def link_side(value: object) -> tuple[int, tuple[str, str]]:
    """``"left of AC"`` -> (+1, ("A", "C")); ValueError if it cannot be read."""
    match = re.fullmatch(r"\s*(left of|right of|слева от|справа от)\s+(\S+)\s*", str(value))
    pair = letters.split(match.group(2)) if match else None
    if not isinstance(value, str) or match is None or pair is None:
        raise ValueError(
            f'{kind_of(value)} stands here; write "left of AC" or "right of AC": where the inner '
            'pin lies when one goes from A to C; for a sliding pair the side stands in "slides"'
        )
    return (1 if match.group(1) in ("left of", "слева от") else -1), pair


def _extra(value: object, names: Names) -> tuple[float | str, ...]:
    if not isinstance(value, list):
        raise ValueError(
            f'{kind_of(value)} stands here; a list is wanted, ["{OTHER_EXTREME}", "105 deg"]'
        )
    words = (OTHER_EXTREME, "другое крайнее")
    return tuple(
        OTHER_EXTREME if item in words else quantities.parse(item, "angle") for item in value
    )


def _accelerations(value: object, names: Names) -> tuple[str, ...]:
    if value in ("all", "все"):
        return ("all",)
    if not isinstance(value, list):
        raise ValueError(
            f'{kind_of(value)} stands here; write a list of positions, [2, 6, "6*"], or "all"'
        )
    return tuple(_position(item, " in the list") for item in value)


def _position(value: object, where: str = " stands here") -> str:
    whole = isinstance(value, int) and not isinstance(value, bool) and 0 <= value <= 10**6
    if not whole and not (isinstance(value, str) and re.fullmatch(r"[0-9]{1,6}\*{0,3}", value)):
        raise ValueError(f'{kind_of(value)}{where}; a position is a number, 6, or a text, "6*"')
    return str(value)


def _places(value: object, names: Names) -> tuple[str, ...]:
    if not isinstance(value, list) or not value:
        raise ValueError(f'{kind_of(value)} stands here; a list of plans is wanted, ["positions"]')
    for item in value:
        if item not in PLACES:
            raise ValueError(_no_choice(item, list(PLACES), list(PLACES)))
    if len(set(value)) < len(value):
        raise ValueError("a plan is named twice; leave one of the two out")
    return tuple(value)


def _letters(value: object, names: Names) -> tuple[str, ...]:
    if not isinstance(value, list) or not all(isinstance(item, str) for item in value):
        raise ValueError(f'{kind_of(value)} stands here; a list of letters is wanted, ["C", "S2"]')
    return tuple(value)


PLACES = (*ALL_PLACES, "velocity table", "acceleration table", *FREE_PLACES)
_MM: Schema = {
    "anyOf": [{"type": "string"}, {"type": "number"}],
    "description": 'a length on the sheet, "60 mm"',
}
_LENGTH: Schema = {
    "anyOf": [{"type": "number"}, {"type": "string"}],
    "description": 'a length: metres, "95 mm", a named length, or a sum such as "-OB - 1.25 BC"',
}
SCALE: Schema = {"anyOf": [{"type": "number", "exclusiveMinimum": 0}, {"type": "string"}]}
_NUMBERS: Schema = {"type": "array", "items": {"anyOf": [{"type": "number"}, {"type": "string"}]}}
_WORDS: Schema = {"type": "array", "items": {"type": "string"}}

Text = Annotated[str, Rule(_text, {"type": "string", "maxLength": letters.LONGEST_TEXT})]
Title = Annotated[str, Rule(_title, {"type": "string", "minLength": 1, "maxLength": 200})]
Language = Annotated[str, choice(*sorted(languages(), reverse=True))]
LinkNumber = Annotated[int, number(bounds.LINK)]
Count = Annotated[int, number(bounds.POSITIONS)]
First = Annotated[int, number(bounds.FIRST)]
Point = Annotated[
    complex,
    Rule(
        _point,
        {"type": "array", "items": _LENGTH, "minItems": 2, "maxItems": 2, "description": "x and y"},
    ),
]
PlainLength = Annotated[float, _quantity("length")]
PositiveLength = Annotated[float, _quantity("length", above=0)]
Length = Annotated[float, Rule(lengths.evaluate, _LENGTH)]
Angle = Annotated[float, _quantity("angle")]
Angles = Annotated[tuple[float, ...], Rule(_angles, _NUMBERS)]
Speed = Annotated[float, Rule(_speed, _quantity_schema("angular speed"))]
Spin = Annotated[float, _quantity("angular acceleration")]
Acceleration = Annotated[float, _quantity("acceleration", above=0)]
Mass = Annotated[float, _quantity("mass", least=0)]
Inertia = Annotated[float, _quantity("moment of inertia", least=0)]
Ratio = Annotated[float, Rule(_ratio, bounded(bounds.SPEED_RATIO))]
Target = Annotated[
    int | str, Rule(_target, {"anyOf": [{"type": "integer"}, {"type": "string", "const": "frame"}]})
]
Sense = Annotated[
    str,
    choice("+", "-", "right", "left", "above", "below", **{
        "−": "-", "справа": "right", "слева": "left", "выше": "above", "ниже": "below",
    }),
]  # fmt: skip
LinkSide = Annotated[
    tuple[int, tuple[str, str]],
    Rule(
        lambda value, names: link_side(value),
        {"type": "string", "pattern": "^(left of|right of|слева от|справа от) \\S+$"},
    ),
]
Turns = Annotated[
    str,
    choice(COUNTERCLOCKWISE, CLOCKWISE, против_часовой_стрелки=COUNTERCLOCKWISE,
           по_часовой_стрелке=CLOCKWISE),
]  # fmt: skip
At = Annotated[
    str,
    choice("left", "right", "top", "bottom", слева="left", справа="right", сверху="top",
           снизу="bottom"),
]  # fmt: skip
Extra = Annotated[tuple[float | str, ...], Rule(_extra, _NUMBERS)]
Accelerations = Annotated[
    tuple[str, ...], Rule(_accelerations, {"anyOf": [_NUMBERS, {"type": "string", "const": "all"}]})
]
Velocities = Annotated[str, choice("direct", "turned", повёрнутый="turned", прямой="direct")]
Poles = Annotated[str, choice("own", "common", свой="own", общий="common")]
Position = Annotated[
    str, Rule(lambda value, names: _position(value), {"type": ["integer", "string"]})
]
Letters = Annotated[tuple[str, ...], Rule(_letters, _WORDS)]
MuL = Annotated[float, Rule(_mu_l, SCALE)]
MuV = Annotated[float | str, Rule(_mu_v, SCALE)]
MuA = Annotated[float, mu("scale of accelerations")]
Drawn = Annotated[float, Rule(_drawn, _MM)]
Ruler = Annotated[float | str, Rule(_ruler, _MM)]
HandName = Annotated[
    str, choice("exact", "cad", "careful", "student", точная="exact", студент="student")
]
Seed = Annotated[int, number(bounds.SEED)]
Format = Annotated[str, choice("A1", "A1 portrait", "A4", А1="A1", А4="A4")]
Places = Annotated[
    tuple[str, ...],
    Rule(_places, {"type": "array", "items": {"type": "string", "enum": list(PLACES)}}),
]
TaskKind = Annotated[str, choice("rocker", кулиса="rocker")]
