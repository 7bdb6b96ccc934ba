"""template: a table to be filled in with what is read off a hand-made drawing."""

from __future__ import annotations

from pathlib import Path

import click

from graphic_tmm.commands.shared.options import SceneName, read_scene
from graphic_tmm.commands.shared.spoken import Command
from graphic_tmm.commands.shared.telling import waiting
from graphic_tmm.language.said import said


@click.command(cls=Command)
@click.argument("scene", type=SceneName())
@click.option(
    "--short",
    is_flag=True,
    help=said("Only what is measured on the plans of one position, explained."),
)
@click.option(
    "--only",
    multiple=True,
    metavar="PLAN[:SEGMENT,...]",
    help=said("Only these plans, or segments and points of a plan; several times."),
)
@click.option(
    "--position",
    default="",
    help=said("Of which position; default: where the most plans are drawn."),
)
@click.option(
    "-o",
    "--output",
    help=said(
        "File to write, .csv or .xlsx, instead of printing; a short one has a picture of its letters."
    ),
)
def template(
    scene: str, short: bool, only: tuple[str, ...], position: str, output: str | None
) -> None:
    """Print a table (CSV, xlsx) to be filled in with readings of SCENE drawn by hand, for check."""
    from graphic_tmm.checking.template import short_of, template_of
    from graphic_tmm.files import write

    of = read_scene(scene, lettered=True)
    path = Path(output or "readings.csv")
    if path.suffix.lower() not in (".csv", ".xlsx"):
        raise click.UsageError(
            said("-o: a template is a CSV or an xlsx file; name it .csv or .xlsx")
        )
    with waiting(said("drawing the plans")):
        if short or only or position:
            files = short_of(of, path.name, only, position, pictured=output is not None)
        else:
            files = {path.name: template_of(of, path.name)}
    if output is None:
        click.echo(files[path.name], nl=False)
        return
    for written in write(path.parent, files, remedy=said("name another file with -o")):
        click.echo(str(written))
