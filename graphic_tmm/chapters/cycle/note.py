"""The section of a cycle of moments in a note: what is given, its graphs, the flywheel; what follows."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.cycle.plan import CYCLE_PLAN
from graphic_tmm.chapters.cycle.record import BESIDE
from graphic_tmm.chapters.cycle.table import cycle_columns, cycle_results
from graphic_tmm.chapters.cycle.task import CYCLE
from graphic_tmm.chapters.cycle.views import cycle_views
from graphic_tmm.chapters.flywheel.note import FlywheelPage, concluded
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.said import said
from graphic_tmm.note.document import Block, Runs, Text
from graphic_tmm.note.figures import in_hand
from graphic_tmm.note.section_chapter import Noted

GIVEN = said(
    "Of the machine the moments on its shaft are known over a cycle of turns, {turns} in number; they are "
    "told at {count} positions. They add up, and the moment on the other side is constant over the cycle."
)


def note(drawn: Drawn, language: str) -> Iterator[Block]:
    """Yield the section of a cycle."""
    made = CYCLE_PLAN.of(drawn)
    if made is None:
        return
    views = cycle_views(in_hand(drawn), True)
    page = FlywheelPage(drawn, language, made.flywheel, BESIDE.on(drawn), views)
    turns, count = Text(str(made.order.turns)), Text(str(made.order.positions))
    yield page.says(GIVEN, turns=turns, count=count)
    yield from page.blocks(list(cycle_columns(drawn)), CYCLE)


def concludes(drawn: Drawn, language: str) -> Iterator[Runs]:
    """Yield what the flywheel has to be, and what the machine takes."""
    made = CYCLE_PLAN.on(drawn)
    yield from concluded(drawn, cycle_results(drawn), made.flywheel.order, language, "cycle")


NOTE = Noted(section=note, concludes=concludes)
