"""steps: the protocol of a plan, printed, or picture by picture on sheets."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from graphic_tmm.commands.shared.formats import chosen
from graphic_tmm.commands.shared.progress import waiting
from graphic_tmm.commands.shared.scenes import SceneName, read_scene
from graphic_tmm.commands.shared.spoken import Command
from graphic_tmm.commands.shared.telling import warn
from graphic_tmm.language.said import said

if TYPE_CHECKING:
    from graphic_tmm.drawn import DrawnScene

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
@click.option(
    "--sheets",
    is_flag=True,
    help=said("Write the series of pictures as A4 sheets, with an overview, instead."),
)
@click.option("-o", "--output", help=said("--sheets: folder for the sheets.  [default: out]"))
@click.option(
    "-f",
    "--format",
    "forms",
    help=said("--sheets: svg, pdf, png; several with commas.  [default: svg]"),
)
def steps(
    scene: str | None,
    plan: str,
    position: str | None,
    why: bool,
    exact: bool,
    sheets: bool,
    output: str | None,
    forms: str | None,
) -> None:
    """Print the numbered protocol of a plan in one position, with the calculation note."""
    from graphic_tmm.fitting.composition import beside, read_composition
    from graphic_tmm.readers.protocol import plans, steps_of
    from graphic_tmm.studio import make

    wanted = _formats(forms, output, sheets=sheets)
    task = read_scene(scene, lettered=sheets)
    given = read_composition(beside(task.source))
    with waiting(said("drawing the plans")):
        drawn = make(task, exact=exact, given=given)
    chosen = plans() if plan == "all" else (plan,)
    lines = steps_of(drawn, chosen, position, task.language, why=why)
    if sheets:
        lines = _written(drawn, chosen, position, wanted, output or "out")
    for line in lines:
        click.echo(line)
    warn(drawn)


def _formats(forms: str | None, output: str | None, *, sheets: bool) -> list[str]:
    """Return what the sheets are written as; refuse what is none of it, and what is asked of no sheets."""
    from graphic_tmm.errors import SheetError
    from graphic_tmm.handout import FORMATS

    if not sheets and (forms is not None or output is not None):
        raise SheetError(said("-o and -f tell where sheets are written and as what: add --sheets"))
    return chosen(forms or FORMATS[0], FORMATS)


def _written(
    drawn: DrawnScene,
    plans: Sequence[str],
    position: str | None,
    formats: Sequence[str],
    output: str,
) -> list[str]:
    """Write the sheets of the pictures; return where they are."""
    from graphic_tmm.files import write
    from graphic_tmm.handout.handout import handout_files

    with waiting(said("drawing the pictures")):
        texts = handout_files(drawn, plans, position, formats)
    return [
        str(path) for path in write(Path(output), texts, remedy=said("name another folder with -o"))
    ]
