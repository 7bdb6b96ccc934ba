"""A cylinder that swings about a pin of the frame, its rod on the crank: its length tells the stroke.

The cover is the bottom at the pin, so the travel is the length CA less the least one; this and the greatest are
those at which the crank lies along the line through both fixed pivots.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import difference, total
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.indicator import words as why
from graphic_tmm.chapters.indicator.task import INDICATOR
from graphic_tmm.chapters.kinematics.bodies import Positions, sliding_points
from graphic_tmm.chapters.kinematics.closings import GuideLeg, PinLeg, dyads
from graphic_tmm.chapters.kinematics.dyads import rocker_offset
from graphic_tmm.chapters.kinematics.survey import Survey
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import Said, said

ASIDE = 1e-3
"""So many degrees before and behind a position tell which way a piston goes there."""
STILL = 1e-9
"""A length that changes by less than this share of itself stands."""


class Swinging(NamedTuple):
    """A swinging cylinder: its piston's leg, whose line goes from the bottom on, its own, its pin's name."""

    leg: GuideLeg
    pin: PinLeg
    name: str


def swinging_of(positions: Positions, survey: Survey, letter: str) -> Swinging | None:
    """Return the swinging cylinder whose rod is pinned at a point; None if none is, or it slides on the frame.

    Raises
    ------
    StructureError
        If its rod is not on the crank, its pin not on the frame, or the rod not in line with the pin; if there
        are several.
    """
    frame = survey.mechanism.frame.number
    sliding = sliding_points(positions.closings, positions.bodies, frame, INDICATOR)
    if letter in dict(sliding):
        return None
    cylinders = list(_pinned_at(positions, survey, letter))
    if len(cylinders) > 1:
        raise _refused(
            said(
                "rods of several cylinders that swing are pinned at {point}: pin each at a point of its own",
                point=letter,
            )
        )
    return cylinders[0] if cylinders else None


def _pinned_at(positions: Positions, survey: Survey, letter: str) -> Iterator[Swinging]:
    """Yield the swinging cylinders whose rods are pinned at a point."""
    mechanism = survey.mechanism
    for closing in dyads(positions.closings, INDICATOR):
        leg, pin = closing.legs
        inner = isinstance(leg, GuideLeg) and leg.inner and isinstance(pin, PinLeg)
        if not inner or closing.group.legs[0].pair.name != letter:
            continue
        assert isinstance(leg, GuideLeg)
        assert isinstance(pin, PinLeg)
        stone, rocker = (mechanism.by_number[one.link] for one in closing.group.legs)
        straight = rocker_offset(closing.group, stone, rocker) == 0.0
        driven = leg.body == survey.structure.first.link and survey.sweep.closed
        if not (straight and driven and pin.body == mechanism.frame.number):
            raise _refused(
                said(
                    "the gas in a cylinder that swings is drawn where its rod is pinned to the crank, itself "
                    "to the frame, and both lie in one line; {point} is another",
                    point=letter,
                )
            )
        yield Swinging(leg, pin, closing.group.legs[1].pair.name)


def _refused(why_not: Said) -> StructureError:
    return StructureError(why_not, f"{INDICATOR}.point", head=INDICATOR)


def draw_length(draft: Draft, survey: Survey, of: Swinging, letter: str) -> tuple[Mark, Mark]:
    """Calculate the travel from the bottom, and the stroke (Length), of a cylinder by its length."""
    mechanism, structure = survey.mechanism, survey.structure
    crank, origin, pin = mechanism.by_number[structure.first.link], structure.origin, of.name
    frame = mechanism.frame.points
    arm = draft.length(f"{origin}{letter}", abs(crank.points[letter] - crank.points[origin]))
    apart = draft.length(f"{origin}{pin}", abs(frame[pin] - frame[origin]))
    least = draft.draw(difference, f"{pin}{letter}_{{min}}", apart, arm, why=why.SHORTEST)
    most = draft.draw(total, f"{pin}{letter}_{{max}}", apart, arm, why=why.LONGEST)
    travel = draft.draw(difference, f"|s_{letter}|", of.pin.length, least, why=why.LENGTHENED)
    return travel, draft.draw(difference, f"s_{{{letter}max}}", most, least, why=why.LENGTH_STROKE)


def goes_from_bottom(survey: Survey, of: Swinging, letter: str, angles: Reals) -> np.ndarray:
    """Tell at which crank angles (degrees) the rod runs out of the cylinder, or has just done so."""
    marks = [survey.positions.point(letter), survey.positions.point(of.name)]
    ends = survey.mechanism.drive.sense * ASIDE * np.array([[-1.0], [1.0]])
    lengths = []
    for row in angles[None, :] + ends:
        reading = survey.at(row[None, :], marks)
        lengths.append(np.abs(reading[marks[0]] - reading[marks[1]])[0])
    before, behind = lengths
    return np.asarray(behind - before >= -STILL * behind)


def bottom_angle(survey: Survey, of: Swinging, letter: str) -> float:
    """Return the crank's angle, degrees, at which the cylinder is shortest: the rod lies towards its pin."""
    mechanism, structure = survey.mechanism, survey.structure
    crank, origin = mechanism.by_number[structure.first.link].points, structure.origin
    frame = mechanism.frame.points
    ahead = (crank[letter] - crank[origin]) / (crank[structure.first.pin] - crank[origin])
    return math.degrees(cmath.phase((frame[of.name] - frame[origin]) / ahead))
