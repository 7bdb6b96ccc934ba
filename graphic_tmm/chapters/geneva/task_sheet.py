"""What a task gives of a Geneva wheel."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.geneva.task import ASKED, FREE, PIN
from graphic_tmm.readers.task_sheet import SIZE, Given, TaskSheet
from graphic_tmm.scene.records import Scene


def given(scene: Scene) -> Iterator[Given]:
    """Yield the slots, the pins where there are several, the sizes of pin and disc."""
    order = ASKED.of(scene)
    if order is None:
        return
    yield Given("z", order.slots)
    if order.pins > 1:
        yield Given("k", order.pins)
    yield Given("d_p/R", PIN) if order.pin is None else Given("d_p", order.pin, SIZE)
    yield Given("(R − R_l)/d_p", FREE) if order.lock is None else Given("R_l", order.lock, SIZE)


TASK_SHEET = TaskSheet(given=given)
