"""What is given on a board of one's own, and what is recorded there: instruments, and any operation.

The first argument of an instrument is the letter of what it draws, which it returns. A length (mm), an
angle (degrees) may be given as a number.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.grammar import OPERATIONS, Operation
from graphic_tmm.board.operations import formulas  # noqa: F401 - entered into the table by being read
from graphic_tmm.board.operations import instruments as ops
from graphic_tmm.board.operations.curve import french_curve
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.values import Angle, Kind, Length, Number, Point, Side
from graphic_tmm.errors import ConstructionError
from graphic_tmm.face.picture import LINK, VECTOR
from graphic_tmm.face.refusals import absent
from graphic_tmm.language.said import said
from graphic_tmm.scene.chapter import whole_book

Given = Mark | float | Sequence[float] | NDArray[Any]
"""A mark, or a number: of several positions one each."""


class Instruments(ABC):
    """Pencil, square, compass and ruler."""

    @abstractmethod
    def draw(
        self,
        operation: str | Operation,
        letter: str,
        *uses: Given,
        unit: str = "",
        why: str = "",
        **choice: int,
    ) -> Mark:
        """Record any operation of the board."""

    def join(self, letter: str, start: Mark, end: Mark) -> Mark:
        """Draw the line `it` through `start` and `end`."""
        return self.draw(ops.join, letter, start, end)

    def ray(self, letter: str, start: Mark, angle: Given) -> Mark:
        """From `start` draw the ray `it` at the angle `angle` to the x axis."""
        return self.draw(ops.ray, letter, start, angle)

    def parallel(self, letter: str, through: Mark, to: Mark, *, sense: int = 1) -> Mark:
        """Through `through` draw `it` parallel to `to`.

        ``sense``: +1, or -1 for the other way.
        """
        return self.draw(ops.parallel, letter, through, to, sense=sense)

    def square(self, letter: str, through: Mark, to: Mark, *, sense: int = 1) -> Mark:
        """Through `through` draw `it` square to `to`.

        ``sense``: +1, or -1 for the other way.
        """
        return self.draw(ops.square, letter, through, to, sense=sense)

    def incline(self, letter: str, through: Mark, to: Mark, by: Given) -> Mark:
        """Through `through` draw `it` at the angle `by` to `to`."""
        return self.draw(ops.incline, letter, through, to, by)

    def shift(self, letter: str, to: Mark, by: Given) -> Mark:
        """Parallel to `to`, at the distance `by` to its left, draw `it`."""
        return self.draw(ops.shift, letter, to, by)

    def lay_off(self, letter: str, on: Mark, length: Given) -> Mark:
        """On `on` lay off `length` from its beginning; mark `it`."""
        return self.draw(ops.lay_off, letter, on, length)

    def place(self, letter: str, on: Mark, x: Given, y: Given) -> Mark:
        """On `on` lay off `x` from its beginning and, square to it to the left, `y`; mark `it`."""
        return self.draw(ops.place, letter, on, x, y)

    def strike(self, letter: str, centre: Mark, radius: Given) -> Mark:
        """With the compass at `centre` and the opening `radius` strike the arc `it`."""
        return self.draw(ops.strike, letter, centre, radius)

    def meet(self, letter: str, base: Mark, other: Mark) -> Mark:
        """Where `base` and `other` meet, mark `it`."""
        return self.draw(ops.meet, letter, base, other)

    def cut(self, letter: str, line: Mark, arc: Mark, side: int) -> Mark:
        """Where the arc `arc` cuts `line`, `side` from the foot of the arc's centre, mark `it`.

        ``side``: +1 along it, -1 back along it.
        """
        return self.draw(ops.cut, letter, line, arc, side)

    def cross(self, letter: str, first: Mark, second: Mark, side: int) -> Mark:
        """Where the arcs `first` and `second` meet, `side` going from centre to centre, mark `it`.

        ``side``: +1 to the left, -1 to the right.
        """
        return self.draw(ops.cross, letter, first, second, side)

    def tangent(self, letter: str, through: Mark, centre: Mark, radius: Given, side: int) -> Mark:
        """From `through` draw the tangent `it` to the circle of radius `radius` about `centre`, `side`.

        ``side``: +1 directed from the centre to the point, -1 directed from the point to the centre.
        """
        return self.draw(ops.tangent, letter, through, centre, radius, side)

    def touch(self, letter: str, start: Mark, arc: Mark, side: int) -> Mark:
        """From `start` draw the tangent to the arc `arc`, `side` of the way to its centre; mark the contact it.

        ``side``: +1 to the left, -1 to the right.
        """
        return self.draw(ops.touch, letter, start, arc, side)

    def similar(self, letter: str, base_a: Mark, base_b: Mark, A: Mark, B: Mark, S: Mark) -> Mark:
        """On `base_a` `base_b` build the figure similar to `A` `B` `S`, lettered in the same sense; mark it."""
        return self.draw(ops.similar, letter, base_a, base_b, A, B, S)

    def homologous(
        self, letter: str, start: Mark, a: Mark, b: Mark, A: Mark, B: Mark, Q: Mark, E: Mark
    ) -> Mark:
        """From `start` draw the segment that is to `Q` `E` as `a` `b` is to `A` `B`, turned alike; mark it."""
        return self.draw(ops.homologous, letter, start, a, b, A, B, Q, E)

    def measure(self, letter: str, start: Mark, end: Mark) -> Mark:
        """Measure `start` `end`."""
        return self.draw(ops.measure, letter, start, end)

    def measure_along(self, letter: str, start: Mark, end: Mark, on: Mark) -> Mark:
        """Measure `start` `end` along `on`, with its sign."""
        return self.draw(ops.measure_along, letter, start, end, on)

    def bearing(self, letter: str, start: Mark, end: Mark) -> Mark:
        """Find the angle of `start` `end` from the x axis."""
        return self.draw(ops.bearing, letter, start, end)


NUMBERS = (Length, Angle, Number, Side)
"""Kinds that a number may stand for."""


class Drafting(Instruments):
    """The log that is written, and the values of what is given in it."""

    def __init__(self, view: str) -> None:
        self._draft = Draft()
        self._draft.open(view)

    def open(self, view: str) -> None:
        """Begin a view of its own, such as a plan of vectors, or go on with it.

        Parameters
        ----------
        view : str
            Its name; letters are its own. What is drawn next stands in it.
        """
        self._draft.open(view)

    def point(self, letter: str, x: Given, y: Given) -> Mark:
        """Take a given point.

        Parameters
        ----------
        letter : str
            What it is called.
        x, y : float or sequence
            Where it is, mm.
        """
        return self._take(Point, letter, np.asarray(x) + 1j * np.asarray(y))

    def length(self, letter: str, mm: Given) -> Mark:
        """Take a given length.

        Parameters
        ----------
        letter : str
            What it is called.
        mm : float or sequence
            How long it is on the sheet, mm.
        """
        return self._take(Length, letter, mm)

    def angle(self, letter: str, degrees: Given) -> Mark:
        """Take a given angle.

        Parameters
        ----------
        letter : str
            What it is called.
        degrees : float or sequence
            Counter-clockwise positive; of several positions one each.
        """
        return self._take(Angle, letter, degrees, "°")

    def number(self, letter: str, value: Given, unit: str = "") -> Mark:
        """Take a given quantity, or a scale factor.

        Parameters
        ----------
        letter : str
            What it is called.
        value : float or sequence
            In SI units; of a scale factor in SI units per mm.
        unit : str
            Its unit: "m/s", "(m/s)/mm".
        """
        return self._take(Number, letter, value, unit)

    def draw(
        self,
        operation: str | Operation,
        letter: str,
        *uses: Given,
        unit: str = "",
        why: str = "",
        **choice: int,
    ) -> Mark:
        """Record any operation of the board: an instrument, a formula.

        Parameters
        ----------
        operation : str or Operation
            Its name: "meet", "in_si" (length times scale factor), "to_board" (quantity by scale factor) ...
        letter : str
            Of what it leaves.
        *uses : Mark or float
            What it takes; a number where it takes a length (mm), an angle (degrees), a number or a side (±1).
        unit : str
            Of the quantity that a formula gives.
        why : str
            The reason of this step; left out, that of the operation.
        **choice : int
            What the operation leaves to be chosen, as ``sense=-1``.

        Returns
        -------
        Mark
            What it leaves.

        Raises
        ------
        AbsentError
            If there is no such operation.
        ConstructionError
            If it takes other marks, or a point of that letter stands in this view already.
        """
        if isinstance(operation, str):
            if operation not in OPERATIONS:
                whole_book()
            if operation not in OPERATIONS:
                raise absent(operation, OPERATIONS)
            operation = OPERATIONS[operation]
        kinds = (*operation.takes, *[None] * len(uses))
        marks = [self._mark(one, kind, operation) for one, kind in zip(uses, kinds, strict=False)]
        chosen: Any = choice
        return self._draft.board.draw(operation, letter, *marks, unit=unit, why=why, **chosen)

    def curve(self, letter: str, through: Mark) -> Mark:
        """Draw the closed smooth curve on which a point lies in all positions, with the French curve.

        Parameters
        ----------
        letter : str
            Of the curve.
        through : Mark
            A point that has several positions, one after the other round the curve.
        """
        return self.draw(french_curve, letter, through, row=self.positions)

    def link(self, *points: Mark) -> None:
        """Draw a link heavily: a rod by two points, a plate by more.

        Parameters
        ----------
        *points : Mark
            Its points, of one view.
        """
        self._draft.figure(LINK, "", *points)

    def vector(self, start: Mark, end: Mark) -> None:
        """Draw an arrow from one point to another.

        Parameters
        ----------
        start, end : Mark
            Points of one view.
        """
        self._draft.figure(VECTOR, "", start, end)

    def say(self, remark: str) -> None:
        """Write a remark that stands before the next step.

        Parameters
        ----------
        remark : str
            A vector equation, a heading.
        """
        self._draft.say(remark)

    @property
    def construction(self) -> Construction:
        """The log as it stands."""
        return self._draft.board.construction()

    @property
    def positions(self) -> int:
        """How many positions are drawn: as many as the longest row of numbers given."""
        rows = (np.asarray(value) for value in self._draft.given.values())
        return max((row.shape[1] for row in rows if row.ndim > 1), default=1)

    def _take(self, kind: Kind, letter: str, value: Any, unit: str = "") -> Mark:
        row = np.asarray(value)
        if row.ndim > 1 or row.dtype.kind not in "iufc" or not row.size:
            says = said("'{letter}': a number is wanted, or a row of them", letter=letter)
            raise ConstructionError(says)
        if row.size > 1 and self.positions not in (1, row.size):
            raise ConstructionError(
                said(
                    "'{letter}': {count} positions are given, {there} before; give as many",
                    letter=letter,
                    count=row.size,
                    there=self.positions,
                )
            )
        return self._draft.take(kind, letter, row[None] if row.ndim else row.item(), unit)

    def _mark(self, one: Given, kind: Kind, operation: Operation) -> Mark:
        """Return a mark as it is, and a number as a given mark without a letter."""
        if isinstance(one, Mark):
            return one
        if kind not in NUMBERS:
            says = said("{operation} takes a mark here, not a number", operation=operation.name)
            raise ConstructionError(says)
        return self._take(kind, "±" if kind is Side else "", one, "°" if kind is Angle else "")
