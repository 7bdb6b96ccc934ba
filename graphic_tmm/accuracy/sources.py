"""Where the error of a quantity comes from: the share of each source, and of each step of the log.

A source's share is what the mean square error loses when that source alone is mended and all else slips as it
did: by the same random streams, so that both differ by that source only. Shares of sources that do not act upon
each other add up to one; what is missing is due to several `together`. A step's share is that of the mean
square which it leaves when it slips alone, each place up or down by its standard deviation, in a balanced
design: neither chance nor the other places are in it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.accuracy.drawing import References
from graphic_tmm.accuracy.quantities import Quantity
from graphic_tmm.accuracy.response import SORTS, size
from graphic_tmm.board.execute import Program, Reading, needed, prepare
from graphic_tmm.board.hand import EXACT, Hand, slip_of
from graphic_tmm.board.record import Step
from graphic_tmm.board.values import Reals
from graphic_tmm.project import Project

DRAWINGS, MANY = 2000, 4000
"""How often all is drawn with each source mended, the second where a drawing has but one number of a quantity
and not a row: shares are then known to some 1 % of the whole."""
TURNS, MORE_TURNS = 16, 64
"""Turns of each step that slips alone; the second where many places of a step end in one number."""
METHOD = "method"
"""What is left with no slip at all: chords, the number of positions, passes."""
MENDED: Mapping[str, float | None] = {
    "swing": 0.0,
    "prick": 0.0,
    "compass": 0.0,
    "reading": 0.0,
    "ruler": None,
    "digits": None,
}
"""The sources of a hand, and what each is when it is mended."""
IN_MM = frozenset({"prick", "compass", "reading", "ruler"})
"""The sources that weigh the less, the larger the drawing."""
TOGETHER = 0.05
"""From this share on, sources act together. Shares themselves are known to 0.01."""


class Share(NamedTuple):
    """A step and its share of the mean square error of a quantity, 0 … 1."""

    step: Step
    share: float


class Sources(NamedTuple):
    """Where the error of a quantity comes from.

    ``square``: the mean square error, (% of the largest)². ``parts``: the share of each source, the largest
    first, none of those that the drawing has not. ``steps``: those of the steps.
    """

    square: float
    parts: Mapping[str, float]
    steps: tuple[Share, ...]

    @property
    def together(self) -> float:
        """What no source brings alone; one that makes others smaller brings nothing."""
        return 1.0 - sum(max(share, 0.0) for share in self.parts.values())

    @property
    def in_mm(self) -> float:
        """The share that falls with the square of the drawing's size."""
        return sum(share for name, share in self.parts.items() if name in IN_MM)


def sources(
    drawing: Project, asked: Sequence[Quantity], references: References, who: Hand
) -> dict[str, Sources]:
    """Return where the errors of quantities come from, by name; none of what has no error or no true value."""
    told = [(q, largest) for q in asked if (largest := references.largest(q, drawing)) > 0.0]
    rows = _sources(drawing, [one for one in told if one[0].row], references, who, DRAWINGS, TURNS)
    single = [one for one in told if not one[0].row]
    found = rows | _sources(drawing, single, references, who, MANY, MORE_TURNS)
    return {q.name: found[q.name] for q in asked if q.name in found}


def _sources(
    drawing: Project,
    asked: Sequence[tuple[Quantity, float]],
    references: References,
    who: Hand,
    drawings: int,
    turns: int,
) -> dict[str, Sources]:
    """Return the same of quantities, each with its largest value, from so many drawings and turns."""
    if not asked:
        return {}
    program = prepare(drawing.construction, [mark for q, _ in asked for mark in q.marks])
    who = who._replace(trials=drawings if who.slips else 1, first=0)
    whole, exact = program.run(drawing.given, hand=who), program.run(drawing.given)
    there = [name for name, mended in MENDED.items() if getattr(who, name) != mended]
    without = {
        name: program.run(drawing.given, hand=who._replace(**{name: MENDED[name]}))  # type: ignore[arg-type]
        for name in there
    }
    steps = _Steps(drawing, program, [q for q, _ in asked], who, turns)
    found = {}
    for quantity, largest in asked:
        due = references.of(quantity, drawing)
        if due is None:
            continue
        square = _square(quantity, whole, due, largest)
        if not square > 0.0:
            continue
        parts = {METHOD: 1.0 - _square(quantity, whole, quantity.read(exact, 1), largest) / square}
        for name, reading in without.items():
            parts[name] = 1.0 - _square(quantity, reading, due, largest) / square
        order = sorted(parts, key=lambda name: -parts[name])
        row = steps.of(quantity, quantity.read(exact, 1), largest, square)
        found[quantity.name] = Sources(square, {name: parts[name] for name in order}, row)
    return found


def _square(quantity: Quantity, reading: Reading, due: Reals, largest: float) -> float:
    """Return the mean square of how far a quantity is off what is due, (% of the largest)²."""
    trials = max((len(reading[mark]) for mark in quantity.marks), default=1)
    off = 100.0 * (quantity.read(reading, trials) - due) / largest
    known = np.isfinite(off)
    return float(np.mean(off**2, where=known)) if known.any() else float("nan")


class _Steps:
    """A log each of whose steps slips alone, in turn."""

    def __init__(
        self,
        drawing: Project,
        program: Program,
        asked: Sequence[Quantity],
        who: Hand,
        turns: int,
    ) -> None:
        marks = [mark for q in asked for mark in q.marks]
        self._log = drawing.construction
        slipping: dict[str, Step] = {}
        for step in needed(drawing.construction, marks):
            slip = slip_of(step.op, *step.it.key)
            if slip is None or slip.kind == "digits" or not who.slips:
                continue  # what a ruler alone rounds is no matter of chance
            if size(who, slip.kind) > 0.0:
                slipping[slip.key] = step
        self._steps, self._turns = tuple(slipping.values()), turns
        self._trials = turns * len(slipping)
        sizes: dict[str, Any] = {sort: size(who, sort) for sort in SORTS}
        hand = EXACT._replace(alone=tuple(slipping), trials=self._trials, **sizes)
        self._drawn = program.run(drawing.given, hand=hand) if slipping else None

    def of(
        self, quantity: Quantity, exact: Reals, largest: float, square: float
    ) -> tuple[Share, ...]:
        """Return the shares of the steps that a quantity needs, the largest first."""
        if self._drawn is None:
            return ()
        off = 100.0 * (quantity.read(self._drawn, self._trials) - exact) / largest
        count = len(self._steps)
        each = off.reshape(self._turns, count, -1).transpose(1, 0, 2).reshape(count, -1)
        known = np.isfinite(each)
        mean = np.sum(np.where(known, each, 0.0) ** 2, axis=1) / np.maximum(known.sum(axis=1), 1)
        own = {step.it.slot for step in needed(self._log, quantity.marks)}
        rows = [Share(s, float(m) / square) for s, m in zip(self._steps, mean, strict=True)]
        return tuple(
            sorted(
                (r for r in rows if r.step.it.slot in own and r.share > 0.0), key=lambda r: -r.share
            )
        )
