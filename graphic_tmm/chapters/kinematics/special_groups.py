"""The rooms that draw groups of class III and IV on each plan, by what group it is."""

from __future__ import annotations

from collections.abc import Mapping

from graphic_tmm.board.draft import Draft
from graphic_tmm.chapters.kinematics.bodies import Positions
from graphic_tmm.chapters.kinematics.closings import PlateClosing, SpecialClosing, SquareClosing
from graphic_tmm.chapters.kinematics.dyads import Ground
from graphic_tmm.chapters.kinematics.motion import Motion
from graphic_tmm.chapters.kinematics.plates import Followed, close_plate
from graphic_tmm.chapters.kinematics.special_point import plate_accelerations, plate_velocities
from graphic_tmm.chapters.kinematics.special_square import (
    square_accelerations,
    square_velocities,
)
from graphic_tmm.chapters.kinematics.squares import close_square
from graphic_tmm.chapters.kinematics.velocity_lines import VelocityLines
from graphic_tmm.mechanism.groups import PlateGroup, SpecialGroup, SquareGroup
from graphic_tmm.mechanism.records import Link


def close_special(
    ground: Ground, group: SpecialGroup, links: Mapping[int, Link], follow: Followed
) -> SpecialClosing:
    """Lay the plates of a group with tracing paper; draw its other links."""
    match group:
        case PlateGroup():
            return close_plate(ground, group, links, follow)
        case SquareGroup():
            return close_square(ground, group, links, follow)


def special_velocities(
    draft: Draft, positions: Positions, plan: Motion, turn: VelocityLines, closing: SpecialClosing
) -> None:
    """Draw the velocities of a group by its special point."""
    match closing:
        case PlateClosing():
            plate_velocities(draft, positions, plan, turn, closing)
        case SquareClosing():
            square_velocities(draft, positions, plan, turn, closing)


def special_accelerations(
    draft: Draft, positions: Positions, velocities: Motion, plan: Motion, closing: SpecialClosing
) -> None:
    """Draw the accelerations of a group by its special point."""
    match closing:
        case PlateClosing():
            plate_accelerations(draft, positions, velocities, plan, closing)
        case SquareClosing():
            square_accelerations(draft, positions, velocities, plan, closing)
