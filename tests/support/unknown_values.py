"""Values on a tape of which nothing is known."""

from __future__ import annotations

from typing import Any

from graphic_tmm.board.tape import Tape
from graphic_tmm.board.unknown import Value
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
