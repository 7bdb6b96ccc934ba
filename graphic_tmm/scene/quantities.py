"""Quantities with units: ``"380 rpm"``, ``"0,05 м/с"`` -> floats in SI, angles in degrees.

A bare number is SI already, but for angles: an angle without a unit is in degrees. A text always
carries its unit, in Russian or English spelling; the decimal sign is a point or a comma. What could
be read in two ways ("1 000 mm", "1,000 mm") is refused.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from decimal import Context, Decimal
from typing import NamedTuple, NoReturn

from graphic_tmm.language.said import Said, joined, said
from graphic_tmm.scene.misfits import digits_of, meant, short, stands
from graphic_tmm.scene.units import GRAVITY, SI, SYSTEMS, UNITS, Dimension, System, Unit, plain_unit

NUMBER = r"(?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)(?:[eE][+-]?[0-9]+)?"
LARGEST, SMALLEST = 1e12, 1e-15
"""No figure of a machine is larger, or smaller and not 0, in SI units."""
NOISE = 1e-12
"""A length (m) or an angle (degrees) below this is what a program's rounding leaves of 0: points nearer than
1e-9 m are one, and sums of floats as large as 360 differ by some 1e-13."""
DECIMALS = 9
"""So many decimals of a figure count: what computers add behind them nobody has measured."""
_EXACT = Context(prec=60)
_QUANTITY = re.compile(rf"([+-]?{NUMBER})(.*)", re.DOTALL)
_THOUSANDS = re.compile(r"[+-]?[1-9][0-9]{0,2},[0-9]{3}(?![0-9])")

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
    "unbalance": (said("an unbalance"), "250 g*mm"),
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
    "power": (said("a power"), "2.2 kW"),
    "stiffness": (said("a stiffness"), "2 kN/m"),
    "damping": (said("a damping"), "150 N*s/m"),
    "ratio": (said("a ratio"), "23 %"),
}
"""Of each dimension a quantity, in words and as an example."""
PAPER = "length on the sheet in mm"
"""The unit that sections declare for what is drawn so long."""


class Measures(NamedTuple):
    """What quantities are kept in while a scene is read, and the g (m/s²) by which a weight becomes a mass."""

    system: System = SYSTEMS[SI]
    gravity: float = GRAVITY


_SI = Measures()
_MEASURES: ContextVar[Measures] = ContextVar("measures", default=_SI)


@contextmanager
def measuring(measures: Measures) -> Iterator[None]:
    """Keep quantities in the units of a scene while it is read."""
    token = _MEASURES.set(measures)
    try:
        yield
    finally:
        _MEASURES.reset(token)


def kept(value: float, dimension: Dimension) -> float:
    """Return a quantity in SI in the units that the scene keeps it in."""
    return value / _MEASURES.get().system.size(dimension)


def si(value: float, dimension: Dimension) -> float:
    """Return a quantity that the scene keeps in its units in SI."""
    return value * _MEASURES.get().system.size(dimension)


def gravity() -> float:
    """Return the g (m/s²) by which a weight becomes a mass."""
    return _MEASURES.get().gravity


def parse(value: object, dimension: Dimension) -> float:
    """Read a quantity of the wanted dimension, in the units that the scene keeps (as `in_si`)."""
    return kept(in_si(value, dimension), dimension)


def in_si(value: object, dimension: Dimension, example: str = "") -> float:
    """Read a quantity of the wanted dimension.

    Parameters
    ----------
    value : int, float or str
        A number (SI; degrees for an angle) or a text with its unit.
    dimension : Dimension
        What is wanted, such as ``"length"``.
    example : str
        What a message gives as an example, if not the usual one.

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
        return _parse_text(value, dimension, example)
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise ValueError(stands(value, wanted(dimension, example)))
    return bounded(value, digits_of(value), dimension)


def bounded(value: float, text: str, dimension: Dimension) -> float:
    """Return ``value`` as a float, 0 where it is rounding; refuse ``text`` if not finite or far too large."""
    if isinstance(value, float) and not math.isfinite(value):
        _refuse(said("{text} is not a finite number", text=short(text)), dimension)
    if abs(value) > LARGEST:
        _refuse(said("{text} is too large a number", text=short(text)), dimension)
    least = NOISE if dimension in ("length", "angle") else SMALLEST
    return 0.0 if abs(value) < least else float(value)


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
    """Return a text with plain minus signs, for dashes too, and no spaces at its ends."""
    return re.sub("[−–—‒‑]", "-", text).strip()


def _parse_text(text: str, dimension: Dimension, example: str) -> float:
    match = _QUANTITY.fullmatch(spoken(text)) if len(text) <= 200 else None
    if match is None:
        says = said('"{text}" is not a number with a unit', text=short(text))
        raise ValueError(joined("; ", (says, wanted(dimension, example))))
    number, rest = match.groups()
    unit = UNITS.get(plain_unit(rest))
    refuse_ambiguous(number, "" if unit else rest, text)
    if not rest.strip():
        raise ValueError(_no_unit(number, dimension))
    if unit is None:
        raise ValueError(_unknown_unit(text, rest, dimension))
    if dimension == "mass" and unit.dimension == "force":
        return _mass_of(number, unit, text)
    if unit.dimension != dimension:
        raise ValueError(_wrong_dimension(text, number, unit, dimension, example))
    return measured(number, unit, text)


_BY_ITS_OWN_G = {UNITS[force]: UNITS[mass] for force, mass in (("kgf", "kg"), ("lbf", "lb"))}
"""A weight divided by the standard g that makes a kgf of a kg, a lbf of a lb."""


def _mass_of(number: str, weight: Unit, text: str) -> float:
    """Return the mass (kg) of what weighs so much."""
    if own := _BY_ITS_OWN_G.get(weight):
        return measured(number, own, text)
    return measured(number, weight, text) / gravity()


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


def _wrong_dimension(
    text: str, number: str, unit: Unit, dimension: Dimension, example: str
) -> Said:
    it = said('"{text}" is {noun}', text=short(text), noun=_WORDS[unit.dimension][0])
    if dimension == "force" and unit.dimension == "mass":
        pounds = unit == UNITS["lb"]
        size = number if pounds else f"{measured(number, unit, text):.10g}"
        weight = said('its weight is "{size} {unit}"', size=size, unit="lbf" if pounds else "kgf")
        return joined("; ", (it, weight, wanted(dimension)))
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
        meant(plain_unit(rest), known),
        said(
            "units of {noun} are {listed}", noun=_WORDS[dimension][0], listed=", ".join(known[:10])
        ),
    )
    return joined("; ", filter(None, hints))


def is_a(value: object, dimension: Dimension) -> bool:
    """Whether a value is a text, a number with a unit of a dimension."""
    if not isinstance(value, str) or len(value) > 200:
        return False
    match = _QUANTITY.fullmatch(spoken(value))
    unit = UNITS.get(plain_unit(match[2])) if match else None
    return unit is not None and unit.dimension == dimension


def last_digit(value: str | float) -> str | float:
    """Return one of the last digit of a quantity as it is written: of "0.80 mm" 0.01 mm."""
    match = _QUANTITY.fullmatch(spoken(value)) if isinstance(value, str) else None
    number = match[1].replace(",", ".") if match else str(value)
    one = f"1e{max(int(Decimal(number).as_tuple().exponent), -DECIMALS)}"
    return f"{one} {match[2]}" if match else float(one)


def in_kgf(value: object) -> bool:
    """Whether a quantity in kgf or lbf stands in a value, in its lists or its tables."""
    if isinstance(value, dict):
        return any(in_kgf(item) for item in value.values())
    if isinstance(value, list):
        return any(in_kgf(item) for item in value)
    found = _QUANTITY.match(value.strip()) if isinstance(value, str) else None
    return found is not None and any(unit in found.group(2) for unit in ("kgf", "кгс", "lbf"))


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
