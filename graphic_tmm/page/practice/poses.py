"""Variants of practice: each plan at another angle of the crank, which a seed chooses of the whole turn."""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Point, Reals
from graphic_tmm.board.values import given as as_value
from graphic_tmm.language.numbers import fixed
from graphic_tmm.page.dense import WHOLE, Dense, dense
from graphic_tmm.page.practice.tasks import Row

APART = 5
"""So many degrees a pose is from an angle that cannot be drawn, at least."""
SHORT = 4.0
"""No vector of a pose is shorter, mm, if the turn has such an angle: directions of shorter ones are lost."""


def posed(row: Row, seed: int) -> Row | None:
    """Return poses of a mechanism, one for each plan of a row; None where nothing turns.

    The same seed poses the same.
    """
    turn = dense(row.work)
    if turn is None or any(step not in turn.log.steps for step in row.steps):
        return None
    chosen = {plan: k for plan in row.places if (k := _angle(turn, row, plan, seed)) is not None}
    at = sorted(set(chosen.values()))
    if not at:
        return None
    given: Mapping[Mark, Any] = {mark: _cut(value, mark, at) for mark, value in turn.given.items()}
    language = row.work.scene.language
    names = tuple(f"{fixed(float(turn.angles[k]) % WHOLE, 1, language)}°" for k in at)
    places = {plan: (at.index(k),) for plan, k in chosen.items()}
    return Row(turn.drawn, turn.log, given, names, places)


def _angle(turn: Dense, row: Row, plan: str, seed: int) -> int | None:
    """Return the angle (its index) that a plan is posed at; None where it is nowhere drawn."""
    good = _drawn(turn)
    shortest = np.where(good, _shortest(turn, row, plan), -1.0)
    order = list(range(turn.whole))
    random.Random(f"{seed}|{plan}").shuffle(order)
    order = [k for k in order if k not in turn.at]
    found = next((k for k in order if shortest[k] >= SHORT), None)
    if found is None and order:
        best = max(order, key=lambda k: shortest[k])
        found = best if shortest[best] > 0.0 else None
    return found


def _drawn(turn: Dense) -> Any:
    """Return at which whole degrees a mechanism is drawn, and at all near them."""
    bad = np.zeros(turn.whole, dtype=bool)
    bad[[k for k in turn.drawn.undrawn if k < turn.whole]] = True
    near = np.zeros_like(bad)
    for by in range(-APART, APART + 1):
        near |= np.roll(bad, by)
    return ~near


def _shortest(turn: Dense, row: Row, plan: str) -> Reals:
    """Return the shortest vector of a plan at every whole degree, mm; NaN counts as none."""
    rows = list(_vectors(turn, row, plan))
    if not rows:
        return np.full(turn.whole, -1.0)
    return np.asarray(np.nan_to_num(np.min(rows, axis=0), nan=-1.0))


def _vectors(turn: Dense, row: Row, plan: str) -> Iterator[Reals]:
    """Yield what is to be drawn of a plan, mm along the angles: lengths, points from its pole.

    What is nothing everywhere is none.
    """
    reading = turn.drawn.reading
    for step in row.steps:
        if step.it.view != plan or step.it.kind not in (Length, Point):
            continue
        length = np.abs(np.broadcast_to(reading[step.it], (1, turn.turned.size))[0, : turn.whole])
        if not (length < SHORT).all():
            yield length


def _cut(value: object, mark: Mark, at: list[int]) -> Any:
    found = as_value(value, mark.kind)
    if isinstance(found, np.ndarray) and found.shape[1] > 1:
        return found[:, at]
    return found
