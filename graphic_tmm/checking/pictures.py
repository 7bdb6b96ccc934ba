"""What is to be seen of a check: the points over their plans, the photograph under its sheet."""

from __future__ import annotations

from pathlib import Path

from graphic_tmm.checking.overlay import overlay_sheet
from graphic_tmm.checking.records import Report
from graphic_tmm.errors import SheetError, printable
from graphic_tmm.files import write
from graphic_tmm.language.said import said
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make, sheets

_REMEDY = said("name another file with --overlay")


def overlay(scene: Scene, report: Report, file: str, enlarge: float) -> Path:
    """Write the exact plans thin under the points that were read; deviations ``enlarge`` times as large."""
    from graphic_tmm.paper.write.svg import svg

    path = _drawing(file)
    text = svg(overlay_sheet(make(scene, exact=True), report, enlarge))
    (written,) = write(path.parent, {path.name: text}, remedy=_REMEDY)
    return written


def underlay(
    scene: Scene, photo: str, corners: str, file: str, number: int = 1
) -> tuple[tuple[Path, ...], tuple[str, ...]]:
    """Write a sheet's photograph, flattened, and over it the exact sheet, thin and coloured, true to the mm.

    ``corners``: of the frame as they were typed, "" to find it. ``number``: of the sheet, from 1. Return the
    files, and what the photograph is warned about. The picture has the drawing's name with "-flat": not the
    photograph's, which may stand beside it.

    Raises
    ------
    SheetError
        If there is no such sheet, the corners are none, the photograph cannot be flattened, or a file cannot be
        written.
    """
    from graphic_tmm.checking.photo.flatten import flatten, png
    from graphic_tmm.checking.photo.ruling import ruled
    from graphic_tmm.paper.write.svg import Under, svg

    path = _drawing(file)
    clicked = _corners(corners) if corners else None
    drawn = sheets(scene)[1]
    if number > len(drawn):
        raise SheetError(
            said(
                "--sheet: there is no sheet {number}; the scene has {count}",
                number=number,
                count=len(drawn),
            )
        )
    sheet = drawn[number - 1]
    lines = ruled(sheet, number == 1)
    flat = flatten(Path(photo), clicked or lines, lines.frame, area=lines.paper)
    picture = f"{path.stem}-flat.png"
    text = svg(sheet, under=Under(picture))
    files: dict[str, str | bytes] = {path.name: text, picture: png(flat)}
    return write(path.parent, files, remedy=_REMEDY), flat.warnings


def _drawing(file: str) -> Path:
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
