"""What a scene gives of its flywheel: δ or J, the rim's diameters."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.flywheel.task import ASKED, FlywheelTask
from graphic_tmm.chapters.indicator.given import given_of as given_of_cylinder
from graphic_tmm.readers.task_sheet import SIZE, Given
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
