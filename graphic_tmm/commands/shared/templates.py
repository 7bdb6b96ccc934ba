"""A file of readings to be filled in, printed or written."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from graphic_tmm.commands.shared.progress import waiting
from graphic_tmm.language.said import said

if TYPE_CHECKING:
    from graphic_tmm.scene.records import Scene


def write_template(
    scene: Scene, short: bool, only: tuple[str, ...], position: str, output: str | None
) -> None:
    """Print a file to be filled in, or write it, with a picture of its letters where it is a short one."""
    from graphic_tmm.checking.template import short_of, template_of
    from graphic_tmm.files import write

    path = Path(output or "readings.csv")
    if path.suffix.lower() not in (".csv", ".xlsx"):
        raise click.UsageError(
            said("-o: a template is a CSV or an xlsx file; name it .csv or .xlsx")
        )
    with waiting(said("drawing the plans")):
        if short or only or position:
            files = short_of(scene, path.name, only, position, pictured=output is not None)
        else:
            files = {path.name: template_of(scene, path.name)}
    if output is None:
        click.echo(files[path.name], nl=False)
        return
    for written in write(path.parent, files, remedy=said("name another file with -o")):
        click.echo(str(written))
