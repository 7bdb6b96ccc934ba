"""What draws the views of a place, as chapters say it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import ClassVar

from graphic_tmm.drawn import Drawn
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.scene.chapter import Answer, places
from graphic_tmm.scene.records import Scene

Draw = Callable[[Drawn, bool], list[Drawing]]
"""A drawn board, lettered? -> views."""


@dataclass(frozen=True)
class Pieces:
    """What draws the views of a place piece by piece, in order."""

    each: tuple[Draw, ...]

    def __call__(self, drawn: Drawn, lettered: bool) -> list[Drawing]:
        """Return the views of all pieces."""
        return [view for draw in self.each for view in draw(drawn, lettered)]


def _nothing(drawn: Drawn, lettered: bool) -> list[Drawing]:
    return []


@dataclass(frozen=True)
class Views(Answer):
    """What draws the views of a chapter's places, by place: ``draw``; ``plain`` where no board is needed."""

    stands: ClassVar[str] = "views.SHOWN"
    draw: Mapping[str, Draw] = field(default_factory=dict)
    plain: Mapping[str, Callable[[Scene], list[Drawing]]] = field(default_factory=dict)


def drawing_of(place: str) -> Draw:
    """Return what draws the views of a place on a board."""
    return Views.of(places()[place][0]).draw.get(place, _nothing)
