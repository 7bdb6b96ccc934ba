"""Ink tied to marks: of what moves in a figure the expressions of its places, as its rules draw it.

A figure is traced (`paper.traced`) at some angles, of its own lengths and of others. A stroke has a variant for
each way in which it was drawn: under which comparisons, from which marks. It is tied if its variants tell
everywhere where it is, or that it is hidden, and nowhere anything else: what an expression does not know of
(a number that left it) is wrong with other lengths, and shows.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from itertools import product
from math import isfinite
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.page.strands import BENT, Key, Moving, letter_key, line_key
from graphic_tmm.page.trials import Trial, values_of
from graphic_tmm.paper.drawing import Drawing, Stroke
from graphic_tmm.paper.expressions import Expressions
from graphic_tmm.paper.traced import Traced, node_of, untraced

SAME = 1e-6
"""Places nearer than this, mm, are one."""
MOST = 12
"""What is drawn in more ways is not tied: a number that leaves its expression makes a way of each angle."""

FOLLOWS, APART = 0.02, 0.05
"""What is tied is drawn by its expressions alone where these are off its rows by no more, mm; it is not tied
where they are farther off: an extreme of the turn may lie between whole degrees, near a lock by millimetres."""

Rows = np.ndarray[Any, np.dtype[np.bool_]]


class Variant(NamedTuple):
    """One way in which something is drawn: under which comparisons (their nodes, their outcome).

    ``places``, ``bulges``: the nodes of its vertices; of a letter of its point.
    """

    conditions: tuple[tuple[int, bool], ...]
    places: tuple[int, ...]
    bulges: tuple[int, ...]

    @property
    def nodes(self) -> tuple[int, ...]:
        """All nodes that it has to do with."""
        return (*self.places, *self.bulges, *(node for node, _ in self.conditions))


class _Seen(NamedTuple):
    """Something as it was drawn once: its nodes, what was compared before, the marks that it is made of.

    ``last``: what was compared since something else was drawn.
    """

    places: tuple[int, ...]
    bulges: tuple[int, ...]
    guards: dict[int, bool]
    last: frozenset[int]
    taken: tuple[int, ...]
    marks: int


class Tracing:
    """The figures of a mechanism, traced in trials: expressions, and their values in all drawings."""

    def __init__(self, among: Expressions, trials: Sequence[Trial], whole: int) -> None:
        self.among, self.trials, self.whole = among, trials, whole

    def traced(
        self, figures: Sequence[Moving], further: Sequence[int] = (), behind: Traces | None = None
    ) -> Traces:
        """Return a figure as it is drawn in all trials, given as each of these has it.

        Or ``behind`` those drawings the first of them at ``further`` angles (indices).
        """
        rows = [(n, one.angles) for n, one in enumerate(self.trials)]
        if behind is not None:
            rows = [(0, tuple(further))]
        drawings = [
            dict(_drawn(self.among, figures[n].at, k)) for n, angles in rows for k in angles
        ]
        if behind is not None:
            rows, drawings = [*behind.rows, *rows], [*behind.drawings, *drawings]
        seen = [one for drawing in drawings for one in drawing.values()]
        only = {node for one in seen for node in (*one.places, *one.bulges, *one.guards)}
        parts = [
            values_of(self.among, self.trials[n].reading, angles, self.whole, only)
            for n, angles in rows
        ]
        values = {k: np.concatenate([part[k] for part in parts]) for k in parts[0]}
        return Traces(self.among, values, rows, drawings)


class Traces:
    """A figure as drawn in trials at angles, ``rows``: what moves, by its key; the values of expressions."""

    def __init__(
        self,
        among: Expressions,
        values: Mapping[int, Complexes],
        rows: Sequence[tuple[int, tuple[int, ...]]],
        drawings: Sequence[dict[Key, _Seen]],
    ) -> None:
        self.among, self.values, self.rows, self.drawings = among, values, rows, drawings
        self.there = np.array([bool(one) for one in drawings])

    def ties(self) -> dict[Key, tuple[Variant, ...]]:
        """Return the variants of all that moves; none of what is not tied."""
        keys = dict.fromkeys(key for one in self.drawings for key in one)
        return {key: self._variants([one.get(key) for one in self.drawings]) for key in keys}

    def _variants(self, rows: Sequence[_Seen | None]) -> tuple[Variant, ...]:
        """Return the ways in which something is drawn; none where they would tell something wrong."""
        ways: dict[tuple[tuple[int, ...], tuple[int, ...]], list[_Seen]] = {}
        for one in rows:
            if one is not None:
                ways.setdefault((one.places, one.bulges), []).append(one)
        if len(ways) > MOST:
            return ()
        often = sorted(ways.values(), key=len, reverse=True)
        for wide, fine in product((False, True), (False, True)):
            found = [
                Variant(self._common(alike, wide=wide), alike[0].places, alike[0].bulges)
                for own in often
                for alike in (self._alike(own, wide=wide) if fine else [own])
            ]
            if not (self._wrong(found, rows) & self.there).any():
                return tuple(dict.fromkeys(found))
        return ()

    def _alike(self, own: Sequence[_Seen], *, wide: bool) -> list[list[_Seen]]:
        """Return what was drawn in one way by what was compared for it, the most frequent first."""
        found: dict[frozenset[int], list[_Seen]] = {}
        for one in own:
            found.setdefault(frozenset(self._compared(one, wide=wide)), []).append(one)
        return sorted(found.values(), key=len, reverse=True)

    def _compared(self, one: _Seen, *, wide: bool) -> Iterator[int]:
        """Yield what was compared before: at last, and of the marks that something is made of; or all."""
        marks = self.among.marks
        return (node for node in one.guards if wide or node in one.last or marks[node] & one.marks)

    def _common(self, rows: Sequence[_Seen], *, wide: bool) -> tuple[tuple[int, bool], ...]:
        """Return what was compared before and came out alike in all drawings."""
        first, *others = rows
        return tuple(
            (node, first.guards[node])
            for node in self._compared(first, wide=wide)
            if all(one.guards.get(node) == first.guards[node] for one in others)
        )

    def _wrong(self, variants: Sequence[Variant], rows: Sequence[_Seen | None]) -> Rows:
        """Return in which drawings variants tell something elsewhere than it is."""
        bad = np.zeros(len(rows), dtype=bool)
        for one, holds in zip(variants, holding(variants, self.values), strict=True):
            for t in np.flatnonzero(holds).tolist():
                bad[t] = not self._same(one, rows[t], t)
        return bad

    def _same(self, variant: Variant, own: _Seen | None, t: int) -> bool:
        if own is None:
            return False
        if any(self.values[node][t].real != own.guards[node] for node in own.taken):
            return False
        if (own.places, own.bulges) == (variant.places, variant.bulges):
            return True
        due = [self.values[node][t] for node in (*own.places, *own.bulges)]
        told = [self.values[node][t] for node in (*variant.places, *variant.bulges)]
        return len(due) == len(told) and bool(np.abs(np.subtract(due, told)).max() < SAME)


def holding(variants: Sequence[Variant], values: Mapping[int, Complexes]) -> list[Rows]:
    """Return where each of some variants is the one that is drawn, (drawing,)."""
    found: list[Rows] = []
    free = np.ones(next(iter(values.values())).shape, dtype=bool)
    for one in variants:
        holds = free.copy()
        for node, outcome in one.conditions:
            holds &= values[node].real == outcome
        for node in (*one.places, *one.bulges):
            holds &= np.isfinite(values[node])
        for node in one.bulges:
            holds &= np.abs(values[node].real) < BENT
        found.append(holds)
        free &= ~holds
    return found


def _drawn(among: Expressions, at: Any, k: int) -> Iterator[tuple[Key, _Seen]]:
    """Yield what moves in a figure at an angle, with what was compared before."""
    among.begin()
    drawing: Drawing = at(k)
    met, before = Counter[object](), 0
    held = _Held(among)
    for stroke in drawing.strokes:
        if isinstance(stroke, Stroke):
            flat: list[Any] = [value for vertex in stroke.path for value in vertex]
            bent = any(abs(untraced(one).real) >= BENT for one in flat[2::3])
            if not bent and all(isfinite(one) for one in flat):
                nodes = [node_of(one, among) for one in flat]
                places = map(among.place, nodes[::3], nodes[1::3])
                since = max((one.seen for one in flat if isinstance(one, Traced)), default=0)
                drawn = tuple(places), tuple(nodes[2::3])
                yield line_key(stroke, met), _seen(held, before, since, *drawn, stroke.of)
                before = since
    for one in drawing.wanted:
        at_ = untraced(one.at)
        if isfinite(at_.real) and isfinite(at_.imag):
            # whether it stands alone is compared when its place is known
            since = len(among.guards)
            node = node_of(one.at, among)
            yield letter_key(one, met), _seen(held, since, since, (node,), (), one.of)


class _Held:
    """What was compared in a drawing, by how many guards were there when something of it was made."""

    def __init__(self, among: Expressions) -> None:
        self.among = among
        self._known: dict[int, tuple[list[bool], dict[int, bool], tuple[int, ...]]] = {}

    def since(self, count: int) -> tuple[list[bool], dict[int, bool], tuple[int, ...]]:
        """Return which guards mattered then, how these came out, which of them need not have come out so."""
        found = self._known.get(count)
        if found is None:
            some = self.among.guards[:count]
            own = [one.node >= 0 and not 0 < one.until <= count for one in some]
            before = [one for one, matters in zip(some, own, strict=True) if matters]
            guards = {one.node: one.found for one in before}
            taken = tuple(one.node for one in before if one.taken)
            found = self._known[count] = own, guards, taken
        return found


def _seen(
    held: _Held,
    last: int,
    since: int,
    places: tuple[int, ...],
    bulges: tuple[int, ...],
    of: Sequence[int],
) -> _Seen:
    """Return something as it was drawn, made when so many guards were there, ``since``.

    ``last``: so many were there when something was drawn before it.
    """
    among = held.among
    own, guards, taken = held.since(since)
    marks = 0
    for node in (*places, *bulges):
        marks |= among.marks[node]
    for slot in of:
        marks |= 1 << slot
    near = frozenset(among.guards[k].node for k in range(last, since) if own[k])
    return _Seen(places, bulges, guards, near, taken, marks)


class Followed(NamedTuple):
    """How variants tell what was drawn: ``apart``: they are off at most, mm; ``whole``: all of it is told."""

    apart: float
    whole: bool


def followed(
    variants: Sequence[Variant],
    values: Mapping[int, Complexes],
    rows: Reals,
    shown: Rows,
    *,
    bent: bool,
) -> Followed:
    """Return how variants tell at the angles drawn what rows (angle, column) do; ``bent``: these have bulges.

    ``values``: of all expressions, at these angles; ``shown``: at which of them anything of the figure is.
    """
    there, apart = np.isfinite(rows[:, 0]), 0.0
    for one, held in zip(variants, holding(variants, values), strict=True):
        holds = held & shown
        places, bulges = (
            np.array([values[node][holds] for node in nodes])
            .reshape(len(nodes), int(holds.sum()))
            .T
            for nodes in (one.places, one.bulges)
        )
        own = rows[holds]
        x, y = (own[:, k :: 3 if bent else 2] for k in (0, 1))
        if not (there[holds].all() and x.shape == places.shape):
            return Followed(np.inf, False)
        apart = max(apart, np.abs(places - x - 1j * y).max(initial=0.0))
        if bent:
            apart = max(apart, np.abs(bulges.real - own[:, 2::3]).max(initial=0.0))
        there = there & ~holds
    return Followed(apart, apart <= FOLLOWS and not there.any())
