"""The road of a study, a few verbs in a row: measure, tell, draw the figure; keep within a budget."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from graphic_tmm.accuracy.budget import Taken, choose
from graphic_tmm.accuracy.minutes import read_minutes
from graphic_tmm.accuracy.report_json import json_report
from graphic_tmm.accuracy.report_text import text_report
from graphic_tmm.accuracy.study import Study, Tell, study
from graphic_tmm.errors import SheetError
from graphic_tmm.files import write
from graphic_tmm.language.said import said
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import scene_name


def studied(
    scene: Scene, hand: str | None, trials: int, minutes: str | None, *, clock: bool
) -> Study:
    """Return the study of a scene, with a bar on the error stream that tells how far it is.

    ``minutes``: a TOML file with a table of minutes; ``clock``: whether seconds are measured.
    """
    table = read_minutes(minutes) if minutes is not None else None
    with _bar() as tell:
        return study(scene, hand=hand, trials=trials, minutes=table, clock=clock, tell=tell)


@contextmanager
def _bar() -> Iterator[Tell]:
    """Show a bar on the error stream; nothing if that is no terminal."""
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

    console = Console(stderr=True)
    columns = (BarColumn(), TextColumn("{task.completed}/{task.total}"), TimeRemainingColumn())
    hidden = not console.is_terminal
    with Progress(
        *columns, TextColumn("{task.description}"), console=console, transient=True, disable=hidden
    ) as bar:
        task = bar.add_task("", total=1)

        def tell(done: int, of: int, name: str) -> None:
            bar.update(task, completed=done, total=of, description=name)

        yield tell


def told(found: Study, form: str) -> str | list[Any]:
    """Return a study as JSON text, or as rich tables and sentences for ``form`` "text"."""
    return json_report(found) if form == "json" else text_report(found)


def figured(found: Study, output: str) -> tuple[Path, ...]:
    """Write the figure of a study as SVG and PNG into a folder; return the files."""
    from graphic_tmm.accuracy.figure import figures

    stem = scene_name(found.scene.source)
    files: dict[str, str | bytes] = {
        f"{stem}-accuracy.{end}": content for end, content in figures(found).items()
    }
    return write(Path(output), files, remedy=said("name another folder with -o"))


def within(scene: Scene, budget: str) -> Taken:
    """Return the cheapest setting of a scene within a budget such as "2%".

    Raises
    ------
    SheetError
        If the budget is no percentage.
    SceneError
        If no setting keeps within it.
    """
    match = re.fullmatch(r"\s*(\d+(?:[.,]\d*)?|[.,]\d+)\s*%?\s*", budget)
    percent = float(match[1].replace(",", ".")) if match else 0.0
    if not percent > 0.0:
        raise SheetError(
            said('--budget: "{budget}" is no percentage above 0; write --budget 2%', budget=budget)
        )
    with _bar() as tell:
        return choose(scene, percent, tell)
