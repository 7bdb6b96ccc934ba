"""The columns of a gear pair: what was measured; the tables of its sheet, by wheels and by places."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle
from graphic_tmm.chapters.gears.beside import BESIDE
from graphic_tmm.chapters.gears.dimensions import VIEW
from graphic_tmm.chapters.gears.plan import GEARS_PLAN
from graphic_tmm.chapters.gears.results import gear_results
from graphic_tmm.chapters.gears.stations import stations
from graphic_tmm.chapters.gears.tables import WHEEL, pair_sizes, size_of
from graphic_tmm.drawn import Drawn
from graphic_tmm.readers.columns import Column, listed
from graphic_tmm.readers.measured import Tabled, measured_columns

SLIDING = "sliding-table"
"""The plan of the table of specific sliding; the diagram is another."""
_BARE = str.maketrans("", "", "_{}")
"""What letters lose where they are typed: N_{1} is N1."""


def gear_columns(drawn: Drawn) -> tuple[Column, ...]:
    """Return what was measured, the dimensions of the wheels and of the pair, the sliding at named places."""
    return (*measured_columns(drawn), *_dimensions(drawn), *_sliding(drawn))


def _dimensions(drawn: Drawn) -> Iterator[Column]:
    made, reading, laid = GEARS_PLAN.on(drawn), drawn.reading, BESIDE.on(drawn).drawn

    def column(symbol: str, key: str, heads: tuple[str, ...], *marks: Mark) -> Column:
        figures = [reading.figure(mark)[:, 0] for mark in marks]
        lengths = [reading.figure(laid[mark])[:, 0] for mark in marks if mark in laid]
        return listed(VIEW, key, symbol, _unit(marks[0]), figures, heads, lengths)

    for symbol, key in WHEEL:
        marks = (size_of(wheel, key) for wheel in made.sizes.wheels)
        yield column(symbol, key, ("1", "2"), *marks)
    arcs = (one.real for one in made.contact.wheels)
    yield column("cd", "arc_of_engagement_drawn", ("1", "2"), *arcs)
    for symbol, key, mark in pair_sizes(drawn):
        # a word of the catalogue, as results are called
        yield column(key if "/" in symbol else symbol, key, (), mark)


def _sliding(drawn: Drawn) -> Iterator[Column]:
    places = stations(drawn)
    heads, x = [place.name.translate(_BARE) for place in places], [place.x for place in places]
    mu = drawn.scales["gear"].value
    yield listed(SLIDING, "x", "x", "m", [mu * one for one in x], heads, x)
    for k in (0, 1):
        figures = [place.sliding[k] for place in places]
        yield listed(SLIDING, f"theta{k + 1}", f"ϑ_{{{k + 1}}}", "", figures, heads)


def _unit(mark: Mark) -> str:
    return "°" if mark.kind is Angle else mark.unit


TABLE = Tabled(columns=gear_columns, results=gear_results)
