"""What a number may be, and the refusal of one that is not. The bounds themselves stand with the keys."""

from __future__ import annotations

import math
from dataclasses import dataclass

from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import Said, joined, said


class TaskError(StructureError):
    """An order that makes no sense; ``key``: the section and the key of a scene that say so."""

    def __init__(self, section: str, key: str, message: str) -> None:
        super().__init__(message, f"{section}.{key}", head=section)
        self.key = section, key


@dataclass(frozen=True)
class Bound:
    """What a number may be: from ``least`` to ``most``, without these where it is ``above`` or ``below``."""

    least: float = -math.inf
    most: float = math.inf
    whole: bool = False
    above: bool = False
    below: bool = False

    def holds(self, value: object) -> bool:
        """Whether a value is a number within the bounds."""
        if isinstance(value, bool) or not isinstance(value, int | float):
            return False
        if isinstance(value, float) and not math.isfinite(value):
            return False
        if self.whole and value != int(value):
            return False
        low = value > self.least if self.above else value >= self.least
        high = value < self.most if self.below else value <= self.most
        return low and high

    @property
    def wanted(self) -> Said:
        """What is wanted: a whole number 4 to 360; a number greater than 0 and less than 1."""
        kind = said("a whole number") if self.whole else said("a number")
        if (
            math.isfinite(self.least)
            and math.isfinite(self.most)
            and not (self.above or self.below)
        ):
            return said(
                "{kind} {least:.10g} to {most:.10g}", kind=kind, least=self.least, most=self.most
            )
        low = said("greater than {end:.10g}", end=self.least)
        low = low if self.above else said("not less than {end:.10g}", end=self.least)
        high = said("less than {end:.10g}", end=self.most)
        high = high if self.below else said("not greater than {end:.10g}", end=self.most)
        ends = [text for end, text in ((self.least, low), (self.most, high)) if math.isfinite(end)]
        return joined(" ", (kind, joined(said(" and "), ends)))

    @property
    def schema(self) -> dict[str, object]:
        """The bounds as a JSON Schema tells them."""
        made: dict[str, object] = {"type": "integer" if self.whole else "number"}
        low = "exclusiveMinimum" if self.above else "minimum"
        high = "exclusiveMaximum" if self.below else "maximum"
        for end, key in ((self.least, low), (self.most, high)):
            if math.isfinite(end):
                made[key] = int(end) if end == int(end) else end
        return made

    def refuse(self, section: str, key: str, value: object) -> None:
        """Refuse a value outside the bounds.

        Raises
        ------
        TaskError
            Which says what is wanted.
        """
        if not self.holds(value):
            plain = isinstance(value, bool) or not isinstance(value, int | float)
            told = str(value) if plain else f"{value:g}"
            says = said(
                "{key} = {told}: {wanted} is wanted", key=key, told=told, wanted=self.wanted
            )
            raise TaskError(section, key, says)


POSITIVE = Bound(0, above=True)
INTERVALS = Bound(4, whole=True)
"""Of a graph: fewer show no curve."""
