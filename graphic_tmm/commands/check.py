"""check: readings of a hand-made drawing against its scene."""

from __future__ import annotations

from collections.abc import Sequence
from importlib import import_module
from typing import Any

import click

from graphic_tmm.commands.shared.judging import (
    JudgedBy,
    composition_of,
    end_with,
    judged_by,
    refuse,
    report_form,
    report_on,
)
from graphic_tmm.commands.shared.options import Finite, SceneName, read_scene
from graphic_tmm.commands.shared.spoken import Command
from graphic_tmm.commands.shared.telling import show, waiting
from graphic_tmm.language.said import said

FORMER = {"--class": "mark", "--photo": "photo", "--template": "template"}
"""Options that made another command of check, and the commands that they are now."""


class Check(Command):
    """check; a command line of one of its former options is that of the command which it has become."""

    def make_context(
        self,
        info_name: str | None,
        args: list[str],
        parent: click.Context | None = None,
        **extra: Any,
    ) -> click.Context:
        """Understand a command line, or hand it on to the command that it means."""
        for option, name in FORMER.items():
            own = args[: args.index("--")] if "--" in args else args
            at = next((i for i, a in enumerate(own) if a.partition("=")[0] == option), None)
            if at is not None:
                command = getattr(import_module(f"graphic_tmm.commands.{name}"), name)
                return command.make_context(name, _now(command, args, at), parent, **extra)  # type: ignore[no-any-return]
        return super().make_context(info_name, args, parent, **extra)


def _now(command: click.Command, args: Sequence[str], at: int) -> list[str]:
    """Return the arguments of ``command`` for those of check with a former option ``at`` a place.

    A file or folder that stood after the option stands after the scene now.
    """
    option, sign, value = args[at].partition("=")
    rest = [*args[:at], *args[at + 1 :]]
    if option == "--template":
        return rest
    if not sign:
        if at == len(rest):
            raise click.UsageError(said("Option {name!r} requires an argument.", name=option))
        value = rest.pop(at)
    valued = {
        name
        for param in command.params
        if isinstance(param, click.Option) and not param.is_flag
        for name in param.opts
    }
    place = 0
    while place < len(rest) and rest[place].startswith("-") and rest[place] not in ("-", "--"):
        place += 2 if rest[place] in valued else 1
    place += place < len(rest) and rest[place] == "--"
    return [*rest[: place + 1], value, *rest[place + 1 :]]


@click.command(cls=Check)
@click.argument("scene", type=SceneName())
@click.argument("readings", required=False)
@click.option("-o", "--output", help=said("File for the report, instead of printing."))
@judged_by
@click.option(
    "--overlay", help=said("SVG file for the exact plans under the points that were read.")
)
@click.option(
    "--enlarge",
    type=Finite(1.0, 1000.0),
    default=1.0,
    show_default=True,
    help=said("How many times larger the overlay shows deviations."),
)
@click.option(
    "--letters",
    multiple=True,
    metavar="K=A",
    help=said("What the student calls K is A in the scene; several are separated by commas."),
)
@click.option(
    "--power",
    is_flag=True,
    help=said("Print what error of each length would be seen, without any READINGS."),
)
@report_form
def check(
    scene: str,
    readings: str | None,
    output: str | None,
    by: JudgedBy,
    overlay: str | None,
    enlarge: float,
    letters: tuple[str, ...],
    power: bool,
    form: str | None,
) -> None:
    """Compare READINGS of a hand-made drawing (CSV, xlsx) with SCENE; status 1 if something is wrong."""
    if power:
        if readings is not None:
            raise click.UsageError(said("--power looks at the scene alone: leave READINGS out"))
        _power(scene, by, output)
        return
    if readings is None:
        raise click.UsageError(
            said(
                "name the file of READINGS; template writes one to be filled in, photo judges a photograph, "
                "mark a class"
            )
        )
    refuse(scene, readings, output)
    task = read_scene(scene, lettered=True)
    report = report_on(task, readings, by, letters)
    if overlay is not None:
        from graphic_tmm.checking import pictures

        with waiting(said("drawing the plans")):
            drawn = pictures.overlay(task, report, overlay, enlarge, composition_of(task))
        click.echo(str(drawn), err=True)  # the report has the other stream to itself
    end_with(report, form, output)


def _power(scene: str, by: JudgedBy, output: str | None) -> None:
    """Print what error of each length of a scene is seen."""
    from graphic_tmm.board.hand import HANDS
    from graphic_tmm.checking.judging.power import seen_errors
    from graphic_tmm.checking.judging.scatter import Limits
    from graphic_tmm.checking.judging.yardstick import Yardsticks
    from graphic_tmm.checking.report.power import power_report
    from graphic_tmm.studio import make

    task = read_scene(scene, lettered=True)
    with waiting(said("drawing by the hand, to tell what is usual")):
        made = make(task, exact=True, given=composition_of(task))
        hand = HANDS[by.hand]._replace(trials=by.trials, seed=task.seed)
        rows = seen_errors(made, Yardsticks(made, hand, Limits(by.doubtful, by.wrong)))
    show(power_report(rows, task.language), 160, output)
