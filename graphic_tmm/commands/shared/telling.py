"""What commands print: messages to people, warnings of a drawn scene, tables; how far they are."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from threading import Timer
from typing import TYPE_CHECKING, Any

import click

from graphic_tmm.commands.shared.spoken import quiet
from graphic_tmm.language.reader import reader
from graphic_tmm.language.said import said

if TYPE_CHECKING:
    from graphic_tmm.accuracy.budget import Tell
    from graphic_tmm.drawn import DrawnScene


_FORCED = ("FORCE_COLOR", "TTY_COMPATIBLE")
"""What has rich take for a terminal whatever it prints to."""


def say(text: str) -> None:
    """Print lines to the error stream; what would act on a terminal, as its escape."""
    from graphic_tmm.errors import printable

    click.echo("\n".join(printable(line) for line in text.split("\n")), err=True)


def tell(text: str) -> None:
    """Print a message of the program in the reader's language."""
    say(f"graphic-tmm: {reader()(text)}")


def warn(made: DrawnScene, *, sheets: bool = False) -> None:
    """Print the warnings of a drawn scene; ``sheets``: also of what no sheet shows."""
    from graphic_tmm.readers.findings import all_warnings

    for text in all_warnings(made, reader().language, sheets=sheets):
        tell(said("{source}: warning: {text}", source=made.scene.source, text=text))


def terminal_width() -> int:
    """Return how many characters a line of the terminal has, many if nothing is printed to one."""
    import shutil

    from graphic_tmm.readers.table import WIDTH

    return shutil.get_terminal_size().columns if sys.stdout.isatty() else WIDTH


def show(text: str | list[Any], width: int, output: str | None = None) -> None:
    """Print text, or what rich makes of tables, so wide if this is no terminal; or write it into a file.

    ``output``: the file's name, which is printed then.

    Raises
    ------
    SheetError
        If the file cannot be written; nothing is left behind then.
    """
    if output is None:
        click.echo(rendered(text, width), nl=False)
        return
    from pathlib import Path

    from graphic_tmm.files import write

    file = Path(output)
    written = {file.name: rendered(text, width, printed=False)}
    for path in write(file.parent, written, remedy=said("name another file with -o")):
        click.echo(str(path))


def rendered(text: str | list[Any], width: int, *, printed: bool = True) -> str:
    """Return what is printed; or what goes into a file, without what only a terminal shows."""
    if isinstance(text, str):
        return text
    terminal = printed and sys.stdout.isatty()
    if (framed := _without_rich(text, width, printed=printed)) is not None:
        return framed
    from io import StringIO
    from itertools import chain

    from rich.console import Console
    from rich.measure import Measurement
    from rich.table import Table

    from graphic_tmm.readers.text import Framed

    console = Console(width=None if terminal else width, file=None if printed else StringIO())
    with console.capture() as written:  # rich has an end of its own for a reader who is gone
        for part in chain.from_iterable(
            one.parts() if isinstance(one, Framed) else (one,) for one in text
        ):
            wide = console.options.update(max_width=10_000)
            needed = Measurement.get(console, wide, part).maximum if isinstance(part, Table) else 0
            console.print(part, width=max(console.width, needed))
    return written.get()


def _without_rich(tables: list[Any], width: int, *, printed: bool) -> str | None:
    """Return tables as text where nothing is bold, italic or coloured; None where that is for rich to print."""
    from graphic_tmm.readers.text import Framed

    told = sys.stdout.encoding or ""
    rich = sys.stdout.isatty() or not told.lower().startswith("utf") or any(map(os.getenv, _FORCED))
    if printed and rich:
        return None
    found = [one.plain(width) if isinstance(one, Framed) else None for one in tables]
    return None if None in found else "".join(filter(None, found))


PATIENCE = 1.0
"""Work that takes longer than this, s, is announced."""


@contextmanager
def waiting(what: str) -> Iterator[None]:
    """Show a line on the error stream as long as something takes, from a second on; nothing if no terminal."""
    if quiet() or not sys.stderr.isatty():
        yield
        return
    from rich.console import Console

    status = Console(stderr=True).status(reader()(what))
    late = Timer(PATIENCE, status.start)
    late.daemon = True
    late.start()
    try:
        yield
    finally:
        late.cancel()
        late.join()
        status.stop()


@contextmanager
def progress() -> Iterator[Tell]:
    """Show a bar on the error stream; nothing if that is no terminal."""
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

    console = Console(stderr=True)
    columns = (BarColumn(), TextColumn("{task.completed}/{task.total}"), TimeRemainingColumn())
    hidden = quiet() or not console.is_terminal
    with Progress(
        *columns, TextColumn("{task.description}"), console=console, transient=True, disable=hidden
    ) as bar:
        task = bar.add_task("", total=1)

        def tell(done: int, of: int, name: str) -> None:
            bar.update(task, completed=done, total=of, description=name)

        yield tell
