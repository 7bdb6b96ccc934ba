"""What is given on a board of one's own, and what is recorded there: any operation, by its marks or numbers."""

from __future__ import annotations

from typing import Any

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.grammar import OPERATIONS, Operation
from graphic_tmm.board.operations import formulas  # noqa: F401 - entered into the table by being read
from graphic_tmm.board.operations.curve import french_curve
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.values import Angle, Kind, Length, Number, Point, Side
from graphic_tmm.errors import ConstructionError
from graphic_tmm.face.asked import absent
from graphic_tmm.face.instruments import Given, Instruments
from graphic_tmm.face.picture import LINK, VECTOR
from graphic_tmm.language.said import said
from graphic_tmm.scene.chapter import whole_book

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
