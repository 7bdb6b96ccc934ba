"""task: the task sheets of a scene and of its variants, and the keys apart from them."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from graphic_tmm.commands.shared.options import SceneName, chosen_forms, language_of, limited
from graphic_tmm.commands.shared.spoken import Command
from graphic_tmm.commands.shared.telling import tell, waiting
from graphic_tmm.language.said import said

if TYPE_CHECKING:
    from graphic_tmm.classroom.variants.variant import Base

NONE = "none"
"""The keys that are wanted where none are."""


@click.command(cls=Command)
@click.argument("scene", type=SceneName())
@click.argument("variants", required=False)
@click.option(
    "-o",
    "--output",
    default="out",
    show_default=True,
    help=said("Folder: the tasks stand in tasks, the keys in keys."),
)
@click.option(
    "-f",
    "--format",
    "forms",
    default="svg",
    show_default=True,
    help=said("Of the sheets: svg, pdf, png; several with commas."),
)
@click.option(
    "--keys",
    default="sheets,table",
    show_default=True,
    help=said("What keys hold: sheets, table, page, note; several with commas; none: no keys."),
)
@click.option(
    "--note",
    "notes",
    default="html",
    show_default=True,
    help=said("The format of the notes of keys: html, md, pdf, docx; several with commas."),
)
@click.option(
    "--readings",
    is_flag=True,
    help=said(
        "Hand out a table for the lengths that are read off, too, for the check; the scale factors are given "
        "then."
    ),
)
@click.option(
    "-j",
    "--jobs",
    type=click.IntRange(0, 256),
    default=1,
    show_default=True,
    help=said("In so many processes; 0: in this one, where no limit holds."),
)
@limited
def task(
    scene: str,
    variants: str | None,
    output: str,
    forms: str,
    keys: str,
    notes: str,
    readings: bool,
    jobs: int,
    limit: float | None,
) -> None:
    """Write task sheets without a solution for VARIANTS (CSV, xlsx) of SCENE; their keys apart from them."""
    from graphic_tmm.classroom.batch.run import USUAL, run
    from graphic_tmm.classroom.tasks.work import FORMATS, KEYS, works
    from graphic_tmm.classroom.variants.start import start_of
    from graphic_tmm.classroom.variants.table import read_variants
    from graphic_tmm.classroom.variants.variant import base as base_of
    from graphic_tmm.errors import SheetError
    from graphic_tmm.language.reader import asked_language, hear
    from graphic_tmm.note.formats import FORMATS as NOTES
    from graphic_tmm.note.formats import refuse_missing
    from graphic_tmm.scene.packaged import scene_path

    if limit is not None and jobs == 0:
        raise click.UsageError(said("--limit holds for other processes: leave it out, or --jobs 0"))
    formats = tuple(chosen_forms(forms, FORMATS))
    held = () if keys.strip().lower() == NONE else tuple(chosen_forms(keys, KEYS, "--keys"))
    written = tuple(chosen_forms(notes, NOTES, "--note"))
    if "note" in held:
        refuse_missing(written)
    place = scene_path(scene)
    hear(language_of(place))
    base = base_of(place)
    _refuse(base)
    found = read_variants(Path(variants)) if variants is not None else ()
    with waiting(said("drawing the tasks and their keys")):
        pieces = works(
            base,
            found,
            variants or "",
            formats=formats,
            keys=held,
            notes=written,
            start=start_of(base) if (held or readings) and found else "",
            language=asked_language() or "",
            readings=readings,
        )
        ran = run(pieces, Path(output), executor=jobs, limit=limit or USUAL)
    for folder in dict.fromkeys(name.partition("/")[0] for name in (*ran.made, *ran.kept)):
        click.echo(str(Path(output, folder)))
    for name, lines in ran.told.items():
        for line in lines:
            tell(said("{source}: warning: {text}", source=name, text=line))
    if ran.failed:
        listed = "\n".join(f"{name}: {message}" for name, message in ran.failed.items())
        raise SheetError(said("not made:\n{listed}", listed=listed))


def _refuse(base: Base) -> None:
    """Refuse a faulty scene before anything is written, in the reader's language."""
    from graphic_tmm.language.reader import asked_language, hear
    from graphic_tmm.paper.lettering.letters import missing
    from graphic_tmm.scene.document import spoken
    from graphic_tmm.scene.read import judged

    hear(spoken(base.text))
    scene = judged(base.text.encode("utf-8"), base.file, missing=missing)
    hear(asked_language() or scene.language)
