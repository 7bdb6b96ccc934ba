"""Numbers as a sheet writes them: − for minus, powers of ten raised, the decimal sign of the language.

Babel's forms are others (a hyphen for minus, E for powers, thousands apart), so the catalogue gives the decimal
sign and the rest is done here.
"""

from __future__ import annotations

import math
from decimal import ROUND_HALF_UP, Context, Decimal

from graphic_tmm.language.catalogue import speaking

_RAISED = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


def decimal_sign(language: str) -> str:
    """Return what stands between the whole and the rest."""
    _ = speaking(language)
    return _(".", context="decimal sign")


def number(value: float, language: str, digits: int = 4) -> str:
    """Return a number to ``digits`` significant figures, with the decimal sign of the language.

    Halves go up, away from nothing, as in tables; the noise of the last bits is left out first.

    >>> number(0.136571, "ru"), number(-4.0, "en"), number(2.5e-07, "en"), number(1096.5, "en")
    ('0,1366', '−4', '2.5·10⁻⁷', '1097')
    """
    if not math.isfinite(value):
        return "—"
    told = Decimal(f"{value:.15g}")
    rounded = float(Context(digits, ROUND_HALF_UP).plus(told))
    # the largest numbers that there are would be rounded to none
    text = f"{rounded if math.isfinite(rounded) else value:.{digits}g}"
    mantissa, _, exponent = text.partition("e")
    if exponent:
        power = int(exponent)
        text = f"{mantissa}·10{str(power).translate(_RAISED)}"
        if 0 < power < 7:
            text = str(told.quantize(Decimal(1), ROUND_HALF_UP))
    text = "0" if text in ("-0", "0") else text.replace("-", "−", 1)
    return text.replace(".", decimal_sign(language))


def fixed(value: float | None, places: int, language: str) -> str:
    """Return a number with a fixed count of decimals; a dash where there is none."""
    if value is None or not math.isfinite(value):
        return "—"
    text = f"{value:.{places}f}"
    text = text.lstrip("-") if float(text) == 0 else text.replace("-", "−")
    return text.replace(".", decimal_sign(language))


def decimals_of(division: float) -> int:
    """Return the decimals of a figure that is read to a division.

    >>> decimals_of(0.1), decimals_of(0.5), decimals_of(0.025), decimals_of(20.0)
    (1, 1, 2, 0)
    """
    return max(0, math.ceil(-math.log10(division) - 1e-9)) if division > 0 else 0


def percent_decimals(division: float | None) -> int:
    """Return the decimals of a difference in %: as many as a ruler can show.

    Plans are some 100 mm long: a division of 0.1 mm is 0.1 % of them. Without a ruler it is `EXACTLY`.

    >>> percent_decimals(0.1), percent_decimals(0.01), percent_decimals(None)
    (1, 2, 2)
    """
    return EXACTLY if division is None else min(EXACTLY, decimals_of(division))


EXACTLY = 2
"""Decimals of a difference in % where nothing is rounded: lengths are drawn to 0.01 mm at the best."""
