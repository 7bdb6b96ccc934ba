"""Quantities with units: ``"380 rpm"``, ``"0,05 м/с"`` -> floats in SI, angles in degrees.

A bare number is SI already, but for angles: an angle without a unit is in degrees. A text always
carries its unit, in Russian or English spelling; the decimal sign is a point or a comma. What could
be read in two ways ("1 000 mm", "1,000 mm") is refused.
"""

from __future__ import annotations

import difflib
import math
import re
from collections.abc import Iterable, Mapping
from decimal import Context, Decimal
from typing import Literal, NamedTuple

Dimension = Literal[
    "length",
    "angle",
    "angular speed",
    "angular acceleration",
    "speed",
    "acceleration",
    "time",
    "mass",
    "force",
    "pressure",
    "moment",
    "moment of inertia",
    "scale of lengths",
    "scale of velocities",
    "scale of accelerations",
    "scale of times",
    "scale of angles",
    "scale of pressures",
    "scale of moments",
    "scale of works",
    "scale of forces",
    "density",
    "ratio",
]


class Unit(NamedTuple):
    """What a spelling of a unit means: its dimension, its size in SI units (angles: degrees)."""

    dimension: Dimension
    factor: Decimal | float


NUMBER = r"(?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)(?:[eE][+-]?[0-9]+)?"
LARGEST, SMALLEST = 1e12, 1e-15
"""No figure of a machine is larger, or smaller and not 0, in SI units."""
KGF = "9.80665"
LONGEST_MEANT, MOST_MEANT = 60, 200
"""A word of more letters is nothing misspelt; so many known words are looked through for what it may mean."""
_EXACT = Context(prec=60)
_QUANTITY = re.compile(rf"([+-]?{NUMBER})(.*)", re.DOTALL)
_THOUSANDS = re.compile(r"[+-]?[1-9][0-9]{0,2},[0-9]{3}(?![0-9])")

_TABLE: tuple[tuple[Dimension, str | float, str], ...] = (
    ("length", "0.001", "mm мм"),
    ("length", "0.01", "cm см"),
    ("length", "1", "m м"),
    ("length", "1000", "km км"),
    ("length", "0.0254", "in дюйм"),
    ("angle", "1", "deg ° degree degrees град градус градуса градусов"),
    ("angle", 180 / math.pi, "rad рад"),
    ("angular speed", "1", "rad/s рад/с 1/s 1/с s⁻¹ с⁻¹ rad·s⁻¹ рад·с⁻¹"),
    ("angular speed", math.pi / 30, "rpm об/мин rev/min r/min 1/min 1/мин min⁻¹ мин⁻¹ об·мин⁻¹"),
    ("angular speed", math.pi / 180, "deg/s °/s град/с °/с"),
    ("angular speed", 2 * math.pi, "rev/s об/с"),
    ("angular acceleration", "1", "rad/s² рад/с² 1/s² 1/с² s⁻² с⁻² rad·s⁻² рад·с⁻²"),
    ("angular acceleration", math.pi / 180, "deg/s² °/s² град/с² °/с²"),
    ("speed", "1", "m/s м/с m·s⁻¹ м·с⁻¹"),
    ("speed", "0.01", "cm/s см/с"),
    ("speed", "0.001", "mm/s мм/с"),
    ("speed", 1 / 3.6, "km/h км/ч"),
    ("acceleration", "1", "m/s² м/с² m·s⁻² м·с⁻²"),
    ("acceleration", "0.001", "mm/s² мм/с²"),
    ("time", "1", "s с"),
    ("time", "0.001", "ms мс"),
    ("time", "60", "min мин"),
    ("mass", "1", "kg кг"),
    ("mass", "0.001", "g г"),
    ("mass", "1000", "t т"),
    ("mass", KGF, "kgf·s²/m кгс·с²/м"),
    ("force", "1", "N Н"),
    ("force", "1000", "kN кН"),
    ("force", KGF, "kgf кгс"),
    ("pressure", "1", "Pa Па N/m² Н/м²"),
    ("pressure", "1e3", "kPa кПа"),
    ("pressure", "1e6", "MPa МПа N/mm² Н/мм²"),
    ("pressure", "1e5", "bar бар"),
    ("pressure", "98066.5", "kgf/cm² кгс/см²"),
    ("moment", "1", "N·m Н·м"),
    ("moment", "0.001", "N·mm Н·мм"),
    ("moment", "1000", "kN·m кН·м"),
    ("moment", KGF, "kgf·m кгс·м"),
    ("moment of inertia", "1", "kg·m² кг·м²"),
    ("moment of inertia", KGF, "kgf·m·s² кгс·м·с²"),
    ("scale of lengths", "1", "m/mm м/мм"),
    ("scale of lengths", "0.001", "mm/mm мм/мм"),
    ("scale of velocities", "1", "(m/s)/mm (м/с)/мм m/s/mm м/с/мм m/(s·mm) м/(с·мм)"),
    ("scale of times", "1", "s/mm с/мм"),
    ("scale of angles", "1", "rad/mm рад/мм"),
    ("scale of pressures", "1", "Pa/mm Па/мм"),
    ("scale of pressures", "1e3", "kPa/mm кПа/мм"),
    ("scale of pressures", "1e6", "MPa/mm МПа/мм"),
    ("scale of moments", "1", "N·m/mm Н·м/мм"),
    ("scale of works", "1", "J/mm Дж/мм"),
    ("scale of forces", "1", "N/mm Н/мм"),
    ("scale of forces", "1000", "kN/mm кН/мм"),
    ("scale of forces", KGF, "kgf/mm кгс/мм"),
    ("density", "1", "kg/m³ кг/м³"),
    ("ratio", "0.01", "%"),
    ("scale of accelerations", "1", "(m/s²)/mm (м/с²)/мм m/s²/mm м/с²/мм m/(s²·mm) м/(с²·мм)"),
)
_EXAMPLES: dict[Dimension, str] = {
    "length": "95 mm",
    "angle": "30 deg",
    "angular speed": "380 rpm",
    "angular acceleration": "20 rad/s^2",
    "speed": "2.5 m/s",
    "acceleration": "9.81 m/s^2",
    "time": "0.2 s",
    "mass": "25 kg",
    "force": "190 N",
    "pressure": "300 kPa",
    "moment": "12 N*m",
    "moment of inertia": "0.02 kg*m^2",
    "scale of lengths": "0.005 m/mm",
    "scale of velocities": "0.25 (m/s)/mm",
    "scale of accelerations": "12.5 (m/s^2)/mm",
    "scale of times": "0.0025 s/mm",
    "scale of angles": "0.05 rad/mm",
    "scale of pressures": "1500 Pa/mm",
    "scale of moments": "8 N*m/mm",
    "scale of works": "16.7 J/mm",
    "scale of forces": "40 N/mm",
    "density": "7800 kg/m^3",
    "ratio": "23 %",
}


def _units() -> dict[str, Unit]:
    return {
        spelling: Unit(dimension, Decimal(factor) if isinstance(factor, str) else factor)
        for dimension, factor, spellings in _TABLE
        for spelling in spellings.split()
    }


UNITS: Mapping[str, Unit] = _units()
"""Every spelling of a unit in its plain form (see ``plain``) -> what it means."""


def plain(unit: str) -> str:
    """One form for the ways a unit may be typed: ``kg * m^2``, ``kg m2`` -> ``kg·m²``.

    Parameters
    ----------
    unit : str
        The unit as typed; spaces of any kind.
    """
    text = re.sub(r"\*\*", "^", unit.strip().removesuffix("."))
    text = re.sub(r"[*⋅∙•×]", "·", text)
    text = re.sub(r"\^?(?:-|⁻)([12¹²])(?![0-9])", r"⁻\1", text)
    text = re.sub(r"(?:(?<=[^\W\d_])|\^|(?<=⁻))([12])(?![0-9])", _raised, text)
    text = re.sub(r"\s*([·/()])\s*", r"\1", text)
    return re.sub(r"\s+", "·", text)


def _raised(match: re.Match[str]) -> str:
    return "¹²"[int(match.group(1)) - 1]


def parse(value: object, dimension: Dimension) -> float:
    """Read a quantity of the wanted dimension.

    Parameters
    ----------
    value : int, float or str
        A number (SI; degrees for an angle) or a text with its unit.
    dimension : Dimension
        What is wanted, such as ``"length"``.

    Returns
    -------
    float
        In SI units; an angle in degrees; a scale in (SI unit)/mm.

    Raises
    ------
    ValueError
        With a sentence that says what is wrong and what to write.
    """
    if isinstance(value, str):
        return _parse_text(value, dimension)
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise ValueError(f"{kind_of(value)} stands here; {wanted(dimension)}")
    return bounded(value, digits_of(value), dimension)


def bounded(value: float, text: str, dimension: Dimension) -> float:
    """Return ``value`` as a float, or refuse ``text`` if it is not finite, or far too large or small."""
    if isinstance(value, float) and not math.isfinite(value):
        raise ValueError(f"{_short(text)} is not a finite number; {wanted(dimension)}")
    if abs(value) > LARGEST:
        raise ValueError(f"{_short(text)} is too large a number; {wanted(dimension)}")
    if 0 < abs(value) < SMALLEST:
        raise ValueError(f"{_short(text)} is too small a number; {wanted(dimension)}")
    return float(value)


def wanted(dimension: Dimension) -> str:
    """Return ``a length is wanted here, for example "95 mm"``."""
    return f'{article(dimension)} is wanted here, for example "{_EXAMPLES[dimension]}"'


def article(noun: str) -> str:
    """Return the noun with its article: ``a mass``, ``an angle``."""
    return f"{'an' if noun[0] in 'aeiou' else 'a'} {noun}"


def kind_of(value: object) -> str:
    """Return what kind of value stands in the file, in words."""
    if isinstance(value, bool):
        return f"{str(value).lower()} (yes or no)"
    if isinstance(value, (int, float)):
        return f"the number {digits_of(value)}"
    if isinstance(value, str):
        return f'the text "{_short(value)}"'
    if isinstance(value, list):
        return "a list [ ]"
    return "a table { }" if isinstance(value, dict) else "a date or time"


def near(word: str, known: Iterable[str], cutoff: float = 0.5) -> str:
    """Return the known word that was probably meant; empty if none is like it."""

    def same_length(other: str) -> float:
        return 0.4 / max(len(word), 1) if len(word) == len(other) else 0.0

    def likeness(other: str) -> float:
        ratio = difflib.SequenceMatcher(None, word.casefold(), other.casefold()).ratio()
        begins = other[:1].casefold() == word[:1].casefold()
        return ratio + (0.1 if begins else 0.0) + same_length(other)

    if len(word) > LONGEST_MEANT:
        return ""
    best = max(sorted(known)[:MOST_MEANT], key=likeness, default="")
    return best if best and likeness(best) >= cutoff else ""


def digits_of(value: float) -> str:
    """Return a number as text; what is beyond all measure (TOML has no limit) in powers of two."""
    huge = isinstance(value, int) and value.bit_length() > 64
    return f"2^{int(value).bit_length()}" if huge else str(value)


def spoken(text: str) -> str:
    """Return a text with plain minus signs and no spaces at its ends."""
    return text.replace("−", "-").strip()


def _short(text: str) -> str:
    return text if len(text) <= 60 else text[:57] + "..."


def _parse_text(text: str, dimension: Dimension) -> float:
    match = _QUANTITY.fullmatch(spoken(text)) if len(text) <= 200 else None
    if match is None:
        raise ValueError(f'"{_short(text)}" is not a number with a unit; {wanted(dimension)}')
    number, rest = match.groups()
    unit = UNITS.get(plain(rest))
    refuse_ambiguous(number, "" if unit else rest, text)
    if not rest.strip():
        raise ValueError(_no_unit(number, dimension))
    if unit is None:
        raise ValueError(_unknown_unit(text, rest, dimension))
    if dimension == "mass" and unit == UNITS["kgf"]:
        unit = UNITS["kg"]  # a weight divided by the standard g that makes a kgf of a kg
    if unit.dimension != dimension:
        raise ValueError(_wrong_dimension(text, number, unit, dimension))
    return measured(number, unit, text)


def measured(number: str, unit: Unit, text: str) -> float:
    """Return ``number`` of ``unit`` in SI, correctly rounded where the factor is a decimal.

    Parameters
    ----------
    number : str
        As in ``NUMBER``, with or without a sign.
    unit : Unit
        One of ``UNITS``.
    text : str
        The whole text, for the message.
    """
    digits = number.replace(",", ".")
    bounded(float(digits), text, unit.dimension)
    if isinstance(unit.factor, float):
        return bounded(float(digits) * unit.factor, text, unit.dimension)
    return bounded(float(_EXACT.multiply(Decimal(digits), unit.factor)), text, unit.dimension)


def refuse_ambiguous(number: str, rest: str, text: str) -> None:
    """Refuse groups of thousands and fractions: ``1 000``, ``1,000``, ``1.000,5``, ``1/2``."""
    if re.match(r"[\s._,']*[0-9]|[.,]", rest):
        raise ValueError(
            f'"{_short(text)}" can be read in two ways; '
            'write the number in one piece, such as "1000.5 mm"'
        )
    if _THOUSANDS.match(number):
        raise ValueError(
            f'"{_short(text)}" can be read in two ways (a thousand or a decimal comma?); '
            f'write "{number.replace(",", ".")}" or "{number.replace(",", "")}" with the unit'
        )
    if re.match(r"\s*/\s*[0-9]", rest):
        raise ValueError(
            f'"{_short(text)}" is a fraction; write it as a decimal, for example "0.5 m"'
        )


def _no_unit(number: str, dimension: Dimension) -> str:
    unit = _EXAMPLES[dimension].split()[1]
    bare = "in degrees" if dimension == "angle" else "in SI units"
    return f'"{number}" has no unit; write "{number} {unit}" (a number without quotes is {bare})'


def _wrong_dimension(text: str, number: str, unit: Unit, dimension: Dimension) -> str:
    said = f'"{_short(text)}" is {article(unit.dimension)}'
    example = f"{number} {_EXAMPLES[dimension].split()[1]}"
    return f'{said}; {article(dimension)} is wanted here, for example "{example}"'


def _unknown_unit(text: str, rest: str, dimension: Dimension) -> str:
    known = [spelling for spelling, unit in UNITS.items() if unit.dimension == dimension]
    meant = near(plain(rest), known)
    mixed = re.search(r"[A-Za-z]", rest) and re.search(r"[А-Яа-яЁё]", rest)
    hints = [
        f'the unit {_short(rest.strip())!r} in "{_short(text)}" is not known',
        "it mixes Latin and Russian letters" if mixed else "",
        f'did you mean "{meant}"?' if meant else "",
        f"units of {article(dimension)} are {', '.join(known[:10])}",
    ]
    return "; ".join(hint for hint in hints if hint)


def in_kgf(value: object) -> bool:
    """Whether a quantity in kgf stands in a value, in its lists or its tables."""
    if isinstance(value, dict):
        return any(in_kgf(item) for item in value.values())
    if isinstance(value, list):
        return any(in_kgf(item) for item in value)
    found = _QUANTITY.match(value.strip()) if isinstance(value, str) else None
    return found is not None and any(unit in found.group(2) for unit in ("kgf", "кгс"))
