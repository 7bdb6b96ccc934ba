"""Verdicts: how far a reading is from its due, measured by how far the hand's own drawings are.

A reading is doubtful where the hand is farther off in a small share of its drawings only, wrong where none of
them comes near. Where earlier readings enter a figure, they are taken as they were found: a slip is blamed
once.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.hand import Hand
from graphic_tmm.checking.cells import Cell, Key, cells, longest, points
from graphic_tmm.checking.own import OwnErrors
from graphic_tmm.checking.records import DOUBTFUL, FINE, WRONG, Judged, Taken
from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.scene.quantities import UNITS, plain
from graphic_tmm.studio import Made, drawings

OWN_TRIALS = 150
"""How often the hand draws to tell what errors its steps make by themselves."""
LEAST = 1e-9
"""A deviation below this share of the plan is none."""


class Limits(NamedTuple):
    """``doubtful``: the quantile of the hand's deviations; ``wrong``: how many times their root mean square.

    A reading is never wrong within ``beyond`` times the farthest of the hand's own drawings.
    """

    doubtful: float = 0.97
    wrong: float = 5.0
    beyond: float = 1.2


class Scatter(NamedTuple):
    """How far the hand's drawings are off a figure: sorted deviations, the limits that follow."""

    sorted: np.ndarray
    doubtful: float
    wrong: float

    def quantile(self, deviation: float) -> float:
        """Return the share of the hand's drawings that are farther off."""
        if not self.sorted.size:
            return 1.0
        below = int(np.searchsorted(self.sorted, deviation, side="left"))
        return float(self.sorted.size - below) / self.sorted.size

    def verdict(self, deviation: float) -> str:
        """Return what a deviation is."""
        if deviation > self.wrong:
            return WRONG
        return DOUBTFUL if deviation > self.doubtful else FINE


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


def scatter(
    made: Made, hand: Hand, wanted: Mapping[Key, Iterable[bool]], limits: Limits
) -> dict[tuple[Key, bool], Scatter]:
    """Return how the hand's drawings scatter, by figure and whether it is in mm."""
    due = cells(made)
    spots = points(made)
    rows: dict[tuple[Key, bool], list[float]] = {
        (key, in_mm): [] for key, kinds in wanted.items() for in_mm in kinds if key in due
    }
    placed: dict[Key, list[float]] = {key: [] for key in wanted if key not in due}
    for drawn in drawings(made, hand):
        where = points(drawn) if placed else {}
        for key, deviations in placed.items():
            if key in where:
                deviations.append(abs(where[key] - spots[key]))
        found = cells(drawn) if rows else {}
        for (key, in_mm), deviations in rows.items():
            one = found.get(key)
            figure = None if one is None else (one.mm if in_mm else one.value)
            goal = due[key].mm if in_mm else due[key].value
            if figure is not None and goal is not None:
                deviations.append(abs(abs(figure) - abs(goal)))
    every = rows | {(key, True): deviations for key, deviations in placed.items()}
    return {at: _limits(np.sort(np.array(d)), limits) for at, d in every.items()}


def _own_scatter(
    made: Made, readings: Sequence[Taken], hand: Hand, limits: Limits
) -> dict[Key, Scatter]:
    """Return how far off the hand's own steps are, where earlier readings are taken as found."""
    rows: dict[Key, list[float]] = {}
    for drawn in drawings(made, hand._replace(trials=min(hand.trials, OWN_TRIALS))):
        figures, where = cells(drawn), points(drawn)
        again = []
        for taken in readings:
            key = (taken.plan, taken.segment, taken.position)
            if _pointed(taken) and key in where:
                z = where[key]
                again.append(taken._replace(x=z.real, y=z.imag))
            elif taken.mm is not None and key in figures and figures[key].mm is not None:
                again.append(taken._replace(mm=abs(figures[key].mm or 0.0)))
        errors = OwnErrors(made, again)
        for taken in again:
            mine = errors.of(taken)
            if mine is not None:
                key = (taken.plan, taken.segment, taken.position)
                rows.setdefault(key, []).append(abs(mine))
    return {key: _limits(np.sort(np.array(row)), limits) for key, row in rows.items()}


def _limits(deviations: np.ndarray, limits: Limits) -> Scatter:
    if not deviations.size:
        return Scatter(deviations, np.inf, np.inf)
    root = float(np.sqrt(np.mean(deviations**2)))
    doubtful = float(np.quantile(deviations, limits.doubtful))
    wrong = max(limits.wrong * root, limits.beyond * float(deviations[-1]))
    return Scatter(deviations, doubtful, max(wrong, doubtful))


def judge(
    made: Made, readings: Sequence[Taken], hand: Hand, limits: Limits, source: str
) -> tuple[tuple[Judged, ...], dict[tuple[Key, bool], Scatter]]:
    """Return every reading with its verdict, and the scatter that it was judged by.

    ``made``: drawn by the exact hand.

    Raises
    ------
    SceneError
        If readings name what the scene does not have; all of them at once.
    """
    due, spots = cells(made), points(made)
    faults, known = [], []
    for taken in readings:
        key = (taken.plan, taken.segment, taken.position)
        says = "" if _pointed(taken) and key in spots else _unknown(key, taken, due)
        if says:
            faults.append(Fault("", taken.line, says))
        else:
            known.append((key, taken))
    if faults:
        raise SceneError(source, tuple(faults[:20]))
    wanted: dict[Key, set[bool]] = {}
    for key, taken in known:
        wanted.setdefault(key, set()).add(taken.mm is not None or _pointed(taken))
    spread = scatter(made, hand, wanted, limits)
    most, own = longest(due), OwnErrors(made, [taken for _, taken in known])
    usual = _own_scatter(made, [taken for _, taken in known], hand, limits)
    judged = []
    for key, taken in known:
        in_mm = taken.mm is not None or _pointed(taken)
        if _pointed(taken):
            found, goal, of = abs(_spot(taken)), abs(spots[key]), "mm"
            deviation = signed = abs(_spot(taken) - spots[key])
        else:
            cell = due[key]
            found, goal = taken_figure(taken, cell), amount(cell, taken)
            signed, of = apart(found, goal), "mm" if in_mm else cell.unit
            deviation = abs(signed)
        seen = spread[key, in_mm]
        whole = most.get((taken.plan, taken.position), 0.0)
        share = 100.0 * deviation / whole if in_mm and whole else 0.0
        mine = own.of(taken)
        counted = deviation
        if mine is not None and key in usual:
            counted, seen = abs(mine), usual[key]
        if counted <= LEAST * max(whole, abs(goal)):
            counted = 0.0
        verdict = seen.verdict(counted)
        blamed = own.step(taken) if verdict != FINE else ""
        quantile = seen.quantile(counted)
        judged.append(
            Judged(taken, found, goal, signed, share, quantile, verdict, of, blamed, mine)
        )
    return tuple(judged), spread


def _pointed(taken: Taken) -> bool:
    """Whether a reading gives the coordinates of a point."""
    return taken.mm is None and taken.x is not None and taken.y is not None


def _spot(taken: Taken) -> complex:
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
