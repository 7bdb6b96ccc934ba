"""What is asked of a synthesis: that the construction of the task is drawn, how large."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from graphic_tmm.language.said import said
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Flaw, Section, key
from graphic_tmm.scene.tasks import SectionKey

CHAPTER_NAME, SYNTHESIS = "linkage_synthesis", "synthesis"
"""What the chapter is called; its section, its place and its board."""


@dataclass(frozen=True)
class SynthesisTask:
    """The construction that finds the lengths of the task is drawn; ``mu_l``: m/mm, if the scene fixes it."""

    mu_l: float | None = key(
        v.MU_L, 'the scale of its lengths: m/mm, or "1:2"', "1:2", None, fixes="size"
    )


ASKED: SectionKey[SynthesisTask] = SectionKey(SYNTHESIS)


def _check(_: Any, parts: Any) -> Iterator[Flaw]:
    if "task" not in parts.doc:
        says = said('it draws how lengths are found: write [task] with kind = "slider-crank", too')
        yield Flaw((SYNTHESIS,), says)


SECTIONS = (
    Section(
        SYNTHESIS, SynthesisTask, "the synthesis of the task, drawn", alone=True, check=_check,
        begin='mu_l = "1:1"',
    ),
)  # fmt: skip
