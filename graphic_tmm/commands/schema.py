"""schema: what a scene may say, for editors."""

from __future__ import annotations

import click

from graphic_tmm.commands.shared.spoken import Command


@click.command(cls=Command)
def schema() -> None:
    """Print the JSON Schema of scenes, for editors."""
    from graphic_tmm.scene.new import schema_text

    click.echo(schema_text(), nl=False)
