"""schema: what a scene may say, for editors."""

from __future__ import annotations

import click

from graphic_tmm.commands.shared.spoken import Command
from graphic_tmm.commands.shared.telling import show
from graphic_tmm.language.said import said


@click.command(cls=Command)
@click.option("-o", "--output", help=said("File to write, instead of printing."))
def schema(output: str | None) -> None:
    """Print the JSON Schema of scenes, for editors."""
    from graphic_tmm.language.reader import reader
    from graphic_tmm.scene.new import schema_text

    show(schema_text(reader().language), 0, output)
