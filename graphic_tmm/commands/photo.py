"""photo: a photograph of a hand-made sheet, laid under its exact plans, its points judged."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from graphic_tmm.commands.shared.judging import (
    JudgedBy,
    composition_of,
    end_with,
    judged_by,
    refuse,
    report_form,
    report_on,
)
from graphic_tmm.commands.shared.options import SceneName, language_of, read_scene
from graphic_tmm.commands.shared.spoken import Command
from graphic_tmm.commands.shared.telling import tell, waiting
from graphic_tmm.language.said import said
from graphic_tmm.paper.formats import PAPERS

if TYPE_CHECKING:
    from collections.abc import Sequence

    from graphic_tmm.checking.own_sheet.clicked import ClickedPlan
    from graphic_tmm.checking.pencil.reading import Pole
    from graphic_tmm.checking.pictures import Laid
    from graphic_tmm.checking.records import Report
    from graphic_tmm.scene.records import Scene


@click.command(cls=Command)
@click.argument("scene", type=SceneName())
@click.argument("photo")
@click.argument("readings", required=False)
@click.option(
    "--sheet",
    type=click.IntRange(1),
    default=1,
    show_default=True,
    help=said("Which sheet the photograph shows."),
)
@click.option(
    "--corners",
    default="",
    help=said(
        "The corners of the frame in the photograph, if it is not found: x,y x,y x,y x,y (dots)."
    ),
)
@click.option(
    "--pole",
    "poles",
    multiple=True,
    help=said(
        "Where the pole of a plan is in the photograph, if it stands elsewhere on the sheet: "
        "velocities:3=x,y (dots)."
    ),
)
@click.option(
    "--plan",
    "plans",
    multiple=True,
    help=said(
        "A plan on a sheet of one's own composition: where its pole p and the end of its first vector, a, "
        "are in the photograph: velocities:3=x,y,x,y (dots); of further plans of a kind p is enough; of "
        "positions, the crank's pivot and its pin. The student's own scale factor and turn are told by these."
    ),
)
@click.option(
    "--propose",
    is_flag=True,
    help=said(
        "Print which plans the photograph seems to show, as --plan to be confirmed, and draw them; nothing is "
        "judged."
    ),
)
@click.option(
    "--paper",
    type=click.Choice(PAPERS),
    help=said(
        "The format of one's own paper, with any frame or none: --corners are then those of the paper, and its "
        "edges are looked for, no frame."
    ),
)
@click.option(
    "--readings-out",
    help=said("CSV file for the points seen in the photograph, to be corrected and checked."),
)
@click.option(
    "--overlay",
    default="photo.svg",
    show_default=True,
    help=said("SVG file for the exact plans over the photograph."),
)
@click.option("-o", "--output", help=said("File for the report, instead of printing."))
@judged_by
@report_form
def photo(
    scene: str,
    photo: str,
    readings: str | None,
    sheet: int,
    corners: str,
    poles: tuple[str, ...],
    plans: tuple[str, ...],
    propose: bool,
    paper: str | None,
    readings_out: str | None,
    overlay: str,
    output: str | None,
    by: JudgedBy,
    form: str | None,
) -> None:
    """Lay PHOTO of a drawn sheet of SCENE under it; judge it or READINGS; status 1: wrong, 3: not all seen."""
    from graphic_tmm.checking.own_sheet.clicked import plans_of
    from graphic_tmm.checking.photographed import poles_of
    from graphic_tmm.checking.pictures import drawing_file, laid, other_place, underlay
    from graphic_tmm.scene.packaged import scene_path

    if readings is not None and (poles or plans or readings_out is not None):
        raise click.UsageError(
            said(
                "--pole, --plan and --readings-out are for points seen in the photograph: leave out READINGS"
            )
        )
    if propose and (readings is not None or poles or plans or readings_out is not None):
        raise click.UsageError(
            said("--propose goes before --plan and --pole, and without READINGS")
        )
    refuse(scene, readings, output)
    of = read_scene(scene, lettered=True)
    # the form on the sheet is the scene's, in whatever language the report is wanted
    drawn = of.spoken_in(language_of(scene_path(scene)))
    other_place(readings_out, drawing_file(overlay))
    clicked, own = poles_of(poles), plans_of(plans)
    with waiting(said("drawing the plans")):
        shown = laid(drawn, photo, corners, sheet, composition_of(of), paper or "")
    for warning in shown.flat.warnings:
        tell(said("warning: {text}", text=warning))
    if propose:
        _propose(shown, by.hand, of.language, overlay)
        return
    if readings is not None:
        report: Report | None = report_on(of, readings, by)
        written = underlay(shown, overlay)
    else:
        report, written = _seen(of, shown, (clicked, own), by, readings_out or "", photo, overlay)
    for path in written:
        click.echo(str(path), err=report is not None)  # a report has the other stream to itself
    if report is not None:
        end_with(report, form, output)


def _propose(shown: Laid, hand: str, language: str, overlay: str) -> None:
    """Print the plans that a photograph seems to show, ready for --plan, and draw where they stand."""
    from graphic_tmm.checking.own_sheet.clicked import plan_text
    from graphic_tmm.checking.photographed import proposed
    from graphic_tmm.checking.pictures import underlay

    with waiting(said("looking for plans in the photograph")):
        found = proposed(shown, hand, language)
    for one in found.plans:
        click.echo(f"--plan {plan_text(one)}")
    if not found.plans:
        tell(said("no plan is recognised in the photograph: give p and a of each with --plan"))
    for path in underlay(shown, overlay, (found.drawing,)):
        click.echo(str(path), err=True)  # what is to be copied has the other stream to itself


def _seen(
    scene: Scene,
    shown: Laid,
    clicked: tuple[dict[Pole, complex], Sequence[ClickedPlan]],
    by: JudgedBy,
    readings_out: str,
    photo: str,
    overlay: str,
) -> tuple[Report | None, tuple[Path, ...]]:
    """Judge the points that are seen in a photograph, and draw them over it; return the files, too."""
    from graphic_tmm.checking.judging.scatter import Limits
    from graphic_tmm.checking.photographed import judged, photographed, points_drawing, write_seen
    from graphic_tmm.checking.pictures import underlay

    with waiting(said("following the lines in the photograph")):
        poles, plans = clicked
        seen = photographed(shown, poles, by.hand, plans)
    if seen is None:
        if readings_out:
            without = said("no plan on this sheet: no file for --readings-out")
            tell(said("warning: {text}", text=without))
        return None, underlay(shown, overlay)
    with waiting(said("drawing by the hand, to tell what is usual")):
        report = judged(
            scene,
            seen,
            hand=by.hand,
            trials=by.trials,
            limits=Limits(by.doubtful, by.wrong),
            given=composition_of(scene),
            stated=(by.scales, by.turns),
            source=readings_out or photo,
        )
    points = points_drawing(seen, report, shown.sheet)
    files = write_seen(readings_out, seen, scene.language) if readings_out else ()
    return report, (*underlay(shown, overlay, (*seen.plans, points)), *files)
