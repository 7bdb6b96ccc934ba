"""Lengths written with names: ``"OA"``, ``"-OB - 1.25 BC"``, ``"10 mm + 0,5*AB"``. Nothing more.

An expression is a sum: terms joined by + and -, each a quantity with its unit or a named length
with an optional coefficient before it.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping

from graphic_tmm.language.said import Said, joined, said
from graphic_tmm.scene import misfits, quantities
from graphic_tmm.scene.quantities import NUMBER
from graphic_tmm.scene.units import UNITS, plain_unit

NAME = re.compile(r"[^\W\d_][^\W²¹]*")
_TERM = re.compile(
    rf"\s*(?P<sign>[+-])?\s*(?P<number>{NUMBER})?\s*(?P<times>[*·⋅])?\s*(?P<name>{NAME.pattern})?\s*"
)


def evaluate(value: object, names: Mapping[str, float]) -> float:
    """Read a length or a sum of named lengths.

    Parameters
    ----------
    value : int, float or str
        A number is in metres; a text is a sum.
    names : mapping of str to float
        The named lengths, m; NaN for one whose own value is faulty (the sum is then NaN).

    Returns
    -------
    float
        Metres.

    Raises
    ------
    ValueError
        With a sentence that says what is wrong and what to write.
    """
    if not isinstance(value, str) or len(value) > 200:
        return quantities.parse(value, "length")
    text = quantities.spoken(value)
    if _is_quantity(text, names):
        return quantities.parse(value, "length")
    total = _sum(text, names)
    return total if math.isnan(total) else quantities.bounded(total, value, "length")


def _is_quantity(text: str, names: Mapping[str, float]) -> bool:
    """Whether the text is one number with any known unit, or a number and nothing."""
    match = re.fullmatch(rf"[+-]?{NUMBER}(.*)", text, re.DOTALL)
    if match is None:
        return False
    rest = match.group(1).strip()
    return rest not in names and (not rest or plain_unit(rest) in UNITS)


def _sum(text: str, names: Mapping[str, float]) -> float:
    total, at = 0.0, 0
    while at < len(text) or at == 0:
        match = _TERM.match(text, at)
        if match is None or not (match["number"] or match["name"]):
            raise ValueError(_unreadable(text, names))
        if at and not match["sign"]:
            quantities.refuse_ambiguous("1", text[at:], text)
            raise ValueError(_unreadable(text, names))
        value = _term(match, text, names)
        total = total - value if match["sign"] == "-" else total + value
        at = match.end()
    return total


def _term(match: re.Match[str], text: str, names: Mapping[str, float]) -> float:
    number, name = match["number"], match["name"]
    if name is None:
        rest = text[match.end("number") :]
        quantities.refuse_ambiguous(number, rest, text)
        if rest.strip() and rest.strip()[0] not in "+-":
            raise ValueError(_unreadable(text, names))
        raise ValueError(
            said(
                '{number} in "{text}" has no unit and no name after it; write "{number} mm" or '
                '"{number} BC"',
                number=number,
                text=text,
            )
        )
    if match["times"] and number is None:
        raise ValueError(_unreadable(text, names))
    if number is not None:
        quantities.refuse_ambiguous(number, "", text)
    if name in names:
        return names[name] if number is None else float(number.replace(",", ".")) * names[name]
    unit = UNITS.get(name)
    if number is None or match["times"] or unit is None:
        raise ValueError(_unknown(name, text, names))
    if unit.dimension != "length":
        return quantities.parse(f"{number} {name}", "length")
    return quantities.kept(quantities.measured(number, unit, text), "length")


def _listed(names: Mapping[str, float]) -> Said:
    if not names:
        return said("no lengths are named: name them in a section [lengths]")
    return said("named lengths are {listed}", listed=", ".join(sorted(names)))


def _unknown(name: str, text: str, names: Mapping[str, float]) -> Said:
    units = [spelling for spelling, unit in UNITS.items() if unit.dimension == "length"]
    hints = (
        said(
            "{name!r}{where} is neither a named length nor a unit of length",
            name=name,
            where="" if name == text else said(' in "{text}"', text=text),
        ),
        misfits.meant(name, [*names, *units]),
        _listed(names),
        said("units are {listed}", listed=", ".join(units)),
    )
    return joined("; ", filter(None, hints))


def _unreadable(text: str, names: Mapping[str, float]) -> Said:
    says = said(
        '"{text}" is not a length: write a number with a unit ("95 mm"), a named length, or a sum such '
        'as "OA - 0.25 BC" (no brackets, no division)',
        text=text,
    )
    return joined("; ", (says, _listed(names)))
