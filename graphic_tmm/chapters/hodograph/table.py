"""The columns of hodographs: angles from their tangents to the accelerations, up to what; the analogues."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from graphic_tmm.board.record import segment_name
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.hodograph.plan import (
    HODOGRAPH_PLAN,
    Hodograph,
    Hodographs,
    view_of_analogues,
)
from graphic_tmm.chapters.hodograph.task import HODOGRAPH
from graphic_tmm.chapters.hodograph.words import ANALOGUES
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS
from graphic_tmm.drawn import Drawn
from graphic_tmm.project import Project
from graphic_tmm.readers.columns import Column, Tabled, empty, row_of
from graphic_tmm.readers.protocol import Protocols

PROTRACTOR, HARMONIC = 1.0, 3
"""How well an angle is read, °; the harmonic of the crank that the ends have to follow."""
EDGE = 2
"""So many positions at either end of a row that does not come back tell nothing of the tangent."""


def angles(drawn: Drawn, one: Hodograph) -> Reals:
    """Return the angles from the tangents to the accelerations (trial, position); NaN where nothing is said."""
    count = len(drawn.names)
    reading = drawn.of(one.angle.view) if one.angle is not None else None
    if one.angle is None or reading is None:
        return empty(count)
    return row_of(reading[one.angle], drawn.row(one.angle.view), count)


def limits(drawn: Drawn, one: Hodograph) -> Reals:
    """Return how large these angles may be for the number of positions, ° (trial, position)."""
    made, count = HODOGRAPH_PLAN.on(drawn), len(drawn.names)
    reading = drawn.of(ACCELERATIONS)
    if one.angle is None or reading is None:
        return empty(count)
    image = made.images[ACCELERATIONS, one.point]
    long = row_of(np.abs(reading[image]), drawn.row(ACCELERATIONS), count)
    most = np.fmax.reduce(long, axis=1, keepdims=True, initial=0.0)
    there = long > 0.0
    times = np.where(there, most / np.where(there, long, 1.0), np.nan)
    found = PROTRACTOR + spread(made.count) * times
    if not made.closed:
        found[:, [*range(EDGE), *range(made.count - EDGE, made.count)]] = np.nan
    return found


def spread(count: int) -> float:
    """Return by how much the slope of a curve through so many ends of a turn may be off, ° of the greatest."""
    return math.degrees((math.tau * HARMONIC / count) ** 4 / 180.0)


def tangent_columns(drawn: Drawn) -> Iterator[Column]:
    """Yield the angles at the hodographs, and the limits up to which they are explained."""
    made, none = HODOGRAPH_PLAN.of(drawn), empty(len(drawn.names))
    for one in made.curves if made is not None else ():
        if one.angle is None:
            continue
        named = ((one.angle.name, angles(drawn, one)), (f"τ_{{{one.point}}}", limits(drawn, one)))
        for letter, row in named:
            yield Column(HODOGRAPH, segment_name(letter), letter, "°", none, row)


def analogue_columns(drawn: Drawn) -> Iterator[Column]:
    """Yield the analogues."""
    made = HODOGRAPH_PLAN.of(drawn)
    for one in made.analogues if made is not None else ():
        view = view_of_analogues(one.plan)
        reading, places, count = drawn.of(view), drawn.row(view), len(drawn.names)
        if reading is None:
            continue
        value = row_of(np.abs(reading.figure(one.value)), places, count)
        letter = one.value.name
        yield Column(ANALOGUES, segment_name(letter), letter, "m", empty(count), value)


def columns(drawn: Drawn) -> Iterator[Column]:
    """Yield the columns of both tables."""
    yield from tangent_columns(drawn)
    yield from analogue_columns(drawn)


TABLE = Tabled(columns=columns)


def _views(project: Project) -> dict[str, tuple[str, ...]]:
    made: Hodographs | None = HODOGRAPH_PLAN.of(project)
    if made is None:
        return {}
    own = [(one.view, one.angle.view) if one.angle else (one.view,) for one in made.curves]
    plans = dict.fromkeys(one.plan for one in made.analogues)
    return {
        HODOGRAPH: tuple(view for views in own for view in views),
        ANALOGUES: tuple(view_of_analogues(plan) for plan in plans),
    }


PROTOCOL = Protocols(views=_views)
