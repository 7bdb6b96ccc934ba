"""Quantities with units: ``"380 rpm"``, ``"0,05 м/с"`` -> floats in SI, angles in degrees.

A bare number is SI already, but for angles: an angle without a unit is in degrees. A text always
carries its unit, in Russian or English spelling; the decimal sign is a point or a comma. What could
be read in two ways ("1 000 mm", "1,000 mm") is refused.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from decimal import Context, Decimal
from typing import Literal, NamedTuple, NoReturn

from graphic_tmm.language.said import Said, joined, said
from graphic_tmm.scene.misfits import digits_of, meant, short, stands

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
_WORDS: dict[Dimension, tuple[str, str]] = {
    "length": (said("a length"), "95 mm"),
    "angle": (said("an angle"), "30 deg"),
    "angular speed": (said("an angular speed"), "380 rpm"),
    "angular acceleration": (said("an angular acceleration"), "20 rad/s^2"),
    "speed": (said("a speed"), "2.5 m/s"),
    "acceleration": (said("an acceleration"), "9.81 m/s^2"),
    "time": (said("a time"), "0.2 s"),
    "mass": (said("a mass"), "25 kg"),
    "force": (said("a force"), "190 N"),
    "pressure": (said("a pressure"), "300 kPa"),
    "moment": (said("a moment"), "12 N*m"),
    "moment of inertia": (said("a moment of inertia"), "0.02 kg*m^2"),
    "scale of lengths": (said("a scale of lengths"), "0.005 m/mm"),
    "scale of velocities": (said("a scale of velocities"), "0.25 (m/s)/mm"),
    "scale of accelerations": (said("a scale of accelerations"), "12.5 (m/s^2)/mm"),
    "scale of times": (said("a scale of times"), "0.0025 s/mm"),
    "scale of angles": (said("a scale of angles"), "0.05 rad/mm"),
    "scale of pressures": (said("a scale of pressures"), "1500 Pa/mm"),
    "scale of moments": (said("a scale of moments"), "8 N*m/mm"),
    "scale of works": (said("a scale of works"), "16.7 J/mm"),
    "scale of forces": (said("a scale of forces"), "40 N/mm"),
    "density": (said("a density"), "7800 kg/m^3"),
    "ratio": (said("a ratio"), "23 %"),
}
"""Of each dimension a quantity, in words and as an example."""
PAPER = "length on the sheet in mm"
"""The unit that sections declare for what is drawn so long."""


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
        raise ValueError(stands(value, wanted(dimension)))
    return bounded(value, digits_of(value), dimension)


def bounded(value: float, text: str, dimension: Dimension) -> float:
    """Return ``value`` as a float, or refuse ``text`` if it is not finite, or far too large or small."""
    if isinstance(value, float) and not math.isfinite(value):
        _refuse(said("{text} is not a finite number", text=short(text)), dimension)
    if abs(value) > LARGEST:
        _refuse(said("{text} is too large a number", text=short(text)), dimension)
    if 0 < abs(value) < SMALLEST:
        _refuse(said("{text} is too small a number", text=short(text)), dimension)
    return float(value)


def _refuse(says: str, dimension: Dimension) -> NoReturn:
    raise ValueError(joined("; ", (says, wanted(dimension))))


def wanted(dimension: Dimension, example: str = "") -> Said:
    """Return ``a length is wanted here, for example "95 mm"``."""
    noun, usual = _WORDS[dimension]
    return said(
        '{noun} is wanted here, for example "{example}"', noun=noun, example=example or usual
    )


def noun_of(unit: str) -> Said | str:
    """Return what a number of a unit that a section declares is, in words; "" of none."""
    if unit == PAPER:
        return said("a length on the sheet")
    return _WORDS[unit][0] if unit in _WORDS else ""


def article(noun: str) -> str:
    """Return the noun with its article: ``a mass``, ``an angle``."""
    return f"{'an' if noun[0] in 'aeiou' else 'a'} {noun}"


def spoken(text: str) -> str:
    """Return a text with plain minus signs and no spaces at its ends."""
    return text.replace("−", "-").strip()


def _parse_text(text: str, dimension: Dimension) -> float:
    match = _QUANTITY.fullmatch(spoken(text)) if len(text) <= 200 else None
    if match is None:
        _refuse(said('"{text}" is not a number with a unit', text=short(text)), dimension)
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
            said(
                '"{text}" can be read in two ways; write the number in one piece, such as "1000.5 mm"',
                text=short(text),
            )
        )
    if _THOUSANDS.match(number):
        raise ValueError(
            said(
                '"{text}" can be read in two ways (a thousand or a decimal comma?); '
                'write "{decimal}" or "{thousands}" with the unit',
                text=short(text),
                decimal=number.replace(",", "."),
                thousands=number.replace(",", ""),
            )
        )
    if re.match(r"\s*/\s*[0-9]", rest):
        raise ValueError(
            said(
                '"{text}" is a fraction; write it as a decimal, for example "0.5 m"',
                text=short(text),
            )
        )


def _no_unit(number: str, dimension: Dimension) -> Said:
    return said(
        '"{number}" has no unit; write "{number} {unit}" (a number without quotes is {bare})',
        number=number,
        unit=_WORDS[dimension][1].split()[1],
        bare=said("in degrees") if dimension == "angle" else said("in SI units"),
    )


def _wrong_dimension(text: str, number: str, unit: Unit, dimension: Dimension) -> Said:
    it = said('"{text}" is {noun}', text=short(text), noun=_WORDS[unit.dimension][0])
    example = f"{number} {_WORDS[dimension][1].split()[1]}"
    return joined("; ", (it, wanted(dimension, example)))


def _unknown_unit(text: str, rest: str, dimension: Dimension) -> Said:
    known = [spelling for spelling, unit in UNITS.items() if unit.dimension == dimension]
    mixed = re.search(r"[A-Za-z]", rest) and re.search(r"[А-Яа-яЁё]", rest)
    hints = (
        said(
            'the unit {unit!r} in "{text}" is not known',
            unit=short(rest.strip()),
            text=short(text),
        ),
        said("it mixes Latin and Russian letters") if mixed else "",
        meant(plain(rest), known),
        said(
            "units of {noun} are {listed}", noun=_WORDS[dimension][0], listed=", ".join(known[:10])
        ),
    )
    return joined("; ", filter(None, hints))


def in_kgf(value: object) -> bool:
    """Whether a quantity in kgf stands in a value, in its lists or its tables."""
    if isinstance(value, dict):
        return any(in_kgf(item) for item in value.values())
    if isinstance(value, list):
        return any(in_kgf(item) for item in value)
    found = _QUANTITY.match(value.strip()) if isinstance(value, str) else None
    return found is not None and any(unit in found.group(2) for unit in ("kgf", "кгс"))


ROUND = 1e-9
"""A share of a speed: nearer than this to a whole tenth of a turn a minute it was given so."""


def turns_a_minute(speed: float) -> float | None:
    """Return an angular velocity (1/s) in turns a minute if it was given so; else None.

    >>> turns_a_minute(39.79350694547071), turns_a_minute(50.0)
    (380.0, None)
    """
    turns = abs(speed) * 30.0 / math.pi
    given = abs(turns * 10.0 - round(turns * 10.0)) <= ROUND * turns * 10.0
    return round(turns, 1) if given else None
