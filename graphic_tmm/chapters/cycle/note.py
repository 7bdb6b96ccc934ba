"""The section of a cycle of moments in a note: what is given, its graphs, the flywheel; what follows."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.cycle.plan import Cycle
from graphic_tmm.chapters.cycle.record import BESIDE
from graphic_tmm.chapters.cycle.views import cycle_views
from graphic_tmm.chapters.flywheel.note import SteadyPage
from graphic_tmm.chapters.flywheel.plan import Flywheel
from graphic_tmm.chapters.flywheel.record import Aside
from graphic_tmm.language.said import said
from graphic_tmm.note.document import Block
from graphic_tmm.note.figures import readable
from graphic_tmm.note.section_chapter import Noted
from graphic_tmm.paper.drawing import Drawing

GIVEN = said(
    "Of the machine the moments on its shaft are known over a cycle of turns, {turns} in number; they are "
    "told at {count} positions. They add up, and the moment on the other side is constant over the cycle."
)


class CyclePage(SteadyPage[Cycle]):
    """A cycle of moments, and the flywheel that keeps it steady."""

    @property
    def flywheel(self) -> Flywheel:
        """The flywheel as recorded."""
        return self.recorded.flywheel

    @property
    def side_calculation(self) -> Aside:
        """What was calculated beside it."""
        return BESIDE.on(self.drawn)

    def views(self) -> list[Drawing]:
        """Return graphs and the rim."""
        return readable(self.drawn, lambda held: cycle_views(held, True))

    def blocks(self) -> Iterator[Block]:
        """Yield what is given, then what is told of any flywheel."""
        order = self.recorded.order
        yield self.says(GIVEN, turns=order.turns, count=order.positions)
        yield from super().blocks()


NOTE = Noted(CyclePage)
