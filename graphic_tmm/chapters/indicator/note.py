"""What notes tell of the gas in a cylinder: its indicator diagram, the force, the scale of the stroke.

Engine and flywheel tell the gas and what follows from it in the order of their book, not in that of the log.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TypeVar

from graphic_tmm.chapters.indicator.plan import INDICATOR_PLAN
from graphic_tmm.chapters.indicator.task import CALCULATED, VIEW
from graphic_tmm.chapters.indicator.views import indicator_views
from graphic_tmm.note.document import Block
from graphic_tmm.note.figures import picture, readable
from graphic_tmm.note.page import Page

T = TypeVar("T")


class GasPage(Page[T]):
    """A chapter that begins with the gas in a cylinder."""

    def gas(self) -> Iterator[Block]:
        """Yield the indicator diagram: its division, pressures, areas, the force; the scale of the stroke."""
        name = self.chapter.name
        views = readable(self.drawn, lambda held: indicator_views(held, True, name))
        charts = INDICATOR_PLAN.on(self.drawn).charts
        if len(charts) == 1:
            yield from self.view(VIEW, [picture(view, self.language) for view in views])
        else:
            for view, chart in zip(views, charts, strict=True):
                yield from self.view(chart.view, [picture(view, self.language)])
        steps = self.drawn.construction.steps
        marks = [step.it for step in steps if step.it.view == CALCULATED]
        yield from self.calculation(*marks)
