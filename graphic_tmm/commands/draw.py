"""draw: the sheets of a scene as files."""

from __future__ import annotations

from pathlib import Path

import click

from graphic_tmm.commands.shared.budget import budgeted, within
from graphic_tmm.commands.shared.scenes import drawn_by, hands, read_scene
from graphic_tmm.commands.shared.telling import warn


@click.command()
@click.argument("scene", required=False)
@click.option("-o", "--output", default="out", show_default=True, help="Folder for the sheets.")
@click.option(
    "-f",
    "--format",
    "forms",
    default="svg",
    show_default=True,
    help="svg, pdf, png, dxf; several with commas.",
)
@hands
@budgeted
def draw(
    scene: str | None,
    output: str,
    forms: str,
    hand: str | None,
    seed: int | None,
    budget: str | None,
) -> None:
    """Draw the sheets of SCENE as files, true to the millimetre."""
    from graphic_tmm.errors import SheetError
    from graphic_tmm.files import write
    from graphic_tmm.studio import FORMATS, sheet_files

    wanted = [form.strip().lower() for form in forms.split(",")]
    if unknown := [form for form in wanted if form not in FORMATS]:
        raise SheetError(f"--format: no {', '.join(unknown)}; choose from {', '.join(FORMATS)}")
    task = within(drawn_by(read_scene(scene, lettered=True), hand, seed), budget)
    made, texts = sheet_files(task, wanted)
    for path in write(Path(output), texts, remedy="name another folder with -o"):
        click.echo(str(path))
    warn(made, sheets=True)
