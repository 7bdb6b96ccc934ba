"""How far a command is, told on the error stream."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from graphic_tmm.accuracy.study import Tell


@contextmanager
def progress() -> Iterator[Tell]:
    """Show a bar on the error stream; nothing if that is no terminal."""
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

    console = Console(stderr=True)
    columns = (BarColumn(), TextColumn("{task.completed}/{task.total}"), TimeRemainingColumn())
    hidden = not console.is_terminal
    with Progress(
        *columns, TextColumn("{task.description}"), console=console, transient=True, disable=hidden
    ) as bar:
        task = bar.add_task("", total=1)

        def tell(done: int, of: int, name: str) -> None:
            bar.update(task, completed=done, total=of, description=name)

        yield tell
