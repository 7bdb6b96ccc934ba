"""What the operations of a cam leave on paper, and how its views ink single marks."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.operations.curve import bezier
from graphic_tmm.board.record import Construction, Figure, Mark, Step
from graphic_tmm.board.values import Complexes
from graphic_tmm.chapters.cam.operations import extreme_of_two, phase_end, slant
from graphic_tmm.chapters.cam.plan import Cam
from graphic_tmm.paper.drawing import Bezier, Drawing, Ink, Label, Wanted, circle, line
from graphic_tmm.paper.figure import Traces
from graphic_tmm.paper.lettering.heights import Heights
from graphic_tmm.paper.rules import segment
from graphic_tmm.paper.seen import Rule, Seen, finite

TRACELESS = frozenset({phase_end.name, extreme_of_two.name, slant.name})
"""Operations that leave no trace: points that are there already under another letter, angles measured with the
protractor."""
DOT = 0.4
"""Radius of a point, mm."""


def picture(
    on: tuple[str, str],
    traces: Traces,
    strokes: Iterable[Ink],
    wanted: Iterable[Wanted],
    positions: Sequence[str],
    labels: Iterable[Label] = (),
) -> Drawing:
    """Return a view of a cam with its title (``on``), what its steps left and what stands on it besides."""
    view, title = on
    return Drawing(
        view,
        title,
        tuple(strokes),
        tuple(labels),
        rubbed=traces.rubbed,
        shows=(view,),
        wanted=tuple(wanted),
        numbers=tuple(enumerate(positions)),
    )


class CamInk:
    """A view of a cam's log and its numbers while it is inked."""

    def __init__(
        self,
        construction: Construction,
        reading: Reading,
        cam: Cam,
        view: str,
        heights: Heights,
    ) -> None:
        count = cam.diagrams.turn.positions
        self.seen = Seen(construction, reading, (view,), range(count))
        self.cam, self.view, self.heights = cam, view, heights

    def all(self, mark: Mark) -> Complexes:
        """The places of a point in all positions."""
        return np.broadcast_to(self.seen.reading[mark][0], (len(self.seen.positions),))

    def one(self, mark: Mark) -> complex:
        """The place of a point that does not vary."""
        return self.seen.point(mark, 0)

    def length(self, mark: Mark) -> float:
        """A number or a length that does not vary."""
        return self.seen.number(mark, 0)

    def used(self, mark: Mark, which: int = 0) -> Mark:
        """What the step that left a mark used."""
        return self.seen.by_mark[mark].uses[which]

    def figures(self, kind: str) -> list[Figure]:
        """The bodies of a kind, as the plan tells them."""
        told = self.seen.construction.figures
        return [figure for figure in told if figure.view == self.view and figure.kind == kind]


def curve(pen: str = "main") -> Rule:
    """Return the rule of a curve that is drawn with a pen."""

    def drawn(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        for run in bezier(seen.reading[step.it]):
            yield Bezier(pen, tuple(complex(z) for z in run), step.it.name)

    return drawn


def reached(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """A point of a curve, and the length laid off to it from where its line begins."""
    spot = seen.point(step.it, k)
    yield from segment("thin", seen.line(step.uses[0], k)[0], spot)
    if finite(spot):
        yield circle("main", spot, DOT, filled=True)


def between(starts: Complexes, ends: Complexes) -> Rule:
    """Return the rule of a line that is drawn between two places of each position."""

    def drawn(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        yield from segment("thin", complex(starts[k]), complex(ends[k]))

    return drawn


def whole(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """A whole circle."""
    centre, radius = seen.arc(step.it, k)
    if math.isfinite(radius) and finite(centre):
        yield circle("thin", centre, radius)


def drawn(*strokes: Ink) -> Rule:
    """Return the rule of a step that leaves these strokes."""

    def left(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        return iter(strokes)

    return left


def straight(pen: str, start: complex, end: complex) -> Rule:
    """Return the rule of a line between two places, if they are there."""
    return drawn(*([line(pen, start, end)] if finite(start, end) else []))
