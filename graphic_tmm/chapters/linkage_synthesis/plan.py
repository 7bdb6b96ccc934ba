"""The synthesis of a task as it is drawn, kind by kind."""

from __future__ import annotations

from collections.abc import Callable

from graphic_tmm.chapters.linkage_synthesis import dead_centres, dwell, places
from graphic_tmm.chapters.linkage_synthesis.figure import SynthesisBoard, SynthesisFigure
from graphic_tmm.chapters.linkage_synthesis.task import ASKED, CHAPTER_NAME
from graphic_tmm.project import Bench
from graphic_tmm.scene.chapter import Recorded
from graphic_tmm.scene.length_task import Task

SYNTHESIS_PLAN: Recorded[SynthesisFigure] = Recorded(CHAPTER_NAME)

DRAWN: dict[str, Callable[[SynthesisBoard, Task], SynthesisFigure]] = {
    "rocker": dead_centres.draw_rocker,
    "slider-crank": dead_centres.draw_slider,
    "crank-rocker": dead_centres.draw_crank_rocker,
    "coupler": places.draw_coupler,
    "angles": places.draw_angles,
    "function": places.draw_function,
    "cylinder": dead_centres.draw_cylinder,
    "dwell": dwell.draw_dwell,
}
"""What draws each kind of task."""


def record(bench: Bench) -> SynthesisFigure | None:
    """Draw the synthesis that the scene asks for."""
    task = bench.scene.task
    if ASKED.of(bench.scene) is None or task is None:
        return None
    return DRAWN[task.kind](SynthesisBoard(bench.draft), task)
