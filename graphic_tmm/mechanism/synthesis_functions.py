"""A four-bar found from a function that its rocker is to show: three pairs of angles for three of its points.

The points are those of Chebyshev's spacing on the range of a function, or the three of a table. Angles are laid
off in proportion to what they stand for.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Number
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism import synthesis_formulas as f
from graphic_tmm.mechanism.synthesis_kinds import (
    PLACES,
    Given,
    Lengths,
    inverted,
    of_angles,
    refuse_count,
    refuse_line,
)

SHARES = (-1.0, 0.0, 1.0)
"""Chebyshev's spacing of three places: by these times cos 30° of half the range from its middle."""
FLAT = 1e-9
"""A function that rises by less than this share of its values does not change."""


class KnownFunction(NamedTuple):
    """A function: the step that calculates it, its value, whether it takes only what is positive."""

    step: Operation
    value: Callable[[float], float]
    positive: bool


KNOWN = {
    "ln x": KnownFunction(f.logarithm, math.log, True),
    "sin x": KnownFunction(f.sine, lambda x: math.sin(math.radians(x)), False),
}
"""The functions that a task may name; the argument of a sine is in degrees."""


def points_of_function(given: Given) -> tuple[list[float], list[float]]:
    """Return where a function is met: arguments and values, the ends of its range first and last.

    Of a table the ends are the first and the last of its three points.
    """
    if "values" in given:
        return _with_ends(given["x"]), _with_ends(given["values"])
    low, high = given["x"]
    x = [
        low,
        *((low + high) / 2.0 + one * (high - low) * math.sqrt(3.0) / 4.0 for one in SHARES),
        high,
    ]
    if "power" in given:
        return x, [one ** given["power"] for one in x]
    return x, [KNOWN[given["y"]].value(one) for one in x]


def _with_ends(row: Sequence[float]) -> list[float]:
    return [row[0], *row, row[-1]]


def pairs_of_function(given: Given) -> tuple[list[float], list[float]]:
    """Return the angles of crank and rocker at which the function is met, degrees."""
    rows = zip(points_of_function(given), (given["crank"], given["rocker"]), strict=True)
    crank, rocker = (
        [to[0] + (one - row[0]) / (row[-1] - row[0]) * (to[1] - to[0]) for one in row[1:-1]]
        for row, to in rows
    )
    return crank, rocker


def take_pairs(draft: Draft, given: Given) -> tuple[list[Mark], list[Mark]]:
    """Calculate the angles of crank and rocker at which the function is met."""
    if "values" in given:
        rows = [
            [
                draft.take(Number, f"{name}_{k}", one)
                for k, one in zip(PLACES, given[key], strict=True)
            ]
            for name, key in (("x", "x"), ("y", "values"))
        ]
        ends = [[row[0], row[-1]] for row in rows]
    else:
        rows, ends = _by_spacing(draft, given)
    found = []
    for (letter, key), row, (low, high) in zip(_ANGLES, rows, ends, strict=True):
        turns = [
            draft.take(Angle, f"{letter}_{n}", one, "°")
            for n, one in zip("0n", given[key], strict=True)
        ]
        found.append(
            [
                draft.draw(f.in_proportion, f"{letter}_{k}", one, low, high, *turns, unit="°")
                for k, one in zip(PLACES, row, strict=True)
            ]
        )
    return found[0], found[1]


_ANGLES = (("φ", "crank"), ("ψ", "rocker"))


def _by_spacing(draft: Draft, given: Given) -> tuple[list[list[Mark]], list[list[Mark]]]:
    """Calculate the three points of Chebyshev's spacing and the ends of the range, arguments and values."""
    low, high = (
        draft.take(Number, f"x_{name}", x) for name, x in zip("0n", given["x"], strict=True)
    )
    more = [draft.take(Number, "p", given["power"])] if "power" in given else []
    power = f.power_function if min(given["x"]) > 0.0 else f.power_of_any
    step = power if more else KNOWN[given["y"]].step
    ends = [draft.draw(step, f"y_{n}", x, *more) for n, x in zip("0n", (low, high), strict=True)]
    x = [
        draft.draw(f.chebyshev, f"x_{k}", low, high, draft.take(Number, "", share))
        for k, share in zip(PLACES, SHARES, strict=True)
    ]
    y = [draft.draw(step, f"y_{k}", one, *more) for k, one in zip(PLACES, x, strict=True)]
    return [x, y], [[low, high], ends]


def function(draft: Draft, given: Given) -> Lengths:
    """A four-bar that meets a function at three points: of Chebyshev's spacing, or of a table."""
    _refuse_function(given)
    refuse_line(inverted(given, *pairs_of_function(given)), "A", "task.rocker")
    return of_angles(draft, given, *take_pairs(draft, given))


def _refuse_function(given: Given) -> None:
    for key in ("crank", "rocker"):
        refuse_count(given, key, 2)
        if given[key][0] == given[key][1]:
            says = said(
                'both ends are one angle, so nothing stands for the function: write two, ["30 deg", "120 deg"]'
            )
            raise StructureError(says, f"task.{key}", head=f"task.{key}")
    for key in ("x", "values"):
        if key in given:
            refuse_count(given, key, len(PLACES) if "values" in given else 2)
    x = given["x"]
    if "y" in given and KNOWN[given["y"]].positive and min(x) <= 0.0:
        says = said("the range of x has to lie above 0, such as [1, 2]")
        raise StructureError(says, "task.x", head="task")
    if "power" in given:
        _refuse_power(x, given["power"])
    if given.get("power") == 0.0:
        says = said("x to the power 0 does not change: take another power")
        raise StructureError(says, "task.power", head="task")
    if len(set(x)) < len(x):
        says = said("the values of x have to differ, such as [1, 2]")
        raise StructureError(says, "task.x", head="task")
    _, y = points_of_function(given)
    if abs(y[-1] - y[0]) <= FLAT * max(map(abs, y)):
        says = said(
            "the function has the same value at both ends, so no angle stands for it: take other ends"
        )
        raise StructureError(says, "task.values" if "values" in given else "task.x", head="task")


def _refuse_power(x: Sequence[float], power: float) -> None:
    """Refuse arguments that have no such power: 0 below 0, what is negative to one that is not whole."""
    if not float(power).is_integer() and min(x) < 0.0:
        says = said(
            "what is below 0 has no such power: begin the range of x at 0, or take a whole power"
        )
        raise StructureError(says, "task.x", head="task")
    if power < 0.0 and min(x) <= 0.0 <= max(x):
        says = said("0 has no power below 0: take a range of x without it, such as [1, 2]")
        raise StructureError(says, "task.x", head="task")
