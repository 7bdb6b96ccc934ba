"""Readings that are of no mark of their own (diagrams, forces, results, parts), by the tables' figures.

Such a figure hangs on many that were read before. It may have been found from these, or from what the
student had without writing it down: of both what the readings are more likely with is taken.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.checking.cells import Key, due_figure, taken_figure
from graphic_tmm.checking.judging.comparison import Comparison
from graphic_tmm.checking.judging.own_errors import apart
from graphic_tmm.checking.mutations.likelihood import (
    BEYOND,
    LOST,
    PLAN,
    broad,
    explained,
    log_density,
    multiple,
    size_of,
)
from graphic_tmm.checking.records import Taken

Array = NDArray[np.float64]


class Reading(NamedTuple):
    """A reading of such a figure: what was found and is due, by what it scatters, what a mm is in its unit.

    ``place``: the index of its position, the number of positions where it has none of the mechanism's;
    ``beside``: it is the quantity of a length that was read, too.
    """

    taken: Taken
    found: complex
    due: complex
    scatter: float
    mm: float
    place: int
    beside: bool = False

    @property
    def at(self) -> tuple[Key, bool]:
        """By what its figure is known."""
        return self.taken.at

    def evidence(self, figures: Any, found: Any = None) -> tuple[Array, Array, Array]:
        """Return how likely it is, how far off, how lost; ``found``: what was read, if otherwise."""
        read = self.found if found is None else found
        if self.taken.pointed:
            error = np.abs(np.asarray(read) - figures)
        else:
            error = apart(np.asarray(read, dtype=complex).real, np.asarray(figures).real)
        change = np.abs(np.asarray(figures) - self.due)
        gone = ~np.isfinite(error)
        whole = PLAN if self.taken.pointed else abs(self.found)
        size = size_of(
            self.scatter, 0.0 if self.taken.pointed else whole, self.mm, np.nan_to_num(change)
        )
        with np.errstate(all="ignore"):
            likely = log_density(error, size, whole)
            off = np.abs(error) / size
        return np.where(gone, LOST, likely), np.where(gone, 0.0, off), gone * 1.0

    @property
    def nearest(self) -> float:
        """The logarithm of how likely it is if it is exactly what it was expected to be."""
        return float(self.evidence(np.asarray(self.found))[0])

    @property
    def unknown(self) -> float:
        """The logarithm of how likely it is if nothing is known of how it was found."""
        size = size_of(self.scatter, abs(self.found), self.mm)
        known = self.evidence(np.asarray(self.due))[0]
        free = broad(abs(self.found - self.due), size, abs(self.found))
        return float(np.log(0.5 * np.exp(known) + 0.5 * free))


def readings(drawing: Comparison, marked: Sequence[Taken]) -> list[Reading]:
    """Return the readings of a drawing that no step of their own is known of; ``marked``: the others."""
    known = set(marked)
    names = drawing.made.mechanism.names if drawing.made.mechanism is not None else ()
    found = []
    for taken in drawing.rows:
        limit = drawing.by.spread.get(taken.at)
        if taken in known or limit is None or not limit.sorted.size:
            continue
        place = names.index(taken.position) if taken.position in names else len(names)
        scatter = drawing.worse * limit.rms
        if taken.pointed:
            found.append(Reading(taken, taken.spot, drawing.spots[taken.key], scatter, 1.0, place))
            continue
        cell = drawing.due[taken.key]
        mu = 1.0 if taken.mm is not None else drawing.scale(taken)
        mm = mu if np.isfinite(mu) else 0.0
        beside = drawing.length_of(taken)
        due = due_figure(cell, taken)
        if beside is not None and np.isfinite(mu):
            due, scatter = abs(beside.mm or 0.0) * mu, 0.0
        figure, length = taken_figure(taken, cell), beside is not None
        figure = abs(figure) if length else figure  # a length has no sign to compare
        found.append(Reading(taken, figure, due, scatter, mm, place, length))
    return found


def multiples(rows: Sequence[Reading]) -> list[float]:
    """Return what the readings of each segment gain by being so many times what is due."""
    segments: dict[tuple[str, str, bool], list[Reading]] = {}
    for one in rows:
        if not one.beside and not one.taken.pointed:
            key = one.taken.plan, one.taken.segment, one.taken.mm is not None
            segments.setdefault(key, []).append(one)
    found = []
    for some in segments.values():
        read = np.array([one.found.real for one in some])
        due = read - np.array([float(apart(one.found.real, one.due.real)) for one in some])
        scatter = np.array([one.scatter for one in some])
        found.append(multiple(read, due, scatter, np.abs(read), max(one.mm for one in some)))
    return found


def gains(
    rows: Sequence[Reading], ways: Sequence[Mapping[tuple[Key, bool], Any]], count: int, places: int
) -> tuple[Array, Array, Array, Array, Array]:
    """Return what readings gain on the base, how many are beyond and lost, (row, position).

    And how many are moved and explained, with the sum of the squares of how far off these are.

    ``ways``: the figures of rows, each way they may have been found; the first row is the base.
    """
    gain, beyond, lost, moved, squares = (np.zeros((count, places + 1)) for _ in range(5))
    for one in rows:
        best: tuple[Array, Array, Array] | None = None
        for figures in ways:
            if one.at not in figures or one.beside:
                continue
            found = one.evidence(figures[one.at])
            if best is None:
                best = found
            else:
                better, pairs = found[0] > best[0], zip(found, best, strict=True)
                likely, off, gone = (np.where(better, new, old) for new, old in pairs)
                best = likely, off, gone
        if best is None:
            beyond[:, one.place] += float(one.evidence(np.asarray(one.due))[1] > BEYOND)
            continue
        base, far = (np.ravel(part)[0] for part in best[:2])
        gain[:, one.place] += best[0] - base
        beyond[:, one.place] += best[1] > BEYOND
        lost[:, one.place] += best[2]
        its_moved, its_squares = explained(best[1], far)
        moved[:, one.place] += its_moved
        squares[:, one.place] += its_squares
    return gain, beyond, lost, moved, squares
