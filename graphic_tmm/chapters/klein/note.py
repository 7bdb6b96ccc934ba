"""The section of the constructions in a note: what they take and how true they are, as the log tells it."""

from __future__ import annotations

from graphic_tmm.chapters.klein.plan import Klein
from graphic_tmm.language.said import said
from graphic_tmm.note.page import Page
from graphic_tmm.note.section_chapter import Noted

_KLEIN = said(
    "By Klein's construction a_B takes {klein_work_klein} elementary operations of geometrography in a position, "
    "all that leads to it counted; nine of ten readings by a student's hand are off by no more than "
    "{klein_error_klein} of the largest."
)
_RITTERHAUS = said(
    "Ritterhaus's construction takes {klein_work_ritterhaus} of them and is off by no more than "
    "{klein_error_ritterhaus}: it needs no compass."
)
_PLANS = said(
    "The plans of velocities and accelerations take {klein_work_accelerations}, and are off by no more than "
    "{klein_error_accelerations}."
)


class KleinPage(Page[Klein]):
    """What the log tells of the constructions; then what each way costs."""

    by_results = (_KLEIN, _RITTERHAUS, _PLANS)


NOTE = Noted(KleinPage)
