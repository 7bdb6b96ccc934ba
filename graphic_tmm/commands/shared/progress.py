"""How far a command is, told on the error stream."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from threading import Timer
from typing import TYPE_CHECKING

from graphic_tmm.commands.shared.spoken import quiet
from graphic_tmm.language.reader import reader

if TYPE_CHECKING:
    from graphic_tmm.accuracy.study import Tell

PATIENCE = 1.0
"""What takes longer than this, s, is told."""


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
