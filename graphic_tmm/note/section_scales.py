"""The scale factors: why they are chosen as they are, and a table of how each was found."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from graphic_tmm.board import scales as choice
from graphic_tmm.board.execute import execute
from graphic_tmm.board.record import Step
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.fitting.choice import SCALES, choices
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import plain, symbol
from graphic_tmm.note.bricks import heading, referred
from graphic_tmm.note.document import (
    OTHERS,
    Block,
    Formula,
    Number,
    Once,
    Run,
    Runs,
    Source,
    Symbol,
    Table,
    Text,
    text,
)
from graphic_tmm.note.steps import NumberSource, calculated, reason_runs
from graphic_tmm.readers.protocol import title_of
from graphic_tmm.scene.captions import captions, view_name

PLAN, FOUND, TAKEN = said("Drawing"), said("Calculation"), said("Scale factor")
GIVEN = said("Taken from the task")
OWN = frozenset({op.name for op in (choice.accepted, choice.next_standard, choice.next_ratio)})
OWN |= {op.name for op in (choice.scale_of, choice.of_turns, choice.times_larger)}
OWN |= {choice.next_standard_length.name, choice.nearest_standard.name}
OWN |= {choice.scale_by_turning.name}
"""Operations of the choice alone: their reasons are told here, others where their formulas are used."""


def scales(made: DrawnScene, language: str) -> Iterator[Block]:
    """Yield the section of the scale factors; none where nothing is drawn to scale."""
    rows = [
        row
        for drawn in made.boards
        for row in _rows(drawn, _calculations(drawn, language), language)
    ]
    if not rows:
        return
    _, words = speaking(language), captions(language)
    yield heading(words[SCALES], 1)
    heads = text(_(PLAN)), text(_(FOUND)), text(_(TAKEN))
    caption = text(words[SCALES])
    table = Table("table-scales", caption, heads, tuple(rows), "lll", long=True)
    yield referred((), language, tables=[table])
    yield table


def _calculations(drawn: Drawn, language: str) -> dict[str, list[Run]]:
    """Return how the scale factors of a board were chosen, by view: each formula behind its reason."""
    chosen = choices(drawn)
    log, given = chosen.construction, chosen.given
    found: dict[str, list[Run]] = {}
    if not log.steps:
        return found
    told = NumberSource(_aside(drawn), log, execute(log, given), SCALES, 0, language)
    view = ""
    for step in log.steps:
        view = _view(step) or view
        some = found.setdefault(view, [])
        if step.reason and (step.op.name in OWN or step.why):
            some += [Text(" "), Once(step.reason, reason_runs(told, step))]
        formula = calculated(told, step)
        if formula is not None and (step.op.formula or step.op is choice.next_ratio):
            some += [Text(" "), formula._replace(flat=True), Text(".")]
        elif step.op is choice.accepted and not step.why:
            some += [Text(" "), Text(f"{speaking(language)(GIVEN)}.")]
    return found


def _aside(drawn: Drawn) -> str:
    """Return what the choice of a board's scale factors is called as a source of numbers."""
    return f"{SCALES} {drawn.board}"


def _view(step: Step) -> str:
    """Return the view whose scale factor a step begins with, "" if it goes on with one."""
    return next((note for note in reversed(step.note.split("\n")) if note), "")


def _rows(drawn: Drawn, found: dict[str, list[Run]], language: str) -> Iterator[tuple[Runs, ...]]:
    """Yield a row a view: those drawn to scale, those beside them, then what else was calculated to choose."""
    for view, scale in drawn.scales.items():
        source = Source("scale", drawn.board, view, OTHERS)
        told = Number(number(scale.value, language), scale.unit, source, scale.value)
        name = title_of(drawn.project, view, language)
        factors: list[Run] = [Formula((Symbol(symbol(scale.symbol, language)), told))]
        for place in dict(scale.own):
            own, mu = Source("scale", drawn.board, view, place), scale.at(place).value
            letter = symbol(f"{scale.symbol}^{{({drawn.names[place]})}}", language)
            figure = Number(number(mu, language), scale.unit, own, mu)
            factors += [Text("; "), Formula((Symbol(letter), figure))]
        yield text(name), _runs(found.get(view, ())), tuple(factors)
    chosen = choices(drawn)
    for view in dict.fromkeys(view for view, _letter in chosen.beside):
        taken: list[Run] = []
        for letter in (letter for other, letter in chosen.beside if other == view):
            slot = str(chosen.beside[view, letter].slot)
            scale, source = chosen.scale(view, letter), Source("mark", _aside(drawn), slot)
            told = Number(number(scale.value, language), scale.unit, source, scale.value)
            taken += [Text("; ")] if taken else []
            taken.append(Formula((Symbol(symbol(letter, language)), told)))
        formulas = () if view in drawn.scales else found.get(view, ())
        yield text(view_name(view, language)), _runs(formulas), tuple(taken)
    beside = {view for view, _letter in chosen.beside}
    for view, formulas in found.items():
        if formulas and view not in drawn.scales and view not in beside:
            yield text(plain(view_name(view, language))), _runs(formulas), ()


def _runs(calculations: Sequence[Run]) -> Runs:
    return tuple(calculations[1:]) or text("—")
