"""The row of positions: steps of the drive from the zero position, and extras outside the row."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.operations.formulas import advance, run_out
from graphic_tmm.board.operations.instruments import stand
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Number
from graphic_tmm.chapters.kinematics import words as why
from graphic_tmm.chapters.kinematics.bodies import Body
from graphic_tmm.chapters.kinematics.extremes import OPPOSITE, draw_extreme
from graphic_tmm.chapters.kinematics.survey import Survey
from graphic_tmm.chapters.kinematics.task import EXTREMES as VIEW
from graphic_tmm.chapters.kinematics.task import POSITIONS
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Extreme, Row, Sweep

OTHER, DEGREES = "other extreme", "°"
ROUNDING = 1e-15
"""An angle that is off a rounder one by no more than this share of it is that one, rounded."""


class Numbered(NamedTuple):
    """The mark of the drive's coordinate, the names of the positions, its values as drawn exactly (° or m)."""

    at: Mark
    names: tuple[str, ...]
    values: np.ndarray


def draw_row(draft: Draft, survey: Survey, frame: Body, row: Row) -> Numbered:
    """Record where the drive stands in every position: the row first, the extras behind it."""
    sweep, sense = survey.sweep, float(survey.mechanism.drive.sense)
    if sweep.unit != DEGREES:
        return _lengths(draft, sweep, row)
    _refuse_repeated(row)
    draft.open(VIEW)
    zero = (
        draw_extreme(draft, survey, frame, row.zero, "0")
        if isinstance(row.zero, Extreme)
        else draft.angle("φ_{0}", _steps(row, sense)[0])
    )
    extras = [_extra(draft, survey, frame, row, extra) for extra in row.extra]
    size = row.count + len(extras)
    turned = np.zeros((1, size))
    turned[0, : row.count] = _steps(row, sense)[1]
    draft.open(POSITIONS if row.open else VIEW)
    by = draft.take(Angle, "Δφ", turned, "°", roles.ROW)
    because = why.FROM_FIRST if row.open else ""
    phi = draft.draw(advance, "φ_{n}", zero, by, unit="°", why=because)
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


def zero_of(row: Row) -> float:
    """Return the coordinate at which a row begins, as far as it is known before it is drawn; else 0."""
    return _steps(row, 1.0)[0]


def _steps(row: Row, sense: float) -> tuple[float, np.ndarray]:
    """Return where a row begins, and how far each of its positions is from there (degrees or m)."""
    if row.places:
        return row.places[0], np.array(row.places) - row.places[0]
    if row.ends is not None:
        low, high = row.ends
        return low, (high - low) * np.arange(row.count) / max(row.count - 1, 1)
    zero = row.zero if isinstance(row.zero, float) else 0.0
    return zero, sense * 360.0 * row.turns * np.arange(row.count) / row.count


def _lengths(draft: Draft, sweep: Sweep, row: Row) -> Numbered:
    """Record how far what slides has come in every position, m."""
    if row.extra or row.zero != 0.0:
        raise StructureError(
            said(
                "a drive that slides has a row from one length to another: write from and to, or all "
                'places, positions = ["600 mm", "700 mm"], and no {key}',
                key="extra" if row.extra else "zero",
            ),
            "drive.extra" if row.extra else "drive.zero",
            head="drive",
        )
    draft.open(POSITIONS)
    first, steps = _steps(row, 1.0)
    zero = draft.take(Number, f"{sweep.letter}_{{0}}", first, sweep.unit)
    by = draft.take(Number, f"Δ{sweep.letter}", steps[None, :], sweep.unit, roles.ROW)
    at = draft.draw(run_out, f"{sweep.letter}_{{n}}", zero, by, unit=sweep.unit)
    names = tuple(str(row.first + k) for k in range(row.count))
    return Numbered(at, names, (first + steps)[None, :])


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
