"""The command line. Heavy packages are imported by the command that needs them.

Exit status: 0 fine, 1 a check has found something, 2 bad input (one clear message; no output half written),
70 a fault of the program (one line; the environment variable GRAPHIC_TMM_TRACEBACK=1 shows where), 130 Ctrl-C,
141 nobody reads what is printed.
"""

from __future__ import annotations

import sys

import click

from graphic_tmm.commands.options import (
    WRONG,
    Finite,
    People,
    budgeted,
    drawn_by,
    hands,
    read_scene,
    say,
    show,
    tell,
    terminal_width,
    warn,
    within,
)
from graphic_tmm.language.said import said

PLANS = (
    "extremes",
    "positions",
    "velocities",
    "accelerations",
    "forces",
    "engine",
    "diagrams",
    "flywheel",
    "cam",
    "gears",
    "planetary",
)


@click.group(cls=People, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(package_name="graphic-tmm")
def main() -> None:
    """Emulate the drawing board: plans of mechanisms as recorded constructions.

    SCENE is a path or the name of a scene that comes with the package; left out, the default scene.
    """
    for stream, errors in ((sys.stdout, "surrogateescape"), (sys.stderr, "backslashreplace")):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(encoding="utf-8", errors=errors)


@main.command()
@click.argument("scene", required=False)
@click.option(
    "-o", "--output", default="out", show_default=True, help=said("Folder for the sheets.")
)
@click.option(
    "-f",
    "--format",
    "forms",
    default="svg",
    show_default=True,
    help=said("svg, pdf, png, dxf; several with commas."),
)
@hands
@budgeted
def draw(
    scene: str | None,
    output: str,
    forms: str,
    hand: str | None,
    seed: int | None,
    budget: str | None,
) -> None:
    """Draw the sheets of SCENE as files, true to the millimetre."""
    from pathlib import Path

    from graphic_tmm.errors import SheetError
    from graphic_tmm.files import write
    from graphic_tmm.studio import FORMATS, sheet_files

    wanted = [form.strip().lower() for form in forms.split(",")]
    if unknown := [form for form in wanted if form not in FORMATS]:
        raise SheetError(
            said(
                "--format: no {unknown}; choose from {known}",
                unknown=", ".join(unknown),
                known=", ".join(FORMATS),
            )
        )
    task = within(drawn_by(read_scene(scene, lettered=True), hand, seed), budget)
    made, texts = sheet_files(task, wanted)
    for path in write(Path(output), texts, remedy=said("name another folder with -o")):
        click.echo(str(path))
    warn(made, sheets=True)


@main.command()
@click.argument("scene", required=False)
@click.option(
    "-f",
    "--format",
    "form",
    type=click.Choice(["text", "csv", "json"]),
    default="text",
    show_default=True,
)
@click.option(
    "--exact", is_flag=True, help=said("Read without the ruler's rounding; print all digits.")
)
@click.option(
    "--width",
    type=click.IntRange(20, 10_000),
    help=said("Characters of a line of text; the terminal's."),
)
@click.option(
    "--decimal",
    type=click.Choice(["point", "comma"]),
    default="point",
    show_default=True,
    help=said("Decimal sign of CSV; with a comma, semicolons stand between the cells."),
)
@click.option(
    "--bom", is_flag=True, help=said("Begin CSV with a byte order mark, as spreadsheets want it.")
)
@hands
@click.option(
    "--trials", type=click.IntRange(1, 100_000), default=1, help=said("How often all is drawn.")
)
@budgeted
def table(
    scene: str | None,
    form: str,
    exact: bool,
    width: int | None,
    decimal: str,
    bom: bool,
    hand: str | None,
    seed: int | None,
    trials: int,
    budget: str | None,
) -> None:
    """Print what SCENE calls for, whether or not a sheet shows it: segments in mm, quantities in SI."""
    from graphic_tmm.studio import make
    from graphic_tmm.studio import table as told

    drawn = make(within(drawn_by(read_scene(scene), hand, seed), budget), exact=exact)
    wide = width or terminal_width()
    text = told(drawn, form, trials, width=wide, comma=decimal == "comma")
    show("\ufeff" + text if bom and form == "csv" and isinstance(text, str) else text, wide)
    warn(drawn)


@main.command()
@click.argument("scene", required=False)
@click.option(
    "-o", "--output", help=said("Folder for the figure, as SVG and PNG; none if left out.")
)
@click.option("-f", "--format", "form", type=click.Choice(["text", "json"]), default="text")
@click.option("--trials", type=click.IntRange(10, 10_000), default=100, show_default=True)
@click.option(
    "--minutes", help=said("TOML file: minutes of elementary operations, R1 = 0.1 and so on.")
)
@click.option(
    "--no-time", is_flag=True, help=said("Measure no seconds: the same bytes every time.")
)
@hands
def accuracy(
    scene: str | None,
    output: str | None,
    form: str,
    trials: int,
    minutes: str | None,
    no_time: bool,
    hand: str | None,
    seed: int | None,
) -> None:
    """Show what accuracy costs in SCENE: errors over work at the board and time on the machine."""
    from graphic_tmm.accuracy import run as road

    task = drawn_by(read_scene(scene), None, seed)
    found = road.studied(task, hand, trials, minutes, clock=not no_time)
    show(road.told(found, form), 200)
    for path in road.figured(found, output) if output is not None else ():
        say(str(path))


@main.command()
@click.argument("scene")
@click.argument("readings", required=False)
@click.option(
    "--template", is_flag=True, help=said("Print a CSV file to be filled in, and check nothing.")
)
@click.option(
    "--hand",
    type=click.Choice(["cad", "careful", "student"]),
    default="student",
    show_default=True,
    help=said("By whose drawings readings are judged."),
)
@click.option(
    "--points",
    type=click.Choice(["paper", "screen", "photo"]),
    default="paper",
    show_default=True,
    help=said(
        "How x and y were read: off the paper with ruler and square, off the drawing on a screen "
        "(0.1 mm), off a photograph (0.5 mm)."
    ),
)
@click.option(
    "--doubtful",
    type=Finite(0.5, 1.0),
    default=0.97,
    show_default=True,
    help=said("Beyond this quantile of the hand's own deviations a reading is doubtful."),
)
@click.option(
    "--wrong",
    type=Finite(1.0, 100.0),
    default=5.0,
    show_default=True,
    help=said("Beyond so many times their root mean square, and beyond them all, it is wrong."),
)
@click.option(
    "--trials",
    type=click.IntRange(20, 100_000),
    default=400,
    show_default=True,
    help=said("How often the hand draws to tell what is usual."),
)
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
    "--photo", help=said("A photograph of the sheet, to be laid under it (with --corners).")
)
@click.option(
    "--sheet",
    type=click.IntRange(1),
    help=said("Which sheet the photograph shows (with --photo); default: the first."),
)
@click.option(
    "--corners", help=said("The corners of the frame in the photograph: x,y x,y x,y x,y (dots).")
)
@click.option(
    "-f",
    "--format",
    "form",
    type=click.Choice(["text", "md", "json", "html"]),
    default="text",
    show_default=True,
)
def check(
    scene: str,
    readings: str | None,
    template: bool,
    hand: str,
    points: str,
    doubtful: float,
    wrong: float,
    trials: int,
    overlay: str | None,
    enlarge: float,
    photo: str | None,
    corners: str | None,
    sheet: int | None,
    form: str,
) -> None:
    """Compare READINGS of a hand-made drawing (a CSV file) with SCENE; status 1 if something is wrong."""
    from graphic_tmm.checking import run as road

    task = read_scene(scene, lettered=True)
    if template:
        click.echo(road.template_of(task), nl=False)
        return
    _refuse_half_asked(readings, photo, sheet, corners)
    report = None
    if readings is not None:
        report = road.checked(task, readings, hand, (doubtful, wrong), trials, points)
    photograph = (photo, corners or "", sheet or 1) if photo is not None else None
    written, warnings = road.pictured(task, report, overlay, enlarge, photograph)
    for warning in warnings:
        tell(said("warning: {text}", text=warning))
    for path in written:
        click.echo(str(path), err=report is not None)  # a report has the other stream to itself
    if report is None:
        return
    show(road.told(report, form), 160)
    if report.wrong:
        raise SystemExit(WRONG)


def _refuse_half_asked(
    readings: str | None, photo: str | None, sheet: int | None, corners: str | None
) -> None:
    if photo is None and (sheet is not None or corners is not None):
        raise click.UsageError(said("--sheet and --corners go with a photograph: add --photo FILE"))
    if readings is None and photo is None:
        raise click.UsageError(said("name the file of READINGS, or ask for --template"))


@main.command()
@click.argument("scene", required=False)
@click.option(
    "-p",
    "--plan",
    type=click.Choice(["all", "synthesis", *PLANS]),
    default="all",
    show_default=True,
)
@click.option("-n", "--position", help=said("Number of the position, as on the sheet."))
@click.option("--exact", is_flag=True, help=said("Read without the ruler's rounding."))
def steps(scene: str | None, plan: str, position: str | None, exact: bool) -> None:
    """Print the numbered protocol of a plan in one position, with the calculation note."""
    from graphic_tmm.readers.protocol import steps_of
    from graphic_tmm.studio import make

    drawn = make(read_scene(scene), exact=exact)
    known = ("synthesis", *PLANS)
    chosen = known if plan == "all" else (plan,)
    for line in steps_of(
        drawn.work, drawn.parts, drawn.scene, chosen, position, drawn.scene.language, known
    ):
        click.echo(line)
    warn(drawn)


@main.command()
def scenes() -> None:
    """List the scenes that come with the package."""
    import tomllib

    from graphic_tmm.studio import packaged

    found = packaged()
    width = max((len(path.name) for path in found), default=0)
    for path in found:
        title = tomllib.loads((path / "scene.toml").read_text(encoding="utf-8")).get("title", "")
        click.echo(f"{path.name:<{width}}  {title}")


@main.command()
@click.argument("folder")
@click.option("--like", help=said("Scene to begin with; the default scene if left out."))
def new(folder: str, like: str | None) -> None:
    """Begin a scene of your own: FOLDER/scene.toml, a copy to change."""
    from pathlib import Path

    from graphic_tmm.errors import Fault, SceneError
    from graphic_tmm.files import write
    from graphic_tmm.scene.document import document
    from graphic_tmm.scene.new import begun
    from graphic_tmm.scene.read import FILE, SCENE, read
    from graphic_tmm.studio import scene_path

    target = Path(folder)
    if (target / FILE).exists():
        fault = Fault("", 0, said("it exists already; choose another folder"))
        raise SceneError(str(target / FILE), (fault,))
    source = scene_path(like)
    file = source / FILE if source.is_dir() else source
    read(file)
    for path in write(target, begun(document(file, SCENE)[0])):
        click.echo(str(path))


@main.command()
def schema() -> None:
    """Print the JSON Schema of scenes, for editors."""
    from graphic_tmm.scene.new import schema_text

    click.echo(schema_text(), nl=False)


if __name__ == "__main__":
    main()
