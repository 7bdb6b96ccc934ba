"""What check, photo and mark share: by whose drawings readings are judged, how a report is printed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import wraps
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import click

from graphic_tmm.commands.shared.ending import NOT_SEEN, WRONG
from graphic_tmm.commands.shared.options import Finite, form_of
from graphic_tmm.commands.shared.telling import show, waiting
from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.language.said import said

if TYPE_CHECKING:
    from graphic_tmm.checking.records import Report
    from graphic_tmm.fitting.composition import Composition
    from graphic_tmm.scene.records import Scene

FORMS = ("text", "md", "json", "html")
"""What a report can be."""

Function = Callable[..., None]


class JudgedBy(NamedTuple):
    """By whose drawings readings are judged, how points were read, where doubt begins, and wrong.

    ``scales``, ``turns``: in which scale factors plans were drawn, and how they were turned.
    """

    hand: str
    points: str
    trials: int
    doubtful: float
    wrong: float
    scales: tuple[str, ...] = ()
    turns: tuple[str, ...] = ()


def judged_by(command: Function) -> Function:
    """Give a command the options of `JudgedBy`, in one argument ``by``."""

    @wraps(command)
    def bundled(
        hand: str,
        points: str,
        trials: int,
        doubtful: float,
        wrong: float,
        scales: tuple[str, ...],
        turns: tuple[str, ...],
        **options: Any,
    ) -> None:
        by = JudgedBy(hand, points, trials, doubtful, wrong, scales, turns)
        command(by=by, **options)

    for option in (
        click.option(
            "--turn",
            "turns",
            multiple=True,
            metavar="PLAN=DEGREES",
            help=said(
                "How a plan is turned against the scene's: velocities=90; else its points tell."
            ),
        ),
        click.option(
            "--mu",
            "scales",
            multiple=True,
            metavar="PLAN=VALUE",
            help=said(
                "The scale factor in which a plan was drawn, SI a mm: velocities=0.02 (of several of a plan: "
                "diagrams:μ_V=0.05); velocities=scene where it was prescribed; else readings tell."
            ),
        ),
        click.option(
            "--trials",
            type=click.IntRange(20, 100_000),
            default=400,
            show_default=True,
            help=said("How often the hand draws to tell what is usual."),
        ),
        click.option(
            "--wrong",
            type=Finite(1.0, 100.0),
            default=5.0,
            show_default=True,
            help=said(
                "Beyond so many times their root mean square, and beyond them all, it is wrong."
            ),
        ),
        click.option(
            "--doubtful",
            type=Finite(0.5, 1.0),
            default=0.97,
            show_default=True,
            help=said("Beyond this quantile of the hand's own deviations a reading is doubtful."),
        ),
        click.option(
            "--points",
            type=click.Choice(["paper", "screen", "photo"]),
            default="paper",
            show_default=True,
            help=said(
                "How x and y were read: off the paper with ruler and square, off the drawing on a screen "
                "(0.1 mm), off a photograph (0.5 mm)."
            ),
        ),
        click.option(
            "--hand",
            type=click.Choice(["cad", "careful", "student"]),
            default="student",
            show_default=True,
            help=said(
                "By whose drawings readings are judged; careful has a quarter of the student's slips, for who "
                "wants to be strict."
            ),
        ),
    ):
        bundled = option(bundled)
    return bundled


def report_form(command: Function) -> Function:
    """Give a command the option of what its report is."""
    text = said("Default: by the file's name, else text.")
    return click.option("-f", "--format", "form", type=click.Choice(FORMS), help=text)(command)


def report_on(scene: Scene, readings: str, by: JudgedBy, letters: Sequence[str] = ()) -> Report:
    """Return the report on a file of readings; ``letters``: pairs, the student's own first.

    Raises
    ------
    SceneError
        Also where the file holds no reading.
    """
    from graphic_tmm.checking.check import check
    from graphic_tmm.checking.congruence.stated import is_scale_row
    from graphic_tmm.checking.judging.scatter import Limits
    from graphic_tmm.checking.readings.letters import letters_of
    from graphic_tmm.checking.readings.read import FileReadings, read_readings

    taken = read_readings(Path(readings))
    own, faults = letters_of(letters)
    if faults:
        raise click.UsageError(faults[0].message)
    if all(map(is_scale_row, taken)):
        says = said("no row holds a figure: there is nothing to judge")
        more = tuple(Fault("", 0, note) for note in taken.notes)
        raise SceneError(readings, (Fault("", 0, says), *more))
    taken = FileReadings.of(taken, taken.notes, {**taken.letters, **own})
    with waiting(said("drawing by the hand, to tell what is usual")):
        return check(
            scene,
            taken,
            hand=by.hand,
            points=by.points,
            trials=by.trials,
            limits=Limits(by.doubtful, by.wrong),
            given=composition_of(scene),
            scales=by.scales,
            turns=by.turns,
            source=readings,
        )


def composition_of(scene: Scene) -> Composition | None:
    """Return the composition that stands with a scene, by which its sheets are drawn; None if there is none."""
    from graphic_tmm.fitting.composition import composition_file, read_composition

    return read_composition(composition_file(scene.source))


def refuse(scene: str, readings: str | None, output: str | None) -> None:
    """Refuse to read scene and readings from one stream, or to write a report into a table."""
    if scene == readings == "-":
        raise click.UsageError(said("one of SCENE and READINGS can be standard input, not both"))
    if (output or "").lower().endswith((".csv", ".xlsx")):
        raise click.UsageError(
            said(
                "-o {file}: a report is no table; name it .md, .json or .html (a table to be filled in is "
                "written by template)",
                file=output,
            )
        )


def end_with(report: Report, form: str | None, output: str | None) -> None:
    """Print a report or write it into a file; the status is 1 if something is wrong, 3 if not all was seen."""
    show(_text(report, form_of(form, output, FORMS)), 160, output)
    if report.wrong:
        raise SystemExit(WRONG)
    if report.sight is not None and not report.sight.whole:
        raise SystemExit(NOT_SEEN)


def _text(report: Report, form: str) -> str | list[Any]:
    """Return a report as Markdown, JSON or HTML text, or as rich tables for ``form`` "text"."""
    from graphic_tmm.checking.report.html import html_report
    from graphic_tmm.checking.report.json import json_report
    from graphic_tmm.checking.report.markdown import markdown_report
    from graphic_tmm.checking.report.text import text_report

    if form == "text":
        return text_report(report)
    return {"md": markdown_report, "json": json_report, "html": html_report}[form](report)
