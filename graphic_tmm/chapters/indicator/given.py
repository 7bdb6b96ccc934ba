"""What a scene gives of a cylinder: its diameter, the rod's, the highest pressure, clearance, strokes."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.indicator.task import IndicatorTask
from graphic_tmm.readers.task_sheet import SIZE, Given


def given_of(order: IndicatorTask) -> Iterator[Given]:
    """Yield what is given of a cylinder, diameters in mm; its pressures stand in a table by positions."""
    yield Given("D", order.cover.bore, SIZE)
    sides = [side for side in (order.cover, order.shaft) if side is not None]
    if rod := max(side.rod for side in sides):
        yield Given("d", rod, SIZE)
    yield Given("p_{max}", order.highest, "Pa")
    if clearance := max(side.clearance for side in sides):
        yield Given("c", clearance)
    if order.strokes != 2:
        yield Given("strokes of the cycle", order.strokes)
