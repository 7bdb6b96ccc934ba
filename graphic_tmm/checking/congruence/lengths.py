"""The lengths of a drawing beside what is due, by the scale factor that they are drawn to."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.record import Step
from graphic_tmm.board.values import Number
from graphic_tmm.checking.cells import Cell, Key, taken_figure
from graphic_tmm.checking.records import Taken

SHORT = 6.0
"""A shorter length says little of a scale factor: a hand is off by 0.9 mm (49 published drawings)."""

POLE = ""
"""The name of the pole among the points of a plan."""


class Group(NamedTuple):
    """What is drawn to one scale factor: a plan, μ in SI a mm, the unit of what its lengths stand for.

    ``powers``: to which power of each scale factor of the scene its lengths go.
    """

    plan: str
    mu: float
    unit: str
    powers: tuple[int, ...]

    @property
    def of(self) -> tuple[str, str]:
        """Its plan and unit: what is drawn to scale factors that are mostly alike."""
        return self.plan, self.unit


def per_mm(unit: str) -> str:
    """Return the unit of the scale factor to which something is drawn."""
    return f"({unit})/mm" if "/" in unit or "·" in unit else f"{unit or '1'}/mm"


class Read(NamedTuple):
    """A length as it was read and as it is due, mm; what it stands for (NaN where that was not written).

    ``laid``: it is the first that is laid off from what is given, as pa is; ``apart``: it is how far two points
    that were read stand apart.
    """

    position: str
    segment: str
    mm: float
    due: float
    value: float = math.nan
    laid: bool = False
    apart: bool = False

    @property
    def ratio(self) -> float:
        """How many times as long as due it is, as a logarithm."""
        return math.log(self.mm / self.due)


class Rate(NamedTuple):
    """A rate that was calculated from the lengths of a plan, and the due one."""

    position: str
    segment: str
    value: float
    due: float

    @property
    def ratio(self) -> float:
        """How many times as large as due it is, as a logarithm."""
        return math.log(abs(self.value / self.due))


def lengths_of(
    rows: Sequence[Taken],
    due: Mapping[Key, Cell],
    groups: Mapping[tuple[str, str], Group],
    laid: Mapping[str, str],
) -> dict[Group, list[Read]]:
    """Return the lengths that were read, those that say something, by what they are drawn to.

    ``groups``: that, by plan and segment; ``laid``: by plan the segment that is laid off first.
    """
    values = values_of(rows, due)
    found: defaultdict[Group, list[Read]] = defaultdict(list)
    for taken in rows:
        cell, group = due.get(taken.key), groups.get(taken.key[:2])
        if taken.mm is None or cell is None or group is None or cell.mm is None:
            continue
        if abs(cell.mm) < SHORT or not taken.mm:
            continue
        first = laid.get(taken.plan) == taken.segment
        value = values.get(taken.key, math.nan)
        one = Read(taken.position, taken.segment, abs(taken.mm), abs(cell.mm), value, first)
        found[group].append(one)
    return found


def values_of(rows: Iterable[Taken], due: Mapping[Key, Cell]) -> dict[Key, float]:
    """Return what was written that lengths stand for, without signs, in the units of what is due."""
    found = {}
    for taken in rows:
        cell = due.get(taken.key)
        if taken.value is not None and cell is not None and cell.mm:
            found[taken.key] = abs(taken_figure(taken, cell))
    return found


def spread_of(
    rows: Sequence[Taken],
    spots: Mapping[Key, complex],
    groups: Mapping[str, Group],
    first: Mapping[str, str],
) -> dict[Group, list[Read]]:
    """Return the distances between points that were read, and from the pole, as lengths of their plans.

    ``groups``: to what each plan of points is drawn; ``first``: by plan the point that is laid off first.
    """
    there: defaultdict[tuple[str, str], dict[str, tuple[complex, complex]]] = defaultdict(dict)
    for taken in rows:
        if taken.pointed and taken.key in spots and taken.plan in groups:
            there[taken.plan, taken.position][taken.segment] = taken.spot, spots[taken.key]
    found: defaultdict[Group, list[Read]] = defaultdict(list)
    for (plan, position), pairs in there.items():
        pairs |= {POLE: (0j, 0j)}
        names = [*pairs]
        for k, name in enumerate(names):
            for other in names[:k]:
                read, due = (abs(pairs[name][j] - pairs[other][j]) for j in (0, 1))
                if due >= SHORT and read > 0.0:
                    laid = name == POLE and other == first.get(plan)
                    one = Read(position, f"{other}{name}", read, due, laid=laid, apart=True)
                    found[groups[plan]].append(one)
    return found


def rates_of(
    rows: Sequence[Taken], due: Mapping[Key, Cell], steps: Mapping[tuple[str, str], Step]
) -> dict[str, list[Rate]]:
    """Return the rates that were calculated, by plan."""
    found: defaultdict[str, list[Rate]] = defaultdict(list)
    for taken in rows:
        cell, step = due.get(taken.key), steps.get((taken.plan, taken.segment))
        if taken.value is None or cell is None or not cell.value or step is None:
            continue
        if step.it.kind is Number and (value := taken_figure(taken, cell)):
            found[taken.plan].append(Rate(taken.position, taken.segment, value, cell.value))
    return found


def middle(ratios: Sequence[float]) -> float:
    """Return the median of logarithms; NaN of none."""
    return float(np.median(ratios)) if len(ratios) else math.nan
