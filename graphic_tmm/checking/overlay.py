"""An overlay: each exact plan thin, the points that were read on it, deviations as arrows, enlarged."""

from __future__ import annotations

from collections.abc import Sequence

from graphic_tmm.checking.cells import points
from graphic_tmm.checking.records import WRONG, Judged, Report
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.errors import SheetError
from graphic_tmm.language.said import said
from graphic_tmm.paper.compose.sheets import pack
from graphic_tmm.paper.drawing import Drawing, Sheet, Stroke, line
from graphic_tmm.paper.formats import size_of
from graphic_tmm.paper.frame.frame import drawing_area, frame
from graphic_tmm.paper.lettering.letters import (
    escape,
)
from graphic_tmm.paper.packing import Room
from graphic_tmm.paper.symbols.kinematic import arrowhead
from graphic_tmm.paper.views import captioned
from graphic_tmm.readers.columns import Readings
from graphic_tmm.scene.captions import captions

FORMATS = ("A4", "A1")
CROSS = 1.2
"""Half of the cross at a point that was read, mm."""
SEEN = 0.5
"""A deviation shorter than this on the sheet has no arrow, mm."""


def overlay_sheet(made: DrawnScene, report: Report, enlarge: float) -> Sheet:
    """Return a sheet with the exact plans and what was read of them, the smallest that holds them.

    Raises
    ------
    SheetError
        If no points were read, or they fill more than a sheet.
    """
    exact = points(made)
    by_plan: dict[tuple[str, str], list[Judged]] = {}
    for one in report.readings:
        if one.taken.pointed:
            by_plan.setdefault((one.taken.plan, one.taken.position), []).append(one)
    if not by_plan:
        raise SheetError(
            said("--overlay: no points were read; give x and y of points in the CSV file")
        )
    words = captions(report.language)
    views = []
    for (plan, position), read in by_plan.items():
        title = f"{words.get(plan, plan)}, {words['position']} {escape(position)}"
        upon = [stroke for one in read for stroke in _read(one, exact[one.taken.key], enlarge)]
        views.append(captioned(plan_view(made, plan, position, upon, title), title))
    size, laid = _laid(views, report.language)
    edge = frame(
        size, language=report.language, first=True, number=1, count=1, fields={"name": report.title}
    )
    return Sheet("overlay", report.title, size, *size_of(size), (edge, *laid), report.language)


def _laid(views: Sequence[Drawing], language: str) -> tuple[str, tuple[Drawing, ...]]:
    """Return the smallest format that holds the views on one sheet, and where they stand there."""
    for size in FORMATS:
        area = drawing_area(size, language, True)
        room = Room(area.inner, area.occupied)
        try:
            laid = pack(views, (room, room), size)
        except SheetError:
            continue
        if len(laid) == 1:
            return size, tuple(laid[0])
    raise SheetError(
        said("--overlay: more plans were read than an A1 sheet holds; check fewer at once")
    )


def plan_view(
    made: DrawnScene, plan: str, position: str, upon: Sequence[Stroke], title: str
) -> Drawing:
    """Return the exact plan in one position, all of it thin, with what was read drawn upon it."""
    assert made.mechanism is not None
    drawn, name = made.mechanism, f"overlay-{plan}-{position}"
    (chapter,) = (one for one in drawn.project.chapters if plan in Readings.of(one).pointed)
    found = Readings.of(chapter).plan_at(
        drawn, plan, drawn.names.index(position), name, title, upon
    )
    told = {stroke.title for stroke in upon}
    strokes = (one if one.title in told else one._replace(pen="thin") for one in found.strokes)
    return found._replace(strokes=tuple(strokes))


def _read(one: Judged, goal: complex, enlarge: float) -> list[Stroke]:
    """Return the cross of a point that was read, and the arrow of its deviation."""
    away = enlarge * (one.taken.spot - goal)
    found, pen = goal + away, "main" if one.verdict == WRONG else "medium"
    strokes = [line(pen, found - CROSS * way, found + CROSS * way) for way in (1 + 1j, 1 - 1j)]
    if abs(away) > SEEN:
        strokes.append(line(pen, goal, found))
        strokes += arrowhead(found, away, pen=pen, length=min(4.0, 0.5 * abs(away)))
    told = f"{one.taken.segment}: {abs(away) / enlarge:.2f} mm"
    return [stroke._replace(title=told) for stroke in strokes]
