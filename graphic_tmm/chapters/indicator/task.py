"""What is given of a cylinder: the gas on both sides of its piston (SI; drawn lengths in mm)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple


@dataclass(frozen=True)
class Stretch:
    """A part of an indicator diagram: on the stroke "out" (from the cover) or "back", between two shares of it.

    Shares are counted from the cover, 0 … 1. From ``pressure`` (Pa) at ``start`` it follows p·V^``exponent`` =
    const, or a straight line to ``last`` (Pa) at ``end``.
    """

    stroke: str
    start: float
    end: float
    pressure: float
    exponent: float | None = None
    last: float = 0.0


@dataclass(frozen=True)
class Gas:
    """The pressure on one side of a piston over the diameter ``bore`` (m).

    ``pressures`` (Pa) at every position of the row; or ``stretches`` of the two strokes, all polytropic or all
    straight, with the ``clearance`` as a share of the stroke. ``rod``: the diameter (m) of a rod that passes
    through that side; 0 for none.
    """

    pressures: tuple[float, ...]
    bore: float
    rod: float = 0.0
    stretches: tuple[Stretch, ...] = ()
    clearance: float = 0.0


@dataclass(frozen=True)
class IndicatorOrder:
    """The indicator diagram of a cylinder whose piston's point slides on the frame.

    ``cover``: the side away from the crank; ``shaft``: the side towards it, None for a single-acting piston.
    ``base`` is the drawn length of the stroke; ``height`` that of the highest pressure, mm, unless ``mu``
    (Pa/mm) says.
    """

    point: str
    cover: Gas
    shaft: Gas | None = None
    base: float = 100.0
    height: float = 100.0
    mu: float | None = None


class Wish(NamedTuple):
    """A cylinder that a chapter needs; of several the one of the highest ``rank`` shows its diagram."""

    rank: int
    by: str
    order: IndicatorOrder
