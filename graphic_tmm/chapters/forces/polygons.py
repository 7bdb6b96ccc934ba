"""Polygons of forces: reactions as their vectors, the known sides laid off one after another."""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.board import roles
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import to_board
from graphic_tmm.board.operations.instruments import lay_off, parallel, square
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Point
from graphic_tmm.chapters.forces import reasons as why

Pair = tuple[int, int]


class Reaction(NamedTuple):
    """The force of one link on another: its letter R_{12}, its vector, its length and its size (N).

    ``normal``: of a sliding pair, the part square to its guide (Length, signed); ``place``: how far from the
    closing point the reaction acts along the guide (Length), and the scale factor of that; None where it acts
    there.
    """

    letter: str
    links: Pair
    tail: Mark
    head: Mark
    length: Mark
    value: Mark
    normal: Mark | None = None
    place: tuple[Mark, Mark] | None = None


class Views(NamedTuple):
    """Where the polygon of what is detached is drawn, and where in the ``last`` pass of friction."""

    polygon: str
    last: str

    def begin(self, draft: Draft) -> Chain:
        """Open the polygon: take its scale and its first vertex."""
        draft.open(self.polygon)
        mu = draft.scale("μ_F", "N/mm")
        start = draft.take(Point, "1", 0j)
        draft.lay_out(start, role=roles.FORCE_POLYGON, last=self.last)
        return Chain(draft, mu, start)


class Polygon(NamedTuple):
    """A polygon of forces as drawn: its view, its scale, its sides (letter, tail, head) in order."""

    view: str
    mu: Mark
    sides: tuple[tuple[str, Mark, Mark], ...]


class Chain:
    """The known sides of a polygon, laid off one after another."""

    def __init__(self, draft: Draft, mu: Mark, start: Mark) -> None:
        self.draft, self.mu, self.end = draft, mu, start
        self.sides: list[tuple[str, Mark, Mark]] = []

    def add(self, letter: str, line: Mark, value: Mark) -> None:
        """Lay off a load parallel to its line of action."""
        draft = self.draft
        side = draft.draw(parallel, f"({letter})", self.end, line, sense=1, why=why.KNOWN_SIDE)
        self.lay(letter, side, value)

    def add_across(self, letter: str, line: Mark, value: Mark) -> None:
        """Lay off a tangential component: square to its link."""
        side = self.draft.draw(
            square, f"({letter})", self.end, line, sense=1, why=why.KNOWN_TANGENTIAL
        )
        self.lay(letter, side, value)

    def lay(self, letter: str, side: Mark, value: Mark) -> None:
        """Lay off a force along a line that begins at the end of the chain."""
        draft = self.draft
        length = draft.draw(to_board, f"y_{{{bare(letter)}}}", value)
        head = self.draft.draw(lay_off, str(self.count + 1), side, length, why=why.KNOWN_SIDE)
        self.sides.append((letter, self.end, head))
        self.end = head

    @property
    def count(self) -> int:
        """How many vertices there are."""
        return len(self.sides) + 1


def bare(letter: str) -> str:
    """Return a letter as it stands in the index of another: F_{12} -> F12."""
    return letter.replace("_", "").replace("{", "").replace("}", "")
