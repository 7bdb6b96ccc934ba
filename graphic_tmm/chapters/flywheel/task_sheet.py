"""What a task gives of a flywheel, and what it asks, a sentence each."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.flywheel.task import ASKED, FLYWHEEL, FlywheelTask
from graphic_tmm.chapters.indicator.given import GasOf
from graphic_tmm.chapters.indicator.given import given_of as given_of_cylinder
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.task_sheet import SIZE, Given, TaskSheet
from graphic_tmm.scene.records import Scene


def given(scene: Scene) -> Iterator[Given]:
    """Yield what a scene gives of its flywheel, the diameter in mm."""
    order = ASKED.of(scene)
    if order is None:
        return
    if order.indicator is not None:
        yield from given_of_cylinder(order.indicator)
    yield from given_of(order)


def given_of(order: FlywheelTask) -> Iterator[Given]:
    """Yield it of what is asked of a flywheel."""
    if order.delta is not None:
        yield Given("δ", order.delta)
    if order.J is not None:
        yield Given("J_F", order.J, "kg·m²")
    if order.rim is not None:
        yield Given("D_e", order.rim.outer, SIZE)
        if order.rim.inner is not None:
            yield Given("D_i", order.rim.inner, SIZE)


def asks(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the diagrams of a cycle, the flywheel, its rim."""
    order = ASKED.of(scene)
    if order is None:
        return
    _ = speaking(language)
    if order.indicator is not None:
        yield _(_INDICATOR)
    yield from of_order(order, language)
    if order.tangents is not None:
        yield _(_ENERGY_MASS)


def of_order(order: FlywheelTask, language: str) -> Iterator[str]:
    """Ask for what is found of any flywheel."""
    _ = speaking(language)
    yield _(_DRIVING if order.constant == "driving" else _RESISTING)
    yield _(_INERTIA if order.J is None else _IRREGULARITY)
    if order.rim is not None:
        yield _(_RIM)


_INDICATOR = said("The indicator diagram is drawn.")
_DRIVING = said(
    "Diagrams over the cycle are drawn: of the reduced moments, of their works by graphical "
    "integration, of the change of kinetic energy; the driving moment is taken as constant."
)
_RESISTING = said(
    "Diagrams over the cycle are drawn: of the reduced moments, of their works by graphical "
    "integration, of the change of kinetic energy; the resisting moment is taken as constant."
)
_INERTIA = said(
    "The moment of inertia of the flywheel is found that keeps the given coefficient of irregularity δ."
)
_IRREGULARITY = said(
    "The coefficient of irregularity δ is found that the flywheel of given moment of inertia keeps."
)
_ENERGY_MASS = said("The flywheel is checked by the energy–mass diagram.")
_RIM = said("The rim of the flywheel is dimensioned, its sketch is drawn.")


_GAS = GasOf(ASKED)
TASK_SHEET = TaskSheet(
    given=given,
    stated=_GAS.stated,
    listed=_GAS.listed,
    acting=_GAS.acting,
    wanted={FLYWHEEL: asks},
)
