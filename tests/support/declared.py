"""Formulas that a test declares, and that are gone after it."""

from __future__ import annotations

from graphic_tmm.board.dimensions import fault
from graphic_tmm.board.formula import FORMULAS, formula
from graphic_tmm.board.grammar import OPERATIONS, Operation
from graphic_tmm.board.values import Angle, Kind, Number


def declared(text: str, leaves: Kind = Number, **options: object) -> Operation:
    """The formula "told", of the marks a, b, c (numbers) and t (an angle) that stand in a text."""
    OPERATIONS.pop("told", None)
    FORMULAS.pop("told", None)
    fault.cache_clear()

    def told() -> None:
        """A text."""

    told.__doc__ = text
    told.__annotations__ = {
        name: Angle if name == "t" else Number for name in "abct" if f"{{{name}}}" in text
    } | {"return": leaves}
    return formula(**options)(told)  # type: ignore[arg-type]
