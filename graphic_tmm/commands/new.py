"""new: a scene to begin with, of the classical mechanisms or like another scene."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any, NamedTuple

import click

from graphic_tmm.commands.shared.options import ParamType, SceneName
from graphic_tmm.commands.shared.spoken import Command
from graphic_tmm.language.catalogue import Speech, languages, speaking
from graphic_tmm.language.reader import reader
from graphic_tmm.language.said import said


class Beginning(NamedTuple):
    """A mechanism to begin with: its name, the scene that it is taken from, a line about it, its title."""

    name: str
    scene: str
    says: str
    title: str


BEGINNINGS = (
    Beginning(
        "slider-crank",
        "offset-slider",
        said("crank, connecting rod, slider; the guide is set off the crank"),
        said("Slider-crank mechanism"),
    ),
    Beginning(
        "four-bar",
        "crank-rocker",
        said("crank, coupler with a third point, rocker"),
        said("Four-bar mechanism"),
    ),
    Beginning(
        "stone-and-rocker",
        "shaper",
        said("crank, stone on a rocker, rod, ram: a shaper, quick return"),
        said("Shaper: stone and rocker"),
    ),
    Beginning(
        "swinging-cylinder",
        "oscillating-cylinder",
        said("crank, piston rod, cylinder that swings on a pin"),
        said("Swinging cylinder"),
    ),
    Beginning(
        "scotch-yoke",
        "scotch-yoke",
        said("crank, stone in the slot of a yoke, yoke in the frame"),
        said("Scotch yoke"),
    ),
    Beginning(
        "tangent",
        "tangent-mechanism",
        said("crank and rocker, a slotted lever drives a bar by a stone"),
        said("Tangent mechanism"),
    ),
    Beginning(
        "toggle",
        "toggle-press",
        said("crank and rocker, a knee of two links pushes the ram"),
        said("Toggle press"),
    ),
    Beginning(
        "crank-press",
        "crank-press",
        said("slider-crank under load: forces by groups, the lever, friction"),
        said("Crank press"),
    ),
    Beginning(
        "six-link",
        "lever",
        said("crank, coupler, rocker and slider under load: forces, the lever"),
        said("Six-link mechanism"),
    ),
    Beginning(
        "engine",
        "engine",
        said("slider-crank with gas in its cylinder: indicator diagram, flywheel"),
        said("Engine"),
    ),
    Beginning(
        "four-stroke",
        "four-stroke",
        said("four strokes over two turns: indicator diagram, flywheel over 4π"),
        said("Four-stroke engine"),
    ),
    Beginning(
        "v-engine",
        "v-engine",
        said("two cylinders at 90° on one crank, four strokes: indicator diagrams, flywheel"),
        said("V engine"),
    ),
    Beginning(
        "compressor",
        "two-stage-compressor",
        said("two cylinders of their own pressures: forces on both pistons, flywheel"),
        said("Two-stage compressor"),
    ),
    Beginning(
        "tipper",
        "tipper",
        said("a cylinder lifts a loaded body: plans over its stroke, the force of its rod"),
        said("Tipper"),
    ),
    Beginning(
        "excavator",
        "excavator",
        said("boom and arm, a cylinder each: two drives, the forces of both rods"),
        said("Excavator: boom and arm"),
    ),
    Beginning(
        "gripper",
        "gripper",
        said("a slider closes two fingers by links: the force along its guide"),
        said("Gripper"),
    ),
    Beginning(
        "clamp",
        "hand-clamp",
        said("a toggle clamp at rest: the force on the work is sought, mechanical advantage"),
        said("Hand clamp"),
    ),
    Beginning(
        "moments",
        "moment-cycle",
        said("moments given over a cycle of turns, without a mechanism: flywheel"),
        said("Flywheel for given moments"),
    ),
    Beginning(
        "rocker-by-task",
        "windrower",
        said("lengths found from the stroke and K_v; forces, diagrams, flywheel"),
        said("Rocker mechanism by its task"),
    ),
    Beginning(
        "gear-pair",
        "gear-pair",
        said("two spur gears with shift: teeth, line of action, sliding"),
        said("Gear train: a pair of gears"),
    ),
    Beginning(
        "planetary",
        "planetary",
        said("planetary train 2K–H: tooth numbers, pictures of speeds"),
        said("Planetary train"),
    ),
    Beginning(
        "cam",
        "cam",
        said("disc cam with a roller: diagrams, least radius, profile"),
        said("Cam mechanism"),
    ),
    Beginning(
        "arc-cam",
        "arc-cam",
        said("cam of base circle, flanks and nose: what its follower does"),
        said("Cam given by arcs"),
    ),
)


def beginning(name: str) -> Beginning | None:
    """Return a mechanism to begin with by its name; None if there is none."""
    return next((one for one in BEGINNINGS if one.name == name), None)


LINKS = (
    said("crank", context="link"),
    said("connecting rod", context="link"),
    said("coupler", context="link"),
    said("rocker", context="link"),
    said("slotted rocker", context="link"),
    said("lever", context="link"),
    said("slider", context="link"),
    said("ram", context="link"),
    said("stone", context="link"),
    said("piston", context="link"),
    said("piston rod", context="link"),
    said("cylinder", context="link"),
    said("rack", context="link"),
    said("knife", context="link"),
    said("body", context="link"),
    said("boom", context="link"),
    said("arm", context="link"),
    said("rod", context="link"),
    said("finger", context="link"),
    said("handle", context="link"),
    said("link", context="link"),
    said("clamp arm", context="link"),
)
"""What the links of these mechanisms are called."""


def link_name(name: str, speech: Speech) -> str:
    """Return a link's name in a language, whatever language it is written in; one of no link here as it is."""
    known = (link for link in LINKS if any(speaking(one)(link) == name for one in languages()))
    return speech(next(known, name))


class Mechanism(ParamType):
    """The name of a mechanism to begin with."""

    name = "mechanism"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> str:
        """Return the name; refuse one that there is not."""
        known = [one.name for one in BEGINNINGS]
        if value not in known:
            listed = ", ".join(known)
            self.fail(said("{value!r} is not one of {choices}.", value=value, choices=listed))
        return str(value)

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[Any]:
        """Return the names that begin so."""
        from click.shell_completion import CompletionItem

        return [
            CompletionItem(one.name, help=reader()(one.says))
            for one in BEGINNINGS
            if one.name.startswith(incomplete)
        ]


@click.command(cls=Command)
@click.argument("folder", required=False)
@click.argument("mechanism", required=False, type=Mechanism())
@click.option("--like", type=SceneName(), help=said("Copy a whole scene instead."))
@click.option("--list", "listed", is_flag=True, help=said("List the mechanisms to begin with."))
def new(folder: str | None, mechanism: str | None, like: str | None, listed: bool) -> None:
    """Begin a scene of your own: FOLDER/scene.toml with a MECHANISM, or a copy of another scene.

    Further sections stand in it as comments, with defaults. Without a MECHANISM the terminal asks.
    """
    if listed:
        click.echo("\n".join(_lines()))
        return
    if folder is None:
        raise click.UsageError(said("name the FOLDER of the new scene, or ask for --list"))
    if mechanism is not None and like is not None:
        raise click.UsageError(said("--like copies a whole scene: leave the MECHANISM out"))
    _refuse_old(Path(folder))
    if mechanism is None and like is None and _on_terminal():
        mechanism = _chosen()
    one = None if mechanism is None else beginning(mechanism)
    _write(Path(folder), one, like)


def _on_terminal() -> bool:
    """Whether a person sits at the terminal."""
    return sys.stdin.isatty()


def _lines() -> list[str]:
    """Return a line for each mechanism, in the reader's language."""
    width = max(len(one.name) for one in BEGINNINGS)
    return [f"{one.name:<{width}}  {reader()(one.says)}" for one in BEGINNINGS]


def _chosen() -> str:
    """Ask on the terminal for a mechanism; return its name."""
    click.echo("\n".join(_lines()), err=True)
    asked_for = reader()(said("Which mechanism?"))
    name: str = click.prompt(asked_for, type=Mechanism(), err=True)
    return name


def _refuse_old(target: Path) -> None:
    from graphic_tmm.errors import Fault, SceneError
    from graphic_tmm.scene.packaged import FILE

    if (target / FILE).exists():
        fault = Fault("", 0, said("it exists already; choose another folder"))
        raise SceneError(str(target / FILE), (fault,))


def _write(target: Path, one: Beginning | None, like: str | None) -> None:
    """Write the files of a new scene and print their names."""
    from graphic_tmm.files import write
    from graphic_tmm.scene.document import document
    from graphic_tmm.scene.new import begun, begun_with
    from graphic_tmm.scene.packaged import FILE, SCENE, scene_path
    from graphic_tmm.scene.read import read

    source = scene_path(like if one is None else one.scene)
    file = source / FILE if source.is_dir() else source
    read(file)
    text = document(file, SCENE)[0]
    speech = reader()
    files = begun_with(text, one.title, speech, link_name) if one else begun(text, speech)
    for path in write(target, files):
        click.echo(str(path))
