"""The classical mechanisms to begin with: each a scene that comes with the package, without how it is drawn."""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.language.catalogue import Speech, languages, speaking
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
)
"""What the links of these mechanisms are called."""


def link_name(name: str, speech: Speech) -> str:
    """Return a link's name in a language, whatever language it is written in; one of no link here as it is."""
    known = (link for link in LINKS if any(speaking(one)(link) == name for one in languages()))
    return speech(next(known, name))
