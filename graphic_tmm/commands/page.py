"""page: a scene as one page for a browser."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from graphic_tmm.commands.shared.options import SceneName, drawn_by, hands, read_scene
from graphic_tmm.commands.shared.spoken import Command
from graphic_tmm.commands.shared.telling import waiting, warn
from graphic_tmm.language.said import said

if TYPE_CHECKING:
    from graphic_tmm.accuracy.answer import Answer
    from graphic_tmm.scene.records import Scene


@click.command(cls=Command)
@click.argument("scene", required=False, type=SceneName())
@click.option("-o", "--output", default="out", show_default=True, help=said("Folder for the page."))
@click.option(
    "--practice",
    is_flag=True,
    help=said(
        "With what lets a person draw the plans himself; --seed then poses each at another angle of the crank."
    ),
)
@click.option(
    "--accuracy",
    "weigh",
    is_flag=True,
    help=said(
        "With what accuracy costs and, beside each plan, where its errors come from (seconds more)."
    ),
)
@hands
def page(
    scene: str | None,
    output: str,
    practice: bool,
    weigh: bool,
    hand: str | None,
    seed: int | None,
) -> None:
    """Write SCENE as one page for a browser: its plans play step by step, its sheets lie beside."""
    from functools import partial

    from graphic_tmm.files import write
    from graphic_tmm.fitting.composition import composition_file, read_composition
    from graphic_tmm.page import FORMAT
    from graphic_tmm.page.page import page as written
    from graphic_tmm.studio import sheet_files

    task = drawn_by(read_scene(scene, lettered=True), hand, None if practice else seed)
    given = read_composition(composition_file(task.source))
    with waiting(said("choosing scale factors and composing the sheets")):
        weighed = _weighed(task) if weigh else None
        whole = partial(written, practised=practice, seed=seed, weighed=weighed)
        made, texts = sheet_files(task, (FORMAT,), given=given, whole={FORMAT: whole})
    for path in write(Path(output), texts, remedy=said("name another folder with -o")):
        click.echo(str(path))
    warn(made, sheets=True)


def _weighed(task: Scene) -> Answer:
    """Return what accuracy costs in a scene."""
    from graphic_tmm.accuracy.answer import answer
    from graphic_tmm.accuracy.cost_figure import plotting

    plotting()
    return answer(task)
