"""The scale factors: what of each plan a millimetre stands for."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.captions import captions
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.note.bricks import heading
from graphic_tmm.note.document import Block, Number, Runs, Source, Symbol, Table, text
from graphic_tmm.readers.titles import title_of

SCALES = said("Scale factors")
PLAN = said("Drawing")


def scales(made: DrawnScene, language: str) -> Iterator[Block]:
    """Yield the section of the scale factors; none where nothing is drawn to scale."""
    _, words = speaking(language), captions(language)
    rows: list[tuple[Runs, ...]] = []
    for drawn in made.boards:
        for view, scale in drawn.scales.items():
            source = Source("scale", drawn.board, view)
            told = Number(number(scale.value, language), "", source, scale.value)
            name = title_of(drawn.project, view, language)
            of = text(unit(scale.unit, language))
            rows.append((text(name), (Symbol(symbol(scale.symbol, language)),), (told,), of))
    if not rows:
        return
    yield heading(_(SCALES), 1)
    heads = text(_(PLAN)), text(words["letter"]), text(words["figure"]), text(words["unit"])
    yield Table("table-scales", text(_(SCALES)), heads, tuple(rows), "llcc")
