"""How finely figures were meant that were written without their last noughts: 2 beside 1.762 is 2.000."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from graphic_tmm.checking.records import Taken

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
