"""page: a scene as one page for a browser, or all scenes of a folder with a gallery."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from graphic_tmm.commands.shared.options import SceneName, drawn_by, hands, read_scene
from graphic_tmm.commands.shared.spoken import Command
from graphic_tmm.commands.shared.telling import progress, waiting, warn
from graphic_tmm.language.said import said

if TYPE_CHECKING:
    from graphic_tmm.accuracy.answer import Answer
    from graphic_tmm.drawn import DrawnScene
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
@click.option(
    "--all",
    "every",
    is_flag=True,
    help=said(
        "All scenes of the folder SCENE, or of the package, and a gallery that leads to them, index.html."
    ),
)
@hands
def page(
    scene: str | None,
    output: str,
    practice: bool,
    weigh: bool,
    every: bool,
    hand: str | None,
    seed: int | None,
) -> None:
    """Write SCENE as one page for a browser: its plans play step by step, its sheets lie beside."""
    from functools import partial

    from graphic_tmm.files import write
    from graphic_tmm.page import FORMAT

    drawn = partial(_drawn, practice=practice, weigh=weigh, hand=hand, seed=seed)
    if every:
        made, texts = _gallery(scene, drawn)
    else:
        with waiting(said("choosing scale factors and composing the sheets")):
            one, texts = drawn(scene, (FORMAT,))
        made = [one]
    for path in write(Path(output), texts, remedy=said("name another folder with -o")):
        click.echo(str(path))
    for one in made:
        warn(one, sheets=True)


def _drawn(
    name: str | None,
    forms: Sequence[str],
    *,
    practice: bool,
    weigh: bool,
    hand: str | None,
    seed: int | None,
) -> tuple[DrawnScene, dict[str, str | bytes]]:
    """Return a scene drawn, and the files of it in some forms."""
    from functools import partial

    from graphic_tmm.fitting.composition import composition_file, read_composition
    from graphic_tmm.page import FORMAT
    from graphic_tmm.page.page import page as written
    from graphic_tmm.studio import sheet_files

    task = drawn_by(read_scene(name, lettered=True), hand, None if practice else seed)
    given = read_composition(composition_file(task.source))
    weighed = _weighed(task) if weigh else None
    whole = partial(written, practised=practice, seed=seed, weighed=weighed)
    return sheet_files(task, forms, given=given, whole={FORMAT: whole})


def _gallery(
    place: str | None, drawn: Callable[..., tuple[DrawnScene, dict[str, str | bytes]]]
) -> tuple[list[DrawnScene], dict[str, str | bytes]]:
    """Return all scenes of a folder, or of the package, drawn; their pages, first sheets and gallery."""
    from graphic_tmm.language.reader import asked_language
    from graphic_tmm.page import FORMAT
    from graphic_tmm.page.gallery import Card, galleries

    title, files = _scenes_of(place)
    made, cards, texts = [], [], dict[str, str | bytes]()
    with progress() as on_the_way:
        for k, (name, file) in enumerate(files.items()):
            on_the_way(k, len(files), name)
            one, found = drawn(str(file), ("svg", FORMAT))
            (page_file,) = (file for file in found if file.endswith(FORMAT))
            picture = next(file for file in found if file.endswith("svg"))
            made.append(one)
            cards.append(Card(name, one.scene.title, one.scene.language, page_file, picture))
            texts |= {file: found[file] for file in (page_file, picture)}
    return made, texts | galleries(cards, title, asked_language())


def _scenes_of(place: str | None) -> tuple[str, Mapping[str, Path]]:
    """Return the title of a folder of scenes, and their files by name; those of the package without one.

    Raises
    ------
    SceneError
        If there is no such folder.
    SheetError
        If no scene stands in it.
    """
    from graphic_tmm.errors import SheetError, printable
    from graphic_tmm.scene.packaged import FILE, packaged
    from graphic_tmm.serve.folder import folder_of

    if place is None:
        title = said("Scenes that come with graphic_tmm")
        return title, {path.name: path / FILE for path in packaged()}
    folder = folder_of(place)
    if not (found := folder.scenes()):
        raise SheetError(said("{folder}: no scene stands there", folder=printable(place)))
    return folder.root.name, found


def _weighed(task: Scene) -> Answer:
    """Return what accuracy costs in a scene."""
    from graphic_tmm.accuracy.answer import answer
    from graphic_tmm.accuracy.cost_figure import plotting

    plotting()
    return answer(task)
