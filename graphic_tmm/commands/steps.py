"""steps: the protocol of a plan."""

from __future__ import annotations

import click

from graphic_tmm.commands.shared.scenes import read_scene
from graphic_tmm.commands.shared.telling import warn

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


@click.command()
@click.argument("scene", required=False)
@click.option(
    "-p",
    "--plan",
    type=click.Choice(["all", "synthesis", *PLANS]),
    default="all",
    show_default=True,
)
@click.option("-n", "--position", help="Number of the position, as on the sheet.")
@click.option("-l", "--language", type=click.Choice(["ru", "en"]), help="Default: the scene's.")
@click.option("--exact", is_flag=True, help="Read without the ruler's rounding.")
def steps(
    scene: str | None, plan: str, position: str | None, language: str | None, exact: bool
) -> None:
    """Print the numbered protocol of a plan in one position, with the calculation note."""
    from graphic_tmm.readers.protocol import steps_of
    from graphic_tmm.studio import make

    drawn = make(read_scene(scene), exact=exact)
    known = ("synthesis", *PLANS)
    chosen = known if plan == "all" else (plan,)
    spoken = language or drawn.scene.language
    for line in steps_of(drawn.work, drawn.parts, drawn.scene, chosen, position, spoken, known):
        click.echo(line)
    warn(drawn)
