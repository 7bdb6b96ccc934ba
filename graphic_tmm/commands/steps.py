"""steps: the protocol of a plan, printed, or picture by picture on sheets."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from graphic_tmm.commands.shared.options import SceneName, chosen_forms, read_scene
from graphic_tmm.commands.shared.spoken import Command
from graphic_tmm.commands.shared.telling import show, waiting, warn
from graphic_tmm.language.catalogue import languages, speaking
from graphic_tmm.language.reader import reader
from graphic_tmm.language.said import said

if TYPE_CHECKING:
    from graphic_tmm.drawn import DrawnScene

    Choice = click.Choice[Any]
else:
    Choice = click.Choice  # no generic class before click 8.2

ALL = said("all", context="plans")


class Plans(Choice):
    """The name of a plan, looked up only when the option is used, so that help stays light.

    It may be the name in code or the caption in any language; an ambiguous name means all its plans.
    """

    def __init__(self) -> None:
        super().__init__([])

    @property
    def choices(self) -> tuple[str, ...]:
        """``all``, and every plan."""
        from graphic_tmm.readers.protocol import plans

        return (ALL, *plans())

    @choices.setter
    def choices(self, value: object) -> None:
        """Leave them to be looked up."""

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> tuple[str, ...]:
        """Return the plans that are meant; refuse what is the name of none."""
        from graphic_tmm.checking.readings.names import plan_meant
        from graphic_tmm.readers.protocol import plans
        from graphic_tmm.scene.captions import plans_named

        if isinstance(value, tuple):  # it is understood already
            return value
        known = plans()
        every = (speaking(language)(ALL).casefold() for language in languages())
        if str(value).casefold() in every:
            return known
        if meant := plan_meant(str(value), known).names:
            return meant
        listed = plans_named(known, reader().language)
        return self.fail(said("{value!r} is not one of {choices}.", value=value, choices=listed))


@click.command(cls=Command)
@click.argument("scene", required=False, type=SceneName())
@click.option(
    "-p",
    "--plan",
    "wanted",
    type=Plans(),
    default="all",
    show_default=True,
    help=said("Of which plan: by this name, or as sheets call it."),
)
@click.option("-n", "--position", help=said("Number of the position, as on the sheet."))
@click.option("--why", is_flag=True, help=said("Tell why each step is done, too."))
@click.option("--exact", is_flag=True, help=said("Read without the ruler's rounding."))
@click.option(
    "--sheets",
    is_flag=True,
    help=said("Write the series of pictures as A4 sheets, with an overview, instead."),
)
@click.option(
    "-o",
    "--output",
    help=said(
        "File to write, instead of printing; --sheets: folder for the sheets.  [default: out]"
    ),
)
@click.option(
    "-f",
    "--format",
    "forms",
    help=said("--sheets: svg, pdf, png; several with commas.  [default: svg]"),
)
def steps(
    scene: str | None,
    wanted: tuple[str, ...],
    position: str | None,
    why: bool,
    exact: bool,
    sheets: bool,
    output: str | None,
    forms: str | None,
) -> None:
    """Print the numbered protocol of a plan in one position, with the calculation note."""
    from graphic_tmm.fitting.composition import composition_file, read_composition
    from graphic_tmm.readers.protocol import steps_of
    from graphic_tmm.studio import make

    formats = _formats(forms, sheets=sheets)
    task = read_scene(scene, lettered=sheets)
    given = read_composition(composition_file(task.source))
    with waiting(said("drawing the plans")):
        drawn = make(task, exact=exact, given=given)
    lines = steps_of(drawn, wanted, position, task.language, why=why)
    if sheets:
        lines = _written(drawn, wanted, position, formats, output or "out")
    show("".join(f"{line}\n" for line in lines), 0, None if sheets else output)
    warn(drawn)


def _formats(forms: str | None, *, sheets: bool) -> list[str]:
    """Return the formats of the sheets; refuse unknown ones, and options of sheets without --sheets."""
    from graphic_tmm.errors import SheetError
    from graphic_tmm.handout import FORMATS

    if not sheets and forms is not None:
        raise SheetError(said("-f tells as what sheets are written: add --sheets"))
    return chosen_forms(forms or FORMATS[0], FORMATS)


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
