"""What moves with the crank: any angles of a turn, and figures that a chapter draws at each of them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Reals

if TYPE_CHECKING:
    from graphic_tmm.paper.drawing import Drawing
    from graphic_tmm.readers.columns import Column

Between = Mapping[Mark, object]
"""Values of marks at the angles of a turn."""


@dataclass(frozen=True)
class Turn:
    """Angles of the crank at which the log of a row of positions is run once more.

    ``turned``: how far it has turned from position zero, degrees, (angle,), with the sign in which it is drawn,
    the zero position first; ``numbers``: where that is in the row, in intervals of it, which has ``count``.
    ``read``: the numbers of marks at these angles, of what is known already.
    """

    turned: Reals
    numbers: Reals
    count: int
    read: Callable[[Iterable[Mark]], Reading]


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
