"""What check does besides judging one drawing: a file to be filled in; hand-ins of a class marked."""

from __future__ import annotations

import os
from collections.abc import Sequence
from contextlib import nullcontext
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, NamedTuple

import click

from graphic_tmm.commands.shared.ending import WRONG
from graphic_tmm.commands.shared.options import language_of
from graphic_tmm.commands.shared.telling import progress, show, tell, waiting
from graphic_tmm.language.reader import asked_language, hear
from graphic_tmm.language.said import said

if TYPE_CHECKING:
    from graphic_tmm.classroom.marks.marking import Class, Marked
    from graphic_tmm.scene.records import Scene


def write_template(
    scene: Scene, short: bool, only: tuple[str, ...], position: str, output: str | None
) -> None:
    """Print a file to be filled in, or write it, with a picture of its letters where it is a short one."""
    from graphic_tmm.checking.template import short_of, template_of
    from graphic_tmm.files import write

    path = Path(output or "readings.csv")
    if path.suffix.lower() not in (".csv", ".xlsx"):
        raise click.UsageError(
            said("-o: a template is a CSV or an xlsx file; name it .csv or .xlsx")
        )
    with waiting(said("drawing the plans")):
        if short or only or position:
            files = short_of(scene, path.name, only, position, pictured=output is not None)
        else:
            files = {path.name: template_of(scene, path.name)}
    if output is None:
        click.echo(files[path.name], nl=False)
        return
    for written in write(path.parent, files, remedy=said("name another file with -o")):
        click.echo(str(written))


OF_CLASS = ("text", "csv", "xlsx", "html")
"""What a summary can be printed as; a workbook is written only."""


class MarkedBy(NamedTuple):
    """What a command line asks for: scene, folder, table of variants, rule, the folder for files, the form.

    ``scheduler``: the address of a cluster's; ``limit``: s that one hand-in may take.
    """

    scene: str
    folder: str
    variants: str | None
    marks: str | None
    output: str | None
    form: str
    scheduler: str | None = None
    limit: float | None = None


def refuse_mixed(of_one: Sequence[object], form: str, output: str | None) -> None:
    """Refuse what is for one drawing beside a class."""
    if any(one not in (None, False, ()) for one in of_one):
        raise click.UsageError(
            said(
                "--class goes with --variants, --marks, -o, -f and by whose hand is judged; leave out READINGS "
                "and what is for one drawing"
            )
        )
    if form not in OF_CLASS:
        raise click.UsageError(
            said(
                "-f {form}: of a class choose one of {listed}",
                form=form,
                listed=", ".join(OF_CLASS),
            )
        )
    if form == "xlsx" and output is None:
        raise click.UsageError(said("-f xlsx: name a folder for it with -o"))


def refuse_without_class(of_class: Sequence[object], form: str | None) -> None:
    """Refuse what is for a class where there is none."""
    if any(one is not None for one in of_class) or form in ("csv", "xlsx"):
        raise click.UsageError(
            said("--variants, --marks, --scheduler, --limit, -f csv and -f xlsx go with --class")
        )


def mark_folder(wanted: MarkedBy, by: tuple[str, str, int, float, float]) -> None:
    """Mark a class; the status is 1 if some hand-in could not be read."""
    from graphic_tmm.classroom.batch.record import write_files
    from graphic_tmm.classroom.marks.marking import mark_class
    from graphic_tmm.classroom.marks.summary import summary_files

    of = _class(wanted, by)
    place = TemporaryDirectory() if wanted.output is None else nullcontext(wanted.output)
    with place as out:
        with progress() as bar:
            marked = mark_class(of, Path(out), bar)
        files = summary_files(marked) if wanted.output is not None else {}
        encoded = {
            name: text.encode("utf-8") if isinstance(text, str) else text
            for name, text in files.items()
        }
        write_files(Path(out), encoded)
    for name in files:
        click.echo(str(Path(out) / name), err=True)
    _show(marked, wanted.form)
    if marked.skipped:
        count = len(marked.skipped)
        tell(said("{n} was skipped: see the summary", "{n} were skipped: see the summary", n=count))
        raise SystemExit(WRONG)


def _class(wanted: MarkedBy, by: tuple[str, str, int, float, float]) -> Class:
    """Return what is to be marked."""
    from graphic_tmm.classroom.marks.judging import By
    from graphic_tmm.classroom.marks.marking import Class, Table
    from graphic_tmm.classroom.marks.rule import FIVE
    from graphic_tmm.classroom.marks.rule_file import read_rule
    from graphic_tmm.classroom.variants.table import read_variants
    from graphic_tmm.classroom.variants.variant import base
    from graphic_tmm.scene.packaged import scene_path

    path = scene_path(wanted.scene)
    hear(asked_language() or language_of(path))
    of = base(path)
    table = None
    if wanted.variants is not None:
        file = Path(wanted.variants)
        table = Table(file, read_variants(file))
    rule = FIVE if wanted.marks is None else read_rule(Path(wanted.marks))
    folder = _folder(wanted)
    where = wanted.scheduler or _processes()
    return Class(folder, of, table, rule, By(*by), asked_language(), where, wanted.limit)


def _folder(wanted: MarkedBy) -> Path:
    """Return the folder of the hand-ins; what is written must not stand among them."""
    folder = Path(wanted.folder)
    if wanted.output is not None:
        out, real = Path(wanted.output).resolve(), folder.resolve()
        if out == real or real in out.parents:
            raise click.UsageError(
                said("-o: the folder stands among what was handed in; name another one")
            )
    return folder


def _processes() -> int:
    """Return how many processors there are for this process."""
    try:
        return len(os.sched_getaffinity(0))
    except AttributeError:  # not on every system
        return os.cpu_count() or 1


def _show(marked: Marked, form: str) -> None:
    from graphic_tmm.classroom.marks.summary import summary_csv, summary_html, text_summary

    if form == "csv":
        show(summary_csv(marked), 160)
    elif form == "html":
        show(summary_html(marked), 160)
    else:
        show(text_summary(marked), 160)
