"""What is to be seen of a check: the points over their plans, the photograph under its sheet."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.checking.cells import points
from graphic_tmm.checking.records import WRONG, Judged, Report
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.errors import SheetError, printable
from graphic_tmm.files import write
from graphic_tmm.fitting.composition import Composition
from graphic_tmm.language.said import said
from graphic_tmm.paper.compose.sheets import pack
from graphic_tmm.paper.drawing import Drawing, Sheet, Stroke, line
from graphic_tmm.paper.formats import size_of, turned
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.paper.packing import Room
from graphic_tmm.paper.ruled import Box
from graphic_tmm.paper.sheet_frame import drawing_area, frame
from graphic_tmm.paper.symbols.kinematic import arrowhead
from graphic_tmm.paper.views import captioned
from graphic_tmm.readers.columns import Readings
from graphic_tmm.scene.captions import captions
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import composed_sheets, make

if TYPE_CHECKING:
    from graphic_tmm.checking.photo.flatten import Photo
    from graphic_tmm.checking.photo.perspective import Corners
    from graphic_tmm.checking.photo.picture import Sent
    from graphic_tmm.checking.photo.quadrilaterals import Ruled

    Image = NDArray[np.uint8]


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


DOTS = 8e6
"""A flattened picture has no more dots: on an A1 four to the mm, as many as a telephone's camera gives."""
FINEST = 8
"""And no more to the mm: a thin line of pencil is then two dots wide."""
_REMEDY = said("name another file with --overlay")


def overlay(
    scene: Scene, report: Report, file: str, enlarge: float, given: Composition | None = None
) -> Path:
    """Write the exact plans thin under the points that were read; deviations ``enlarge`` times as large.

    ``given``: the composition of the sheets, as for `make`.
    """
    from graphic_tmm.paper.write.svg import svg

    path = drawing_file(file)
    text = svg(overlay_sheet(make(scene, exact=True, given=given), report, enlarge))
    (written,) = write(path.parent, {path.name: text}, remedy=_REMEDY)
    return written


class Laid(NamedTuple):
    """A photograph and the sheet that it shows, of a scene as drawn there; ``number``: of the sheet, from 1.

    ``own_paper``: the student's paper is another one than our sheet: nothing of ours is looked for on it.
    """

    made: DrawnScene
    sheet: Sheet
    flat: Photo
    number: int
    own_paper: bool = False


def laid(
    scene: Scene,
    photo: str | Sent,
    corners: str,
    number: int = 1,
    given: Composition | None = None,
    paper: str = "",
) -> Laid:
    """Return a sheet's photograph, flattened to the sheet's true millimetres.

    ``corners``: of the frame as they were typed, "" to find it. ``number``: of the sheet, from 1. ``given``:
    the composition of the sheets, if they have one. ``paper``: the format of a student's own paper; then
    corners are the paper's, and where no frame of ours is seen they are, too.

    Raises
    ------
    SheetError
        If there is no such sheet, the corners are none, no frame is found, or the photograph cannot be
        flattened.
    """
    from graphic_tmm.checking.photo.picture import read_photo
    from graphic_tmm.checking.photo.quadrilaterals import ruled

    clicked = _corners(corners) if corners else None
    made, found = composed_sheets(scene, given)
    drawn = found.sheets
    if number > len(drawn):
        raise SheetError(
            said(
                "--sheet: there is no sheet {number}; the scene has {count}",
                number=number,
                count=len(drawn),
            )
        )
    sheet = drawn[number - 1]
    image = read_photo(photo)
    if paper:
        return Laid(made, *_on_own_paper(sheet, image, clicked, paper), number, own_paper=True)
    lines = ruled(sheet, number == 1)
    try:
        flat = _flat(image, clicked or lines, lines.frame, lines.paper)
    except SheetError:
        if clicked:
            raise
        flat = _by_edges(image, lines.paper, sheet.format)
    return Laid(made, sheet, flat, number)


def _flat(image: Image, corners: Corners | Ruled, frame: Box, paper: Box) -> Photo:
    from graphic_tmm.checking.photo.flatten import flatten

    dots = min(math.floor(math.sqrt(DOTS / (paper.right * paper.top))), FINEST)
    edges = frame == paper
    return flatten(image, corners, frame, area=paper, dots_per_mm=float(dots), refined=not edges)


def _by_edges(image: Image, paper: Box, size: str) -> Photo:
    """Return a photograph flattened by the edges of the paper, which is said."""
    from graphic_tmm.checking.photo.paper_edges import paper_found

    corners = [(z.real, z.imag) for z in paper_found(image)]
    flat = _flat(image, corners, paper, paper)
    taken = said(
        "no frame of this sheet is seen: the edges of the paper were taken, as of an upright {size}; "
        "of another format by --paper",
        size=size,
    )
    return flat._replace(warnings=(taken, *flat.warnings))


def _on_own_paper(
    sheet: Sheet, image: Image, clicked: Corners | None, paper: str
) -> tuple[Sheet, Photo]:
    """Return a student's own paper, nothing on it, and its photograph; it stands or lies as it is seen."""
    from graphic_tmm.checking.photo.paper_edges import paper_found

    corners = paper_found(image, clicked)
    sides = abs(np.roll(corners, -1) - corners)
    wide, high = size_of(paper)
    if (wide > high) != (sides[0] + sides[2] > sides[1] + sides[3]):
        paper = turned(paper)
    wide, high = size_of(paper)
    box = Box(0.0, 0.0, wide, high)
    flat = _flat(image, [(z.real, z.imag) for z in corners], box, box)
    own = sheet._replace(format=paper, width=wide, height=high, drawings=())
    return own, flat


def underlay(shown: Laid, file: str, upon: Sequence[Drawing] = ()) -> tuple[Path, ...]:
    """Write a sheet's photograph, the exact sheet over it, thin and coloured, and what is to be ``upon`` it.

    Return the files. The picture has the drawing's name with "-flat": not the photograph's, which may stand
    beside it.

    Raises
    ------
    SheetError
        If a file cannot be written.
    """
    from graphic_tmm.checking.photo.flatten import png
    from graphic_tmm.paper.write.svg import Under, svg

    path = drawing_file(file)
    picture = _picture(path)
    sheet = shown.sheet._replace(drawings=(*shown.sheet.drawings, *upon))
    text = svg(sheet, under=Under(picture))
    files: dict[str, str | bytes] = {path.name: text, picture: png(shown.flat)}
    return write(path.parent, files, remedy=_REMEDY)


def other_place(file: str | None, drawing: Path) -> None:
    """Raise SheetError if a file of readings is to be written where a drawing or its picture is."""
    if file is not None and Path(file).resolve() in (
        drawing.resolve(),
        drawing.with_name(_picture(drawing)).resolve(),
    ):
        raise SheetError(
            said(
                "--readings-out: {file}: the drawing is written there; name another file",
                file=printable(file),
            )
        )


def _picture(drawing: Path) -> str:
    return f"{drawing.stem}-flat.png"


def drawing_file(file: str) -> Path:
    """Return where a drawing is to be written; raises SheetError if that is no name of an SVG file."""
    path = Path(file)
    if path.suffix.lower() != ".svg":
        raise SheetError(
            said(
                "--overlay: {file}: the drawing is an SVG file; name it .svg",
                file=printable(file),
            )
        )
    return path


def _corners(text: str) -> list[tuple[float, float]]:
    try:
        found = [tuple(float(x) for x in pair.split(",")) for pair in text.split()]
    except ValueError:
        found = []
    if len(found) != 4 or any(len(pair) != 2 for pair in found):
        raise SheetError(
            said(
                '--corners: write the four corners of the frame in dots of the photograph, "10,12 '
                '3000,15 ..."'
            )
        )
    return [(x, y) for x, y in found]
