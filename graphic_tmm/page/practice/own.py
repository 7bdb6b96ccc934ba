"""What the page packs for a drawing of one's own: frames of sheets, papers, how their lines are sought."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.page.practice.seeking import seeking, too_much
from graphic_tmm.paper.drawing import Sheet
from graphic_tmm.paper.formats import FORMATS
from graphic_tmm.paper.sheet_frame import drawing_area

_WAYS = {"portrait": said("upright"), "landscape": said("lying")}
"""How a format of its own name does not lie."""


def own(sheets: Sequence[Sheet], language: str) -> dict[str, Any]:
    """Return the data of a drawing of one's own (OwnPack of web/own/corners.js)."""
    return {
        "frames": [_frame(sheet, language, number == 0) for number, sheet in enumerate(sheets)],
        "papers": [
            [_called(name, language), paper.width, paper.height] for name, paper in FORMATS.items()
        ],
        "seeking": seeking(),
    } | too_much()


def _frame(sheet: Sheet, language: str, first: bool) -> list[float]:
    """Return the frame of a sheet, mm from its lower left corner: left, bottom, right, top."""
    return [round(float(side), 6) for side in drawing_area(sheet.format, language, first).inner]


def _called(name: str, language: str) -> str:
    """Return what a format is called: A4, A4 lying."""
    size, _, way = name.partition(" ")
    return f"{size} {speaking(language)(_WAYS[way])}" if way else size
