"""The row of positions: steps of the drive from the zero position, and extras outside the row."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.operations.formulas import advance, run_out
from graphic_tmm.board.operations.outside import stand, stand_out
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Number
from graphic_tmm.chapters.kinematics import words as why
from graphic_tmm.chapters.kinematics.bodies import Body
from graphic_tmm.chapters.kinematics.extremes import Wanted, draw_extreme
from graphic_tmm.chapters.kinematics.sides import LAST
from graphic_tmm.chapters.kinematics.survey import Survey
from graphic_tmm.chapters.kinematics.task import EXTREMES as VIEW
from graphic_tmm.chapters.kinematics.task import POSITIONS
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Extreme, Row, Sweep

DEGREES = "°"
ROUNDING = 1e-15
"""An angle that is off a rounder one by no more than this share of it is that one, rounded."""


class Numbered(NamedTuple):
    """The mark of the drive's coordinate; the names of the positions, their values as drawn exactly (° or m).

    ``numbers``: where each position stands in the row, in intervals of it; extras stand between.
    """

    at: Mark
    names: tuple[str, ...]
    values: np.ndarray
    numbers: np.ndarray


def draw_row(draft: Draft, survey: Survey, frame: Body, row: Row) -> Numbered:
    """Record where the drive stands in every position: the row first, the extras behind it.

    Raises
    ------
    StructureError
        If a zero position is asked of what slides, a position is named twice, or an extreme one is not there.
    """
    sweep, sense = survey.sweep, float(survey.mechanism.drive.sense)
    turns, letter = sweep.unit == DEGREES, sweep.letter
    _refuse_zero(sweep, row)
    _refuse_repeated(sweep, row)
    outside = POSITIONS if row.open else VIEW
    draft.open(outside)
    first, steps = _steps(row, sense if turns else 1.0)
    if isinstance(row.zero, Extreme):
        zero = draw_extreme(draft, survey, frame, Wanted(row.zero), "0")
    else:
        zero = _given(draft, sweep, f"{letter}_{{0}}", first)
    extras, tag = list[Mark](), ""
    for extra in row.extra:
        if isinstance(extra, Extreme):
            _refuse_late(survey, extra)
            tag += "*"
            extras.append(
                draw_extreme(draft, survey, frame, Wanted(extra, "extra", row.reach), tag)
            )
        else:
            draft.open(outside)
            name = _degrees(row, extra) if turns else f"{extra:.10g}"
            extras.append(_given(draft, sweep, f"{letter}_{{{name}}}", extra))
    size = row.count + len(extras)
    gone = np.zeros((1, size))
    gone[0, : row.count] = steps
    draft.open(outside)
    by = draft.take(Angle if turns else Number, f"Δ{letter}", gone, sweep.unit, roles.ROW)
    because = why.FROM_FIRST if turns and row.open else ""
    on, apart = (advance, stand) if turns else (run_out, stand_out)
    at = draft.draw(on, f"{letter}_{{n}}", zero, by, unit=sweep.unit, why=because)
    for place, mark in enumerate(extras):
        there = np.zeros((1, size))
        there[0, row.count + place] = 1.0
        chosen = draft.take(Number, "", there)
        at = draft.draw(apart, letter, at, mark, chosen, unit=sweep.unit)
    log = draft.board.construction()
    values = execute(log, draft.given | {draft.mu_l: 1.0}, [at])[at]
    values = np.broadcast_to(values, (1, size))
    numbers = _numbers(values[0], row, sweep, sense)
    return Numbered(at, _names(row, numbers, turns=turns), values, numbers)


def _given(draft: Draft, sweep: Sweep, letter: str, value: float) -> Mark:
    if sweep.turns:
        return draft.angle(letter, value)
    return draft.take(Number, letter, value, sweep.unit)


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


def _refuse_zero(sweep: Sweep, row: Row) -> None:
    if not sweep.turns and row.zero != 0.0:
        raise StructureError(
            said(
                "a drive that slides has a row from one length to another: write from and to, or all "
                'places, positions = ["600 mm", "700 mm"], and no zero',
            ),
            "drive.zero",
            head="drive",
        )


def extreme_places(row: Row) -> tuple[int, ...]:
    """Return the positions (indices) of a row that are extreme positions of a point."""
    zero = (0,) if isinstance(row.zero, Extreme) else ()
    return (
        *zero,
        *(row.count + k for k, extra in enumerate(row.extra) if isinstance(extra, Extreme)),
    )


def _refuse_repeated(sweep: Sweep, row: Row) -> None:
    for place, extra in enumerate(row.extra):
        if extra in row.extra[:place] or (isinstance(extra, Extreme) and extra == row.zero):
            if isinstance(extra, Extreme):
                told = f"{extra.point}: {extra.at}"
            else:
                told = f"{extra:.10g}{'°' if sweep.turns else ' m'}"
            raise StructureError(
                said("{told} is named twice: leave one of the two out", told=told),
                "drive.extra",
                head="extra",
            )


def _refuse_late(survey: Survey, extreme: Extreme) -> None:
    if survey.returning_late and survey.sweep.closed:
        raise StructureError(
            said(
                "the extreme position of {point} may lie in the second turn (group {group} flips an odd "
                "number of times in a turn): give the crank angle in degrees",
                point=extreme.point,
                group=survey.returning_late[0],
            ),
            "drive.extra",
            head="extra",
        )


def _degrees(row: Row, angle: float) -> str:
    """Return an angle with ten digits, or as many more as tell it from a rounder one and from the others."""
    others = [other for other in row.extra if isinstance(other, float) and other != angle]
    for digits in range(10, 18):
        told = f"{angle:.{digits}g}"
        rounder = len(told) < digits and abs(float(told) - angle) > ROUNDING * abs(angle)
        if not rounder and told not in [f"{other:.{digits}g}" for other in others]:
            break
    return told


def _numbers(values: np.ndarray, row: Row, sweep: Sweep, sense: float) -> np.ndarray:
    """Return where coordinates stand in a row, in intervals of it."""
    if row.open:
        own = values[: row.count]
        order = np.argsort(own)
        numbers = np.interp(values, own[order], order)
    else:
        turn = sweep.high - sweep.low
        gone = np.round((values - values[0]) * sense, LAST) % turn
        numbers = gone * row.count / (turn * row.turns)
    numbers[: row.count] = np.arange(row.count)
    return np.asarray(numbers)


def _names(row: Row, numbers: np.ndarray, *, turns: bool) -> tuple[str, ...]:
    """Return the names of positions: numbers, angles outside the row, others after the position they follow."""
    names = [str(row.first + k) for k in range(row.count)]
    for extra, number in zip(row.extra, numbers[row.count :], strict=True):
        if turns and not isinstance(extra, Extreme):
            names.append(f"{_degrees(row, extra)}°")
            continue
        passed = math.floor(number + 1e-9) % (row.count // row.turns)
        name = f"{row.first + passed}*"
        while name in names:
            name += "*"
        names.append(name)
    return tuple(names)
