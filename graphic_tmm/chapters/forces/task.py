"""Loads and effects: what acts on the links, and what of it a scene calls for. SI, degrees."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from graphic_tmm.chapter import Asked
from graphic_tmm.chapters.indicator.task import IndicatorOrder

GRAVITY = 9.81
"""g throughout the documents, m/s²: what a weight is taken with if a scene gives no other."""
AGAINST = "against"
"""The direction of a load that resists: against the velocity of its point, or the rotation of its link."""


@dataclass(frozen=True)
class Travel:
    """A size by the travel of a point that slides on the frame: shares of the stroke 0 … 1, and sizes.

    ``out`` is the stroke from the zero position, ``back`` the other; an empty one has no load.
    """

    of: str
    out: tuple[tuple[float, float], ...] = ()
    back: tuple[tuple[float, float], ...] = ()


@dataclass(frozen=True)
class Load:
    """A force (N) at a point of a link, or a moment (N·m) on the link where ``point`` is None.

    ``size``: constant; or at every position of the row; ``by_angle``: at turns of the crank from the zero
    position (degrees, in order), straight between them; ``travel``. ``direction``: degrees, fixed in the
    sheet; or `AGAINST`. A moment with a direction in degrees is counter-clockwise positive.
    """

    link: int
    point: str | None = None
    size: float | tuple[float, ...] = 0.0
    direction: float | str = AGAINST
    by_angle: tuple[tuple[float, float], ...] = ()
    travel: Travel | None = None


@dataclass(frozen=True)
class Friction:
    """Coefficients by pair (its letter or guide), pin radii (m) by letter, passes with friction."""

    f: Mapping[str, float]
    radius: Mapping[str, float]
    passes: int = 2


@dataclass(frozen=True)
class ForcesOrder:
    """Kinetostatics and Zhukovsky's lever in some positions.

    ``positions``: their numbers, or ("all",). ``balance``: a "force" at the crank pin, square to the crank, or
    a "moment". ``couples``: on the lever as "moment" or as a "pair" of forces. ``single``: links whose inertia
    force and couple are replaced by one force. ``limit``: of the difference of both methods, %. ``mu``: N/mm
    of every polygon; None for standard ones. ``g``: of weights, m/s². ``gas``: the
    indicator diagram whose gas pushes the piston.
    """

    positions: tuple[str, ...]
    loads: tuple[Load, ...] = ()
    gravity: bool = False
    inertia: bool = False
    gas: IndicatorOrder | None = None
    friction: Friction | None = None
    balance: str = "force"
    couples: str = "moment"
    single: tuple[int, ...] = field(default=())
    limit: float = 5.0
    mu: float | None = None
    g: float = GRAVITY


ASKED: Asked[ForcesOrder] = Asked("forces")
