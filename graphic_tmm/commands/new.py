"""new: a scene to begin with."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from graphic_tmm.commands.shared.scenes import ParamType, SceneName
from graphic_tmm.commands.shared.spoken import Command
from graphic_tmm.language.reader import reader
from graphic_tmm.language.said import said

if TYPE_CHECKING:
    from graphic_tmm.commands.shared.beginnings import Beginning


class Mechanism(ParamType):
    """The name of a mechanism to begin with."""

    name = "mechanism"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> str:
        """Return the name; refuse one that there is not."""
        from graphic_tmm.commands.shared.beginnings import BEGINNINGS

        known = [one.name for one in BEGINNINGS]
        if value not in known:
            listed = ", ".join(known)
            self.fail(said("{value!r} is not one of {choices}.", value=value, choices=listed))
        return str(value)

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[Any]:
        """Return the names that begin so."""
        from click.shell_completion import CompletionItem

        from graphic_tmm.commands.shared.beginnings import BEGINNINGS

        return [
            CompletionItem(one.name, help=reader()(one.says))
            for one in BEGINNINGS
            if one.name.startswith(incomplete)
        ]


@click.command(cls=Command)
@click.argument("folder", required=False)
@click.argument("mechanism", required=False, type=Mechanism())
@click.option("--like", type=SceneName(), help=said("Copy a whole scene instead."))
@click.option("--list", "listed", is_flag=True, help=said("List the mechanisms to begin with."))
def new(folder: str | None, mechanism: str | None, like: str | None, listed: bool) -> None:
    """Begin a scene of your own: FOLDER/scene.toml with a MECHANISM, or a copy of another scene.

    Further sections stand in it as comments, with defaults. Without a MECHANISM the terminal asks.
    """
    from graphic_tmm.commands.shared.beginnings import beginning

    if listed:
        click.echo("\n".join(_lines()))
        return
    if folder is None:
        raise click.UsageError(said("name the FOLDER of the new scene, or ask for --list"))
    if mechanism is not None and like is not None:
        raise click.UsageError(said("--like copies a whole scene: leave the MECHANISM out"))
    _refuse_old(Path(folder))
    if mechanism is None and like is None and _on_terminal():
        mechanism = _chosen()
    one = None if mechanism is None else beginning(mechanism)
    _write(Path(folder), one, like)


def _on_terminal() -> bool:
    """Whether somebody can be asked."""
    return sys.stdin.isatty()


def _lines() -> list[str]:
    """Return a line for each mechanism, in the reader's language."""
    from graphic_tmm.commands.shared.beginnings import BEGINNINGS

    width = max(len(one.name) for one in BEGINNINGS)
    return [f"{one.name:<{width}}  {reader()(one.says)}" for one in BEGINNINGS]


def _chosen() -> str:
    """Ask on the terminal for a mechanism; return its name."""
    click.echo("\n".join(_lines()), err=True)
    asked_for = reader()(said("Which mechanism?"))
    name: str = click.prompt(asked_for, type=Mechanism(), err=True)
    return name


def _refuse_old(target: Path) -> None:
    from graphic_tmm.errors import Fault, SceneError
    from graphic_tmm.scene.read import FILE

    if (target / FILE).exists():
        fault = Fault("", 0, said("it exists already; choose another folder"))
        raise SceneError(str(target / FILE), (fault,))


def _write(target: Path, one: Beginning | None, like: str | None) -> None:
    """Write the files of a new scene, and tell their names."""
    from graphic_tmm.commands.shared.beginnings import link_name
    from graphic_tmm.files import write
    from graphic_tmm.scene.document import document
    from graphic_tmm.scene.new import begun, begun_with
    from graphic_tmm.scene.packaged import scene_path
    from graphic_tmm.scene.read import FILE, SCENE, read

    source = scene_path(like if one is None else one.scene)
    file = source / FILE if source.is_dir() else source
    read(file)
    text = document(file, SCENE)[0]
    speech = reader()
    files = begun_with(text, one.title, speech, link_name) if one else begun(text, speech)
    for path in write(target, files):
        click.echo(str(path))
