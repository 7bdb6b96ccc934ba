"""What a synthesis leaves for its readers, and the ways of drawing that its kinds share."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import in_si, to_board
from graphic_tmm.board.operations.graphs import halve
from graphic_tmm.board.operations.instruments import (
    cut,
    incline,
    join,
    lay_off,
    measure,
    meet,
    ray,
    square,
    strike,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Point, Side
from graphic_tmm.chapters.linkage_synthesis import words as why
from graphic_tmm.chapters.linkage_synthesis.task import SYNTHESIS
from graphic_tmm.scene.length_task import Task


def line_name(start: Mark, end: Mark | str) -> str:
    """Return what the line through two points is called; their indices stay their own."""
    first = re.sub(r"_(\w+)", r"_{\1}", start.letter)
    return f"({first}{end if isinstance(end, str) else end.letter})"


class Circle(NamedTuple):
    """A circle of the figure about a point, as far as it goes through some others; ``pen`` as ink has it.

    ``farther``: how far it goes on behind these, degrees: a locus shows where else its point might stand.
    """

    pen: str
    centre: Mark
    through: tuple[Mark, ...]
    farther: float = 10.0


class Between(NamedTuple):
    """An angle of the figure at a point, from one to another, and the mark that bears its letter."""

    vertex: Mark
    start: Mark
    end: Mark
    letter: Mark


@dataclass(frozen=True)
class Position:
    """The mechanism in one position, joint by joint from O; ``slides``: its last joint on a guide."""

    joints: tuple[Mark, ...]
    slides: bool = False


class Dyad(NamedTuple):
    """A second dyad: the coupler's point over a turn; its links (Length); the lines that it is drawn as."""

    course: Mark
    links: tuple[Mark, Mark]
    positions: tuple[Position, ...]


@dataclass(frozen=True)
class SynthesisFigure:
    """A synthesis as drawn.

    ``measured``: by letters the lengths that were read off (Number, m). ``positions``: of the mechanism found,
    the first in thick lines. ``pivots``: on the frame; ``points``: others that bear a letter; ``guide``: two
    points of a slider's guide. ``circles``: those that stay. ``places``: whether the mechanism was made to go
    through its positions one after the other. ``transmission``: angles of transmission that were measured;
    ``angles``: those that are shown; ``worst``: positions in thin lines, such as those of worst transmission;
    ``dyad``: the second one of a six-bar, in thick lines too.
    """

    task: Task
    mu: Mark
    measured: Mapping[str, Mark]
    positions: tuple[Position, ...]
    pivots: tuple[Mark, ...]
    points: tuple[Mark, ...]
    guide: tuple[Mark, Mark] | None = None
    circles: tuple[Circle, ...] = ()
    places: bool = False
    transmission: tuple[Mark, ...] = ()
    angles: tuple[Between, ...] = ()
    worst: tuple[Position, ...] = ()
    dyad: Dyad | None = None


class SynthesisBoard:
    """The draft of a synthesis, its scale, and what its kinds do alike."""

    def __init__(self, draft: Draft) -> None:
        self.draft = draft
        draft.open(SYNTHESIS)
        self.mu = draft.scale("μ_l", "m/mm")
        draft.lay_out()

    def length(self, letter: str, metres: Mark) -> Mark:
        """Return a length on the board for one in m."""
        return self.draft.draw(to_board, letter, metres, self.mu)

    def read(self, name: str, start: Mark, end: Mark, because: str = "") -> Mark:
        """Measure a length and return it in m."""
        length = self.draft.draw(measure, name, start, end, why=because)
        return self.real(name, length)

    def real(self, name: str, length: Mark) -> Mark:
        """Return a length on the board in m."""
        return self.draft.draw(in_si, f"l_{{{name}}}", length, self.mu, unit="m")

    def side(self, sign: int) -> Mark:
        """Take on which side a point lies of two."""
        return self.draft.take(Side, "±", float(sign))

    def origin(self, letter: str) -> Mark:
        """Take the point from which the drawing begins."""
        return self.draft.take(Point, letter, 0j)

    def axis(self, start: Mark, letter: str, degrees: float = 0.0) -> Mark:
        """Draw a line from a point at an angle."""
        return self.draft.draw(ray, letter, start, self.draft.direction(degrees))

    def off(self, letter: str, line: Mark, length: Mark, because: str = "") -> Mark:
        """Lay off a length from the beginning of a line."""
        return self.draft.draw(lay_off, letter, line, length, why=because)

    def on(self, letter: str, start: Mark, through: Mark, length: Mark, because: str = "") -> Mark:
        """Lay off a length from a point towards another, and on."""
        line = self.draft.draw(join, line_name(start, through), start, through)
        return self.off(letter, line, length, because)

    def circle_of_angle(self, start: Mark, end: Mark, chord: Mark, angles: Sequence[Mark]) -> Mark:
        """Return the centre of the circle from which a chord is seen under θ: of both angles to its ends."""
        sides = [
            self.draft.draw(incline, line_name(point, "M"), point, chord, angle, why=why.SEEN)
            for point, angle in zip((start, end), angles, strict=True)
        ]
        return self.draft.draw(meet, "M", *sides)

    def crank_and_rod(self, pivot: Mark, near: Mark, far: Mark) -> tuple[Mark, Mark, Mark]:
        """Return crank and rod (Length) from the distances of B in both dead centres, and the farther line."""
        short = self.draft.draw(measure, f"{pivot.letter}{near.letter}", pivot, near)
        arc = self.draft.draw(strike, "(k)", pivot, short)
        line = self.draft.draw(join, line_name(far, pivot), far, pivot)
        until = self.draft.draw(cut, "D", line, arc, self.side(-1))
        middle = self.draft.draw(halve, "E", far, until, why=why.TWICE_CRANK)
        return (
            self.draft.draw(measure, "OA", far, middle),
            self.draft.draw(measure, "AB", pivot, middle),
            line,
        )

    def dead_centre(self, letter: str, end: Mark, pivot: Mark, rod: Mark) -> Mark:
        """Return the crank pin of a dead centre: the rod is laid off from B towards O, and on."""
        line = self.draft.draw(join, line_name(end, pivot), end, pivot)
        return self.off(letter, line, rod, why.IN_LINE)

    def bisector(self, start: Mark, end: Mark, letter: str, because: str = why.BISECTOR) -> Mark:
        """Draw the bisector of the chord between two places."""
        chord = self.draft.draw(join, line_name(start, end), start, end)
        middle = self.draft.draw(halve, letter, start, end, why=why.MIDDLE)
        return self.draft.draw(square, f"({letter})", middle, chord, why=because)

    def centre(
        self,
        letter: str,
        places: Sequence[Mark],
        middles: tuple[str, str],
        because: str = why.BISECTOR,
    ) -> Mark:
        """Return the centre of the circle through three places: where two bisectors meet."""
        first, second, third = places
        lines = (
            self.bisector(first, second, middles[0], because),
            self.bisector(second, third, middles[1], because),
        )
        return self.draft.draw(meet, letter, *lines)
