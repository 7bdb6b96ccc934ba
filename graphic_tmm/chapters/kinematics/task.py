"""What is asked of the plans of a mechanism: views, places, rows of tables that cost a step. SI, degrees."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from graphic_tmm.language.said import said
from graphic_tmm.scene import letters
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Flaw, Said, Section, key
from graphic_tmm.scene.tables import Named
from graphic_tmm.scene.tasks import SectionKey

if TYPE_CHECKING:
    from graphic_tmm.scene.sections import Parts


KINEMATICS = "kinematics"
POSITIONS, VELOCITIES, ACCELERATIONS = "positions", "velocities", "accelerations"
"""The plans: places of sheets, views of the board, and what other chapters need."""
PLANS = (POSITIONS, VELOCITIES, ACCELERATIONS)
TURNS = "turns"
"""What else may be needed of the plans: that their row goes over so many turns of the crank."""
BY_DRIVE = "velocities by drive"
"""A place, and a need: velocities as each of several drives causes them."""
EXTREMES = "extremes"
SPECIAL_POINTS = "special points"
"""The view of the board in which special points of plates are drawn."""
GIVEN = "given"
"""The place of the table of what is given."""
FULL_TURN = said(
    "a curve goes through all positions of a turn, and the mechanism does not assemble in each of them; "
    "change its lengths so that the crank turns fully"
)
"""Why there is no curve along the positions, and what to do."""


@dataclass(frozen=True)
class Rows:
    """Further rows: lengths and angles, relative accelerations, paths (by letters), pins (radii, m)."""

    lengths: tuple[str, ...] = key(
        v.LETTERS,
        "distances of two points; of one that slides along a guide, along it, with a sign",
        ["OD"],
        (),
    )
    angles: tuple[str, ...] = key(
        v.LETTERS,
        "angles of links from the x axis, from the first letter to the second",
        ["AB"],
        (),
    )
    relative: tuple[str, ...] = key(
        v.LETTERS,
        "whole accelerations of one point relative to another, the first to the second",
        ["BA"],
        (),
    )
    paths: tuple[str, ...] = key(
        v.LETTERS,
        "points whose normal and tangential acceleration and radius of curvature are found",
        ["S2"],
        (),
    )
    pins: Mapping[str, float] = key(
        Named(v.POSITIVE_LENGTH),
        'radii of pins by their letter, { A = "20 mm" }: how fast the pin rubs, r·|ω_i − ω_j|',
        default={},
    )


ASKED: SectionKey[Rows] = SectionKey("rows")


def _check(asked: Said, parts: Parts) -> Iterator[Flaw]:
    """Every letter that is none, every row of accelerations where none are drawn."""
    frame = set(parts.frame.points) if parts.frame is not None else set()
    moving = {k for link in parts.links if link is not None for k in link.points}
    for name in ("lengths", "angles", "relative"):
        for k, pair in enumerate(getattr(asked, name)):
            yield from _pair(("rows", name, k), pair, frame | moving)
    for k, letter in enumerate(asked.paths):
        yield from parts.moves(("rows", "paths", k), letter)
    for letter in asked.pins:
        if letter not in frame | moving:
            says = said('"{letter}" is no point', letter=letter[:20])
            yield Flaw(
                ("rows", "pins", letter), letters.unknown(says, letter, frame | moving, _POINTS)
            )
    gained = parts.drive is not None and parts.drive.accelerations
    for name in ("relative", "paths"):
        if getattr(asked, name) and not gained:
            says = said('it is read off acceleration plans; write accelerations = "all" in [drive]')
            yield Flaw(("rows", name), says)


_POINTS = said("points")


def _pair(path: tuple[str | int, ...], pair: str, known: set[str]) -> Iterator[Flaw]:
    found = letters.split(pair)
    if found is None or found[0] == found[1]:
        says = said('"{pair}" is not two letters; write two points, "AB"', pair=pair[:20])
        yield Flaw(path, says)
        return
    for letter in found:
        if letter not in known:
            says = said('"{letter}" is no point', letter=letter[:20])
            yield Flaw(path, letters.unknown(says, letter, known, _POINTS))


SECTIONS = (
    Section("rows", Rows, "further rows of the tables", begin='lengths = ["OA"]', check=_check),
)
