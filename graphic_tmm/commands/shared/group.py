"""The commands that there are: the files of `graphic_tmm.commands`, found by being there."""

from __future__ import annotations

import pkgutil
from importlib import import_module

import click

from graphic_tmm.commands.shared.ending import People

HOME = "graphic_tmm.commands"


class Commands(People):
    """A file `name.py` holds the command `name`; it is loaded when that, or the help of all, is asked for."""

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
