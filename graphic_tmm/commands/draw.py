"""draw: the sheets of a scene as files."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from graphic_tmm.commands.shared.options import (
    SceneName,
    budgeted,
    chosen_forms,
    drawn_by,
    hands,
    read_scene,
    within,
)
from graphic_tmm.commands.shared.spoken import Command
from graphic_tmm.commands.shared.telling import waiting, warn
from graphic_tmm.language.said import said

if TYPE_CHECKING:
    from graphic_tmm.drawn import DrawnScene
    from graphic_tmm.paper.drawing import Sheet


@click.command(cls=Command)
@click.argument("scene", required=False, type=SceneName())
@click.option(
    "-o", "--output", default="out", show_default=True, help=said("Folder for the sheets.")
)
@click.option(
    "-f",
    "--format",
    "forms",
    default="svg",
    show_default=True,
    help=said("svg, pdf, png, dxf, html (a page that plays the plans); several with commas."),
)
@click.option(
    "--composition",
    is_flag=True,
    help=said(
        "Write down where the views stand, too: composition.toml, used where it stands beside SCENE."
    ),
)
@click.option("--strokes", is_flag=True, help=said("DXF: letters as strokes, not as text."))
@hands
@budgeted
def draw(
    scene: str | None,
    output: str,
    forms: str,
    composition: bool,
    strokes: bool,
    hand: str | None,
    seed: int | None,
    budget: str | None,
    nearest: bool,
) -> None:
    """Draw the sheets of SCENE as files, true to the millimetre."""
    from graphic_tmm.files import write
    from graphic_tmm.fitting.composition import composition_file, read_composition
    from graphic_tmm.page import FORMAT
    from graphic_tmm.studio import FORMATS, sheet_files

    wanted = chosen_forms(forms, (*FORMATS, FORMAT))
    task = within(drawn_by(read_scene(scene, lettered=True), hand, seed), budget, nearest=nearest)
    given = read_composition(composition_file(task.source))
    with waiting(said("choosing scale factors and composing the sheets")):
        made, texts = sheet_files(
            task,
            wanted,
            strokes=strokes,
            given=given,
            composition=composition,
            whole={FORMAT: _page},
        )
    for path in write(Path(output), texts, remedy=said("name another folder with -o")):
        click.echo(str(path))
    warn(made, sheets=True)


def _page(made: DrawnScene, drawn: Sequence[Sheet]) -> str:
    """Return the page of a scene; its packages are imported only when one is wanted."""
    from graphic_tmm.page.page import page

    return page(made, drawn)
