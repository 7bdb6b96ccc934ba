"""The command line: the files of `graphic_tmm.commands`, one a command.

Exit status: 0 fine, 1 a check has found something, 2 bad input (one clear message; no output half written),
70 a fault of the program (one line; the environment variable GRAPHIC_TMM_TRACEBACK=1 shows where), 130 Ctrl-C,
141 nobody reads what is printed.
"""

from __future__ import annotations

import sys
from importlib.resources import files

import click

from graphic_tmm.commands.shared.ending import Commands
from graphic_tmm.errors import in_single_file
from graphic_tmm.language.said import said


def _changes(ctx: click.Context, _: click.Parameter, wanted: bool) -> None:
    """Print what has changed, page by page where somebody sits at a terminal."""
    if wanted:
        text = (files("graphic_tmm") / "CHANGES.md").read_text(encoding="utf-8")
        click.echo_via_pager(text.rstrip("\n"))
        ctx.exit()


@click.group(cls=Commands, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(package_name="graphic-tmm")
@click.option(
    "--changes",
    is_flag=True,
    is_eager=True,
    expose_value=False,
    callback=_changes,
    help=said("Show what each version changed, the newest first, and exit."),
)
def main() -> None:
    """Emulate the drawing board: plans of mechanisms as recorded constructions.

    SCENE is a path or the name of a scene that comes with the package; left out, the default scene.
    """
    for stream, errors in ((sys.stdout, "surrogateescape"), (sys.stderr, "backslashreplace")):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(encoding="utf-8", errors=errors)


def start() -> None:
    """Run what the command line asks for; a single file that is opened by a click has none: the studio."""
    if not in_single_file():
        main()
    from multiprocessing import freeze_support

    from graphic_tmm.commands.shared.single_file import studio_arguments, without_own_libraries

    freeze_support()
    without_own_libraries()
    main(sys.argv[1:] or studio_arguments())


if __name__ == "__main__":
    start()
