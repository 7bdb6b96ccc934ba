"""note: the explanatory note of a scene as files."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from graphic_tmm.commands.shared.options import chosen_forms, drawn_by, hands, read_scene
from graphic_tmm.commands.shared.spoken import Command
from graphic_tmm.commands.shared.telling import waiting, warn
from graphic_tmm.language.said import said

if TYPE_CHECKING:
    from collections.abc import Iterable

    from graphic_tmm.note.document import Block
    from graphic_tmm.scene.records import Scene


@click.command(cls=Command)
@click.argument("scene", required=False)
@click.option("-o", "--output", default="out", show_default=True, help=said("Folder for the note."))
@click.option(
    "-f",
    "--format",
    "forms",
    default="pdf",
    show_default=True,
    help=said("pdf, html, docx, md; several with commas."),
)
@click.option(
    "--accuracy",
    "weighed",
    is_flag=True,
    help=said(
        "With a section on how exact the constructions are and what accuracy costs (seconds more)."
    ),
)
@hands
def note(
    scene: str | None, output: str, forms: str, weighed: bool, hand: str | None, seed: int | None
) -> None:
    """Write the explanatory note of SCENE: task, structure, plans with their calculations, conclusions."""
    from graphic_tmm.files import write
    from graphic_tmm.fitting.composition import composition_file, read_composition
    from graphic_tmm.note.formats import FORMATS, refuse_missing
    from graphic_tmm.note.note import note_files
    from graphic_tmm.note.note import wanted as drawn_for
    from graphic_tmm.scene.packaged import scene_name
    from graphic_tmm.studio import make

    wanted = chosen_forms(forms, FORMATS)
    refuse_missing(wanted)
    task = drawn_by(read_scene(scene, lettered=True), hand, seed)
    given = read_composition(composition_file(task.source))
    with waiting(said("choosing scale factors and writing the note")):
        made = make(task, wanted=drawn_for(task), given=given)
        further = _accuracy(task) if weighed else ()
        texts = note_files(made, f"{scene_name(task.source)}-note", wanted, further)
    for path in write(Path(output), texts, remedy=said("name another folder with -o")):
        click.echo(str(path))
    warn(made)


def _accuracy(task: Scene) -> Iterable[Block]:
    """Return the section on the accuracy of a scene's constructions."""
    from graphic_tmm.accuracy.answer import answer
    from graphic_tmm.accuracy.cost_figure import plotting
    from graphic_tmm.accuracy.note_section import accuracy_section

    plotting()
    return accuracy_section(answer(task))
