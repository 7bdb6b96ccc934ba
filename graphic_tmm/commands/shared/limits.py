"""How long one piece of work may take: a time on the command line."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any, TypeVar

import click

from graphic_tmm.commands.shared.scenes import ParamType
from graphic_tmm.language.said import said

F = TypeVar("F", bound=Callable[..., Any])
LEAST, MOST = 0.1, 864_000.0
"""A limit lies between these, s."""


class Time(ParamType):
    """A time with its unit, as in a scene; a bare number is of seconds, as there."""

    name = "time"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return s; refuse what is none, or no limit."""
        from graphic_tmm.scene.quantities import NUMBER, parse

        if not isinstance(value, str):
            return value
        bare = re.fullmatch(rf"\s*{NUMBER}\s*", value)
        try:
            seconds = parse(f"{value} s" if bare else value, "time")
        except ValueError as error:
            self.fail(error.args[0], param, ctx)
        if not LEAST <= seconds <= MOST:
            self.fail(said('"{value}" is no limit; write a time such as "10 min"', value=value))
        return seconds


def limited(command: F) -> F:
    """Give a command the option of how long one piece of its work may take; None if nobody says."""
    return click.option(
        "--limit",
        type=Time(),
        metavar="TIME",
        help=said(
            "What takes longer is broken off and named, the rest is made: 90 s, 10 min.  [default: 10 min]"
        ),
    )(command)
