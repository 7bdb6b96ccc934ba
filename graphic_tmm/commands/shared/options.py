"""Arguments and options of several commands: the scene, its hand, forms of files, limits of time and error."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Sequence
from pathlib import PurePath
from typing import TYPE_CHECKING, Any, TypeVar

import click

from graphic_tmm.commands.shared.telling import progress, tell
from graphic_tmm.language.reader import asked_language, hear
from graphic_tmm.language.said import said

if TYPE_CHECKING:
    from pathlib import Path

    from graphic_tmm.scene.records import Scene


if TYPE_CHECKING:
    ParamType = click.ParamType[str]
else:
    ParamType = click.ParamType  # no generic class before click 8.2

F = TypeVar("F", bound=Callable[..., Any])


class SceneName(ParamType):
    """A scene: a path, the name of one that comes with the package, or - for standard input."""

    name = "scene"

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[Any]:
        """Return the names of scenes that begin so, and what a shell knows of files."""
        from click.shell_completion import CompletionItem

        from graphic_tmm.scene.packaged import packaged

        names = [path.name for path in packaged() if path.name.startswith(incomplete)]
        return [*map(CompletionItem, names), CompletionItem(incomplete, type="file")]


def read_scene(name: str | None, *, lettered: bool = False) -> Scene:
    """Return the scene of a path or a name, in the language that was asked for.

    ``lettered``: refuse letters that cannot be written on a sheet.
    """
    from graphic_tmm.scene.packaged import scene_path
    from graphic_tmm.scene.read import read

    path = scene_path(name)
    hear(language_of(path))
    if lettered:
        from graphic_tmm.paper.lettering.letters import missing

        scene = read(path, missing=missing)
    else:
        scene = read(path)
    language = asked_language() or scene.language
    hear(language)
    return scene.spoken_in(language)


def language_of(path: Path) -> str:
    """Return the language that a scene's file asks for, however wrong the rest of it is; "" if none."""
    from graphic_tmm.scene.document import LOOKED, spoken
    from graphic_tmm.scene.packaged import FILE

    file = path / FILE if path.is_dir() else path
    if not file.is_file():
        return ""
    try:
        with file.open(encoding="utf-8", errors="replace") as stream:
            return spoken(stream.read(LOOKED))
    except OSError:
        return ""


def hands(command: F) -> F:
    """Give a command the options of the hand that draws."""
    for option in (
        click.option(
            "--seed", type=click.IntRange(0, 2**31), help=said("Which of the hand's drawings.")
        ),
        click.option(
            "--hand",
            type=click.Choice(["exact", "cad", "careful", "student"]),
            help=said("Who draws; default: the scene's."),
        ),
    ):
        command = option(command)
    return command


def drawn_by(scene: Scene, hand: str | None, seed: int | None) -> Scene:
    """Return the scene drawn by another hand, with that hand's own ruler."""
    from graphic_tmm.scene.build import drawn_by as drawn

    return drawn(scene, hand, seed)


class Finite(click.FloatRange):
    """A number between bounds; what is not a number lies between none."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return the number; refuse nan, which no comparison finds out of bounds."""
        number = super().convert(value, param, ctx)
        if number != number:
            self.fail(said("{value} is not a finite number", value=value), param, ctx)
        return number


def chosen_forms(forms: str, known: Sequence[str], option: str = "--format") -> list[str]:
    """Return the forms that an option names.

    Raises
    ------
    SheetError
        If one of them is unknown; the message lists the known ones.
    """
    from graphic_tmm.errors import SheetError

    wanted = [form.strip().lower() for form in forms.split(",")]
    if unknown := [form for form in wanted if form not in known]:
        says = said(
            "{option}: no {unknown}; choose from {known}",
            option=option,
            unknown=", ".join(unknown),
            known=", ".join(known),
        )
        raise SheetError(says)
    return wanted


def form_of(form: str | None, output: str | None, known: Sequence[str]) -> str:
    """Return the one form that is asked for: by its name, else by the end of a file's name, else the first.

    >>> form_of(None, "table.CSV", ["text", "csv"]), form_of("text", "table.csv", ["text", "csv"])
    ('csv', 'text')
    """
    end = PurePath(output or "").suffix[1:].lower()
    return form or (end if end in known else known[0])


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
    """Give a command the option of how long one piece of work may take, s; None by default."""
    return click.option(
        "--limit",
        type=Time(),
        metavar="TIME",
        help=said(
            "What takes longer is broken off and named, the rest is made: 90 s, 10 min.  [default: 10 min]"
        ),
    )(command)


def processors() -> int:
    """Return how many processors there are for this process."""
    if hasattr(os, "sched_getaffinity"):  # not on every system
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def budgeted(command: F) -> F:
    """Give a command the options of an error to be kept within."""
    near = click.option(
        "--nearest",
        is_flag=True,
        help=said("Where nothing keeps within --budget, draw what comes nearest."),
    )
    return click.option(
        "--budget",
        help=said(
            "Largest error, such as 2%: take the cheapest setting that keeps every quantity within "
            "it."
        ),
    )(near(command))


def within(scene: Scene, budget: str | None, *, nearest: bool = False) -> Scene:
    """Return the scene at the cheapest setting within a budget such as "2%", and print which it is.

    ``nearest``: where none keeps within it, the best.

    Raises
    ------
    SheetError
        If the budget is no percentage.
    SceneError
        If no setting keeps within it, and ``nearest`` is not wanted.
    """
    from graphic_tmm.errors import SheetError

    if budget is None:
        if nearest:
            raise SheetError(said("--nearest goes with --budget; write --budget 2% --nearest"))
        return scene
    from graphic_tmm.accuracy.budget import choose

    percent = _percentage(budget)
    with progress() as on_the_way:
        taken = choose(scene, percent, on_the_way, nearest=nearest)
    tell(f"{scene.source}: {taken.sentence}")
    return taken.scene


def _percentage(budget: str) -> float:
    from graphic_tmm.errors import SheetError

    match = re.fullmatch(r"\s*(\d+(?:[.,]\d*)?|[.,]\d+)\s*%?\s*", budget)
    percent = float(match[1].replace(",", ".")) if match else 0.0
    if not percent > 0.0:
        raise SheetError(
            said('--budget: "{budget}" is no percentage above 0; write --budget 2%', budget=budget)
        )
    return percent
