"""What is recorded of a cam, and why there may be no result."""

from __future__ import annotations

from graphic_tmm.chapters.cam.beside import record_beside
from graphic_tmm.chapters.cam.plan import record
from graphic_tmm.language.said import said
from graphic_tmm.project import Plan

PLAN = Plan(
    record=record,
    aside=record_beside,
    charts=lambda made: made.charts,
    result=lambda made: (made.least,),
    remedy=said(
        "no centre of the cam keeps the pressure angle within its limit; allow a larger one "
        "(pressure, or a smaller transmission), or a smaller stroke or longer phases"
    ),
)
