"""The scale factors: how each was chosen, and a table of what a millimetre of each plan stands for."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.board.execute import execute
from graphic_tmm.captions import captions, view_name
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.fitting.choice import SCALES, choices
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.note.bricks import heading
from graphic_tmm.note.document import Block, Number, Runs, Source, Symbol, Table, text
from graphic_tmm.note.protocol import Known, protocol_blocks
from graphic_tmm.note.steps import Told
from graphic_tmm.readers.titles import title_of

PLAN = said("Drawing")


def scales(made: DrawnScene, language: str) -> Iterator[Block]:
    """Yield the section of the scale factors; none where nothing is drawn to scale."""
    rows = [row for drawn in made.boards for row in _rows(drawn, language)]
    if not rows:
        return
    words = captions(language)
    yield heading(words[SCALES], 1)
    known: Known = set()
    for drawn in made.boards:
        yield from _chosen(drawn, language, known)
    heads = text(speaking(language)(PLAN)), text(words["letter"]), text(words["figure"])
    head = (*heads, text(words["unit"]))
    yield Table("table-scales", text(words[SCALES]), head, tuple(rows), "llcc")


def _chosen(drawn: Drawn, language: str, known: Known) -> Iterator[Block]:
    """Yield how the scale factors of a board were chosen."""
    found = choices(drawn)
    if found.construction.steps:
        reading = execute(found.construction, found.given)
        yield from protocol_blocks(
            Told(_aside(drawn), found.construction, reading, SCALES, 0, language), known=known
        )


def _aside(drawn: Drawn) -> str:
    """Return what the choice of a board's scale factors is called as a source of numbers."""
    return f"{SCALES} {drawn.board}"


def _rows(drawn: Drawn, language: str) -> Iterator[tuple[Runs, ...]]:
    for view, scale in drawn.scales.items():
        source = Source("scale", drawn.board, view)
        told = Number(number(scale.value, language), "", source, scale.value)
        name, of = title_of(drawn.project, view, language), text(unit(scale.unit, language))
        yield text(name), (Symbol(symbol(scale.symbol, language)),), (told,), of
    found = choices(drawn)
    for view, letter in found.beside:
        slot = str(found.beside[view, letter].slot)
        scale, source = found.scale(view, letter), Source("mark", _aside(drawn), slot)
        told = Number(number(scale.value, language), "", source, scale.value)
        name, of = view_name(view, language), text(unit(scale.unit, language))
        yield text(name), (Symbol(symbol(letter, language)),), (told,), of
