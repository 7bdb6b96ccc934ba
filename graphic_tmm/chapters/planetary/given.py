"""What a scene gives of its planetary train: ratio, speed, module, teeth, satellites, the pair behind it."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.planetary.task import ASKED, SCHEMES
from graphic_tmm.readers.given import given_speed
from graphic_tmm.readers.task_sheet import SIZE, Given
from graphic_tmm.scene.records import Scene


def given(scene: Scene) -> Iterator[Given]:
    """Yield what a scene gives of its planetary train, modules in mm."""
    order = ASKED.of(scene)
    if order is None:
        return
    yield given_speed(order.driving, order.speed)
    if order.ratio is not None:
        yield Given("U_{1H}" if order.driving == "1" else "U_{H1}", order.ratio)
        yield Given("ΔU_{max}", 100.0 * order.tolerance, "%")
    if order.module_2 is None:
        yield Given("m", order.module, SIZE)
    else:
        yield Given("m_{1-2}", order.module, SIZE)
        yield Given("m_{3-4}", order.module_2, SIZE)
    for number, teeth in enumerate(order.teeth, 1):
        if teeth is not None:
            yield Given(f"z_{number}", teeth)
    for number, teeth in enumerate(order.behind, len(SCHEMES[order.scheme].wheels) + 1):
        yield Given(f"z_{number}", teeth)
    yield Given("k", ", ".join(map(str, order.satellites)))
