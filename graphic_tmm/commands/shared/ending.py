"""The commands that there are, and how they end: every error is one message, every end has its exit status."""

from __future__ import annotations

import gc
import pkgutil
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from importlib import import_module
from typing import Any

import click

from graphic_tmm.commands.shared.spoken import (
    SpokenGroup,
    click_speaking,
    in_words_of,
    language_asked,
)
from graphic_tmm.commands.shared.telling import tell
from graphic_tmm.language.reader import reader, reading
from graphic_tmm.language.said import said

FINE, WRONG, BAD, NOT_SEEN, FAULT, BROKEN_OFF, NO_READER = 0, 1, 2, 3, 70, 130, 141
"""Exit statuses: success; a check found something; bad input; a photograph does not show all that was asked
for; a fault of the program; Ctrl-C; the reader of the output is gone (the last two as shells report SIGINT and
SIGPIPE)."""

SELDOM = 100_000
"""Threshold of the garbage collector while a command runs: allocations minus deallocations."""


class People(SpokenGroup):
    """The commands as a person calls them: every error is one message, and every end has its own status."""

    def main(self, *args: Any, **options: Any) -> Any:
        """Run a command and exit with its status; see the statuses above."""
        from graphic_tmm.files import call

        options["standalone_mode"] = False
        given = options.get("args", args[0] if args else None)
        asked = language_asked(sys.argv[1:] if given is None else given)
        with _collecting_seldom(), reading(asked), click_speaking():
            try:
                with call():
                    ended = super().main(*args, **options)
                sys.stdout.flush()
            except (Exception, KeyboardInterrupt, SystemExit) as error:
                ended = _ended(error)
        sys.exit(ended if isinstance(ended, int) else FINE)

    def make_context(self, *args: Any, **options: Any) -> click.Context:
        """Understand the command line; help may be asked for, and its reader gone."""
        with _piped():
            return super().make_context(*args, **options)

    def invoke(self, ctx: click.Context) -> Any:
        """Run the command; its reader may be gone."""
        with _piped():
            return super().invoke(ctx)


@contextmanager
def _collecting_seldom() -> Iterator[None]:
    """Look for cycles of objects seldom within: a drawing makes many objects, of which next to all stay."""
    before = gc.get_threshold()
    gc.set_threshold(SELDOM, *before[1:])
    try:
        yield
    finally:
        gc.set_threshold(*before)


@contextmanager
def _piped() -> Iterator[None]:
    """End with a status of its own when the reader is gone, before click ends with 1."""
    try:
        yield
    except BrokenPipeError:
        raise click.exceptions.Exit(_hushed()) from None


def _ended(error: BaseException) -> int:
    """Tell a person what has ended the program; return the exit status."""
    from graphic_tmm.errors import TmmError, reason_of

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
        what = reason_of(error)
        tell(said("{place}{what}: check the path and its rights", place=place, what=what))
    elif isinstance(error, TmmError):
        tell(error.in_language(reader()))
    else:
        return _own_fault(error)
    return BAD


def _own_fault(error: BaseException) -> int:
    """Report an unforeseen error: it is the program's, not the person's."""
    import os
    import traceback

    from graphic_tmm.errors import TRACEBACK, own_fault

    if os.environ.get(TRACEBACK):
        traceback.print_exception(error)
    tell(own_fault(error))
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


HOME = "graphic_tmm.commands"


class Commands(People):
    """The commands: `name.py` holds the command `name`, loaded when it runs or when all are listed."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Return the names of the commands, sorted."""
        files = pkgutil.iter_modules(import_module(HOME).__path__)
        return sorted(file.name for file in files if not file.ispkg)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Return a command; None if there is none of that name."""
        if cmd_name not in self.list_commands(ctx):
            return None
        found: click.Command = getattr(import_module(f"{HOME}.{cmd_name}"), cmd_name)
        return found
