"""accuracy: what accuracy costs in a scene."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from graphic_tmm.commands.shared.options import SceneName, drawn_by, hands, read_scene
from graphic_tmm.commands.shared.spoken import Command
from graphic_tmm.commands.shared.telling import progress, rendered, say, show
from graphic_tmm.language.said import said

if TYPE_CHECKING:
    from collections.abc import Mapping

    from graphic_tmm.accuracy.answer import Answer
    from graphic_tmm.scene.records import Scene

WIDTH = 200
"""Characters of a line of the report."""
NARROW = 80
"""Those of what is told of effects."""


@click.command(cls=Command)
@click.argument("scene", required=False, type=SceneName())
@click.option("-o", "--output", help=said("Folder for the report, and the figure as SVG and PNG."))
@click.option("-f", "--format", "form", type=click.Choice(["text", "json", "csv"]), default="text")
@click.option("--trials", type=click.IntRange(10, 10_000), default=100, show_default=True)
@click.option(
    "--minutes", help=said("TOML file: minutes of elementary operations, R1 = 0.1 and so on.")
)
@click.option(
    "--no-time", is_flag=True, help=said("Measure no seconds: the same bytes every time.")
)
@click.option(
    "--all",
    "everything",
    is_flag=True,
    help=said("Every setting that was tried, not only the answer."),
)
@click.option(
    "--effects",
    is_flag=True,
    help=said("Show what each effect costs and changes, and which is not worth drawing."),
)
@click.option(
    "--hard",
    is_flag=True,
    help=said("Walk the turn instead: how many digits are left near dead centres and locks."),
)
@hands
def accuracy(
    scene: str | None,
    output: str | None,
    form: str,
    trials: int,
    minutes: str | None,
    no_time: bool,
    everything: bool,
    effects: bool,
    hard: bool,
    hand: str | None,
    seed: int | None,
) -> None:
    """Show what accuracy costs in SCENE: errors over work at the board and time on the machine."""
    from graphic_tmm.accuracy.answer import answer
    from graphic_tmm.accuracy.answer_text import answer_text
    from graphic_tmm.accuracy.cost_figure import plotting
    from graphic_tmm.accuracy.geometrography import read_minutes
    from graphic_tmm.accuracy.report_json import csv_report, json_report
    from graphic_tmm.accuracy.report_text import text_report
    from graphic_tmm.accuracy.study import study
    from graphic_tmm.accuracy.timing import Stopwatch
    from graphic_tmm.errors import SheetError

    task = drawn_by(read_scene(scene), None, seed)
    table = read_minutes(minutes) if minutes is not None else None
    if effects:
        if form == "csv":
            raise SheetError(said("--effects is printed as text or JSON; leave -f csv out"))
        _effects(task, hand, trials, table, form, output, clock=not no_time)
        return
    if hard:
        _hard(task, form, output)
        return
    if output is not None:
        plotting()
    own = drawn_by(task, hand, seed)
    report: str | list[Any]
    if everything or form != "text":
        with progress() as tell:
            found = study(
                own,
                trials=trials,
                minutes=table,
                clock=not no_time,
                tell=tell,
                literal=hand is not None,
            )
        weighed, width = found.answer, WIDTH
        if form == "text":
            report = text_report(found)
        else:
            report = json_report(found) if form == "json" else csv_report(found)
    else:
        with progress() as tell:
            watch = None if no_time else Stopwatch()
            around, literal = output is not None, hand is not None
            weighed = answer(own, table, watch, tell, around=around, literal=literal)
        width = NARROW
        report = answer_text(weighed)
    show(report, width)
    if output is not None:
        end = {"text": "txt"}.get(form, form)
        for path in _written(weighed, {end: rendered(report, width, printed=False)}, output):
            say(str(path))


def _effects(
    scene: Scene,
    hand: str | None,
    trials: int,
    minutes: Mapping[str, float] | None,
    form: str,
    output: str | None,
    *,
    clock: bool,
) -> None:
    """Show what the effects of a scene cost and change; write it into a folder, too."""
    from graphic_tmm.accuracy.effects.effect_study import study_effects
    from graphic_tmm.accuracy.effects.report_effects import effects_json, effects_text
    from graphic_tmm.files import write
    from graphic_tmm.scene.packaged import scene_name

    with progress() as tell:
        found = study_effects(
            scene, hand=hand, trials=trials, minutes=minutes, clock=clock, tell=tell
        )
    report = effects_json(found) if form == "json" else effects_text(found, NARROW)
    show(report, NARROW)
    if output is not None:
        name = f"{scene_name(scene.source)}-effects.{'json' if form == 'json' else 'txt'}"
        files = {name: rendered(report, NARROW, printed=False)}
        for path in write(Path(output), files, remedy=said("name another folder with -o")):
            say(str(path))


def _hard(scene: Scene, form: str, output: str | None) -> None:
    """Show how many digits are left along the turn of a scene; write it into a folder, too."""
    from graphic_tmm.accuracy.hard.hard_text import hard_json, hard_text
    from graphic_tmm.accuracy.hard.walk import walk
    from graphic_tmm.files import write
    from graphic_tmm.scene.packaged import scene_name

    end, tell = ("json", hard_json) if form == "json" else ("txt", hard_text)
    report = tell(walk(scene))
    show(report, NARROW)
    if output is not None:
        files: dict[str, str | bytes] = {f"{scene_name(scene.source)}-hard.{end}": report}
        for path in write(Path(output), files, remedy=said("name another folder with -o")):
            say(str(path))


def _written(weighed: Answer, report: dict[str, str], output: str) -> tuple[Path, ...]:
    """Write the report and the figure of an answer (by their ends) into a folder; return the files."""
    from graphic_tmm.accuracy.cost_figure import figures
    from graphic_tmm.files import write
    from graphic_tmm.scene.packaged import scene_name

    stem = scene_name(weighed.scene.source)
    every: dict[str, str | bytes] = {**report, **figures(weighed)}
    files = {f"{stem}-accuracy.{end}": content for end, content in every.items()}
    return write(Path(output), files, remedy=said("name another folder with -o"))
