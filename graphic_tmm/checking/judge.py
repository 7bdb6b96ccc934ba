"""Verdicts: how far a reading is from its due, measured by how far the hand's own drawings are.

A reading is doubtful where the hand is farther off in a small share of its drawings only, wrong where none of
them comes near. Where earlier readings enter a figure, they are taken as they were found: a slip is blamed
once.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from graphic_tmm.board.hand import Hand
from graphic_tmm.checking.cells import Cell, Key, cells, longest, points
from graphic_tmm.checking.own import OwnErrors
from graphic_tmm.checking.records import FINE, VERDICTS, Judged, Taken
from graphic_tmm.checking.scatter import Limits, Scatter, scatter
from graphic_tmm.checking.usual import Usual, usual_errors
from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.scene.quantities import UNITS, plain
from graphic_tmm.studio import Made

LEAST = 1e-9
"""A deviation below this share of the plan is none."""


def amount(cell: Cell, taken: Taken) -> float:
    """Return the figure that a reading is compared with: mm where it is given in mm."""
    found = cell.mm if taken.mm is not None else cell.value
    assert found is not None
    return found


def apart(found: float, due: float) -> float:
    """Return by how much a figure exceeds its due; a segment without a sign is a magnitude."""
    return found - due if found < 0.0 else found - abs(due)


def taken_figure(taken: Taken, cell: Cell) -> float:
    """Return a reading in mm, or as a quantity in the unit of its figure.

    Raises
    ------
    ValueError
        If its unit is not known or measures something else.
    """
    if taken.mm is not None:
        return taken.mm
    assert taken.value is not None
    if taken.unit in ("", "1", cell.unit):
        return taken.value
    own, other = UNITS.get(plain(taken.unit)), UNITS.get(plain(cell.unit))
    if own is None or (other is not None and own.dimension != other.dimension):
        raise ValueError(
            f'the unit "{taken.unit[:20]}" does not fit; write it in {cell.unit or "plain numbers"}'
        )
    factor = float(other.factor) if other is not None else 1.0
    return taken.value * float(own.factor) / factor


class Yardstick(NamedTuple):
    """By what readings are judged: how the hand's drawings scatter, and what errors its own steps make."""

    spread: Mapping[tuple[Key, bool], Scatter]
    usual: Mapping[Key, Usual]


def yardstick(made: Made, readings: Sequence[Taken], hand: Hand, limits: Limits) -> Yardstick:
    """Return by what readings of these figures are judged. ``made``: drawn by the exact hand."""
    wanted: dict[Key, set[bool]] = {}
    for taken in readings:
        wanted.setdefault(taken.key, set()).add(taken.in_mm)
    spread = scatter(made, hand, wanted, limits)
    return Yardstick(spread, usual_errors(made, readings, hand, limits))


def refuse_unknown(made: Made, readings: Sequence[Taken], source: str) -> None:
    """Raise what is wrong with the names of readings.

    Raises
    ------
    SceneError
        If readings name what the scene does not have; all of them at once.
    """
    due, spots = cells(made), points(made)
    faults = []
    for taken in readings:
        says = "" if taken.pointed and taken.key in spots else _unknown(taken.key, taken, due)
        if says:
            faults.append(Fault("", taken.line, says))
    if faults:
        raise SceneError(source, tuple(faults[:20]))


def judge(made: Made, readings: Sequence[Taken], by: Yardstick) -> tuple[Judged, ...]:
    """Return every reading with its verdict. ``made``: drawn by the exact hand."""
    due, spots = cells(made), points(made)
    most, own = longest(due), OwnErrors(made, readings)
    judged = []
    for taken in readings:
        key = taken.key
        if taken.pointed:
            found, goal, of = abs(spot_of(taken)), abs(spots[key]), "mm"
            deviation = signed = abs(spot_of(taken) - spots[key])
        else:
            cell = due[key]
            found, goal = taken_figure(taken, cell), amount(cell, taken)
            signed, of = apart(found, goal), "mm" if taken.in_mm else cell.unit
            deviation = abs(signed)
        seen = by.spread[key, taken.in_mm]
        whole = most.get((taken.plan, taken.position), 0.0)
        share = 100.0 * deviation / whole if taken.in_mm and whole else 0.0
        errors = own.of(taken)
        counted, of_it, blamed, mine = deviation, deviation, own.step(taken), None
        if errors and key in by.usual:
            times, worst = by.usual[key].worst(errors)
            mine = worst.error
            # a length that is right is not wrong because an earlier one was copied wrongly
            if taken.pointed or _milder(by.usual[key].scatter, times, seen, deviation):
                counted, seen = times, by.usual[key].scatter
                of_it, blamed = worst.error, worst.step
        if abs(of_it) <= LEAST * max(whole, abs(goal)):
            counted = 0.0
        verdict = seen.verdict(counted)
        step = own.named(blamed) if verdict != FINE else ""
        quantile = seen.quantile(counted)
        judged.append(Judged(taken, found, goal, signed, share, quantile, verdict, of, step, mine))
    return tuple(judged)


def _milder(one: Scatter, deviation: float, other: Scatter, by: float) -> bool:
    """Whether the first verdict is not more severe than the second."""
    return VERDICTS.index(one.verdict(deviation)) <= VERDICTS.index(other.verdict(by))


def spot_of(taken: Taken) -> complex:
    """Return where a reading says that a point stands."""
    assert taken.x is not None
    assert taken.y is not None
    return complex(taken.x, taken.y)


def _unknown(key: Key, taken: Taken, due: Mapping[Key, Cell]) -> str:
    """Return what is wrong with the name of a reading; empty if nothing."""
    plan, segment, position = key
    if key in due:
        cell = due[key]
        if taken.mm is not None and cell.mm is None:
            return f"{segment} is not drawn in mm; give its value and unit"
        if taken.mm is None and taken.value is None:
            return f"points are compared on plans of positions, velocities and accelerations, not {segment}"
        try:
            taken_figure(taken, cell)
        except ValueError as error:
            return str(error)
        return ""
    there = sorted({plan for plan, _, _ in due})
    if plan not in there:
        return f'there is no plan "{plan[:30]}"; there are {", ".join(there)}'
    segments = sorted({s for p, s, _ in due if p == plan})
    if segment not in segments:
        return f'plan {plan} has no segment "{segment[:30]}"; it has {", ".join(segments)}'
    places = [n for p, s, n in due if (p, s) == (plan, segment)]
    return (
        f'{segment} has no figure at position "{position[:20]}"; it has some at {", ".join(places)}'
    )
