"""The columns of the constructions: sides of the figure, what they stand for, how far the plans are off."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.board.record import Mark, segment_name
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.klein.accuracy import prices
from graphic_tmm.chapters.klein.record import KLEIN_PLAN, Figure
from graphic_tmm.chapters.klein.task import VIEWS
from graphic_tmm.chapters.klein.words import DIFFERENCE
from graphic_tmm.drawn import Drawn, Results
from graphic_tmm.readers.columns import Column, Tabled, empty, row_of
from graphic_tmm.readers.protocol import Protocols

EVEN = 1e-11
"""Figures that differ by less of their own size differ by rounding only."""


def figure_columns(drawn: Drawn, figure: Figure) -> Iterator[Column]:
    """Yield the columns of a construction: segments and quantities; differences from the plans in %."""
    reading, places, count = drawn.of(figure.view), drawn.row(figure.view), len(drawn.names)
    if reading is None:
        return
    planned = _planned(drawn)
    for one in figure.quantities:
        mm, value = (
            row_of(np.abs(reading.figure(mark)), places, count) for mark in (one.segment, one.value)
        )
        segment = segment_name(one.segment.letter)
        unit = one.value.unit
        yield Column(
            figure.view, segment, one.segment.name, unit, mm, value, quantity=one.vector
        )  # fmt: skip
        mark = planned.get(one.vector)
        if mark is not None and (due := _by_plan(drawn, mark)) is not None:
            apart = _apart(value, due, drawn.percent_decimals)
            yield Column(figure.view, f"{segment}_off", DIFFERENCE, "%", empty(count), apart)


def _planned(drawn: Drawn) -> dict[str, Mark]:
    """Return, by what they are of, the points of the plans whose vectors from the pole are held against."""
    made, plans = KLEIN_PLAN.on(drawn), KINEMATICS_PLAN.on(drawn)
    found: dict[str, Mark] = {}
    for sign, motion in (("v", plans.velocities), ("a", plans.accelerations)):
        if motion is None:
            continue
        images = motion.images.by_letter[made.of.rod.link]
        found |= {f"{sign}_{k}": images[k] for k in (made.of.pin, made.of.slider)}
        found |= {f"{sign}_{{{k}}}": images[k] for k in made.of.points}
    return found


def _by_plan(drawn: Drawn, image: Mark) -> Reals | None:
    """Return how long the vector to an image is, in SI, by positions; None where its plan is not drawn."""
    reading, scale = drawn.of(image.view), drawn.scales.get(image.view)
    if reading is None or scale is None:
        return None
    return row_of(np.abs(reading[image]) * scale.value, drawn.row(image.view), len(drawn.names))


def _apart(found: Reals, due: Reals, decimals: int) -> Reals:
    """Return by how much figures differ from what is due, in % of the largest due of their drawing."""
    largest = np.fmax.reduce(np.abs(due), axis=1, keepdims=True, initial=0.0)
    apart = np.where(np.isclose(found, due, rtol=EVEN, atol=0.0), 0.0, found - due)
    row: Reals = np.round(100.0 * apart / np.where(largest > 0.0, largest, np.nan), decimals) + 0.0
    return row


def columns(drawn: Drawn) -> Iterator[Column]:
    """Yield the columns of all constructions."""
    made = KLEIN_PLAN.of(drawn)
    for figure in made.figures.values() if made is not None else ():
        yield from figure_columns(drawn, figure)


def results(drawn: Drawn) -> Results:
    """Return what each way of finding a_B takes in a position, and how a student's scatters."""
    if KLEIN_PLAN.of(drawn) is None:
        return {}
    found: dict[str, tuple[Reals, str]] = {}
    for way, price in prices(drawn).items():
        found[f"klein_work_{way}"] = np.array([price.operations]), ""
        found[f"klein_scatter_{way}"] = np.array([round(price.scatter, 1)]), "%"
    return found


TABLE = Tabled(columns=columns, results=results)
PROTOCOL = Protocols(views=lambda project: {view: (f"{view} scales", view) for view in VIEWS})
