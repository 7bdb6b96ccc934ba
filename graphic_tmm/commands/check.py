"""check: readings of a hand-made drawing against its scene."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import click

from graphic_tmm.commands.shared.ending import WRONG
from graphic_tmm.commands.shared.hand_ins import (
    MarkedBy,
    mark_folder,
    refuse_mixed,
    refuse_without_class,
    write_template,
)
from graphic_tmm.commands.shared.options import Finite, SceneName, form_of, limited, read_scene
from graphic_tmm.commands.shared.spoken import Command
from graphic_tmm.commands.shared.telling import show, tell, waiting
from graphic_tmm.language.said import said

if TYPE_CHECKING:
    from graphic_tmm.checking.records import Report
    from graphic_tmm.fitting.composition import Composition
    from graphic_tmm.scene.records import Scene

FORMS = ("text", "md", "json", "html")
"""What a report can be."""


@click.command(cls=Command)
@click.argument("scene", type=SceneName())
@click.argument("readings", required=False)
@click.option(
    "--template", is_flag=True, help=said("Print a CSV file to be filled in, and check nothing.")
)
@click.option(
    "--short",
    is_flag=True,
    help=said("With --template: only what is measured on the plans of one position, explained."),
)
@click.option(
    "--only",
    multiple=True,
    metavar="PLAN[:SEGMENT,...]",
    help=said(
        "With --template: only these plans, or segments and points of a plan; several times."
    ),
)
@click.option(
    "--position",
    help=said("With --template: of which position; default: where the most plans are drawn."),
)
@click.option(
    "--class",
    "folder",
    metavar="FOLDER",
    help=said(
        "Mark a class: FOLDER holds readings or photographs, named by variant and student. Status 1 if some of "
        "them could not be read."
    ),
)
@click.option(
    "--variants",
    metavar="FILE",
    help=said("With --class: the table of variants; each is judged by that which its name names."),
)
@click.option(
    "--marks", metavar="FILE", help=said("With --class: the rule for marks, a file as marks.toml.")
)
@click.option(
    "--scheduler",
    metavar="ADDRESS",
    help=said("With --class: let the cluster of this Dask scheduler do it: tcp://10.0.0.1:8786."),
)
@limited
@click.option(
    "-o",
    "--output",
    help=said(
        "File for the report, instead of printing. With --template: the file, .csv or .xlsx; a short one has a "
        "picture of its letters. With --class: the folder for summary, gradebook and reports."
    ),
)
@click.option(
    "--hand",
    type=click.Choice(["cad", "careful", "student"]),
    default="student",
    show_default=True,
    help=said("By whose drawings readings are judged."),
)
@click.option(
    "--points",
    type=click.Choice(["paper", "screen", "photo"]),
    default="paper",
    show_default=True,
    help=said(
        "How x and y were read: off the paper with ruler and square, off the drawing on a screen "
        "(0.1 mm), off a photograph (0.5 mm)."
    ),
)
@click.option(
    "--doubtful",
    type=Finite(0.5, 1.0),
    default=0.97,
    show_default=True,
    help=said("Beyond this quantile of the hand's own deviations a reading is doubtful."),
)
@click.option(
    "--wrong",
    type=Finite(1.0, 100.0),
    default=5.0,
    show_default=True,
    help=said("Beyond so many times their root mean square, and beyond them all, it is wrong."),
)
@click.option(
    "--trials",
    type=click.IntRange(20, 100_000),
    default=400,
    show_default=True,
    help=said("How often the hand draws to tell what is usual."),
)
@click.option(
    "--overlay", help=said("SVG file for the exact plans under the points that were read.")
)
@click.option(
    "--enlarge",
    type=Finite(1.0, 1000.0),
    default=1.0,
    show_default=True,
    help=said("How many times larger the overlay shows deviations."),
)
@click.option(
    "--photo", help=said("A photograph of the sheet, to be laid under it; its frame is found.")
)
@click.option(
    "--sheet",
    type=click.IntRange(1),
    help=said("Which sheet the photograph shows (with --photo); default: the first."),
)
@click.option(
    "--corners",
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
    "--readings-out",
    help=said("CSV file for the points seen in the photograph, to be corrected and checked."),
)
@click.option(
    "-f",
    "--format",
    "form",
    type=click.Choice([*FORMS, "csv", "xlsx"]),
    help=said("Default: by the file's name, else text."),
)
def check(
    scene: str,
    readings: str | None,
    template: bool,
    short: bool,
    only: tuple[str, ...],
    position: str | None,
    folder: str | None,
    variants: str | None,
    marks: str | None,
    scheduler: str | None,
    limit: float | None,
    output: str | None,
    hand: str,
    points: str,
    doubtful: float,
    wrong: float,
    trials: int,
    overlay: str | None,
    enlarge: float,
    photo: str | None,
    corners: str | None,
    sheet: int | None,
    poles: tuple[str, ...],
    readings_out: str | None,
    form: str | None,
) -> None:
    """Compare READINGS of a hand-made drawing (a CSV file) with SCENE; status 1 if something is wrong."""
    by = _By(hand, points, trials, (doubtful, wrong))
    if folder is not None:
        of_one = (readings, template, short, only, position, overlay, photo, corners, sheet)
        refuse_mixed((*of_one, poles, readings_out), form or FORMS[0], output)
        of = (scene, folder, variants, marks, output, form or FORMS[0], scheduler, limit)
        mark_folder(MarkedBy(*of), by.options)
        return
    refuse_without_class((variants, marks, scheduler, limit), form)
    if not template:
        _refuse_half_asked(scene, readings, photo, (sheet, corners, poles or None, readings_out))
        _refuse_twice_asked(readings, poles, readings_out)
        _refuse_untemplated(short or bool(only), position, output)
    task = read_scene(scene, lettered=True)
    if template:
        write_template(task, short, only, position or "", output)
        return
    if photo is not None:
        wanted = _Wanted(photo, corners or "", overlay or "photo.svg", sheet or 1)
        report, written = _of_photo(task, readings, wanted, poles, readings_out, by)
    else:
        assert readings is not None
        with waiting(said("drawing by the hand, to tell what is usual")):
            report = _judged(task, readings, by)
        with waiting(said("drawing the plans")):
            written = _overlaid(task, report, overlay, enlarge)
    for path in written:
        click.echo(str(path), err=report is not None)  # a report has the other stream to itself
    if report is None:
        return
    show(_report_text(report, form_of(form, output, FORMS)), 160, output)
    if report.wrong:
        raise SystemExit(WRONG)


class _By(NamedTuple):
    """By what is judged; ``beyond``: where doubt begins, and wrong."""

    hand: str
    points: str
    trials: int
    beyond: tuple[float, float]

    @property
    def options(self) -> tuple[str, str, int, float, float]:
        """All of it in a row, as the options come."""
        return (self.hand, self.points, self.trials, *self.beyond)


class _Wanted(NamedTuple):
    """Of a photograph: its file, the corners as typed, the drawing to be written, which sheet it shows."""

    photo: str
    corners: str
    file: str
    number: int


def _refuse_half_asked(
    scene: str, readings: str | None, photo: str | None, of_photo: tuple[object, ...]
) -> None:
    if photo is None and any(one is not None for one in of_photo):
        raise click.UsageError(
            said(
                "--sheet, --corners, --pole and --readings-out go with a photograph: add --photo FILE"
            )
        )
    if scene == readings == "-":
        raise click.UsageError(said("one of SCENE and READINGS can be standard input, not both"))
    if readings is None and photo is None:
        raise click.UsageError(
            said("name the file of READINGS, show a photograph (--photo), or ask for --template")
        )


def _refuse_twice_asked(
    readings: str | None, poles: tuple[str, ...], readings_out: str | None
) -> None:
    if readings is not None and (poles or readings_out is not None):
        raise click.UsageError(
            said(
                "--pole and --readings-out are for points seen in the photograph: leave out READINGS"
            )
        )


def _refuse_untemplated(short: bool, position: str | None, output: str | None) -> None:
    table = (output or "").lower().endswith((".csv", ".xlsx"))
    if short or position is not None or table:
        raise click.UsageError(
            said("--short, --only, --position and -o for a table go with --template")
        )


def _judged(scene: Scene, readings: str, by: _By) -> Report:
    """Return the report on a file of readings."""
    from graphic_tmm.checking.check import check
    from graphic_tmm.checking.judging.scatter import Limits
    from graphic_tmm.checking.readings.read import read_readings

    taken, limits = read_readings(Path(readings)), Limits(*by.beyond)
    return check(
        scene,
        taken,
        hand=by.hand,
        points=by.points,
        trials=by.trials,
        limits=limits,
        given=_composition(scene),
        source=readings,
    )


def _composition(scene: Scene) -> Composition | None:
    """Return the composition beside a scene, by which its sheets are drawn; None if there is none."""
    from graphic_tmm.fitting.composition import composition_file, read_composition

    return read_composition(composition_file(scene.source))


def _of_photo(
    scene: Scene,
    readings: str | None,
    wanted: _Wanted,
    poles: tuple[str, ...],
    readings_out: str | None,
    by: _By,
) -> tuple[Report | None, tuple[Path, ...]]:
    """Write a photograph under its sheet; return a report on its readings or those given, and the files.

    Said is what makes the photograph doubtful.
    """
    from graphic_tmm.checking.judging.scatter import Limits
    from graphic_tmm.checking.photographed import (
        judged,
        photographed,
        points_drawing,
        poles_of,
        write_seen,
    )
    from graphic_tmm.checking.pictures import drawing_file, laid, other_place, underlay

    other_place(readings_out, drawing_file(wanted.file))
    clicked = poles_of(poles)
    with waiting(said("drawing the plans")):
        given = _composition(scene)
        shown = laid(scene, wanted.photo, wanted.corners, wanted.number, given)
    for warning in shown.flat.warnings:
        tell(said("warning: {text}", text=warning))
    if readings is not None:
        with waiting(said("drawing by the hand, to tell what is usual")):
            report = _judged(scene, readings, by)
        return report, underlay(shown, wanted.file)
    with waiting(said("following the lines in the photograph")):
        seen = photographed(shown, clicked, by.hand)
    if seen is None:
        if readings_out is not None:
            tell(
                said(
                    "warning: {text}",
                    text=said("no plan on this sheet: no file for --readings-out"),
                )
            )
        return None, underlay(shown, wanted.file)
    with waiting(said("drawing by the hand, to tell what is usual")):
        limits, source = Limits(*by.beyond), readings_out or wanted.photo
        report = judged(
            scene,
            seen,
            hand=by.hand,
            trials=by.trials,
            limits=limits,
            given=given,
            source=source,
        )
    written = () if readings_out is None else write_seen(readings_out, seen, scene.language)
    return report, (
        *underlay(shown, wanted.file, (points_drawing(seen, report, shown.sheet),)),
        *written,
    )


def _overlaid(scene: Scene, report: Report, file: str | None, enlarge: float) -> tuple[Path, ...]:
    """Write the points that were read over their plans, where that is asked for; return the file."""
    from graphic_tmm.checking.pictures import overlay

    return () if file is None else (overlay(scene, report, file, enlarge, _composition(scene)),)


def _report_text(report: Report, form: str) -> str | list[Any]:
    """Return a report as Markdown, JSON or HTML text, or as rich tables for ``form`` "text"."""
    from graphic_tmm.checking.report.html import html_report
    from graphic_tmm.checking.report.json import json_report
    from graphic_tmm.checking.report.markdown import markdown_report
    from graphic_tmm.checking.report.text import text_report

    if form == "text":
        return text_report(report)
    return {"md": markdown_report, "json": json_report, "html": html_report}[form](report)
