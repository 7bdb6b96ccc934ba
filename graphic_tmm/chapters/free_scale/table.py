"""The columns of a plan to a free scale: velocities, what they differ by from those by the special point."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.chapters.free_scale import words as why
from graphic_tmm.chapters.free_scale.record import FREE_SCALE_PLAN, FreeScale
from graphic_tmm.chapters.free_scale.task import FREE_SCALE
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.project import Project
from graphic_tmm.readers.columns import Column, Tabled, empty, row_of
from graphic_tmm.readers.protocol import Protocols
from graphic_tmm.scene.chapter import Holder


def columns(drawn: Drawn) -> Iterator[Column]:
    """Yield the velocities that are read, each with what it differs by."""
    made, count = FREE_SCALE_PLAN.of(drawn), len(drawn.names)
    reading = drawn.of(FREE_SCALE)
    if made is None or reading is None:
        return
    for one in made.results:
        value = np.abs(reading.figure(one.value))
        yield Column(
            FREE_SCALE, f"v_{one.point}", f"v_{one.point}", "m/s", empty(count),
            row_of(value, [made.at], count),
        )  # fmt: skip


TABLE = Tabled(columns=columns)


def _views(project: Project) -> dict[str, tuple[str, ...]]:
    made: FreeScale | None = FREE_SCALE_PLAN.of(project)
    return {} if made is None else {FREE_SCALE: (why.PLATE, FREE_SCALE)}


def _title(held: Holder, view: str, language: str) -> str:
    """Return what a view of the log is called."""
    made, speech = FREE_SCALE_PLAN.of(held), speaking(language)
    if made is not None and view == FREE_SCALE:
        return speech(why.CAPTIONS[FREE_SCALE])
    return speech(why.LINE) if view == why.PLATE else ""


PROTOCOL = Protocols(views=_views, titles=_title)
