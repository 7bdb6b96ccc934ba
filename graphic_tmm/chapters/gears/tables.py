"""Tables of a gear pair: its dimensions in mm, wheel by wheel; specific sliding on the line of action."""

from __future__ import annotations

import math

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle
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
        own, mate = _of(one, key), _of(other, key)
        cells = [_cell(reading, mark, language) for mark in (own, mate)]
        rows.append([symbol, *cells, _unit(own, language)])
    pair = (
        ("m", sizes.m), ("α_{w}", sizes.alpha_w), ("a_{w}", sizes.a_w), ("y", sizes.y),
        ("Δy", sizes.dy), ("h", sizes.h), ("p", sizes.p), ("p_{b}", sizes.p_b),
        ("ε_{α}", sizes.contact_ratio), ("ab/p_{b}", made.contact.drawn),
    )  # fmt: skip
    rows += [[s, _cell(reading, mark, language), "", _unit(mark, language)] for s, mark in pair]
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


def _of(wheel: WheelSizes, key: str) -> Mark:
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


def sliding_table(
    reading: Reading, made: Gear, language: str, title: str, heights: Heights
) -> Drawing:
    """Return x (mm on the drawing) and both slidings at N1, a, P, b, N2, and at the stations of the task.

    At N1 and N2 one of the teeth stands still, at P neither slides, whatever the ruler makes of x.
    """
    sliding, words = made.sliding, captions(language)
    length = float(reading[made.line.length][0, 0])
    pole = float(reading[sliding.pole.x][0, 0])
    places = [
        (0.0, "N_{1}", -math.inf, 1.0),
        (pole, "P", 0.0, 0.0),
        (length, "N_{2}", 1.0, -math.inf),
    ]
    for name, stations in zip("ab", sliding.ends, strict=True):
        first, second = (float(reading[mark][0, 0]) for mark in stations.sliding)
        places.append((float(reading[stations.x][0, 0]), name, first, second))
    if sliding.further is not None:
        for k in range(len(made.order.stations)):
            x, first, second = (
                float(reading[mark][0, k]) for mark in (sliding.further.x, *sliding.further.sliding)
            )
            places.append((x, str(k + 1), first, second))
    places.sort(key=lambda place: place[0])
    rows = [["x", unit("mm", language), *(fixed(x, 1, language) for x, *_ in places)]]
    for k, found in ((1, [place[2] for place in places]), (2, [place[3] for place in places])):
        rows.append([f"ϑ_{{{k}}}", "", *(_sliding(value, language) for value in found)])
    heads = [words["value"], words["unit"], *(name for _, name, *_ in places)]
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
    if value in (0.0, -math.inf):
        return "−∞" if value else "0"
    return fixed(value, 2 if abs(value) > 4.0 else 3, language)
