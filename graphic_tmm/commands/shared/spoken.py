"""Commands whose help speaks the reader's language, and click's own words in it."""

from __future__ import annotations

import gettext
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from copy import copy
from inspect import cleandoc
from typing import Any, TypeVar

import click

from graphic_tmm.language.catalogue import Speech, languages
from graphic_tmm.language.reader import reader
from graphic_tmm.language.said import Said, said

C = TypeVar("C", bound=click.Command)
NAMES = "-l", "--language"
QUIET = "graphic_tmm.quiet"
"""Where a command keeps that it is to show no progress."""
CLICK = (
    said("Usage:"),
    said("Options"),
    said("Commands"),
    said("Show this message and exit."),
    said("Show the version and exit."),
    said("default: {default}"),
    said("required"),
    said("Error: {message}"),
    said("Try '{command} {option}' for help."),
    said("Missing command."),
    said("Missing argument"),
    said("Missing option"),
    said("No such command {name!r}."),
    said("No such option: {name}"),
    said("Invalid value: {message}"),
    said("Invalid value for {param_hint}: {message}"),
    said("{value!r} is not one of {choices}."),
    said("{value!r} is not a valid {number_type}."),
    said("{value} is not in the range {range}."),
    said("Option {name!r} requires an argument."),
    said("Option {name!r} does not take a value."),
)
"""What click itself says, by gettext, where a person can meet it here."""
METAVARIABLES = (
    said("[OPTIONS]"),
    said("COMMAND [ARGS]..."),
    said("text", context="metavariable"),
    said("integer range", context="metavariable"),
    said("float range", context="metavariable"),
)
"""What click writes in a usage, and (in capitals) for the value of an option."""


def language_asked(arguments: Sequence[str]) -> str:
    """Return the language that a command line asks for, "" if none or none that there is.

    It is looked for before the command line is understood, so that what is wrong with it is said in it.
    """
    rest = iter(arguments)
    for one in rest:
        name, sign, value = one.partition("=")
        if name in NAMES:
            language = value if sign else next(rest, "")
            return language if language in languages() else ""
    return ""


def language_option() -> click.Option:
    """Return the option of the language, which every command has."""
    return click.Option(
        NAMES,
        type=click.Choice(languages()),
        expose_value=False,
        help=said("Language of all that is drawn and said; default: the scene's, the terminal's."),
    )


def quiet_option() -> click.Option:
    """Return the option of showing no progress, which every command has."""

    def keep(ctx: click.Context, param: click.Parameter, value: bool) -> None:
        ctx.meta[QUIET] = value

    return click.Option(
        ("-q", "--quiet"),
        is_flag=True,
        expose_value=False,
        callback=keep,
        help=said("Show no progress."),
    )


def quiet() -> bool:
    """Whether the command that runs is to show no progress."""
    ctx = click.get_current_context(silent=True)
    return ctx is not None and bool(ctx.meta.get(QUIET))


@contextmanager
def click_speaking() -> Iterator[None]:
    """Let click find its own words in the catalogue within; it asks `gettext.dgettext` for each."""
    kept = gettext.dgettext
    gettext.dgettext = lambda domain, message: reader()(message)
    try:
        yield
    finally:
        gettext.dgettext = kept


def in_words_of(speech: Speech, error: click.ClickException) -> click.ClickException:
    """Return an error of the command line with its message in a language."""
    if isinstance(error.message, Said):
        vars(error)["message"] = speech(error.message)
    return error


class Command(click.Command):
    """A command with the option of the language, and with its help in the reader's."""

    def __init__(self, *args: Any, **options: Any) -> None:
        super().__init__(*args, **options)
        self.params += [quiet_option(), language_option()]

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Understand a command line; of an option that other commands have, say which."""
        try:
            return super().parse_args(ctx, args)
        except click.NoSuchOption as error:
            if owners := _owners(ctx, error.option_name):
                raise click.UsageError(
                    said(
                        "No such option: {name}; it is an option of {commands}",
                        name=error.option_name,
                        commands=", ".join(owners),
                    ),
                    ctx,
                ) from error
            raise

    def get_help(self, ctx: click.Context) -> str:
        """Return the help in the reader's language."""
        return click.Command.get_help(translated(self, reader()), ctx)

    def get_short_help_str(self, limit: int = 45) -> str:
        """Return the line of the command in the help of all, in the reader's language."""
        return click.Command.get_short_help_str(translated(self, reader()), limit)


def _owners(ctx: click.Context, option: str) -> list[str]:
    """Return the names of the commands, of those that stand with this one, that have an option."""
    group = None if ctx.parent is None else ctx.parent.command
    if not isinstance(group, click.Group):
        return []
    commands = {name: group.get_command(ctx, name) for name in group.list_commands(ctx)}
    return [
        name
        for name, command in commands.items()
        if command is not None and any(option in param.opts for param in command.params)
    ]


def translated(command: C, speech: Speech) -> C:
    """Return a command as its help shows it in a language."""
    shown = copy(command)
    shown.help = speech(cleandoc(command.help or ""))
    shown.options_metavar = speech(command.options_metavar or "")
    if isinstance(shown, click.Group):
        shown.subcommand_metavar = speech(shown.subcommand_metavar or "")
    shown.params = [_translated(one, speech) for one in command.params]
    shown._help_option = None  # made anew in the language
    return shown


def _translated(param: click.Parameter, speech: Speech) -> click.Parameter:
    if not isinstance(param, click.Option):
        return param
    shown = copy(param)
    shown.help = speech(param.help or "") or None
    shown.type = copy(param.type)
    shown.type.name = speech(param.type.name, context="metavariable")
    return shown


class SpokenGroup(click.Group):
    """Commands of which every one has the option of the language; help is in the reader's."""

    command_class = Command

    def __init__(self, *args: Any, **options: Any) -> None:
        super().__init__(*args, **options)
        self.params.append(language_option())

    def get_help(self, ctx: click.Context) -> str:
        """Return the help in the reader's language."""
        return click.Group.get_help(translated(self, reader()), ctx)
