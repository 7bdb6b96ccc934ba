"""The mechanism tried at any crank angles before the sheet is begun: an own small board, exact hand.

Extreme positions, the range of the crank that assembles, and the choice of μ are all found from here.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.operations.instruments import measure_along, ray
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.values import Angle, Reals
from graphic_tmm.chapters.kinematics.motion import Motion
from graphic_tmm.chapters.kinematics.positions import (
    Positions,
    draw_frame,
    draw_positions,
    side_record,
    side_values,
)
from graphic_tmm.chapters.kinematics.velocities import draw_velocities
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.mechanism.structure import Structure

STEPS = 1440
"""Crank angles tried over a turn: every quarter of a degree."""


@dataclass(frozen=True)
class Survey:
    """The plan of positions and velocities over a crank angle that is given freely, drawn at 1 m to 1 mm."""

    mechanism: Mechanism
    structure: Structure
    construction: Construction
    given: dict[Mark, object]
    positions: Positions
    velocities: Motion
    axes: dict[tuple[str, str], Mark]

    @property
    def returning_late(self) -> tuple[str, ...]:
        """The groups that flip an odd number of times in a turn: back in their place after two turns only."""
        sides = [
            (g.name, side_record(self.mechanism, g)) for g in self.structure.groups if g.kind < 4
        ]
        return tuple(name for name, side in sides if side and len(side.flips_at or ()) % 2)

    def at(self, angles: Reals, wanted: Iterable[Mark]) -> Reading:
        """Run at crank angles, degrees (trial, position)."""
        given = self.given | {self.positions.phi: angles}
        for group in self.structure.groups:
            side = side_record(self.mechanism, group)
            if group.name in self.positions.sides and side is not None:
                given[self.positions.sides[group.name]] = side_values(side, angles)
        return execute(self.construction, given, wanted)

    def turn(self, wanted: Iterable[Mark]) -> tuple[Reals, Reading]:
        """Run over a whole turn; return the angles (1, n) and the reading."""
        angles = np.arange(STEPS, dtype=np.float64)[None, :] * (360.0 / STEPS)
        return angles, self.at(angles, wanted)


def survey(mechanism: Mechanism, structure: Structure) -> Survey:
    """Draw the mechanism on a small board of its own.

    Raises
    ------
    StructureError
        If the side of a group that has two assemblies is missing, speaks of other letters than the
        group's outer pivots, or is given twice and not alike.
    """
    _refuse_missing_sides(mechanism, structure)
    _refuse_strange_sides(mechanism, structure)
    draft = Draft()
    frame = draw_frame(draft, mechanism, structure)
    phi = draft.ask(Angle, "φ", "°")
    positions = draw_positions(draft, mechanism, structure, frame, phi)
    velocities = draw_velocities(draft, mechanism, structure, positions, turned=False)
    pole = velocities.images.pole
    x = draft.draw(ray, "(px)", pole, draft.direction(0.0))
    y = draft.draw(ray, "(py)", pole, draft.direction(90.0))
    axes = {}
    for number, body in positions.bodies.items():
        for letter in body.link.points:
            image = velocities.images.by_letter[number][letter]
            if image == pole or (letter, "x") in axes:
                continue
            for name, axis in (("x", x), ("y", y)):
                along = f"{image.letter}{name}"
                axes[letter, name] = draft.draw(measure_along, along, pole, image, axis)
    given = draft.given | {draft.mu_l: 1.0, velocities.mu: 1.0}
    return Survey(
        mechanism, structure, draft.board.construction(), given, positions, velocities, axes
    )


def _refuse_missing_sides(mechanism: Mechanism, structure: Structure) -> None:
    for group in structure.groups:
        if group.kind > 3 or side_record(mechanism, group) is not None:
            continue
        if group.kind == 1:
            a, c = (leg.pair.name for leg in group.legs)
            links = "{} or {}".format(*group.links)
            remedy = said(
                'give link {links} side = "left of {a}{c}" or "right of {a}{c}"',
                links=links,
                a=a,
                c=c,
            )
            key = f"link {group.links[0]}"
        else:
            pair = group.legs[1].pair if group.kind == 2 else group.inner
            remedy = said('give slides of link {links} side = "+" or "-"', links=pair.links[0])
            key = f"link {pair.links[0]}, slides"
        raise StructureError(
            said(
                "group {name} can be assembled in two ways: {remedy}",
                name=group.name,
                remedy=remedy,
            ),
            key,
        )


def _refuse_strange_sides(mechanism: Mechanism, structure: Structure) -> None:
    for group in structure.groups:
        if group.kind != 1:
            continue
        a, c = (leg.pair.name for leg in group.legs)
        told = []
        for number in group.links:
            side = mechanism.by_number[number].side
            if side is None:
                continue
            if side.left_of not in ((a, c), (c, a)):
                raise StructureError(
                    said(
                        "link {number}: its side speaks of {listed}, but group {name} has its "
                        'outer pivots at {a} and {c}: write side = "left of {a}{c}" or "right of '
                        '{a}{c}"',
                        number=number,
                        listed="".join(side.left_of or ()),
                        name=group.name,
                        a=a,
                        c=c,
                    ),
                    f"link {number}, side",
                )
            told.append((side.sign if side.left_of == (a, c) else -side.sign, side.flips_at))
        if len(set(told)) > 1:
            raise StructureError(
                said(
                    "links {links} and {links2} give group {name} different sides: leave the side "
                    "of one of them out",
                    links=group.links[0],
                    links2=group.links[1],
                    name=group.name,
                ),
                *(f"link {number}, side" for number in group.links),
            )
