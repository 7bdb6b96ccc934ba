"""An overlay: each exact plan thin, the points that were read on it, deviations as arrows, enlarged."""

from __future__ import annotations

from graphic_tmm.captions import CAPTIONS
from graphic_tmm.checking.cells import Key, points
from graphic_tmm.checking.records import FINE, WRONG, Judged, Report
from graphic_tmm.errors import SheetError
from graphic_tmm.paper.arranging import captioned
from graphic_tmm.paper.drawing import Bezier, Drawing, Sheet, Stroke, circle, line
from graphic_tmm.paper.frame import SIZES, drawing_area, frame
from graphic_tmm.paper.ink_plans import markup
from graphic_tmm.paper.layout import Room, pack
from graphic_tmm.paper.letters import escape
from graphic_tmm.paper.placing import Wanted, place
from graphic_tmm.paper.symbols import arrowhead
from graphic_tmm.studio import Made

FORMAT = "A1"
CROSS = 1.2
"""Half of the cross at a point that was read, mm."""


def overlay_sheet(made: Made, report: Report, enlarge: float) -> Sheet:
    """Return a sheet with the exact plans and what was read of them.

    Raises
    ------
    SheetError
        If no points were read, or they fill more than a sheet.
    """
    exact = points(made)
    by_plan: dict[tuple[str, str], list[Judged]] = {}
    for one in report.readings:
        if one.taken.x is not None and one.taken.y is not None:
            by_plan.setdefault((one.taken.plan, one.taken.position), []).append(one)
    if not by_plan:
        raise SheetError("--overlay: no points were read; give x and y of points in the CSV file")
    words = CAPTIONS[report.language]
    views = []
    for (plan, position), read in by_plan.items():
        title = f"{words[plan]}, {words['position']} {escape(position)}"
        views.append(captioned(_plan(exact, plan, position, read, enlarge, title), title))
    area = drawing_area(FORMAT, report.language, True)
    room = Room(area.inner, area.occupied)
    laid = pack(views, (room, room), FORMAT)
    if len(laid) > 1:
        raise SheetError(
            "--overlay: more plans were read than an A1 sheet holds; check fewer at once"
        )
    edge = frame(
        FORMAT,
        language=report.language,
        first=True,
        number=1,
        count=1,
        fields={"name": report.title},
    )
    width, height = SIZES[FORMAT]
    return Sheet("overlay", report.title, FORMAT, width, height, (edge, *laid[0]))


def _plan(
    exact: dict[Key, complex],
    plan: str,
    position: str,
    read: list[Judged],
    enlarge: float,
    title: str,
) -> Drawing:
    """Return one plan: rays from its pole to exact points thin, crosses and arrows of deviation."""
    due = {letter: z for (p, letter, n), z in exact.items() if (p, n) == (plan, position)}
    strokes: list[Stroke | Bezier] = [line("thin", 0j, z) for z in due.values() if abs(z) > 0.5]
    strokes += [circle("thin", z, 0.6) for z in due.values()]
    wanted = [Wanted(markup(letter), z, 3.5, 1.5, z) for letter, z in due.items()]
    for one in read:
        assert one.taken.x is not None
        assert one.taken.y is not None
        goal = due[one.taken.segment]
        found = goal + enlarge * (complex(one.taken.x, one.taken.y) - goal)
        pen = {FINE: "medium", WRONG: "main"}.get(one.verdict, "medium")
        for way in (1 + 1j, 1 - 1j):
            strokes.append(line(pen, found - CROSS * way, found + CROSS * way))
        if abs(found - goal) > 0.5:
            strokes.append(line(pen, goal, found))
            strokes += arrowhead(
                found, found - goal, pen=pen, length=min(4.0, 0.5 * abs(found - goal))
            )
    labels = place(wanted, strokes)
    return Drawing(f"overlay-{plan}-{position}", title, tuple(strokes), labels)
