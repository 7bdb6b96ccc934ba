"""The section of the constructions in a note: what they take and how true they are, as the log tells it."""

from __future__ import annotations

from graphic_tmm.chapters.klein.record import Klein
from graphic_tmm.language.said import said
from graphic_tmm.note.page import Page
from graphic_tmm.note.section_chapter import Noted

_KLEIN = said(
    "By Klein's construction the slider's acceleration takes {klein_work_klein} elementary operations of "
    "geometrography in a position, all that leads to it counted; drawn by a student's hand again and again it "
    "scatters by {klein_scatter_klein} of its largest."
)
_RITTERHAUS = said(
    "Ritterhaus's construction takes {klein_work_ritterhaus} of them, for it needs no compass, and scatters by "
    "{klein_scatter_ritterhaus}."
)
_PLANS = said(
    "The plans of velocities and accelerations take {klein_work_accelerations} and scatter by "
    "{klein_scatter_accelerations}."
)


class KleinPage(Page[Klein]):
    """What the log tells of the constructions; then what each way costs."""

    by_results = (_KLEIN, _RITTERHAUS, _PLANS)


NOTE = Noted(KleinPage)
