"""Values on a tape of which nothing is known; what they come to if they are known."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from graphic_tmm.board.compile.tape import INPUT, Part, Ref, Tape
from graphic_tmm.board.compile.trace import Value
from graphic_tmm.board.values import Arc, Line, Point


def unknown(tape: Tape, kind: Any) -> Any:
    """A value of a kind of which nothing is known."""

    def number() -> Value:
        return Value(tape, tape.input(moving=True))

    def vector() -> Value:
        return Value(tape, tape.input(moving=True), tape.input(moving=True))

    if kind is Line:
        return Line(vector(), vector())  # type: ignore[arg-type]
    if kind is Arc:
        return Arc(vector(), number())  # type: ignore[arg-type]
    return vector() if kind is Point else number()


def numbers_on(tape: Tape, part: Part, rows: Sequence[Any]) -> Any:
    """What a part of a tape comes to by numpy, where rows (or single numbers) enter in their order."""
    entering, left = iter(rows), list[Any]()
    with np.errstate(all="ignore"):
        for node in tape.nodes:
            takes = [left[t] if isinstance(t, int) else np.float64(t) for t in node.takes]
            does = {"length": np.hypot, "choose": np.where}.get(node.does) or getattr(
                np, node.does, None
            )
            left.append(next(entering) if node.does == INPUT else does(*takes))
    if isinstance(part, Ref):
        return -left[part.node] if part.minus else left[part.node]
    return 0.0 if part is None else part
