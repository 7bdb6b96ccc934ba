"""Tables on the sheet: links, pairs and formula of structure; segments and quantities by positions."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from graphic_tmm.language.numbers import fixed
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.paper.blocks import breakable, fewest
from graphic_tmm.paper.drawing import Drawing, Within
from graphic_tmm.paper.formats import HEIGHTS, Heights
from graphic_tmm.paper.lettering.letters import (
    escape,
)
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.packing import in_pieces
from graphic_tmm.paper.ruled import ruled_table
from graphic_tmm.readers.columns import (
    Column,
    known_at,
)
from graphic_tmm.readers.rounding import rounded_figures
from graphic_tmm.scene.captions import captions, moving_or_not

SIZE = 3.5
"""Sizes of lettering, mm (ГОСТ 2.304)."""


def result_table(
    plan: str,
    columns: Sequence[Column],
    names: Sequence[str],
    language: str,
    *,
    upright: bool = False,
    at_rest: bool = False,
    heights: Heights = HEIGHTS["A4"],
) -> Drawing:
    """Return the table of a plan: rows of segments (mm and quantity) and rates, columns of positions.

    ``upright``: a row for each position instead. A table that no sheet holds whole is broken into blocks, or
    turned the other way, whichever gives fewer. ``heights``: those of its place; ``at_rest``: the mechanism
    stands.
    """
    words = captions(language)
    shown = known_at(columns)
    rows = []
    for column, figures in zip(columns, rounded_figures(columns), strict=True):
        letter = words.get(column.letter) or markup(symbol(column.letter, language))
        if column.drawn:
            cells = [fixed(figures.mm[k], figures.mm_places, language) for k in shown]
            rows.append([letter, unit("mm", language), *cells])
            letter = symbol(column.quantity, language) if column.quantity else letter
        cells = [fixed(figures.value[k], figures.places, language) for k in shown]
        rows.append([letter, unit(column.unit, language), *cells])
    heads = [words["value"], words["unit"], *(escape(names[k]) for k in shown)]
    name, again = f"table-{plan}", words["continued"]
    title = moving_or_not(words, f"table {plan}", at_rest)
    ruled = partial(
        breakable, name, title, again=again, size=heights.number, title_size=heights.title
    )

    def lying() -> Drawing:
        align = ["left", "left", *["centre"] * len(shown)]
        return ruled(heads, rows, lead=2, align=align)

    def standing() -> Drawing:
        first, *others = (list(column) for column in zip(heads, *rows, strict=True))
        align = ["centre"] * len(first)
        return ruled(first, others, lead=1, over=1, align=align)

    usual, other = (standing, lying) if upright else (lying, standing)
    made = usual()

    def apart(within: Within) -> list[Drawing]:
        return fewest(within, in_pieces(made, within), in_pieces(other(), within))

    return made._replace(apart=apart)


def results(
    name: str, title: str, rows: Sequence[Sequence[str]], language: str, heights: Heights
) -> Drawing:
    """Return a table of results, ``name`` in the drawing: each row a quantity, its figure and its unit."""
    words = captions(language)
    return ruled_table(
        name,
        title,
        [words["value"], words["results"], words["unit"]],
        rows,
        size=heights.number,
        title_size=heights.title,
        align=["left", "centre", "left"],
    )
