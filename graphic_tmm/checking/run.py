"""The road of a check, a few verbs in a row: read the readings, judge, tell; templates and overlays."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from graphic_tmm.checking.cells import POINTED, RESULTS, position_names
from graphic_tmm.checking.cells import points as spots
from graphic_tmm.checking.check import check
from graphic_tmm.checking.overlay import overlay_sheet
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.readings.writing import template
from graphic_tmm.checking.records import Report
from graphic_tmm.checking.report.html import html_report
from graphic_tmm.checking.report.json import json_report
from graphic_tmm.checking.report.text import markdown_report, text_report
from graphic_tmm.checking.scatter import Limits
from graphic_tmm.errors import SheetError, printable
from graphic_tmm.files import write
from graphic_tmm.language.said import said
from graphic_tmm.readers.columns import Column
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make, scene_columns, scene_results, sheets

_REMEDY = said("name another file with --overlay")


def template_of(scene: Scene) -> str:
    """Return the CSV file of all that can be measured of a scene, to be filled in."""
    made = make(scene, exact=True)
    names = position_names(made)
    rows = list(scene_columns(made))
    for name, (value, unit) in scene_results(made).items():
        rows.append(Column(RESULTS, name, name, unit, (None,), (value,)))
    letters = dict.fromkeys((plan, letter) for plan, letter, _ in spots(made) if plan in POINTED)
    return template(rows, names, tuple(letters), language=scene.language)


def checked(
    scene: Scene,
    readings: str,
    hand: str,
    limits: tuple[float, float],
    trials: int,
    points: str = "paper",
) -> Report:
    """Return the report on a file of readings; ``points``: how their x and y were read."""
    taken = read_readings(Path(readings))
    doubtful, wrong = limits
    bounds = Limits(doubtful=doubtful, wrong=wrong)
    return check(
        scene, taken, hand=hand, points=points, trials=trials, limits=bounds, source=readings
    )


def told(report: Report, form: str) -> str | list[Any]:
    """Return a report as Markdown, JSON or HTML text, or as rich tables for ``form`` "text"."""
    if form == "text":
        return text_report(report)
    return {"md": markdown_report, "json": json_report, "html": html_report}[form](report)


def pictured(
    scene: Scene,
    report: Report | None,
    file: str | None,
    enlarge: float,
    photograph: tuple[str, str, int] | None,
) -> tuple[tuple[Path, ...], tuple[str, ...]]:
    """Write what is to be seen of a check: the photograph under its sheet, else the points over their plans.

    ``photograph``: its file, corners, and the number of the sheet. Return the files and the warnings.
    """
    if photograph is not None:
        photo, corners, number = photograph
        return underlay(scene, photo, corners, file or "photo.svg", number)
    if report is None or file is None:
        return (), ()
    return (overlaid(scene, report, file, enlarge),), ()


def overlaid(scene: Scene, report: Report, file: str, enlarge: float) -> Path:
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

    ``number``: of the sheet, from 1. Return the files, and what the photograph is warned about. The picture
    has the drawing's name with "-flat": not the photograph's, which may stand beside it.

    Raises
    ------
    SheetError
        If there is no such sheet, the corners are none, the photograph cannot be flattened, or a file cannot be
        written.
    """
    from graphic_tmm.checking.photo.photo import flatten, png
    from graphic_tmm.paper.frame.frame import drawing_area
    from graphic_tmm.paper.write.svg import Under, svg

    path = _drawing(file)
    clicked = _corners(corners)
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
    left, bottom, right, top = drawing_area(sheet.format, scene.language, number == 1).inner
    paper = (0.0, 0.0, sheet.width, sheet.height)
    flat = flatten(Path(photo), clicked, (left, bottom, right, top), area=paper)
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
