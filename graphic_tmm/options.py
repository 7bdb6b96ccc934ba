"""What the commands share: options, reading a scene, telling errors and warnings, printing tables."""

from __future__ import annotations

import sys
from collections.abc import Callable
from functools import wraps
from typing import TYPE_CHECKING, Any, TypeVar

import click

if TYPE_CHECKING:
    from graphic_tmm.scene.records import Scene
    from graphic_tmm.studio import Made

F = TypeVar("F", bound=Callable[..., Any])


def people(command: F) -> F:
    """Turn every error a person can mend into one message and exit status 2."""

    @wraps(command)
    def run(*args: Any, **options: Any) -> Any:
        from graphic_tmm.errors import TmmError

        try:
            return command(*args, **options)
        except TmmError as error:
            say(f"graphic-tmm: {error}")
        except BrokenPipeError:
            sys.stderr.close()
        except OSError as error:
            place = f"{error.filename}: " if error.filename else ""
            say(f"graphic-tmm: {place}{error.strerror or error}: check the path and its rights")
        raise SystemExit(2)

    return run  # type: ignore[return-value]


def say(text: str) -> None:
    """Print to the error stream."""
    click.echo(text, err=True)


def read_scene(name: str | None, *, lettered: bool = False) -> Scene:
    """Return the scene of a path or a name; ``lettered``: refuse letters that cannot be written on a sheet."""
    from graphic_tmm.scene.read import read
    from graphic_tmm.studio import scene_path

    path = scene_path(name)
    if not lettered:
        return read(path)
    from graphic_tmm.paper.letters import missing

    return read(path, missing=missing)


def hands(command: F) -> F:
    """Give a command the options of the hand that draws."""
    for option in (
        click.option("--seed", type=click.IntRange(0, 2**31), help="Which of the hand's drawings."),
        click.option(
            "--hand",
            type=click.Choice(["exact", "cad", "careful", "student"]),
            help="Who draws; default: the scene's.",
        ),
    ):
        command = option(command)
    return command


def budgeted(command: F) -> F:
    """Give a command the option of an error to be kept within."""
    said = (
        "Largest error, such as 2%: take the cheapest setting that keeps every quantity within it."
    )
    return click.option("--budget", help=said)(command)


def within(scene: Scene, budget: str | None) -> Scene:
    """Return the scene at the cheapest setting within a budget; tell which it is."""
    if budget is None:
        return scene
    from graphic_tmm.accuracy import road

    taken = road.within(scene, budget)
    say(f"graphic-tmm: {scene.source}: {taken.sentence}")
    return taken.scene


def drawn_by(scene: Scene, hand: str | None, seed: int | None) -> Scene:
    """Return the scene drawn by another hand, with that hand's own ruler."""
    from dataclasses import replace

    from graphic_tmm.scene.build import DIVISIONS

    if hand is not None:
        scene = replace(scene, hand=hand, ruler=DIVISIONS[hand])
    return scene if seed is None else replace(scene, seed=seed)


def warn(made: Made, *, sheets: bool = False) -> None:
    """Tell what of a scene comes to nothing or could not be drawn; ``sheets``: and what no sheet shows."""
    from graphic_tmm.scene.remarks import unplaced
    from graphic_tmm.studio import part_warnings, warnings

    told = [*made.scene.remarks, *(unplaced(made.scene) if sheets else ())]
    told += list(warnings(made.work)) if made.work is not None else []
    told += [text for part in made.parts for text in part_warnings(part)]
    for text in told:
        say(f"graphic-tmm: {made.scene.source}: warning: {text}")


def terminal_width() -> int:
    """Return how many characters a line of the terminal has, many if nothing is printed to one."""
    import shutil

    from graphic_tmm.studio import WIDTH

    return shutil.get_terminal_size().columns if sys.stdout.isatty() else WIDTH


def show(text: str | list[Any], width: int) -> None:
    """Print text, or what rich makes of tables; so wide if this is no terminal."""
    if isinstance(text, str):
        click.echo(text, nl=False)
        return
    from rich.console import Console
    from rich.measure import Measurement
    from rich.table import Table

    console = Console(width=None if sys.stdout.isatty() else width)
    for part in text:
        wide = console.options.update(max_width=10_000)
        needed = Measurement.get(console, wide, part).maximum if isinstance(part, Table) else 0
        console.print(part, width=max(console.width, needed))
