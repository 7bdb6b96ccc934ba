"""What a task gives of an engine's cylinders, and what it asks for."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.cylinders.task import ASKED, CYLINDERS, IN_LINE, OPPOSED, VEE
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.task_sheet import (
    SIZE,
    Given,
    Listed,
    TaskSheet,
    given_figure,
    given_speed,
)
from graphic_tmm.scene.records import Scene


def given(scene: Scene) -> Iterator[Given]:
    """Yield what a scene gives of its cylinders."""
    order = ASKED.of(scene)
    if order is None:
        return
    yield Given("m", order.mass, "kg")
    yield Given("r", order.crank, SIZE)
    yield Given("l", order.rod, SIZE)
    yield given_speed("1", order.speed)
    if order.spacing:
        yield Given("a", order.spacing, SIZE)
    if order.layout == VEE:
        yield Given("γ", order.angle, "°")
    if order.banked and order.offset:
        yield Given("b", order.offset, SIZE)


def stated(scene: Scene, language: str) -> Iterator[str]:
    """Tell how the cylinders stand, and in which order they fire where that is given."""
    order = ASKED.of(scene)
    if order is None:
        return
    _ = speaking(language)
    yield _(_APART if order.apart else _STAND[order.layout], n=order.count)
    if order.firing:
        row = "–".join(map(str, order.firing))
        yield _("They fire evenly in the order {row}.", row=row)


def listed(scene: Scene, language: str) -> Iterator[Listed]:
    """Yield the angles of the cranks, where these are given."""
    order = ASKED.of(scene)
    if order is None or order.firing:
        return
    _ = speaking(language)
    heads = (_("No.", context="heading"), *(str(k) for k in range(1, order.count + 1)))
    row = ("θ, °", *(given_figure(one.crank % 360.0, language) for one in order.each))
    yield Listed("cranks", _(_CRANKS), heads, (row,))


def asks(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the polygons and for what remains."""
    order = ASKED.of(scene)
    if order is None:
        return
    _ = speaking(language)
    yield _(_BY_BANKS if order.banked else _POLYGONS)
    yield _(_REST)


_STAND = {
    IN_LINE: said("Cylinders of the engine in line: {n}."),
    VEE: said("Cylinders of the V engine, two rods on each pin, the left bank first: {n}."),
    OPPOSED: said("Opposed cylinders of the engine, the left bank first: {n}."),
}
_APART = said("Cylinders of the V engine, a crank for each, the left bank first: {n}.")
_CRANKS = said("Angles of the cranks from the engine's axis")
_POLYGONS = said("Draw the polygons of forces and moments of the first and the second order.")
_BY_BANKS = said(
    "Draw the polygons of forces and moments of the first and the second order, of direct and reverse vectors."
)
_REST = said("Find what remains of them, and at which turn of the shaft it is greatest.")

TASK_SHEET = TaskSheet(given=given, stated=stated, listed=listed, wanted={CYLINDERS: asks})
