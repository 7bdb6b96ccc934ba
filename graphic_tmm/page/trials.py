"""A mechanism of its own lengths and of others, traced: what ink that is tied to marks is tried with."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple
from zlib import crc32

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.record import Mark, kept
from graphic_tmm.board.values import Complexes, Number
from graphic_tmm.drawn import Drawn, Numbers
from graphic_tmm.page.dense import Dense
from graphic_tmm.page.strands import MovingFigures
from graphic_tmm.paper.covering import covered
from graphic_tmm.paper.expressions import Expressions
from graphic_tmm.paper.traced import traced

SHARES, ANGLES = (0.0, 0.03, 0.08, 0.15), (24, 12, 12, 12)
"""By how much lengths and other quantities are varied at most in each trial; at how many angles it is drawn.
More of both found out nothing further over the scenes of the package."""


class Trial(NamedTuple):
    """A mechanism of some lengths: as drawn, with traced numbers; its numbers; its angles (indices)."""

    drawn: Drawn
    reading: Reading
    angles: tuple[int, ...]


def trials(found: Dense, among: Expressions) -> tuple[Trial, ...]:
    """Return the mechanism of its own lengths and of others."""
    return tuple(
        trial(found, varied(found, n, share), among, angles_of(found, n, count))
        for n, (share, count) in enumerate(zip(SHARES, ANGLES, strict=True))
    )


def angles_of(found: Dense, n: int, count: int) -> tuple[int, ...]:
    """Return so many whole degrees evenly over the turn, others in each trial ``n``."""
    spread = (7 * n + k * found.whole // count for k in range(count))
    return tuple(dict.fromkeys(k % found.whole for k in spread))


def trial(
    found: Dense, given: Mapping[Mark, Any], among: Expressions, angles: tuple[int, ...]
) -> Trial:
    """Return the mechanism with other givens."""
    reading = execute(found.log, given)
    seen = traced(reading, among)
    numbers = Numbers(seen, dict.fromkeys(found.drawn.numbers.own, seen), seen)
    drawn = replace(found.drawn, numbers=numbers, given=given)
    for chapter in drawn.project.chapters:
        drawn.cache.update(MovingFigures.of(chapter).own(found.sheet, drawn))
    return Trial(drawn, reading, angles)


def varied(found: Dense, n: int, share: float) -> dict[Mark, Any]:
    """Return what is given, each quantity varied by up to a share of it; alike letters alike."""
    given = dict(found.given)
    for mark in found.log.given:
        if _quantity(mark, given[mark]):
            by = 2.0 * crc32(f"{mark.name} {n}".encode()) / 2**32 - 1.0
            given[mark] = given[mark] * (1.0 + share * by)
    return given | _across(found, given)


def _across(found: Dense, given: Mapping[Mark, Any]) -> dict[Mark, Any]:
    """Return what is drawn once across the positions of the sheet, with other givens."""
    log, sheet = found.sheet.construction, found.sheet.given
    own = {m: given.get(m, value) if _single(value) else value for m, value in sheet.items()}
    marks = [step.it for step in log.steps if step.op.across and step.it in given]
    drawn = kept(log, own, execute(log, own, marks).values)
    return {mark: drawn[mark] for mark in marks if mark in drawn}


def _single(value: Any) -> bool:
    return np.size(value) == 1


def _quantity(mark: Mark, value: Any) -> bool:
    """Whether a given is a quantity of its own: one number with a unit."""
    own = mark.kind is Number and mark.role not in (roles.ROW, roles.STATION)
    return own and mark.unit != "" and np.size(value) == 1


def values_of(
    among: Expressions,
    reading: Reading,
    angles: Sequence[int],
    whole: int,
    only: Iterable[int] | None = None,
) -> dict[int, Complexes]:
    """Return the values of all expressions, or ``only`` of some, at some angles, each (angle,).

    ``whole``: so many positions make the turn.
    """

    def mark(slot: int, part: int) -> Any:
        value = reading.values[slot]
        row = (value[part] if isinstance(value, tuple) else value)[0]
        return np.broadcast_to(row, (reading.positions,))

    def over_turn(op: str, node: int) -> Any:
        row = among.values(mark, over_turn, covered, [node])[node].real
        row = np.broadcast_to(row, (reading.positions,))[:whole]
        # beside a lock an extreme lies between two whole degrees: NaN, as all that is not everywhere
        return np.array(row.min() if op == "lowest" else row.max())

    at = list(angles)
    found = among.values(lambda slot, part: mark(slot, part)[at], over_turn, covered, only)
    alone = (len(at),)
    return {
        k: value if value.shape == alone else np.broadcast_to(value, alone)
        for k, value in found.items()
    }
