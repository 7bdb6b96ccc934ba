"""Tables of a gear pair: its dimensions in mm, wheel by wheel; specific sliding on the line of action."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Reals
from graphic_tmm.captions import captions
from graphic_tmm.chapters.gears.dimensions import WheelSizes
from graphic_tmm.chapters.gears.plan import Gear
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.language.units import unit
from graphic_tmm.paper.blocks import breakable
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.lettering.heights import Heights

PLACES = 3
"""Decimals of lengths in mm and of coefficients."""
DIGITS = 4
"""Figures of an angle, of a contact ratio and of a sliding."""


def dimension_table(
    reading: Reading, made: Gear, language: str, title: str, heights: Heights
) -> Drawing:
    """Return the dimensions: those of the wheels side by side, then those of the pair."""
    words, sizes = captions(language), made.sizes
    one, other = sizes.wheels
    rows = []
    for symbol, key in WHEEL:
        own, mate = size_of(one, key), size_of(other, key)
        cells = [_cell(reading, mark, language) for mark in (own, mate)]
        rows.append([symbol, *cells, _unit(own, language)])
    rows += [
        [symbol, _cell(reading, mark, language), "", _unit(mark, language)]
        for symbol, _, mark in pair_sizes(made)
    ]
    heads = [words["value"], "1", "2", words["unit"]]
    align = ["left", "centre", "centre", "left"]
    return breakable(
        "table-gear",
        title,
        heads,
        rows,
        again=words["continued"],
        size=heights.number,
        title_size=heights.title,
        align=align,
    )


WHEEL = (
    ("z", "z"), ("x", "x"), ("r", "r"), ("r_{b}", "r_b"), ("r_{w}", "r_w"), ("r_{f}", "r_f"),
    ("r_{a}", "r_a"), ("s", "s"), ("s_{a}", "s_a"), ("x_{min}", "x_min"),
)  # fmt: skip
"""What the table tells of a wheel: the symbol, the name in its sizes."""


def pair_sizes(made: Gear) -> tuple[tuple[str, str, Mark], ...]:
    """Return what the table tells of the pair: the symbol, the name that machines read, the mark."""
    sizes = made.sizes
    return (
        ("m", "m", sizes.m), ("α_{w}", "alpha_w", sizes.alpha_w), ("a_{w}", "a_w", sizes.a_w),
        ("y", "y", sizes.y), ("Δy", "delta_y", sizes.dy), ("h", "h", sizes.h), ("p", "p", sizes.p),
        ("p_{b}", "p_b", sizes.p_b), ("ε_{α}", "contact_ratio", sizes.contact_ratio),
        ("ab/p_{b}", "contact_ratio_drawn", made.contact.drawn),
    )  # fmt: skip


def size_of(wheel: WheelSizes, key: str) -> Mark:
    """Return a dimension of a wheel by its name among them."""
    mark = getattr(wheel, key)
    assert isinstance(mark, Mark)
    return mark


def _cell(reading: Reading, mark: Mark, language: str) -> str:
    value = float(reading[mark][0, 0])
    if mark.unit == "m":
        return fixed(1000.0 * value, PLACES, language)
    return number(value, language, DIGITS)


def _unit(mark: Mark, language: str) -> str:
    if mark.kind is Angle:
        return unit("°", language)
    return unit("mm" if mark.unit == "m" else mark.unit, language)


class SlidingPlace(NamedTuple):
    """A place on the line of action: its name, x (mm from N1) and the slidings of both wheels, (trial,)."""

    name: str
    x: Reals
    sliding: tuple[Reals, Reals]


def sliding_places(reading: Reading, made: Gear) -> list[SlidingPlace]:
    """Return the places of which the sliding is told: the limits, the ends, the pole, those of the task."""
    sliding, none, whole = made.sliding, np.full(1, -np.inf), np.ones(1)
    found = [
        SlidingPlace("N_{1}", np.zeros(1), (none, whole)),
        SlidingPlace("N_{2}", reading[made.line.length][:, 0], (whole, none)),
    ]
    named = (("a", sliding.ends[0]), ("P", sliding.pole), ("b", sliding.ends[1]))
    told = [(name, stations, 0) for name, stations in named]
    if sliding.further is not None:
        told += [(str(k + 1), sliding.further, k) for k in range(len(made.order.stations))]
    for name, stations, k in told:
        x, first, second = (reading[mark][:, k] for mark in (stations.x, *stations.sliding))
        found.append(SlidingPlace(name, x, (first, second)))
    return found


def sliding_table(
    reading: Reading, made: Gear, language: str, title: str, heights: Heights
) -> Drawing:
    """Return x (mm on the drawing) and both slidings at N1, a, P, b, N2, and at the stations of the task."""
    words = captions(language)
    places = sorted(sliding_places(reading, made), key=lambda place: float(place.x[0]))
    rows = [["x", unit("mm", language), *(fixed(float(p.x[0]), 1, language) for p in places)]]
    for k in (0, 1):
        cells = [_sliding(float(place.sliding[k][0]), language) for place in places]
        rows.append([f"ϑ_{{{k + 1}}}", "", *cells])
    heads = [words["value"], words["unit"], *(place.name for place in places)]
    align = ["left", "left", *["centre"] * len(places)]
    return breakable(
        "table-sliding",
        title,
        heads,
        rows,
        again=words["continued"],
        size=heights.number,
        title_size=heights.title,
        lead=2,
        align=align,
    )


def _sliding(value: float, language: str) -> str:
    return "−∞" if value == -math.inf else fixed(value, 2 if abs(value) > 4.0 else 3, language)
