"""What a task asks of the forces of a crank mechanism, a sentence each."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.engine.given import given
from graphic_tmm.chapters.engine.names import TRANSFER_PLACE
from graphic_tmm.chapters.engine.task import ASKED
from graphic_tmm.chapters.indicator import asks as gas
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.task_sheet import Acting, Listed, Posed, TaskSheet
from graphic_tmm.scene.records import Scene


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
