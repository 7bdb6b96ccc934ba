"""What a task gives of an engine's crank mechanism, and what it asks, a sentence each."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.engine.formulas import KGF
from graphic_tmm.chapters.engine.task import ASKED, TRANSFER_PLACE
from graphic_tmm.chapters.indicator import given as gas
from graphic_tmm.chapters.indicator.given import given_of
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.task_sheet import Acting, Given, Listed, Posed, TaskSheet
from graphic_tmm.scene.records import Scene


def given(scene: Scene) -> Iterator[Given]:
    """Yield what a scene gives; the mass in kgf·s²/m where forces are counted in kgf."""
    order = ASKED.of(scene)
    if order is None:
        return
    yield from given_of(order.indicator)
    if order.share is not None:
        yield Given("k", order.share)
    if order.mass is not None:
        kgf = order.unit == "kgf"
        yield Given("m", order.mass / KGF if kgf else order.mass, "kgf·s²/m" if kgf else "kg")


def plan(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the indicator diagram and the forces in every position."""
    yield speaking(language)(_PLAN)


def transfer(scene: Scene, language: str) -> Iterator[str]:
    """Ask for how forces are passed on."""
    yield speaking(language)(_TRANSFER)


def diagrams(scene: Scene, language: str) -> Iterator[str]:
    """Ask for their diagrams."""
    yield speaking(language)(_DIAGRAMS)


_PLAN = said(
    "The indicator diagram is drawn; the forces of the gas and of inertia on the piston are "
    "resolved into the pressure on the guide N, the force along the rod Q, the tangential force T "
    "and the radial force K in every position."
)
_TRANSFER = said("The transfer of forces in the crank mechanism is shown in one position.")
_DIAGRAMS = said(
    "Diagrams of the forces and of the turning moment over a turn of the crank are drawn."
)


def listed(scene: Scene, language: str) -> Iterator[Listed]:
    """Yield the pressures in the cylinder."""
    order = ASKED.of(scene)
    if order is not None:
        yield from gas.listed(order.indicator, scene, language)


def acting(scene: Scene, posed: Posed) -> Iterator[Acting]:
    """Yield the force of the gas."""
    order = ASKED.of(scene)
    if order is not None:
        yield from gas.acting(order.indicator, scene, posed)


TASK_SHEET = TaskSheet(
    given=given,
    listed=listed,
    acting=acting,
    wanted={"engine": plan, TRANSFER_PLACE: transfer, "engine diagrams": diagrams},
)
