"""The section of forces by centres in a note: what the log tells, and whether the three ways agree."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.advantage.plan import Advantage
from graphic_tmm.chapters.advantage.table import OFF_LEVER, OFF_PLANS, stem
from graphic_tmm.language.said import said
from graphic_tmm.note.document import Runs
from graphic_tmm.note.page import COLUMNS, Page
from graphic_tmm.note.section_chapter import Noted

_BALANCE = said(
    "In position {position} what balances the drive by the instantaneous centres differs from the force plans "
    "by {apart} %, from the lever by {lever} %."
)
_TOOL = said(
    "In position {position} the unknown force by the instantaneous centres differs from that of the lever by "
    "{apart} %."
)


class AdvantagePage(Page[Advantage]):
    """Forces by centres, and how far they are off the other ways."""

    tables = (COLUMNS,)

    def concludes(self) -> Iterator[Runs]:
        """Yield for each position how far the balance by centres is off the other ways."""
        made = self.recorded
        if made.balance is None:
            return
        names = [f"{stem(made)}_{end}" for end in (OFF_PLANS, OFF_LEVER)[: len(made.off)]]
        for k in made.places:
            values = [self.columns[name].first_figures[1][k] for name in names]
            if k in self.drawn.undrawn or None in values:
                continue
            apart, *lever = (self.quantity(name, k, 2)._replace(unit="") for name in names)
            put = {"apart": apart, **({"lever": lever[0]} if lever else {})}
            yield self.sentence(_BALANCE if lever else _TOOL, put, position=self.drawn.names[k])


NOTE = Noted(AdvantagePage)
