"""What a note concludes of a planetary train: its ratio by the teeth and as drawn, its conditions."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.trains.plan import Planetary
from graphic_tmm.chapters.trains.tooth_verdicts import check
from graphic_tmm.language.said import said
from graphic_tmm.note.document import Runs
from graphic_tmm.note.page import RESULTS, Page
from graphic_tmm.note.section_chapter import Noted

RATIO = said(
    "The ratio of the train is {planetary_ratio} by its teeth and {planetary_ratio_drawn} as drawn, "
    "{planetary_difference} apart."
)
SEVERAL = said(
    "All conditions of the train hold: its wheels have a common axis, {planetary_satellites} satellites are "
    "fewer than touch (at most {planetary_most} have room) and can be put in, no tooth is undercut."
)
BEVEL = said("The satellites can be put in evenly.")
ONE = said("All conditions of the train hold: its wheels have a common axis, no tooth is undercut.")


BROKEN = said("The train moves as drawn, but it cannot be made as it is: {conditions}.")
FASTER = said(
    "The driven shaft turns at {planetary_omega} by Willis and {planetary_omega_drawn} as drawn, "
    "{planetary_omega_difference} apart."
)
EFFICIENCY = said(
    "Of the power that is put in the train hands on the share {planetary_efficiency}."
)

CIRCULATES = said(
    "In the members that wheels join the share {planetary_circulating} of the power put in goes round and "
    "round: it loads these wheels and drives nothing."
)


class TrainPage(Page[Planetary]):
    """What is measured on a train stands where it is measured, in no table of its own."""

    tables = (RESULTS,)
    by_results = (RATIO, FASTER, EFFICIENCY, CIRCULATES)

    def concludes(self) -> Iterator[Runs]:
        """Yield the ratio, and that the conditions hold, or which are broken."""
        yield from super().concludes()
        made = self.recorded
        broken = [one.text for one in check(made.order, made.train) if not one.holds]
        if broken:
            yield self.sentence(BROKEN, conditions="; ".join(map(self.speech, broken)))
        elif made.train.scheme.bevel:
            yield self.sentence(BEVEL)
        else:
            yield self.sentence(SEVERAL if "planetary_most" in self.results else ONE)


NOTE = Noted(TrainPage)
