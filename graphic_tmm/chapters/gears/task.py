"""What is asked for of a gear pair: two spur wheels cut by one rack (SI; drawn lengths in mm)."""

from __future__ import annotations

from dataclasses import dataclass

from graphic_tmm.chapter import Asked


@dataclass(frozen=True)
class GearOrder:
    """A pair of external spur gears with the module ``m`` (m) and the shift coefficients ``x1``, ``x2``.

    Wheel 1 drives. ``alpha`` (degrees), ``ha`` and ``c`` are those of the basic rack. ``delta_y``: the
    equalising shift if a table gives it, else it follows exactly. ``steps``: by how many steps a flank is
    rolled. ``least_tip``: the least thickness at the tip, in modules. ``stations``: further distances from N1
    along the drawn line of action, mm, at which the specific sliding is found. ``mu`` (m/mm) and
    ``mu_sliding`` (1/mm): scales if the task fixes them, else standard ones are chosen.
    """

    z1: int
    z2: int
    m: float
    x1: float = 0.0
    x2: float = 0.0
    alpha: float = 20.0
    ha: float = 1.0
    c: float = 0.25
    delta_y: float | None = None
    steps: int = 12
    least_tip: float = 0.2
    stations: tuple[float, ...] = ()
    mu: float | None = None
    mu_sliding: float | None = None


ASKED: Asked[GearOrder] = Asked("gears")
