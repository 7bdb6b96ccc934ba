"""Numbers of the command line."""

from __future__ import annotations

from typing import Any

import click

from graphic_tmm.language.said import said


class Finite(click.FloatRange):
    """A number between bounds; what is not a number lies between none."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return the number; refuse nan, which no comparison finds out of bounds."""
        number = super().convert(value, param, ctx)
        if number != number:
            self.fail(said("{value} is not a finite number", value=value), param, ctx)
        return number
