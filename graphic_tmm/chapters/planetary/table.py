"""The columns of a planetary train: what was measured, the conditions in numbers, the trains to choose from."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle
from graphic_tmm.chapters.planetary.plan import PLANETARY_PLAN
from graphic_tmm.chapters.planetary.tables import CHOICE, trains_wanted
from graphic_tmm.chapters.planetary.verdict import train_results
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.names import plain
from graphic_tmm.readers.columns import Column, listed
from graphic_tmm.readers.measured import Tabled, measured_columns

CONDITIONS, TRAINS = "planetary-conditions", "planetary-trains"
"""The plans of the tables of a train."""


def planetary_columns(drawn: Drawn) -> tuple[Column, ...]:
    """Return what was measured, both sides of each condition, the trains that fulfil the order by rank."""
    return (*measured_columns(drawn), *_conditions(drawn), *_trains(drawn))


def _conditions(drawn: Drawn) -> Iterator[Column]:
    found: dict[str, Mark] = {}
    for condition in PLANETARY_PLAN.on(drawn).sizes.conditions:
        for mark in (condition.left, condition.right):
            if mark is not None:
                found.setdefault(plain(mark.name), mark)
    for name, mark in found.items():
        unit = "°" if mark.kind is Angle else mark.unit
        yield listed(CONDITIONS, name, mark.name, unit, [drawn.reading.figure(mark)[:, 0]], ())


def _trains(drawn: Drawn) -> Iterator[Column]:
    trains = trains_wanted(PLANETARY_PLAN.on(drawn))
    if trains is None:
        return
    most = min(CHOICE, len(trains))
    heads = [str(rank + 1) for rank in range(most)]
    wheels = enumerate(trains.scheme.wheels)
    rows: list[tuple[str, str, str, NDArray[Any]]] = [
        *((f"z{wheel}", f"z_{{{wheel}}}", "", trains.teeth[:, k]) for k, wheel in wheels),
        ("k", "k", "", trains.satellites),
        ("U", "U", "", trains.ratio),
        ("size", "train size", "m", trains.size),
    ]
    for segment, letter, unit, row in rows:
        figures = list(row[:most, None].astype(np.float64))
        yield listed(TRAINS, segment, letter, unit, figures, heads)


TABLE = Tabled(columns=planetary_columns, results=train_results)
