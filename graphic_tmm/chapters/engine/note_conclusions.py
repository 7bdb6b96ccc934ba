"""What follows from an engine's forces: how far the series is off the motion, whether T does the gas's work."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise

from graphic_tmm.chapters.engine.plan import Engine
from graphic_tmm.chapters.engine.record import WORKS
from graphic_tmm.chapters.indicator.note import GasPage
from graphic_tmm.drawn import single
from graphic_tmm.language.said import said
from graphic_tmm.note.document import Runs

GREATEST = said("The greatest inertia force is {exact} by the plans (position {position}).")
SERIES = said("By the series of two terms it is {series} (position {position}).")

EQUAL = said(
    "Over a turn the tangential force does the work {work_T}, the gas {work_P}: they differ by {work_apart}, "
    "so they are equal but for what the graphs can show."
)
UNEQUAL = said(
    "Over a turn the tangential force does the work {work_T}, the gas {work_P}: they differ by {work_apart}, "
    "more than the graphs explain."
)
CLOSE = 5.0
"""Works that differ by no more than this, %, agree: graphs with twelve positions are no better."""


NOTHING = said(
    "In positions {positions} the pressure on the guide and the turning moment are nought: the rod lies along"
    " the cylinder."
)
GUIDE = said("The pressure on the guide is greatest in position {position}: {N}.")
ONE_WAY = said(
    "It presses one side of the guide all the time: its sense goes by the sense of turning, not by that of the "
    "piston."
)
TURNED = said(
    "In positions {positions} it turns round, as the gas is compressed at the end of the stroke."
)
MOMENT = said("The turning moment is greatest in position {position}: {M}.")
DRIVES = said("It acts in the sense of turning in all positions of the row.")
BACKWARDS = said(
    "In positions {positions} it acts against the turning, as the compressed gas resists."
)
COVER = said(
    "The acceleration of the parts that move to and fro is greatest in position {position}, {a_B}; it changes "
    "its sign between positions {before} and {after}."
)
EARLY = said("That is before the crank stands square to the cylinder: the rod is not endless.")
USUAL = said("That is between 50° and 80° from the dead centre, as experience has it.")
NOUGHT = 1e-9
"""What is less than this share of the greatest is nought."""


class EngineConclusions(GasPage[Engine]):
    """What follows for guide, crank and moving parts, the inertia both ways, the works over a turn."""

    def concludes(self) -> Iterator[Runs]:
        """Yield it, a sentence each."""
        yield from self._guide()
        yield from self._moment()
        yield from self._acceleration()
        yield from self.extreme(GREATEST, "P_in", "exact")
        yield from self.extreme(SERIES, "P_in_series", "series")
        yield from self._works()

    def _signs(self, segment: str) -> list[tuple[str, int]]:
        """Return the positions that are drawn with the signs of a column there; 0 where it is nought."""
        drawn = self.drawn
        column = self.columns[segment].without(drawn.undrawn)
        values = column.first_figures[1][: drawn.project.count]
        most = max((abs(value) for value in values if value is not None), default=0.0)
        there = ((name, value) for name, value in zip(drawn.names, values, strict=False))
        return [
            (name, 0 if abs(value) <= NOUGHT * most else (1 if value > 0 else -1))
            for name, value in there
            if value is not None
        ]

    def _guide(self) -> Iterator[Runs]:
        """Yield where the pressure on the guide is nought, where it is greatest, whether it turns round."""
        signs = self._signs("N")
        if nowhere := _named(signs, 0):
            yield self.sentence(NOTHING, positions=nowhere)
        turned = _named(signs, -1)
        words = (GUIDE, TURNED if turned else ONE_WAY)
        yield from self.extreme(words, "N", "N", positions=turned)

    def _moment(self) -> Iterator[Runs]:
        """Yield where the turning moment is greatest, where it resists."""
        against, most = _named(self._signs("M"), -1), self.greatest("M")
        if most is not None:
            angle = self.drawn.names.index(most[1]) * 360.0 / self.drawn.project.count
            usual = (USUAL,) if 50.0 <= angle <= 80.0 else ()
            words = (MOMENT, *usual, BACKWARDS if against else DRIVES)
            yield from self.extreme(words, "M", "M", positions=against)

    def _acceleration(self) -> Iterator[Runs]:
        """Yield where the acceleration is greatest, and where on the way out it changes its sign."""
        turns = [(a, b) for (a, s), (b, t) in pairwise(self._signs("a_B")) if s * t < 0]
        if turns:
            before, after = turns[0]
            early = 4 * self.drawn.names.index(after) <= self.drawn.project.count
            words = (COVER, EARLY) if early else COVER
            yield from self.extreme(words, "a_B", "a_B", before=before, after=after)

    def _works(self) -> Iterator[Runs]:
        """Yield whether the tangential force does the work of the gas over a turn."""
        results = single(self.results)
        values = [value for name, (value, _) in results.items() if name in WORKS]
        if len(values) == len(WORKS) and all(map(math.isfinite, values)):
            yield self.sentence(EQUAL if abs(values[-1]) <= CLOSE else UNEQUAL)


def _named(signs: list[tuple[str, int]], sign: int) -> str:
    return ", ".join(name for name, own in signs if own == sign)
