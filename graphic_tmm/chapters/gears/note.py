"""What a note concludes of a gear pair: its contact ratio by the formula and as drawn, its checks."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.gears.contact import verdicts
from graphic_tmm.chapters.gears.plan import Gear
from graphic_tmm.language.said import said
from graphic_tmm.note.document import Runs
from graphic_tmm.note.page import Page
from graphic_tmm.note.section_chapter import Noted

MESHING = "gear"
"""The view of the meshing: its teeth are drawn by the same steps many times."""
RATIO = said(
    "The contact ratio is {contact_ratio} by the formula and {contact_ratio_drawn} as drawn, "
    "{contact_ratio_difference} apart."
)
SLIDES = said(
    "Wheel 2 turns with {n2}; the flanks slide with {v_sa} where a pair begins to touch and with {v_sb} "
    "where it ceases, {v_sa_ratio} and {v_sb_ratio} of the velocity {v_rolling} of the rolling circles."
)
SLIDES_ON_RACK = said(
    "The rack runs with {v_rolling}, {travel} in a turn of the wheel; the flanks slide with {v_sa} where a "
    "pair begins to touch and with {v_sb} where it ceases."
)
SKEW = said(
    "Over the width the teeth overlap by {overlap_ratio}: in all {total_ratio} pairs touch."
)
ALL = said(
    "All conditions of the meshing hold: no tooth is pointed ({s_a1} and {s_a2} at the tips) or undercut, the "
    "flanks do not interfere, the clearance is kept, and the contact ratio {contact_ratio} is above 1."
)


class GearPage(Page[Gear]):
    """Dimensions in full; of the meshing what is calculated and read."""

    calculated = (MESHING,)
    tables = ()
    by_results = (RATIO, SKEW, SLIDES, SLIDES_ON_RACK)

    def concludes(self) -> Iterator[Runs]:
        """Yield the contact ratio; one sentence where every check holds: those that fail are warnings."""
        yield from super().concludes()
        if all(one.holds for one in verdicts(self.recorded.checks, self.drawn.reading)):
            yield self.sentence(ALL)


NOTE = Noted(GearPage)
