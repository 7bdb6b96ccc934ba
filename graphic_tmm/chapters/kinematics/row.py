"""The row of positions: equal steps of the crank from the zero position, and extras outside the row."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.operations.formulas import advance
from graphic_tmm.board.operations.instruments import stand
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Number
from graphic_tmm.chapters.kinematics.bodies import Body
from graphic_tmm.chapters.kinematics.extremes import OPPOSITE, draw_extreme
from graphic_tmm.chapters.kinematics.survey import Survey
from graphic_tmm.chapters.kinematics.task import EXTREMES as VIEW
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Extreme, Row

OTHER = "other extreme"
ROUNDING = 1e-15
"""An angle that is off a rounder one by no more than this share of it is that one, rounded."""


class Numbered(NamedTuple):
    """The crank's angle mark, the names of the positions, their angles in degrees as drawn exactly."""

    phi: Mark
    names: tuple[str, ...]
    angles: np.ndarray


def draw_row(draft: Draft, survey: Survey, frame: Body, row: Row) -> Numbered:
    """Record where the crank stands in every position: the row first, the extras behind it."""
    sense = 1.0 if survey.mechanism.drive.speed > 0 else -1.0
    _refuse_repeated(row)
    draft.open(VIEW)
    zero = (
        draw_extreme(draft, survey, frame, row.zero, "0")
        if isinstance(row.zero, Extreme)
        else draft.angle("φ_{0}", row.zero)
    )
    extras = [_extra(draft, survey, frame, row, extra) for extra in row.extra]
    size = row.count + len(extras)
    turned = np.zeros((1, size))
    turned[0, : row.count] = sense * 360.0 * row.turns * np.arange(row.count) / row.count
    draft.open(VIEW)
    by = draft.take(Angle, "Δφ", turned, "°", roles.CRANK_ANGLE)
    phi = draft.draw(advance, "φ_{n}", zero, by, unit="°")
    for place, mark in enumerate(extras):
        there = np.zeros((1, size))
        there[0, row.count + place] = 1.0
        at = draft.take(Number, "", there)
        phi = draft.draw(stand, "φ", phi, mark, at, unit="°")
    values = execute(
        draft.board.construction(), draft.given | {draft.mu_l: 1.0}, [phi, zero, *extras]
    )
    start = float(values[zero][0, 0])
    names = [str(row.first + k) for k in range(row.count)]
    for extra, mark in zip(row.extra, extras, strict=True):
        names.append(_name(row, extra, (float(values[mark][0, 0]) - start) * sense))
    return Numbered(phi, tuple(names), np.broadcast_to(values[phi], (1, size)))


def extreme_places(row: Row) -> tuple[int, ...]:
    """Return the positions (indices) of a row that are extreme positions of a point."""
    zero = (0,) if isinstance(row.zero, Extreme) else ()
    return (*zero, *(row.count + k for k, extra in enumerate(row.extra) if extra == OTHER))


def _refuse_repeated(row: Row) -> None:
    for place, extra in enumerate(row.extra):
        if extra in row.extra[:place]:
            told = f'"{extra}"' if isinstance(extra, str) else f"{extra:.10g}°"
            raise StructureError(
                said("{told} is named twice: leave one of the two out", told=told),
                "drive.extra",
                head="extra",
            )


def _extra(draft: Draft, survey: Survey, frame: Body, row: Row, extra: float | str) -> Mark:
    if not isinstance(extra, str):
        return draft.angle(f"φ_{{{_degrees(row, extra)}}}", extra)
    if not isinstance(row.zero, Extreme):
        raise StructureError(
            said(
                '"other extreme" needs a zero position that is an extreme itself: give zero = '
                '{ point = "D", at = "left" }, or the crank angle in degrees'
            ),
            "drive.extra",
            "drive.zero",
            head="extra",
        )
    if survey.returning_late:
        raise StructureError(
            said(
                '"other extreme" may lie in the second turn (group {group} flips an odd number of '
                "times in a turn): give the crank angle in degrees",
                group=survey.returning_late[0],
            ),
            "drive.extra",
            head="extra",
        )
    other = Extreme(row.zero.point, OPPOSITE[row.zero.at])
    return draw_extreme(draft, survey, frame, other, "*")


def _degrees(row: Row, angle: float) -> str:
    """Return an angle with ten digits, or as many more as tell it from a rounder one and from the others."""
    others = [other for other in row.extra if not isinstance(other, str) and other != angle]
    for digits in range(10, 18):
        told = f"{angle:.{digits}g}"
        rounder = len(told) < digits and abs(float(told) - angle) > ROUNDING * abs(angle)
        if not rounder and told not in [f"{other:.{digits}g}" for other in others]:
            break
    return told


def _name(row: Row, extra: float | str, travelled: float) -> str:
    if not isinstance(extra, str):
        return f"{_degrees(row, extra)}°"
    in_turn = row.count // row.turns
    interval = (travelled % 360.0) * in_turn / 360.0
    passed = math.floor(interval + 1e-9) % in_turn
    return f"{row.first + passed}*"
