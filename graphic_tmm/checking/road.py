"""The road of a check, a few verbs in a row: read the readings, judge, tell; templates and overlays."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from graphic_tmm.checking.cells import POINTED, RESULTS, position_names
from graphic_tmm.checking.cells import points as spots
from graphic_tmm.checking.check import check
from graphic_tmm.checking.overlay import overlay_sheet
from graphic_tmm.checking.readings import read_readings
from graphic_tmm.checking.records import Report
from graphic_tmm.checking.report_html import html_report
from graphic_tmm.checking.report_json import json_report
from graphic_tmm.checking.report_text import markdown_report, text_report
from graphic_tmm.checking.scatter import Limits
from graphic_tmm.checking.writing import template
from graphic_tmm.errors import SheetError
from graphic_tmm.files import write
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make, scene_columns, scene_results, sheets
from graphic_tmm.tables.columns import Column


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


def overlaid(scene: Scene, report: Report, file: str, enlarge: float) -> Path:
    """Write the exact plans thin under the points that were read; deviations ``enlarge`` times as large."""
    from graphic_tmm.paper.svg import svg

    path = Path(file)
    text = svg(overlay_sheet(make(scene, exact=True), report, enlarge))
    (written,) = write(path.parent, {path.name: text}, remedy="name another file with --overlay")
    return written


def underlay(
    scene: Scene, photo: str, corners: str, file: str
) -> tuple[tuple[Path, ...], tuple[str, ...]]:
    """Write a sheet's photograph, flattened, under the exact sheet at true millimetres.

    Return the files, and what the photograph is warned about.
    """
    from graphic_tmm.checking.photo import flatten, png
    from graphic_tmm.paper.frame import SIZES, drawing_area
    from graphic_tmm.paper.svg import svg

    drawn = sheets(scene)[1]
    sheet = drawn[0]
    area = drawing_area(sheet.format, scene.language, True)
    left, bottom, right, top = area.inner
    width, height = SIZES[sheet.format]
    frame, paper = (left, bottom, right, top), (0.0, 0.0, width, height)
    flat = flatten(Path(photo), _corners(corners), frame, area=paper)
    path = Path(file)
    image = path.with_suffix(".png").name
    text = svg(sheet)
    cut = text.index(">", text.index("<svg")) + 1
    placed = (
        f'<image href="{image}" x="0" y="0" width="{width:g}" height="{height:g}" '
        'preserveAspectRatio="none"/>'
    )
    whole = text[:cut] + placed + text[cut:]
    files: dict[str, str | bytes] = {path.name: whole, image: png(flat)}
    written = write(path.parent, files, remedy="name another file with --overlay")
    return tuple(written), tuple(flat.warnings)


def _corners(text: str) -> list[tuple[float, float]]:
    try:
        found = [tuple(float(x) for x in pair.split(",")) for pair in text.split()]
    except ValueError:
        found = []
    if len(found) != 4 or any(len(pair) != 2 for pair in found):
        raise SheetError(
            '--corners: write the four corners of the frame in dots of the photograph, "10,12 3000,15 ..."'
        )
    return [(x, y) for x, y in found]
