"""Readings as marks of the log: which step each is of, and how finely it can be told."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.findings import step_number
from graphic_tmm.board.hand import Hand, Streams
from graphic_tmm.board.record import Mark, Step, segment_name
from graphic_tmm.board.values import Length, Number, Point, Reals
from graphic_tmm.checking.cells import Cell, Key, half_of, pointed, taken_figure
from graphic_tmm.checking.judging import slips
from graphic_tmm.checking.judging.own_errors import Grain, alone
from graphic_tmm.checking.records import Last, Taken
from graphic_tmm.drawn import Drawn
from graphic_tmm.readers.columns import Readings
from graphic_tmm.scene.records import Scene


class Pointing(NamedTuple):
    """How x and y are read: the standard deviation of each is ``hand`` of the slip of the hand, or ``mm``.

    Common to a plan is what its ``pole`` is off, mm, to all of its kind what their ``scale`` factor is off, a
    share (standard deviations); neither tells how finely points were read.
    """

    hand: float
    mm: float
    pole: float = 0.0
    scale: float = 0.0


POINTS: Mapping[str, Pointing] = {
    "paper": Pointing(hand=1.0, mm=0.0),
    "screen": Pointing(hand=0.0, mm=0.1),
    "photo": Pointing(hand=0.0, mm=0.5),
    "own sheet": Pointing(hand=0.0, mm=0.5, pole=0.3, scale=0.005),
}
"""With ruler and square on the paper; by a cursor on the drawing itself; by a cursor on a photograph of it,
or of a student's own sheet, on which poles are clicked and scale factors estimated.

0.1 mm is what a cursor on an enlarged drawing leaves; 0.5 mm what corners clicked to 2 px leave of the
photograph of an A1 (0.7 mm at most). That is the most of it: where many points were read, the drawing
itself tells how much of it there is.
"""
GIVEN = 0.005
"""What the scene gives is right to three digits: it is looked at for slips, not for rounding. Could be
at least 0.002 to 0.015."""


class Reader(NamedTuple):
    """Who reads a drawing: the hand that drew it, with the coarser of its ruler and the sheet's.

    ``points``: how points are read; ``exactly``: without a slip of their own.
    """

    hand: Hand
    points: str = "paper"
    exactly: bool = False

    @property
    def half(self) -> float:
        """Half a division of the ruler, mm."""
        return 0.5 * (self.hand.ruler or 0.0)

    def unblurred(self, written: float) -> float:
        """Return how far rounding alone carries a length read off the paper, mm; see `slips`."""
        return slips.unblurred(self.half, written, self.hand.reading)

    def lost(self, last: Last, share: float = 1.0) -> float:
        """Return how far rounding alone carries a point, mm: the digits written, less the slip of reading it.

        ``share``: of that slip, as a drawing has it.
        """
        return slips.lost(last.x, last.y, share * self.pointing)

    def rounding(self, figure: float) -> float:
        """Return half a unit of the last digit that the hand keeps in a calculation."""
        return 0.0 if self.hand.digits is None else slips.rounding(self.hand.digits, figure)

    @property
    def pointing(self) -> float:
        """The standard deviation of a coordinate, mm."""
        by = POINTS[self.points]
        return 0.0 if self.exactly else max(by.hand * self.hand.reading, by.mm)

    @property
    def sharp(self) -> Reader:
        """Who reads the same drawing, but coordinates without a slip."""
        return self._replace(exactly=True)

    def chance(self, key: str, shape: tuple[int, int]) -> Reals:
        """Return standard normal numbers of a stream of their own."""
        return Streams(self.hand).normal(f"read|{key}", 0, 0, shape)

    def measured(self, length: Reals, key: str) -> Reals:
        """Return lengths (trial, position) that were drawn, as they are read off the paper."""
        return self.hand.read(length + self.hand.reading * self.chance(key, length.shape))

    def pointed(self, spot: np.ndarray, key: str) -> np.ndarray:
        """Return points (trial, position) as their coordinates are read."""
        wide = (spot.shape[0], 2 * spot.shape[1])
        spot = spot + self.pointing * self.chance(key, wide).view(np.complex128)
        if self.points != "paper" or self.exactly:
            return self._from_pole(spot, key.partition("|")[0])
        parts = np.ascontiguousarray(spot).view(np.float64)  # 1j · NaN would warn
        return np.asarray(self.hand.read(parts)).view(np.complex128)

    def _from_pole(self, spot: np.ndarray, plan: str) -> np.ndarray:
        """Return points of a plan with what its pole and its scale factor, common to all of them, are off."""
        by = POINTS[self.points]
        if by.scale:
            spot = spot * (1.0 + by.scale * self.chance(f"scale|{plan}", (spot.shape[0], 1)))
        if by.pole:
            wide = (spot.shape[0], 2 * spot.shape[1])
            spot = spot - by.pole * self.chance(f"pole|{plan}", wide).view(np.complex128)
        return spot


def reader(scene: Scene, hand: Hand, points: str) -> Reader:
    """Return who reads a drawing of a scene."""
    rulers = [ruler for ruler in (hand.ruler, scene.ruler) if ruler is not None]
    return Reader(hand._replace(ruler=max(rulers, default=None)), points)


def steps_of(work: Drawn | None) -> dict[tuple[str, str], Step]:
    """Return the steps of a mechanism that can be read: its lengths, points and rates, by plan and name.

    A plan that no position asks for is recorded where forces need it, and drawn nowhere.
    """
    if work is None:
        return {}
    log = work.construction
    found: dict[tuple[str, str], Step] = {}
    plans = pointed()
    steps = {
        step.it: step for step in alone(log) if step.it in (work.of(step.it.view) or work.reading)
    }
    for mark, step in steps.items():
        if mark.view in plans and mark.kind is Length:
            found.setdefault((mark.view, segment_name(mark.letter)), step)
        if mark.view in plans and mark.kind is Point:
            found.setdefault(mark.key, step)
    for chapter in work.project.chapters:
        for key, mark in Readings.of(chapter).named_marks(work.project).items():
            if mark in steps and mark.kind is Number:
                found[key] = steps[mark]
    return found


def step_name(work: Drawn | None, step: Step | None) -> str:
    """Return a step as a report names it: its number in its plan, its letter; empty for none."""
    if step is None or work is None:
        return ""
    return f"{step_number(work.construction, step)} {step.it.name}"


def scale_of(work: Drawn, plan: str) -> float:
    """Return μ of a plan, SI per mm; NaN if it has none."""
    view = work.construction.view(plan)
    mark = None if view is None else view.scale
    for reading in (work.reading, work.of(plan)):
        if mark is not None and reading is not None and mark in reading:
            return float(reading[mark][0, 0])
    return float("nan")


def as_marks(
    work: Drawn,
    steps: Mapping[tuple[str, str], Step],
    readings: Iterable[Taken],
    cells: Mapping[Key, Cell],
    by: Reader,
) -> tuple[dict[Mark, Any], dict[Mark, Grain]]:
    """Return what was read of marks, and how far it may be off by its rounding alone; arrays (1, position).

    A length that was read in mm and as a quantity is taken in mm.
    """
    names = work.names
    found: dict[Mark, Any] = {}
    grain: dict[Mark, Grain] = {}
    for taken in sorted(readings, key=lambda one: one.mm is not None):
        step = steps.get((taken.plan, taken.segment))
        if step is None or taken.position not in names:
            continue
        read = mark_figure(work, step, taken, cells.get(taken.key), by)
        if read is None:
            continue
        empty = np.full((1, len(names)), np.nan, np.complex128 if taken.pointed else np.float64)
        place = names.index(taken.position)
        found.setdefault(step.it, empty)[0, place] = read[0]
        nothing = Grain(np.zeros((1, len(names))), np.zeros((1, len(names))))
        of = grain.setdefault(step.it, nothing)
        of.read[0, place], of.used[0, place] = read[1:]
    return found, grain


def mark_figure(
    work: Drawn, step: Step, taken: Taken, cell: Cell | None, by: Reader
) -> tuple[complex | float, float, float] | None:
    """Return a reading in the unit of its mark (mm; of a rate its own), and how far rounding may carry it.

    Once as it was read, once as others are calculated with it.
    """
    last = taken.last
    if step.it.kind is Point:
        return (taken.spot, by.lost(last), 0.0) if taken.pointed else None
    if (taken.value is None and taken.mm is None) or cell is None:
        return None
    figure, half = taken_figure(taken, cell), half_of(taken, cell)
    if step.it.kind is Number:
        return figure, half, half
    mu = 1.0 if taken.mm is not None else scale_of(work, taken.plan)
    return figure / mu, by.unblurred(half / mu), half / mu + by.half
