"""keys: what every key of a scene means."""

from __future__ import annotations

import click

from graphic_tmm.commands.shared.spoken import Command
from graphic_tmm.commands.shared.telling import show
from graphic_tmm.language.said import said


@click.command(cls=Command)
@click.argument("sections", nargs=-1, metavar="[SECTION]...")
@click.option("-o", "--output", help=said("File to write, instead of printing."))
def keys(sections: tuple[str, ...], output: str | None) -> None:
    """Print what every key of a scene means, its unit, bounds, default; of each SECTION, or of all."""
    from graphic_tmm.language.reader import reader
    from graphic_tmm.scene.keys import reference
    from graphic_tmm.scene.sections import declared

    known = tuple(declared())
    for name in sections:
        if name not in known:
            listed = ", ".join(known)
            raise click.UsageError(
                said("{value!r} is not one of {choices}.", value=name, choices=listed)
            )
    show(reference(reader().language, sections), 0, output)
