"""The scene of a command: read by its path or name, drawn by the hand that is asked for."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeVar

import click

from graphic_tmm.language.reader import asked, hear
from graphic_tmm.language.said import said

if TYPE_CHECKING:
    from pathlib import Path

    from graphic_tmm.scene.records import Scene

if TYPE_CHECKING:
    ParamType = click.ParamType[str]
else:
    ParamType = click.ParamType  # no generic class before click 8.2

F = TypeVar("F", bound=Callable[..., Any])


class SceneName(ParamType):
    """A scene: a path, the name of one that comes with the package, or - for standard input."""

    name = "scene"

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[Any]:
        """Return the names of scenes that begin so, and what a shell knows of files."""
        from click.shell_completion import CompletionItem

        from graphic_tmm.scene.packaged import packaged

        names = [path.name for path in packaged() if path.name.startswith(incomplete)]
        return [*map(CompletionItem, names), CompletionItem(incomplete, type="file")]


def read_scene(name: str | None, *, lettered: bool = False) -> Scene:
    """Return the scene of a path or a name, in the language that was asked for.

    ``lettered``: refuse letters that cannot be written on a sheet.
    """
    from graphic_tmm.scene.packaged import scene_path
    from graphic_tmm.scene.read import read

    path = scene_path(name)
    hear(language_of(path))
    if lettered:
        from graphic_tmm.paper.lettering.letters import missing

        scene = read(path, missing=missing)
    else:
        scene = read(path)
    language = asked() or scene.language
    hear(language)
    return scene.spoken_in(language)


def language_of(path: Path) -> str:
    """Return the language that a scene's file asks for, however wrong the rest of it is; "" if none."""
    from graphic_tmm.scene.document import LOOKED, spoken
    from graphic_tmm.scene.read import FILE

    file = path / FILE if path.is_dir() else path
    if not file.is_file():
        return ""
    try:
        with file.open(encoding="utf-8", errors="replace") as stream:
            return spoken(stream.read(LOOKED))
    except OSError:
        return ""


def hands(command: F) -> F:
    """Give a command the options of the hand that draws."""
    for option in (
        click.option(
            "--seed", type=click.IntRange(0, 2**31), help=said("Which of the hand's drawings.")
        ),
        click.option(
            "--hand",
            type=click.Choice(["exact", "cad", "careful", "student"]),
            help=said("Who draws; default: the scene's."),
        ),
    ):
        command = option(command)
    return command


def drawn_by(scene: Scene, hand: str | None, seed: int | None) -> Scene:
    """Return the scene drawn by another hand, with that hand's own ruler."""
    from graphic_tmm.scene.build import drawn_by as drawn

    return drawn(scene, hand, seed)
