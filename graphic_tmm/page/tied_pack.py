"""Expressions that ink is tied to, as the page carries them: what is needed of them, each operation a sign.

The page's program calculates them (`page/web/live/tied.js`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.script_rows import RowScript
from graphic_tmm.board.values import Complexes
from graphic_tmm.drawn import Drawn
from graphic_tmm.page.dense import Dense
from graphic_tmm.page.live.log import LiveLog
from graphic_tmm.page.strands import Key, Moving, MovingStroke, Strands
from graphic_tmm.page.tied import APART, Followed, Traces, Tracing, Variant, followed, holding
from graphic_tmm.page.trials import trials, values_of
from graphic_tmm.paper.expressions import COVERED, Expressions

SIGNS = {
    "mark": "m",
    "number": "n",
    "plus": "+",
    "minus": "-",
    "times": "*",
    "over": "/",
    "conjugate": "~",
    "real": "r",
    "imag": "i",
    "complex": "c",
    "abs": "a",
    "bearing": "b",
    "heading": "h",
    "tangent": "t",
    "arcsine": "s",
    "sign": "g",
    "floor": "f",
    "round": "o",
    "smaller": "_",
    "larger": "=",
    "less": "<",
    "chosen": "?",
    COVERED: "#",
    "lowest": "v",
    "highest": "^",
}
"""What operations are called in a page."""


class TiesPack:
    """The expressions of a page while they are packed, and the comparisons that variants hold under."""

    def __init__(self, among: Expressions, variants: Iterable[Variant]) -> None:
        self.among = among
        self.nodes = among.needed({node for one in variants for node in one.nodes})
        self.number = {node: k for k, node in enumerate(self.nodes)}
        self.holds: dict[tuple[int, ...], int] = {}

    def variants(self, variants: Sequence[Variant]) -> list[Any]:
        """Return the variants of what moves: under which comparisons, its places, its bulges if it has any."""
        return [[self._held(one), *self._vertices(one)] for one in variants]

    def _held(self, one: Variant) -> int:
        """Return the number of the comparisons that a variant holds under.

        Each is told by the number of its node from 1 on, below 0 if it came out false.
        """
        told = tuple((self.number[n] + 1) * (1 if found else -1) for n, found in one.conditions)
        return self.holds.setdefault(told, len(self.holds))

    def _vertices(self, one: Variant) -> tuple[list[int], Any]:
        straight = all(self.among.nodes[k] == ("number", (0.0, 0.0)) for k in one.bulges)
        bulges: Any = 0 if straight else [self.number[k] for k in one.bulges]
        return [self.number[k] for k in one.places], bulges

    def data(self) -> dict[str, Any]:
        """Return all expressions: their signs, of what each is made (how far before it), their numbers."""
        numbers: dict[float, int] = {}
        of: list[int] = []
        for k, node in enumerate(self.nodes):
            op, parts = self.among.nodes[node]
            if op == "mark":
                of += map(int, parts)
            elif op == "number":
                of += (numbers.setdefault(round(x, 12) + 0.0, len(numbers)) for x in parts)
            else:
                of += [len(parts)] if op == COVERED else []
                of += (int(n) if n < 0 else k - self.number[int(n)] for n in parts)
        return {
            "ops": "".join(SIGNS[self.among.nodes[node].op] for node in self.nodes),
            "of": of,
            "numbers": list(numbers),
            "holds": [list(told) for told in self.holds],
        }


class Tied(NamedTuple):
    """What moves and is tied: its variants; whether these tell all that its rows do."""

    variants: list[Any]
    whole: bool


def _run(found: Dense) -> int:
    """Return the marks that a page's log knows, a bit for each slot."""
    log = LiveLog(found, RowScript())
    steps = (step.it for step in (*log.live, *log.sheet))
    return sum(
        1 << slot for slot in {mark.slot for mark in (*log.own, *log.kept, *steps)} | {*log.carried}
    )


class FigureTies:
    """What is tied of the figures of a page, packed; ``made``: by their names their rows over the angles."""

    def __init__(
        self,
        found: Dense,
        figures: Callable[[Drawn], Iterable[Moving]],
        made: Mapping[str, Strands],
    ) -> None:
        self.found, self.made, self.among = found, made, Expressions()
        self.run = _run(found)
        tried = trials(found, self.among)
        rows = [{one.name: one for one in figures(one.drawn)} for one in tried]
        tracing = Tracing(self.among, tried, found.whole)
        tied = {
            name: self._ties(tracing, [one[name] for one in rows], strands)
            for name, strands in made.items()
        }
        self.ties = {name: ties for name, (ties, _) in tied.items()}
        self.whole = {name: whole for name, (_, whole) in tied.items()}
        every = (one for ties in self.ties.values() for own in ties.values() for one in own)
        self.pack = TiesPack(self.among, every)

    def _ties(
        self, tracing: Tracing, figures: Sequence[Moving], made: Strands
    ) -> tuple[dict[Key, tuple[Variant, ...]], set[Key]]:
        """Return what is tied of a figure, and of what that tells all that its rows do.

        It is traced at further angles where it is not drawn as at the others.
        """
        traces = tracing.traced(figures)
        ties = self._known(traces)
        values = self._values(ties, made)
        missing = np.zeros(len(made.drawn), dtype=bool)
        for key, own in ties.items():
            if own and key in made.rows:
                missing |= np.isfinite(made.rows[key][:, 0]) & ~np.any(holding(own, values), axis=0)
        further = [made.drawn[k] for k in np.flatnonzero(missing)]
        if further:
            ties = self._known(tracing.traced(figures, further, traces))
            values = self._values(ties, made)
        found = self._followed(ties, made, values)
        near = {
            key: own if found[key].apart <= APART or not isinstance(key, MovingStroke) else ()
            for key, own in ties.items()
        }
        return near, {key for key, one in found.items() if one.whole}

    def _followed(
        self,
        ties: Mapping[Key, tuple[Variant, ...]],
        made: Strands,
        values: Mapping[int, Complexes],
    ) -> dict[Key, Followed]:
        """Return how what is tied tells the rows of a figure; what has none is told whole."""
        shown = np.any([np.isfinite(row[:, 0]) for row in made.rows.values()], axis=0)
        return {
            key: followed(own, values, made.rows[key], shown, bent=isinstance(key, MovingStroke))
            if own and key in made.rows
            else Followed(0.0, True)
            for key, own in ties.items()
        }

    def _known(self, traces: Traces) -> dict[Key, tuple[Variant, ...]]:
        """Return what is tied to marks that the page's log knows."""
        marks = self.among.marks
        return {
            key: own
            if not any(marks[node] & ~self.run for one in own for node in one.nodes)
            else ()
            for key, own in traces.ties().items()
        }

    def _values(
        self, ties: Mapping[Key, tuple[Variant, ...]], made: Strands
    ) -> dict[int, Complexes]:
        only = [node for own in ties.values() for one in own for node in one.nodes]
        reading, whole = self.found.drawn.reading, self.found.whole
        return values_of(self.among, reading, made.drawn, whole, only)

    def of(self, name: str) -> dict[Key, Tied]:
        """Return what is tied of a figure."""
        whole = self.whole[name]
        return {
            key: Tied(self.pack.variants(own), key in whole)
            for key, own in self.ties[name].items()
            if own
        }

    @property
    def slots(self) -> frozenset[int]:
        """The marks that they are tied to, by their slots."""
        nodes = (self.among.nodes[node] for node in self.pack.nodes)
        return frozenset(int(node.of[0]) for node in nodes if node.op == "mark")

    def data(self) -> dict[str, Any]:
        """Return the expressions of all figures."""
        return self.pack.data()
