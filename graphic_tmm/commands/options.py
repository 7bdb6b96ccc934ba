"""What the commands share: how they end, options, reading a scene, telling warnings, printing tables."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import replace
from typing import TYPE_CHECKING, Any, TypeVar

import click

from graphic_tmm.commands.spoken import (
    Command,
    click_speaking,
    in_words_of,
    language_asked,
    language_option,
    translated,
)
from graphic_tmm.language.catalogue import languages
from graphic_tmm.language.reader import hear, reader, reading
from graphic_tmm.language.said import said

if TYPE_CHECKING:
    from pathlib import Path

    from graphic_tmm.scene.records import Scene
    from graphic_tmm.studio import Made

F = TypeVar("F", bound=Callable[..., Any])

FINE, WRONG, BAD, FAULT, BROKEN_OFF, NO_READER = 0, 1, 2, 70, 130, 141
"""Exit statuses: all well; a check has found something; the input is bad; the program is at fault; Ctrl-C;
nobody reads what is printed (the last two as a shell tells them of SIGINT and SIGPIPE)."""
TRACEBACK = "GRAPHIC_TMM_TRACEBACK"
"""The variable of the environment by which a fault of the program shows where it is."""


class People(click.Group):
    """The commands as a person calls them: every error is one message, and every end has its own status."""

    command_class = Command

    def __init__(self, *args: Any, **options: Any) -> None:
        super().__init__(*args, **options)
        self.params.append(language_option())

    def main(self, *args: Any, **options: Any) -> Any:
        """Run a command and exit with its status; see the statuses above."""
        from graphic_tmm.files import call

        options["standalone_mode"] = False
        given = options.get("args", args[0] if args else None)
        with reading(language_asked(sys.argv[1:] if given is None else given)), click_speaking():
            try:
                with call():
                    ended = super().main(*args, **options)
                sys.stdout.flush()
            except (Exception, KeyboardInterrupt, SystemExit) as error:
                ended = _ended(error)
        sys.exit(ended if isinstance(ended, int) else FINE)

    def get_help(self, ctx: click.Context) -> str:
        """Return the help in the reader's language, with all commands."""
        shown = translated(self, reader())
        shown.commands = {name: translated(one, reader()) for name, one in self.commands.items()}
        return click.Group.get_help(shown, ctx)

    def make_context(self, *args: Any, **options: Any) -> click.Context:
        """Understand the command line; help may be asked for, and its reader gone."""
        with _piped():
            return super().make_context(*args, **options)

    def invoke(self, ctx: click.Context) -> Any:
        """Run the command; its reader may be gone."""
        with _piped():
            return super().invoke(ctx)


@contextmanager
def _piped() -> Iterator[None]:
    """End with a status of its own when the reader is gone, before click ends with 1."""
    try:
        yield
    except BrokenPipeError:
        raise click.exceptions.Exit(_hushed()) from None


def _ended(error: BaseException) -> int:
    """Tell a person what has ended the program; return the exit status."""
    from graphic_tmm.errors import TmmError

    if isinstance(error, BrokenPipeError):
        return _hushed()
    if isinstance(error, SystemExit):
        return error.code if isinstance(error.code, int) else FINE if error.code is None else BAD
    if isinstance(error, (KeyboardInterrupt, click.Abort)):
        return BROKEN_OFF
    if isinstance(error, click.ClickException):
        in_words_of(reader(), error).show()
    elif isinstance(error, OSError):
        place = f"{error.filename}: " if error.filename else ""
        what = str(error.strerror or error)
        tell(said("{place}{what}: check the path and its rights", place=place, what=what))
    elif isinstance(error, TmmError):
        tell(error.told(reader()))
    else:
        return _own_fault(error)
    return BAD


def _own_fault(error: BaseException) -> int:
    """Tell of an error that nobody has foreseen: it is the program's, not the person's."""
    import os
    import traceback

    if os.environ.get(TRACEBACK):
        traceback.print_exception(error)
    what = " ".join(f"{type(error).__name__}: {error}".split()).rstrip(":")
    tell(
        said(
            "a fault of the program, not of the input ({what}); set {variable}=1 to see where, and "
            "report it",
            what=what[:200],
            variable=TRACEBACK,
        )
    )
    return FAULT


def _hushed() -> int:
    """Let nothing more be written to a reader who is gone, nor be complained of at the end."""
    import os

    nowhere = os.open(os.devnull, os.O_WRONLY)
    for stream in (sys.stdout, sys.stderr):
        with suppress(OSError, ValueError):  # it is no stream of the system
            os.dup2(nowhere, stream.fileno())
    os.close(nowhere)
    return NO_READER


def say(text: str) -> None:
    """Print lines to the error stream; what would act on a terminal, as its escape."""
    from graphic_tmm.errors import printable

    click.echo("\n".join(printable(line) for line in text.split("\n")), err=True)


def tell(text: str) -> None:
    """Print a message of the program in the reader's language."""
    say(f"graphic-tmm: {reader()(text)}")


def read_scene(name: str | None, *, lettered: bool = False) -> Scene:
    """Return the scene of a path or a name; ``lettered``: refuse letters that cannot be written on a sheet."""
    from graphic_tmm.scene.read import read
    from graphic_tmm.studio import scene_path

    path = scene_path(name)
    hear(language_of(path))
    if lettered:
        from graphic_tmm.paper.lettering.letters import missing

        return read(path, missing=missing)
    return read(path)


def language_of(path: Path) -> str:
    """Return the language that a scene's file asks for, right or wrong as the rest of it may be; "" if none."""
    import re
    from contextlib import suppress

    from graphic_tmm.scene.read import FILE

    with suppress(OSError, ValueError):
        file = path / FILE if path.is_dir() else path
        if file.is_file():
            with file.open(encoding="utf-8", errors="replace") as stream:
                found = re.search(
                    r"""^language\s*=\s*["'](\w+)["']""", stream.read(256_000), re.MULTILINE
                )
            return found[1] if found is not None and found[1] in languages() else ""
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


class Finite(click.FloatRange):
    """A number between bounds; what is not a number lies between none."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return the number; refuse nan, which no comparison finds out of bounds."""
        number = super().convert(value, param, ctx)
        if number != number:
            self.fail(said("{value} is not a finite number", value=value), param, ctx)
        return number


def budgeted(command: F) -> F:
    """Give a command the option of an error to be kept within."""
    return click.option(
        "--budget",
        help=said(
            "Largest error, such as 2%: take the cheapest setting that keeps every quantity within "
            "it."
        ),
    )(command)


def within(scene: Scene, budget: str | None) -> Scene:
    """Return the scene at the cheapest setting within a budget; tell which it is."""
    if budget is None:
        return scene
    from graphic_tmm.accuracy import run as road

    taken = road.within(scene, budget)
    tell(f"{scene.source}: {taken.sentence}")
    return taken.scene


def drawn_by(scene: Scene, hand: str | None, seed: int | None) -> Scene:
    """Return the scene drawn by another hand, with that hand's own ruler."""
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
        tell(said("{source}: warning: {text}", source=made.scene.source, text=text))


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
    with console.capture() as written:  # rich has an end of its own for a reader who is gone
        for part in text:
            wide = console.options.update(max_width=10_000)
            needed = Measurement.get(console, wide, part).maximum if isinstance(part, Table) else 0
            console.print(part, width=max(console.width, needed))
    click.echo(written.get(), nl=False)
