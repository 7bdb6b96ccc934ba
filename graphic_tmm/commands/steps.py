"""steps: the protocol of a plan."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click

from graphic_tmm.commands.shared.progress import waiting
from graphic_tmm.commands.shared.scenes import SceneName, read_scene
from graphic_tmm.commands.shared.spoken import Command
from graphic_tmm.commands.shared.telling import warn
from graphic_tmm.language.said import said

if TYPE_CHECKING:
    Choice = click.Choice[str]
else:
    Choice = click.Choice  # no generic class before click 8.2


class Plans(Choice):
    """The plans of all chapters, looked up when one is asked for: help of other commands stays light."""

    def __init__(self) -> None:
        super().__init__([])

    @property
    def choices(self) -> tuple[str, ...]:
        """``all``, and every plan."""
        from graphic_tmm.readers.protocol import plans

        return ("all", *plans())

    @choices.setter
    def choices(self, value: object) -> None:
        """Leave them to be looked up."""


@click.command(cls=Command)
@click.argument("scene", required=False, type=SceneName())
@click.option(
    "-p",
    "--plan",
    type=Plans(),
    default="all",
    show_default=True,
)
@click.option("-n", "--position", help=said("Number of the position, as on the sheet."))
@click.option("--why", is_flag=True, help=said("Tell why each step is done, too."))
@click.option("--exact", is_flag=True, help=said("Read without the ruler's rounding."))
def steps(scene: str | None, plan: str, position: str | None, why: bool, exact: bool) -> None:
    """Print the numbered protocol of a plan in one position, with the calculation note."""
    from graphic_tmm.readers.protocol import plans, steps_of
    from graphic_tmm.studio import make

    task = read_scene(scene)
    with waiting(said("drawing the plans")):
        drawn = make(task, exact=exact)
    chosen = plans() if plan == "all" else (plan,)
    for line in steps_of(drawn, chosen, position, task.language, why=why):
        click.echo(line)
    warn(drawn)
