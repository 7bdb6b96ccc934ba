"""What a note tells of the lever: loads at their images, couples converted, arms and moments, the result."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.board.operations.statics import on_lever
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.forces.lever import Carried, Lever
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.note.bricks import filled
from graphic_tmm.note.document import (
    Block,
    Display,
    Paragraph,
    Ref,
    Run,
    Runs,
    Symbol,
    Table,
    text,
)
from graphic_tmm.note.steps import Told, calculated

LEVER = said(
    "The velocity plan turned by 90° is taken for a rigid lever that can turn about its pole {pole}. All "
    "forces are applied at the images of their points, parallel to themselves, the balancing one too, at "
    "{pin}: the arm of each about the pole then shows the velocity along it, its moment shows its power. The "
    "powers add up to nothing, so the lever is in equilibrium."
)
COUPLES = said(
    "A couple is replaced by one of equal power: by its moment times the image of its link, divided by the "
    "link."
)
ARMS = said("The arms are measured; forces, arms and moments stand in {table}.")
MOMENTS = said("Forces on the lever, their arms and moments about the pole")
FORCE, POINT = said("Force"), said("Image")
APART = said("Against the balancing force found by the force plans:")


def applied(told: Told, lever: Lever) -> Iterator[Block]:
    """Yield how the loads come to stand on the lever: in words, couples converted, a table of moments."""
    speech = speaking(told.language)
    put: dict[str, Run] = {"pole": told.symbol(lever.pole), "pin": told.symbol(lever.pin)}
    yield Paragraph(filled(speech(LEVER), put))
    if lever.couples:
        yield Paragraph(text(speech(COUPLES)))
        yield from _formulas(told, *(one.value for one in lever.couples))
    rows = tuple(_row(told, one) for one in lever.forces)
    if rows:
        found = _table(told, rows)
        yield Paragraph(filled(speech(ARMS), {"table": Ref(found.id)}))
        yield found


def compared(told: Told, difference: Mark) -> Iterator[Block]:
    """Yield how far what balances the lever is from what the force plans gave."""
    yield Paragraph(text(speaking(told.language)(APART)))
    yield from _formulas(told, difference)


def _formulas(told: Told, *marks: Mark) -> Iterator[Block]:
    steps = (told.log.step(mark) for mark in marks)
    found = [calculated(told, step) for step in steps if step is not None]
    formulas = tuple(one for one in found if one is not None)
    if formulas:
        yield Display(formulas)


def _row(told: Told, one: Carried) -> tuple[Runs, ...]:
    """Return a row of the table: the force, its size, its image, its arm, its moment."""
    step = next(s for s in told.log.steps if s.op is on_lever and s.uses[0] == one.value)
    letter = Symbol(symbol(one.letter, told.language))
    figures = (told.number(mark) for mark in (step.uses[1], step.it))
    return (
        (letter,),
        (told.number(one.value),),
        (told.symbol(one.point),),
        *((figure,) for figure in figures),
    )


def _table(told: Told, rows: tuple[tuple[Runs, ...], ...]) -> Table:
    speech, language = speaking(told.language), told.language
    heads = (
        text(speech(FORCE)),
        text(unit("N", language)),
        text(speech(POINT)),
        (Symbol("h"), *text(f", {unit('mm', language)}")),
        (Symbol("M"), *text(f", {unit('N·mm', language)}")),
    )
    return Table("table-lever", text(speech(MOMENTS)), heads, rows, "lcccc")
