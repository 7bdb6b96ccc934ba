"""Figures as hands type them: ``17.5``, ``17,5 мм``, ``−3``, ``87000 Pa``; how finely they were meant."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from graphic_tmm.checking.records import Taken
from graphic_tmm.language.said import said
from graphic_tmm.scene.quantities import LARGEST, NUMBER
from graphic_tmm.scene.units import UNITS, plain_unit

SHEET = {
    **dict.fromkeys(("mm", "мм"), 1.0),
    **dict.fromkeys(("cm", "см"), 10.0),
    **dict.fromkeys(("in", "inch", "inches", "дюйм", "дюймы", "дюйма", "дюймов", '"', "″"), 25.4),
}
"""Units in which paper is measured, mm."""
BARE = ("1", "-", "–", "—")
"""Ways to write that a value has no unit; an empty cell may as well be one forgotten."""
_FIGURE = re.compile(rf"([+-]?{NUMBER})\s*(.*)", re.DOTALL)
_PLAIN = re.compile(r"[+-]?[0-9]{1,12}(?:\.[0-9]{1,20})?")
_COMMA = re.compile(r"[+-]?[0-9]*,[0-9]+(?:[eE][+-]?[0-9]+)?")
_THOUSANDS = re.compile(r"[+-]?[1-9][0-9]{0,2},[0-9]{3}")
_LAST = re.compile(r"[0-9]*[.,]?([0-9]*)(?:[eE]([+-]?[0-9]{1,6}))?")
_DATE = re.compile(r"\d{4}-\d\d-\d\d(?: .*)?|\d{1,2}\.\d{1,2}\.\d{4}|\d\d:\d\d:\d\d.*")
_NOTHING = frozenset(
    (*BARE[1:], "−", "--", "нет", "н/д", "n/a", "na", "none", "?", "??", "…", "...", "не снято")
)
_ABOUT = re.compile(
    r"(?:[≈~∼≅≃]|ок\.?|около|примерно|прибл\.?|ca\.|c\.|about|approx\.?)\s*(?=[-+−]?[.,]?\d)",
    re.IGNORECASE,
)
_WITHIN = re.compile(rf"([+-]?{NUMBER})\s*(?:±|\+/-|\+-)\s*({NUMBER})\s*(\D*)")
_SHORTEST = 40
"""Of a cell that a message quotes so many characters are shown."""


def is_nothing(cell: str) -> bool:
    """Whether a cell says that nothing was read: a dash, "нет", "?"."""
    return cell.casefold() in _NOTHING


def plainly(cell: str, name: str = "") -> str:
    """Return a figure without what says that it is rough, or of what it is.

    >>> plainly("≈ 60"), plainly("pd = 25,1", "pd"), plainly("25,1±0,5 мм"), plainly("-")
    ('60', '25,1', '25,1 мм', '')
    """
    if is_nothing(cell):
        return ""
    if name and cell.startswith(name) and "=" in cell:
        named, _, rest = cell.partition("=")
        cell = rest.strip() if named.strip() == name else cell
    cell = _ABOUT.sub("", cell, count=1) if _ABOUT.match(cell) else cell
    within = _WITHIN.fullmatch(cell) if "±" in cell or "+-" in cell or "+/" in cell else None
    return f"{within[1]} {within[3]}".strip() if within else cell


def unit_behind(cell: str) -> str:
    """Return what stands behind the figure of a cell; "" for nothing, or no figure.

    >>> unit_behind("1,004 м/с"), unit_behind("25,1")
    ('м/с', '')
    """
    found = _FIGURE.fullmatch(_straight(plainly(cell)))
    return "" if found is None else found[2].strip()


def decimal_comma(cell: str) -> bool:
    """Return whether a cell is a number whose comma cannot but be its decimal sign.

    >>> decimal_comma("17,5"), decimal_comma("1,234"), decimal_comma("17.5")
    (True, False, False)
    """
    text = _straight(cell)
    return "," in text and bool(_COMMA.fullmatch(text)) and not _THOUSANDS.fullmatch(text)


def millimetres(cell: str, *, commas: bool, usual: float = 1.0) -> tuple[float, float]:
    """Return the millimetres of a cell that is not empty, and how many mm a unit of its figure is.

    Parameters
    ----------
    cell : str
        As typed; mm, cm or inches may follow.
    commas : bool
        Whether a comma in the file is known to be the decimal sign; else "1,234" is refused.
    usual : float
        The unit of a cell that has none, mm: that of its column.

    Raises
    ------
    ValueError
        With a sentence that says what is wrong and what to write.
    """
    number, rest = _figure(cell, commas, said("millimetres, such as 17.5"))
    unit = SHEET.get(rest.casefold().rstrip("."), 0.0) if rest else usual
    if not unit:
        raise ValueError(
            said(
                '"{cell}" is not a number of millimetres; write it in mm, such as 17.5',
                cell=_short(cell),
            )
        )
    return number * unit, unit


def value_of(cell: str, unit: str, *, commas: bool) -> tuple[float | None, str]:
    """Return a value and its unit, "" for a bare number; None and the unit if the cell is empty.

    Parameters
    ----------
    cell, unit : str
        As typed; the unit may stand behind the number, too. "1" or a dash is the unit of a bare number.
    commas : bool
        As in ``millimetres``.

    Raises
    ------
    ValueError
        With a sentence that says what is wrong and what to write.
    """
    if not cell:
        return None, "" if unit in BARE else unit
    number, rest = _figure(cell, commas, said("a value, such as 16.3"))
    if rest and unit and plain_unit(rest) != plain_unit(unit):
        raise ValueError(
            said(
                '"{cell}" has a unit, and "{unit}" is another; keep one',
                cell=_short(cell),
                unit=_short(unit),
            )
        )
    found = unit or rest
    if not found:
        raise ValueError(
            said(
                '"{cell}" has no unit; write it into the column "unit" (1 for a bare number)',
                cell=_short(cell),
            )
        )
    return number, "" if found in BARE else found


def half_unit(cell: str) -> float:
    """Return half a unit of the last digit of a figure that could be read; 0 for an empty cell.

    >>> half_unit("54,3 мм"), half_unit("−31.40"), half_unit("7"), half_unit("1.2e3"), half_unit("")
    (0.05, 0.005, 0.5, 50.0, 0.0)
    """
    match = _LAST.match(_straight(cell).lstrip("+-"))
    if not cell or match is None:
        return 0.0
    decimals, exponent = match.groups()
    return float(f"5e{int(exponent or 0) - len(decimals) - 1}")


def _figure(cell: str, commas: bool, wanted: str) -> tuple[float, str]:
    """Return the number of a cell, and what stands behind it."""
    simple = cell.replace(",", ".") if commas else cell
    if _PLAIN.fullmatch(simple):  # as almost every cell is, in files of any length
        return float(simple), ""
    if cell.startswith("="):
        says = said('"{cell}" is a formula without a result; write the figure', cell=_short(cell))
        raise ValueError(says)
    if _DATE.fullmatch(cell):
        says = said(
            '"{cell}" is a date: the spreadsheet made it of a number; format the cell as text and '
            "write the number again",
            cell=_short(cell),
        )
        raise ValueError(says)
    match = _FIGURE.fullmatch(_straight(cell))
    if match is None:
        raise ValueError(
            said(
                '"{cell}" is not a number; write {wanted}, or leave it empty',
                cell=_short(cell),
                wanted=wanted,
            )
        )
    digits, rest = match.groups()
    rest = rest.strip()
    if rest and not (rest[0].isalpha() or rest[0] in '°%("″') and plain_unit(rest) not in UNITS:
        raise ValueError(
            said(
                '"{cell}" is not one number; write it in one piece, such as 1234.5',
                cell=_short(cell),
            )
        )
    if not commas and _THOUSANDS.fullmatch(digits):
        point, whole = digits.replace(",", "."), digits.replace(",", "")
        raise ValueError(
            said(
                '"{cell}" can be read in two ways; write {point} or {whole} (a comma is taken for '
                "the decimal sign where cells are separated by semicolons)",
                cell=_short(cell),
                point=point,
                whole=whole,
            )
        )
    number = float(digits.replace(",", "."))
    if not math.isfinite(number) or abs(number) > LARGEST:
        raise ValueError(
            said('"{cell}" is too large a number; check its exponent', cell=_short(cell))
        )
    return number, rest


def _straight(cell: str) -> str:
    return cell.replace("−", "-")


def _short(text: str) -> str:
    return text if len(text) <= _SHORTEST else f"{text[:_SHORTEST]}..."


_KINDS = ("mm", "value", "x", "y")


class _Finest(NamedTuple):
    """The finest half unit, and the most digits, of figures that were written alike."""

    half: float = math.inf
    digits: int = 1


def meant(readings: Sequence[Taken]) -> tuple[Taken, ...]:
    """Return readings with half a unit of the last digit that was meant.

    Figures of one plan and unit are written alike: with as many digits, or as many decimals. One that has fewer
    of both has lost its noughts, as spreadsheets take them away.
    """
    finest: dict[tuple[str, ...], _Finest] = {}
    for taken in readings:
        for kind, figure, half in _figures(taken):
            found = finest.get(key := _alike(taken, kind), _Finest())
            finest[key] = _Finest(min(found.half, half), max(found.digits, _digits(figure, half)))
    return tuple(_refined(taken, finest) for taken in readings)


def _refined(taken: Taken, finest: dict[tuple[str, ...], _Finest]) -> Taken:
    last = taken.last
    for kind, figure, half in _figures(taken):
        of = finest[_alike(taken, kind)]
        # with so many digits as others have the figure would end here
        long = half * 10.0 ** (_digits(figure, half) - of.digits)
        last = last._replace(**{kind: min(half, max(of.half, long))})
    return taken if last == taken.last else taken._replace(last=last)


def _figures(taken: Taken) -> Iterable[tuple[str, float, float]]:
    """Yield what was written in a row: its kind, the figure, half a unit of its last digit."""
    for kind in _KINDS:
        figure, half = getattr(taken, kind), getattr(taken.last, kind)
        if figure is not None and half > 0.0:
            yield kind, figure, half


def _alike(taken: Taken, kind: str) -> tuple[str, ...]:
    if kind == "value":
        return (taken.plan, taken.unit, kind)
    return (taken.plan, kind if kind == "mm" else "xy")


def _digits(figure: float, half: float) -> int:
    """Return with how many digits a figure was written; one at least."""
    if figure == 0.0:
        return 1
    return max(math.floor(math.log10(abs(figure)) + 1e-12) - round(math.log10(2.0 * half)) + 1, 1)
