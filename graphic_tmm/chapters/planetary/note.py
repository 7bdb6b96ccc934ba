"""What a note concludes of a planetary train: its ratio by the teeth and as drawn, its conditions."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.planetary.plan import Planetary
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
ONE = said("All conditions of the train hold: its wheels have a common axis, no tooth is undercut.")


class TrainPage(Page[Planetary]):
    """What is measured on a train stands where it is measured, in no table of its own."""

    tables = (RESULTS,)
    by_results = (RATIO,)

    def concludes(self) -> Iterator[Runs]:
        """Yield the ratio, and that the conditions hold: a train that breaks one is refused."""
        yield from super().concludes()
        yield self.sentence(SEVERAL if "planetary_most" in self.results else ONE)


NOTE = Noted(TrainPage)
