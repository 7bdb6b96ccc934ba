"""new: a scene to begin with."""

from __future__ import annotations

from pathlib import Path

import click

from graphic_tmm.commands.shared.spoken import Command
from graphic_tmm.language.said import said


@click.command(cls=Command)
@click.argument("folder")
@click.option("--like", help=said("Scene to begin with; the default scene if left out."))
def new(folder: str, like: str | None) -> None:
    """Begin a scene of your own: FOLDER/scene.toml, a copy to change."""
    from graphic_tmm.errors import Fault, SceneError
    from graphic_tmm.files import write
    from graphic_tmm.scene.document import document
    from graphic_tmm.scene.new import begun
    from graphic_tmm.scene.read import FILE, SCENE, read
    from graphic_tmm.scenes import scene_path

    target = Path(folder)
    if (target / FILE).exists():
        fault = Fault("", 0, said("it exists already; choose another folder"))
        raise SceneError(str(target / FILE), (fault,))
    source = scene_path(like)
    file = source / FILE if source.is_dir() else source
    read(file)
    for path in write(target, begun(document(file, SCENE)[0])):
        click.echo(str(path))
