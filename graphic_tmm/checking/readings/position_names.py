"""Which position is meant by what somebody typed: 1, 01, №1, I, "пол. 1", 45°, "φ = 45"."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from graphic_tmm.checking.readings.names import DASHES, NOTHING, Meant, meant, signs

_POSITION = re.compile(
    r"\(?(?:no|#|pos(?:ition)?\.?|пол(?:ож(?:ение)?)?\.?)?\s*0*(\d+)(?:-?[ея]|[.,]0*)?"
    r"\s*([*×xх]+|°|deg|град\.?)?\)?"
)
_ROMAN = re.compile(r"(x{0,2})(ix|iv|v?i{0,3})")
_LOOK_ALIKE = str.maketrans({"і": "i", "х": "x", "ӏ": "i"})
_DIGITS = {"i": 1, "v": 5, "x": 10}
_ANGLE = re.compile(
    r"(?:(?:φ|phi|ф|fi)1?=(\d+(?:[.,]\d+)?)(?:°|deg|град\.?)?|(\d+(?:[.,]\d+)?)(?:°|deg|град\.?))"
)
NEAR = 0.051
"""An angle is written to a tenth of a degree."""


def position_meant(
    typed: str, names: Sequence[str], angles: Mapping[str, Sequence[float]] | None = None
) -> Meant:
    """Return which position is meant: "01" and "1.0" are 1, "6 *" is 6*, a dash is none.

    ``angles``: of each position, as people may count them, degrees.

    >>> position_meant("01", ["0", "1"]).only, position_meant("6∗", ["6", "6*"]).only
    ('1', '6*')
    """
    if typed in names:
        return Meant((typed,))
    if typed in DASHES and "" in names:
        return Meant(("",), "sign")
    number = _numbered(typed)
    found = tuple(name for name in names if number and _numbered(name) == number)
    if not found and number and not number[1]:
        found = tuple(name for name in names if _numbered(name) == (number[0], "°"))
    if found:
        return Meant(found, "sign")
    if (roman := _roman(typed)) and str(roman) in names:
        return Meant((str(roman),), "roman")
    turned = _turned(typed, names, angles or {})
    return turned if turned.names else meant(typed, {name: frozenset() for name in names if name})


def is_position(text: str) -> bool:
    """Whether a title may be of a position: a number, a Roman one, an angle."""
    return _numbered(text) is not None or bool(_roman(text)) or _angle(text) is not None


def _turned(typed: str, names: Sequence[str], angles: Mapping[str, Sequence[float]]) -> Meant:
    angle = _angle(typed)
    if angle is None:
        return NOTHING
    near = [
        name
        for name in names
        if any(abs((one - angle + 180.0) % 360.0 - 180.0) < NEAR for one in angles.get(name, ()))
    ]
    return Meant(tuple(near), "angle") if near else NOTHING


def _angle(typed: str) -> float | None:
    found = _ANGLE.fullmatch(signs(typed).casefold())
    return None if found is None else float((found[1] or found[2]).replace(",", "."))


def _roman(typed: str) -> int:
    """Return a Roman number up to 29; 0 for none."""
    word = signs(typed).casefold().translate(_LOOK_ALIKE)
    if not word or _ROMAN.fullmatch(word) is None:
        return 0
    digits = [_DIGITS[sign] for sign in word]
    return sum(-d if d < max(digits[k:]) else d for k, d in enumerate(digits))


def _numbered(name: str) -> tuple[str, str] | None:
    found = _POSITION.fullmatch(signs(name).casefold())
    if found is None:
        return None
    number, mark = found.groups()
    sign = "°" if mark else ""
    if mark and mark[0] in "*×xх":
        sign = "*" * len(mark)
    return str(int(number)), sign
