"""variants: a table of variants of a scene, drawn from ranges, none of them a bad one."""

from __future__ import annotations

from pathlib import Path

import click

from graphic_tmm.commands.shared.options import SceneName, language_of
from graphic_tmm.commands.shared.spoken import Command
from graphic_tmm.commands.shared.telling import progress, tell
from graphic_tmm.language.reader import asked_language, hear, reader
from graphic_tmm.language.said import said


@click.command(cls=Command)
@click.argument("scene", required=False, type=SceneName())
@click.option(
    "-n",
    "--count",
    type=click.IntRange(1, 100_000),
    default=30,
    show_default=True,
    help=said("How many variants."),
)
@click.option(
    "--seed",
    type=click.IntRange(0, 2**31),
    default=1,
    show_default=True,
    help=said("Which of many such tables."),
)
@click.option(
    "--ranges",
    help=said("File of ranges and of what a good variant is.  [default: ranges.toml by the scene]"),
)
@click.option(
    "-o",
    "--output",
    type=click.Path(dir_okay=False),
    help=said("The table, .csv or .xlsx; default: CSV is printed."),
)
def variants(
    scene: str | None, count: int, seed: int, ranges: str | None, output: str | None
) -> None:
    """Draw variants of SCENE from ranges: all of them assemble, and can be drawn and measured well."""
    from graphic_tmm.classroom.variants.drawing import draw_variants
    from graphic_tmm.classroom.variants.ranges import FILE, read_ranges
    from graphic_tmm.classroom.variants.table import write_variants
    from graphic_tmm.classroom.variants.variant import base
    from graphic_tmm.files import write
    from graphic_tmm.paper.lettering.letters import missing
    from graphic_tmm.scene.packaged import scene_path

    table = Path(output or "variants.csv")
    if table.suffix.lower() not in (".csv", ".xlsx"):
        raise click.UsageError(
            said("-o: a table of variants is a CSV or an xlsx file; name it .csv or .xlsx")
        )
    path = scene_path(scene)
    spoken = asked_language() or language_of(path)
    hear(spoken)
    of = base(path)
    wanted = read_ranges(Path(ranges) if ranges else of.file.with_name(FILE), of)
    with progress() as on_the_way:

        def in_reader_language(done: int, all: int, name: str) -> None:
            on_the_way(done, all, reader()(name))

        found = draw_variants(of, wanted, count, seed, missing=missing, tell=in_reader_language)
    text = write_variants(found.variants, table.name, language=spoken or "en")
    if output is None:
        click.echo(text, nl=False)
    else:
        remedy = said("name another file with -o")
        for written in write(table.parent, {table.name: text}, remedy=remedy):
            click.echo(str(written))
    tell(found.sentence)
