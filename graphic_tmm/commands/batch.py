"""batch: sheets, tables, notes, pages of every variant of a scene, in processes here or in a cluster."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from graphic_tmm.commands.shared.ending import WRONG
from graphic_tmm.commands.shared.options import (
    SceneName,
    chosen_forms,
    hands,
    language_of,
    limited,
    processors,
)
from graphic_tmm.commands.shared.spoken import Command
from graphic_tmm.commands.shared.telling import progress, tell, waiting
from graphic_tmm.language.reader import asked_language, hear, reader
from graphic_tmm.language.said import said

if TYPE_CHECKING:
    from graphic_tmm.classroom.batch.run import Ran
    from graphic_tmm.classroom.making import Request
    from graphic_tmm.classroom.variants.variant import Base, Variant

NAMED = 3
"""Greatest number of variants named in a message; the others are counted."""


@click.command(cls=Command)
@click.argument("scene", type=SceneName())
@click.argument("variants", type=click.Path(path_type=Path))
@click.option(
    "-o", "--output", default="out", show_default=True, help=said("Folder for all of it.")
)
@click.option(
    "--make",
    "makes",
    default="draw",
    show_default=True,
    help=said("draw, table, note, page, scene: what is made of each variant; several with commas."),
)
@click.option(
    "-f",
    "--format",
    "forms",
    help=said(
        "Formats, with commas: each of what is made takes those that it can be written as.  "
        "[default: svg, csv, md]"
    ),
)
@click.option(
    "--jobs", type=click.IntRange(1, 1000), help=said("Processes; default: one a processor.")
)
@click.option(
    "--scheduler",
    metavar="ADDRESS",
    help=said("Let the cluster of this Dask scheduler do it: tcp://10.0.0.1:8786."),
)
@click.option(
    "--anew",
    is_flag=True,
    help=said("Compose the sheets of each variant by themselves, not as those of SCENE."),
)
@limited
@hands
def batch(
    scene: str,
    variants: Path,
    output: str,
    makes: str,
    forms: str | None,
    jobs: int | None,
    scheduler: str | None,
    limit: float | None,
    anew: bool,
    hand: str | None,
    seed: int | None,
) -> None:
    """Draw every variant of SCENE that the table VARIANTS (CSV, xlsx) names; nothing is made twice."""
    from graphic_tmm.classroom.batch.run import USUAL, BrokenOff, run
    from graphic_tmm.classroom.making import Request, work
    from graphic_tmm.classroom.variants.start import start_of
    from graphic_tmm.classroom.variants.table import read_variants
    from graphic_tmm.classroom.variants.variant import base
    from graphic_tmm.scene.packaged import scene_path

    if jobs is not None and scheduler is not None:
        raise click.UsageError(
            said("--jobs are processes here, --scheduler is elsewhere: take one")
        )
    of = base(scene_path(scene))
    hear(asked_language() or language_of(of.file))
    plain = Request("", "", hand=hand, seed=seed, language=asked_language())
    plain = _formatted(plain, makes, forms)
    named = read_variants(variants)
    with waiting(said("composing the sheets of the scene")):
        plain = plain if anew else plain._replace(composition=start_of(of), lent=True)
        found, wrong = _texts(of, named, variants)
    works = [work(one.name, plain._replace(text=text, source=name)) for one, text, name in found]
    names = {one.name: variant for one, (variant, *_) in zip(works, found, strict=True)}
    try:
        with progress() as on_the_way:
            ran = run(
                works,
                Path(output),
                executor=scheduler or jobs or processors(),
                limit=limit or USUAL,
                tell=lambda done, all_, name: on_the_way(done, all_, names[name].name),
            )
    except BrokenOff as error:
        says = said(
            "{done} of {of} done; run the same command again to make the rest",
            done=error.ran.done,
            of=error.ran.of,
        )
        tell(says)
        raise
    for name, message in ran.failed.items():
        wrong[names[name].name] = _at_its_line(of, names[name], variants) or said(
            "variant {name}: {says}", name=names[name].name, says=message
        )
    _end(ran, names, [wrong[one.name] for one in named if one.name in wrong], output)


def _end(ran: Ran, names: dict[str, Variant], wrong: Sequence[str], output: str) -> None:
    """Print warnings, failures and counts; exit with a status if something was wrong."""
    lines: dict[str, list[str]] = {}
    for name, told in ran.told.items():
        for line in told:
            lines.setdefault(line, []).append(names[name].name)
    for line, some in lines.items():
        tell(said("{source}: warning: {text}", source=_listed(some), text=line))
    for says in wrong:
        tell(says)
    counts = said(
        "{folder}: {made} made, {kept} there already, {failed} failed",
        folder=output,
        made=len(ran.made),
        kept=len(ran.kept),
        failed=len(wrong),
    )
    click.echo(reader()(counts))
    if wrong:
        raise SystemExit(WRONG)


def _listed(names: Sequence[str]) -> str:
    first = ", ".join(names[:NAMED])
    more = len(names) - NAMED
    return said("{first} and {n} more", first=first, n=more) if more > 0 else first


def _formatted(plain: Request, makes: str, forms: str | None) -> Request:
    """Return the request with its outputs and formats; refuse unknown ones, and formats without an output."""
    from graphic_tmm.classroom.making import MAKES, TABLES
    from graphic_tmm.errors import SheetError
    from graphic_tmm.note.formats import FORMATS as NOTES
    from graphic_tmm.note.formats import refuse_missing
    from graphic_tmm.page import FORMAT
    from graphic_tmm.studio import FORMATS as SHEETS

    wanted = tuple(dict.fromkeys(one.strip() for one in makes.split(",")))
    if unknown := [one for one in wanted if one not in MAKES]:
        says = said(
            "--make: no {unknown}; choose from {known}",
            unknown=", ".join(unknown),
            known=", ".join(MAKES),
        )
        raise SheetError(says)
    takes = {
        "draw": (*SHEETS, FORMAT),
        "table": TABLES,
        "note": NOTES,
        "page": (FORMAT,),
        "scene": (),
    }
    known = dict.fromkeys(form for one in wanted for form in takes[one])
    asks = dict.fromkeys(chosen_forms(forms, tuple(known)) if forms else ())
    some = {one: tuple(form for form in asks if form in takes[one]) for one in wanted}
    plain = plain._replace(
        makes=wanted,
        sheets=some.get("draw") or plain.sheets,
        tables=some.get("table") or plain.tables,
        notes=some.get("note") or plain.notes,
    )
    if "note" in wanted:
        refuse_missing(plain.notes)
    return plain


def _texts(
    of: Base, variants: Sequence[Variant], table: Path
) -> tuple[list[tuple[Variant, str, str]], dict[str, str]]:
    """Return each variant with the text and the file's name of its scene; messages of those that have none."""
    from graphic_tmm.classroom.variants.variant import source_of, text_of
    from graphic_tmm.errors import SceneError

    found: list[tuple[Variant, str, str]] = []
    wrong: dict[str, str] = {}
    for one in variants:
        try:
            found.append((one, text_of(of, one, str(table)), source_of(of, one).name))
        except SceneError as error:
            wrong[one.name] = error.in_language(reader())
    return found, wrong


def _at_its_line(of: Base, variant: Variant, table: Path) -> str:
    """Return what is wrong with a variant's scene, at its line of the table; "" if the scene is good."""
    from graphic_tmm.classroom.variants.variant import scene_of
    from graphic_tmm.errors import SceneError
    from graphic_tmm.paper.lettering.letters import missing

    try:
        scene_of(of, variant, str(table), missing=missing)
    except SceneError as error:
        return error.in_language(reader())
    return ""
