"""The instruments as methods: what each does is the sentence of its operation, with which its docstring begins.

The first argument of each is the letter of what it draws, which it returns. A length (mm), an angle (degrees)
may be given as a number.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import Any

from numpy.typing import NDArray

from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.operations import instruments as ops
from graphic_tmm.board.record import Mark

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
