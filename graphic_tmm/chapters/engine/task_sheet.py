"""What a task gives of an engine's crank mechanism."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.engine.formulas import KGF
from graphic_tmm.chapters.engine.task import ASKED
from graphic_tmm.chapters.indicator.given import GasOf, given_of
from graphic_tmm.readers.task_sheet import Given, TaskSheet
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


_GAS = GasOf(ASKED)
TASK_SHEET = TaskSheet(
    given=given,
    listed=_GAS.listed,
    acting=_GAS.acting,
)
