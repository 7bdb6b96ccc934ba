"""Rules that chapters give to single marks of a plan: see `showing`."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.board.operations.curve import bezier
from graphic_tmm.board.record import Step
from graphic_tmm.paper.drawing import Bezier, Ink, circle, line
from graphic_tmm.paper.rules import laid_off
from graphic_tmm.paper.seen import Rule, Seen, finite


def leaving(*strokes: Ink) -> Rule:
    """Return the rule of a step that leaves these strokes."""

    def left(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        return iter(strokes)

    return left


def straight(pen: str, start: complex, end: complex) -> Rule:
    """Return the rule of a line between two places (mm), if they are there."""
    return leaving(*([line(pen, start, end)] if finite(start, end) else []))


def curve(pen: str = "main") -> Rule:
    """Return the rule of a curve that is drawn with a pen."""

    def drawn(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        for run in bezier(seen.reading[step.it]):
            yield Bezier(pen, tuple(complex(z) for z in run), step.it.name)

    return drawn


def dotted(radius: float) -> Rule:
    """Return the rule of a point that is a dot; ``radius`` in mm."""

    def dot(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        spot = seen.point(step.it, k)
        if finite(spot):
            yield circle("main", spot, radius, filled=True)

    return dot


def reached(radius: float) -> Rule:
    """Return the rule of a point to which a length was laid off from where its line begins: both are drawn."""
    dot = dotted(radius)

    def laid(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        yield from laid_off(seen, step, k)
        yield from dot(seen, step, k)

    return laid
