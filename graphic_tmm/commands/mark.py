"""mark: what a class has handed in, judged and marked."""

from __future__ import annotations

from contextlib import nullcontext
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

import click

from graphic_tmm.commands.shared.ending import WRONG
from graphic_tmm.commands.shared.judging import JudgedBy, judged_by
from graphic_tmm.commands.shared.options import SceneName, language_of, limited, processors
from graphic_tmm.commands.shared.spoken import Command
from graphic_tmm.commands.shared.telling import progress, show, tell
from graphic_tmm.language.reader import asked_language, hear
from graphic_tmm.language.said import said

if TYPE_CHECKING:
    from graphic_tmm.classroom.marks.marking import Marked

FORMS = ("text", "csv", "xlsx", "html")
"""What a summary can be printed as; a workbook is written only."""


@click.command(cls=Command)
@click.argument("scene", type=SceneName())
@click.argument("folder")
@click.option(
    "--variants",
    metavar="FILE",
    help=said("The table of variants; each is judged by that which its name names."),
)
@click.option("--marks", metavar="FILE", help=said("The rule for marks, a file as marks.toml."))
@click.option(
    "--scheduler",
    metavar="ADDRESS",
    help=said("Let the cluster of this Dask scheduler do it: tcp://10.0.0.1:8786."),
)
@limited
@click.option("-o", "--output", help=said("Folder for summary, gradebook and reports."))
@judged_by
@click.option(
    "-f",
    "--format",
    "form",
    type=click.Choice(FORMS),
    default="text",
    show_default=True,
    help=said("What the summary is printed as."),
)
def mark(
    scene: str,
    folder: str,
    variants: str | None,
    marks: str | None,
    scheduler: str | None,
    limit: float | None,
    output: str | None,
    by: JudgedBy,
    form: str,
) -> None:
    """Mark a class by SCENE: FOLDER holds readings or photographs, named by variant and student.

    Status 1 if some of them could not be read.
    """
    from graphic_tmm.classroom.batch.record import write_files
    from graphic_tmm.classroom.marks.judging import By
    from graphic_tmm.classroom.marks.marking import Class, Table, mark_class
    from graphic_tmm.classroom.marks.rule import FIVE
    from graphic_tmm.classroom.marks.rule_file import read_rule
    from graphic_tmm.classroom.marks.summary import summary_files
    from graphic_tmm.classroom.variants.table import read_variants
    from graphic_tmm.classroom.variants.variant import base
    from graphic_tmm.scene.packaged import scene_path

    if form == "xlsx" and output is None:
        raise click.UsageError(said("-f xlsx: name a folder for it with -o"))
    path = scene_path(scene)
    hear(asked_language() or language_of(path))
    task = Class(
        folder=_outside(Path(folder), output),
        base=base(path),
        table=None if variants is None else Table(Path(variants), read_variants(Path(variants))),
        rule=FIVE if marks is None else read_rule(Path(marks)),
        by=By(*by),
        language=asked_language(),
        where=scheduler or processors(),
        limit=limit,
    )
    place = TemporaryDirectory() if output is None else nullcontext(output)
    with place as out:
        with progress() as bar:
            marked = mark_class(task, Path(out), bar)
        files = summary_files(marked) if output is not None else {}
        encoded = {
            name: text.encode("utf-8") if isinstance(text, str) else text
            for name, text in files.items()
        }
        write_files(Path(out), encoded)
    for name in files:
        click.echo(str(Path(out) / name), err=True)
    _show(marked, form)
    if marked.skipped:
        count = len(marked.skipped)
        tell(said("{n} was skipped: see the summary", "{n} were skipped: see the summary", n=count))
        raise SystemExit(WRONG)


def _outside(folder: Path, output: str | None) -> Path:
    """Return the folder of the hand-ins; what is written must not stand among them."""
    if output is not None:
        out, real = Path(output).resolve(), folder.resolve()
        if out == real or real in out.parents:
            raise click.UsageError(
                said("-o: the folder stands among what was handed in; name another one")
            )
    return folder


def _show(marked: Marked, form: str) -> None:
    from graphic_tmm.classroom.marks.summary import summary_csv, summary_html, text_summary

    if form == "csv":
        show(summary_csv(marked), 160)
    elif form == "html":
        show(summary_html(marked), 160)
    else:
        show(text_summary(marked), 160)
