"""What a chapter tells whoever reads figures off its plans."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import ClassVar

from graphic_tmm.board.record import Mark
from graphic_tmm.drawn import Drawn
from graphic_tmm.paper.drawing import Drawing, Stroke
from graphic_tmm.project import Project
from graphic_tmm.readers.columns import Column
from graphic_tmm.scene.chapter import Answer


def _no_plan(
    drawn: Drawn, plan: str, place: int, name: str, title: str, upon: Sequence[Stroke]
) -> Drawing:
    raise KeyError(plan)


@dataclass(frozen=True)
class Readings(Answer):
    """What a chapter knows of readings.

    ``pointed``: the plans of which readings may give points; ``plan_at``: such a plan in one position, lettered
    clear of what is drawn upon it. ``named_marks``: marks by plan and the name that machines read.
    ``vectors``: the columns of the vectors that are measured on its plans.
    """

    stands: ClassVar[str] = "views.READINGS"
    pointed: tuple[str, ...] = ()
    plan_at: Callable[[Drawn, str, int, str, str, Sequence[Stroke]], Drawing] = _no_plan
    named_marks: Callable[[Project], Mapping[tuple[str, str], Mark]] = lambda project: {}
    vectors: Callable[[Drawn], Iterable[Column]] = lambda drawn: ()
