"""table: what a scene calls for, as figures."""

from __future__ import annotations

import click

from graphic_tmm.commands.shared.options import (
    SceneName,
    budgeted,
    drawn_by,
    form_of,
    hands,
    read_scene,
    within,
)
from graphic_tmm.commands.shared.spoken import Command
from graphic_tmm.commands.shared.telling import show, terminal_width, waiting, warn
from graphic_tmm.language.said import said

FORMS = ("text", "csv", "json")


@click.command(cls=Command)
@click.argument("scene", required=False, type=SceneName())
@click.option(
    "-f",
    "--format",
    "form",
    type=click.Choice(FORMS),
    help=said("Default: by the file's name, else text."),
)
@click.option("-o", "--output", help=said("File to write, instead of printing."))
@click.option(
    "--exact", is_flag=True, help=said("Read without the ruler's rounding; print all digits.")
)
@click.option(
    "--width",
    type=click.IntRange(20, 10_000),
    help=said("Characters of a line of text; the terminal's."),
)
@click.option(
    "--decimal",
    type=click.Choice(["point", "comma"]),
    default="point",
    show_default=True,
    help=said("Decimal sign of CSV; with a comma, semicolons stand between the cells."),
)
@click.option(
    "--bom", is_flag=True, help=said("Begin CSV with a byte order mark, as spreadsheets want it.")
)
@hands
@click.option(
    "--trials", type=click.IntRange(1, 100_000), default=1, help=said("How often all is drawn.")
)
@budgeted
def table(
    scene: str | None,
    form: str | None,
    output: str | None,
    exact: bool,
    width: int | None,
    decimal: str,
    bom: bool,
    hand: str | None,
    seed: int | None,
    trials: int,
    budget: str | None,
    nearest: bool,
) -> None:
    """Print what SCENE calls for, whether or not a sheet shows it: segments in mm, quantities in SI."""
    from graphic_tmm.fitting.composition import composition_file, read_composition
    from graphic_tmm.readers.table import WIDTH
    from graphic_tmm.readers.table import table as told
    from graphic_tmm.studio import make

    task = within(drawn_by(read_scene(scene), hand, seed), budget, nearest=nearest)
    given = read_composition(composition_file(task.source))
    wide = width or (terminal_width() if output is None else WIDTH)
    form = form_of(form, output, FORMS)
    with waiting(said("drawing the plans")):
        drawn = make(task, exact=exact, given=given)
        text = told(drawn, form, trials, width=wide, comma=decimal == "comma")
    marked = bom and form == "csv" and isinstance(text, str)
    show(f"\ufeff{text}" if marked else text, wide, output)
    warn(drawn)
