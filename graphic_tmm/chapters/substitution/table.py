"""The columns of accelerations by substitution: of pins, each in the position that is drawn."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.chapters.kinematics.task import ACCELERATIONS
from graphic_tmm.chapters.substitution import words as why
from graphic_tmm.chapters.substitution.record import SUBSTITUTION_PLAN
from graphic_tmm.chapters.substitution.task import SUBSTITUTION
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.project import Project
from graphic_tmm.readers.columns import Column, Tabled, empty, row_of
from graphic_tmm.readers.protocol import Protocols
from graphic_tmm.scene.chapter import Holder


def columns(drawn: Drawn) -> Iterator[Column]:
    """Yield the accelerations of pins that are read."""
    made, count = SUBSTITUTION_PLAN.of(drawn), len(drawn.names)
    reading = drawn.of(SUBSTITUTION)
    if made is None or reading is None:
        return
    mu = drawn.scales[ACCELERATIONS].value
    for pin in made.pins:
        value = np.abs(mu * reading.figure(pin.substituted))
        yield Column(
            SUBSTITUTION, f"a_{pin.letter}", f"a_{pin.letter}", "m/s²", empty(count),
            row_of(value, [made.at], count),
        )  # fmt: skip


TABLE = Tabled(columns=columns)


def _views(project: Project) -> dict[str, tuple[str, ...]]:
    made = SUBSTITUTION_PLAN.of(project)
    return {} if made is None else {SUBSTITUTION: (why.HELD, SUBSTITUTION)}


def _title(held: Holder, view: str, language: str) -> str:
    """Return what a view of the log is called."""
    titles = {why.HELD: why.HELD_VIEW, SUBSTITUTION: why.CAPTIONS[SUBSTITUTION]}
    known = SUBSTITUTION_PLAN.of(held) is not None and view in titles
    return speaking(language)(titles[view]) if known else ""


PROTOCOL = Protocols(views=_views, titles=_title)
