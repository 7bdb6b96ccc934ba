"""The columns of hodographs: angles from their tangents to the accelerations, up to what; the analogues."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.board.record import segment_name
from graphic_tmm.board.values import Curve, Reals
from graphic_tmm.chapters.hodograph import words as why
from graphic_tmm.chapters.hodograph.record import (
    HODOGRAPH_PLAN,
    Hodograph,
    Hodographs,
    view_of_analogues,
)
from graphic_tmm.chapters.hodograph.task import HODOGRAPH
from graphic_tmm.chapters.hodograph.words import ANALOGUES, LIMIT
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, VELOCITIES
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.project import Project
from graphic_tmm.readers.columns import Column, Tabled, empty, row_of
from graphic_tmm.readers.protocol import Protocols
from graphic_tmm.scene.chapter import Holder

PROTRACTOR, TIMES = 1.0, 3.0
"""How well an angle is read, °; how many times the spread of slopes explains an angle.

A harmonic that turns by θ from one end to the next has a slope that is wrong by θ⁴/180 on a cubic spline, by
θ⁴/30 in differences of the fourth order. What is between them is 5 times the spline's error where θ is small,
and no less than a third of it up to 150°; where a peak falls between two ends, both see it alike, but those
beside it do not: the larger of the three counts.
"""
EDGE = 3
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
    if one.angle is None or drawn.of(one.angle.view) is None:
        return empty(count)
    row = range(EDGE, made.count - EDGE) if not made.closed else range(made.count)
    held = [k for k in drawn.row(one.angle.view) if k in row]
    found = PROTRACTOR + TIMES * slopes_apart(drawn.reading[one.curve])
    return row_of(found[:, held], held, count)


def slopes_apart(curve: Curve) -> Reals:
    """Return by how much slopes of a curve at a knot, or next to it, differ from those by differences, °.

    ``curve``: evenly run through; of an open one the places at both ends tell nothing.
    """
    z = curve.knots
    one, two = (np.roll(z, -k, axis=1) - np.roll(z, k, axis=1) for k in (1, 2))
    apart, long = np.abs((8.0 * one - two) / 12.0 - curve.tangents), np.abs(curve.tangents)
    there = long > 0.0
    found = np.where(there, np.degrees(apart / np.where(there, long, 1.0)), np.nan)
    most: Reals = np.fmax.reduce([np.roll(found, k, axis=1) for k in (-1, 0, 1)])
    return most


def tangent_columns(drawn: Drawn) -> Iterator[Column]:
    """Yield the angles at the hodographs, and the limits up to which they are explained."""
    made, none = HODOGRAPH_PLAN.of(drawn), empty(len(drawn.names))
    for one in made.curves if made is not None else ():
        if one.angle is None:
            continue
        name = segment_name(one.angle.name)
        yield Column(HODOGRAPH, name, one.angle.name, "°", none, angles(drawn, one))
        yield Column(HODOGRAPH, f"{name}_limit", LIMIT, "°", none, limits(drawn, one))


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


def _title(held: Holder, view: str, language: str) -> str:
    """Return what a view of the log is called."""
    made, speech = HODOGRAPH_PLAN.of(held), speaking(language)
    for one in made.curves if made is not None else ():
        velocities = one.plan == VELOCITIES
        if view == one.view:
            return speech(why.VELOCITY if velocities else why.ACCELERATION, point=one.point)
        if one.angle is not None and view == one.angle.view:
            return speech(why.TANGENTS, point=one.point)
    plans = {view_of_analogues(plan): plan for plan in (VELOCITIES, ACCELERATIONS)}
    if view in plans:
        return speech(why.FIRST if plans[view] == VELOCITIES else why.SECOND)
    return ""


PROTOCOL = Protocols(views=_views, titles=_title)
