"""Tables of a gear pair: its dimensions in mm, wheel by wheel; specific sliding on the line of action."""

from __future__ import annotations

import math

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle
from graphic_tmm.chapters.gears.beside import BESIDE
from graphic_tmm.chapters.gears.dimensions import WheelSizes
from graphic_tmm.chapters.gears.plan import GEARS_PLAN
from graphic_tmm.chapters.gears.stations import stations
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.language.units import unit
from graphic_tmm.paper.blocks import breakable
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.lettering.heights import Heights
from graphic_tmm.scene.captions import captions

PLACES = 3
"""Decimals of lengths in mm and of coefficients."""
DIGITS = 4
"""Figures of an angle, of a contact ratio and of a sliding."""


def dimension_table(drawn: Drawn, language: str, title: str, heights: Heights) -> Drawing:
    """Return the dimensions: those of the wheels side by side, then those of the pair; and as drawn."""
    words, made, beside = captions(language), GEARS_PLAN.on(drawn), BESIDE.on(drawn)
    sizes, reading = made.sizes, drawn.reading

    def row(symbol: str, own: Mark, *mates: Mark) -> list[str]:
        real = [_cell(reading, mark, language) for mark in (own, *mates)]
        laid = [_drawn(reading, beside.drawn.get(mark), language) for mark in (own, *mates)]
        gap = [""] * (1 - len(mates))
        return [symbol, *real, *gap, _unit(own, language), *laid, *gap]

    rows = [row(symbol, *(size_of(one, key) for one in sizes.wheels)) for symbol, key in WHEEL]
    one, other = made.contact.wheels
    rows.append(row("cd", one.real, other.real))
    rows += [row(symbol, mark) for symbol, _, mark in pair_sizes(drawn)]
    _ = speaking(language)
    laid = [_("{wheel}, drawn,\nmm", wheel=k) for k in (1, 2)]
    heads = [words["value"], "1", "2", words["unit"], *laid]
    align = ["left", "centre", "centre", "left", "centre", "centre"]
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


def pair_sizes(drawn: Drawn) -> tuple[tuple[str, str, Mark], ...]:
    """Return what the table tells of the pair: the symbol, the name that machines read, the mark."""
    made, beside = GEARS_PLAN.on(drawn), BESIDE.on(drawn)
    sizes = made.sizes
    return (
        ("u_{12}", "gear_ratio", beside.ratio), ("m", "m", sizes.m),
        ("α_{w}", "alpha_w", sizes.alpha_w), ("a_{w}", "a_w", sizes.a_w), ("y", "y", sizes.y),
        ("Δy", "delta_y", sizes.dy), ("h", "h", sizes.h), ("h_{w}", "h_w", sizes.h_w),
        ("p", "p", sizes.p), ("p_{b}", "p_b", sizes.p_b),
        ("s_{cd}", "arc_of_engagement", beside.arc),
        ("ε_{α}", "contact_ratio", sizes.contact_ratio),
        (f"{working(drawn)}/p_{{b}}", "contact_ratio_drawn", made.contact.drawn),
    )  # fmt: skip


def working(drawn: Drawn) -> str:
    """Return what the working part of the line of action is called: ab, or N₁b where a is the limit N₁."""
    return "".join(end.letter for end in GEARS_PLAN.on(drawn).line.ends)


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


def _drawn(reading: Reading, mark: Mark | None, language: str) -> str:
    return "" if mark is None else fixed(float(reading[mark][0, 0]), 1, language)


def _unit(mark: Mark, language: str) -> str:
    if mark.kind is Angle:
        return unit("°", language)
    return unit("mm" if mark.unit == "m" else mark.unit, language)


def sliding_table(drawn: Drawn, language: str, title: str, heights: Heights) -> Drawing:
    """Return x (mm on the drawing) and both slidings at N1, a, P, b, N2, and at the stations of the task."""
    words, places = captions(language), stations(drawn)
    cells = [fixed(float(one.x[0]), 1, language) for one in places]
    rows = [["x", unit("mm", language), *cells]]
    for k in (0, 1):
        cells = [_sliding(float(one.sliding[k][0]), language) for one in places]
        rows.append([f"ϑ_{{{k + 1}}}", "", *cells])
    heads = [words["value"], words["unit"], *(one.name for one in places)]
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
