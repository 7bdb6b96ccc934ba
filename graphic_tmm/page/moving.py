"""Figures that move with the crank, as chapters draw them in one position or another."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import ClassVar

from graphic_tmm.board.record import Mark
from graphic_tmm.drawn import Drawn
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.readers.columns import Column
from graphic_tmm.scene.chapter import Answer


@dataclass(frozen=True)
class Moving:
    """A figure that moves with the crank.

    ``name``: of its view in the log; ``title``, ``caption``: what people do (mark-up), its scale factors.
    ``at``: a position (index) -> its ink, its letters still wanted; empty where it cannot be drawn.
    ``on_sheet``: what the view of a position is called that shows the same on a sheet, by its number.
    ``still``: what stands about it and does not move. ``columns``: what is told of it along the positions.
    ``crank``: of the mechanism itself the pivot and the pin of what is turned.
    """

    name: str
    title: str
    caption: str
    at: Callable[[int], Drawing]
    on_sheet: Callable[[str], str]
    still: Callable[[], Drawing] | None = None
    columns: Callable[[], Iterable[Column]] = lambda: ()
    crank: tuple[Mark, Mark] | None = None


@dataclass(frozen=True)
class MovingFigures(Answer):
    """The ``figures`` that a chapter shows of one position, whichever it is."""

    stands: ClassVar[str] = "turning.FIGURES"
    figures: Callable[[Drawn], Iterable[Moving]] = lambda drawn: ()
