"""Between which bounds the numbers of an order lie: stated here, and nowhere else.

The check of a scene, its schema and the plans' refusals read them, so that what one of them takes, all take.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from graphic_tmm.errors import StructureError


class OrderError(StructureError):
    """An order that makes no sense; ``key``: the section and the key of a scene that say so."""

    def __init__(self, section: str, key: str, message: str) -> None:
        super().__init__(f"{section}: {message}")
        self.key, self.says = (section, key), message


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
    def wanted(self) -> str:
        """What is wanted: a whole number 4 to 360; a number greater than 0 and less than 1."""
        kind = "a whole number" if self.whole else "a number"
        if (
            math.isfinite(self.least)
            and math.isfinite(self.most)
            and not (self.above or self.below)
        ):
            return f"{kind} {self.least:.10g} to {self.most:.10g}"
        low = f"{'greater than' if self.above else 'not less than'} {self.least:.10g}"
        high = f"{'less than' if self.below else 'not greater than'} {self.most:.10g}"
        ends = [text for end, text in ((self.least, low), (self.most, high)) if math.isfinite(end)]
        return f"{kind} {' and '.join(ends)}"

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
        OrderError
            Which says what is wanted.
        """
        if not self.holds(value):
            plain = isinstance(value, bool) or not isinstance(value, int | float)
            told = str(value) if plain else f"{value:g}"
            raise OrderError(section, key, f"{key} = {told}: {self.wanted} is wanted")


_SHARE = Bound(0, 1, above=True, below=True)
_ANGLE = Bound(0, 90, above=True, below=True)
_RACK = Bound(0, 45, above=True, below=True)
_SHIFT = Bound(-5, 5)
_TEETH = Bound(1, 1000, whole=True)
POSITIVE = Bound(0, above=True)
_ADDENDUM, _CLEARANCE = Bound(0, 5, above=True), Bound(0, 5)

_MOVING, _DWELL = Bound(0, 360, above=True, below=True), Bound(0, 360, below=True)
CAM: Mapping[str, Bound] = {
    "rise": _MOVING,
    "upper_dwell": _DWELL,
    "fall": _MOVING,
    "lower_dwell": _DWELL,
    "least_curvature": Bound(0),
    "pressure": _ANGLE,
    "transmission": _ANGLE,
    "pressure_return": _ANGLE,
    "share_of_r0": _SHARE,
    "share_of_curvature": _SHARE,
    "parts": Bound(4, 360, whole=True),
}
"""Of a cam: angles in degrees, lengths in m; fewer parts of a phase show no curve, more are no drawing."""

GEARS: Mapping[str, Bound] = {
    "z1": Bound(5, 2000, whole=True),
    "z2": Bound(5, 2000, whole=True),
    "x1": _SHIFT,
    "x2": _SHIFT,
    "alpha": _RACK,
    "ha": _ADDENDUM,
    "c": _CLEARANCE,
    "delta_y": _SHIFT,
    "steps": Bound(4, 60, whole=True),
    "stations": POSITIVE,
}
"""Of a pair of gears: with fewer teeth no flank is left between the root and the tip that could drive."""

PLANETARY: Mapping[str, Bound] = {
    "alpha": _RACK,
    "ha": _ADDENDUM,
    "c": _CLEARANCE,
    "tolerance": Bound(0, 0.5),
    "ratio": Bound(-10_000, 10_000),
    "teeth": _TEETH,
    "satellites": Bound(1, 49, whole=True),
    "least": _TEETH,
    "most": _TEETH,
    "ring_most": _TEETH,
    "behind": _TEETH,
}
"""Of a planetary train."""

LINK = Bound(0, 999, whole=True)
FIRST = Bound(0, 1, whole=True)
SEED = Bound(0, 2**31, whole=True)
DELTA = Bound(0, 2, above=True, below=True)
RIM_RATIO = _SHARE
FRICTION = Bound(0, 2)
EXPONENT = Bound(0, 3)
WITHIN = Bound(0, 1)
LIMIT = Bound(0, 100, above=True)
PASSES = Bound(2, 50, whole=True)
STUDS = Bound(1, 24, whole=True)
SPEED_RATIO = Bound(1, 100, above=True, below=True)
POSITIONS = Bound(1, 100_000, whole=True)
INTERVALS = Bound(4, whole=True)
"""Of a graph: fewer show no curve."""
