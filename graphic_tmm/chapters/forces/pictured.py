"""Which loads have a diagram, over what, how far it reaches: what a sheet shows, and what μ is chosen by."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.forces.given import braced, letters, sizes_of, varies
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.task import Load
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn

ACROSS, UP = 70.0, 40.0
"""Room for the base and for the largest size, mm."""
VIEW = "load"
"""What the diagram of a load is called by code, before its letter."""


class Pictured(NamedTuple):
    """A load that varies: its place in the scene, its letter, its size on the board.

    ``reach``: of the base (m of travel, degrees of the turn, positions); ``largest``: size, N or N·m. ``base``,
    ``unit``: of what a mm of the base and of the height stands for; the base of positions has no unit.
    """

    place: int
    letter: str
    load: Load
    size: Mark
    reach: float
    largest: float
    base: str
    unit: str

    @property
    def view(self) -> str:
        """What code calls the diagram."""
        return f"{VIEW} {self.letter}"

    @property
    def scales(self) -> tuple[str, str]:
        """The letters of the scale factors of the base ("" where it has none) and of the height."""
        along = {"m/mm": "μ_S", "°/mm": "μ_φ"}.get(self.base, "")
        return along, f"μ_{self.letter[0]}"


def pictured(drawn: Drawn) -> Iterator[Pictured]:
    """Yield the loads that are given by the travel of a slider, the turn or the position, in order."""
    made = FORCES_PLAN.on(drawn)
    loads = made.order.loads
    for k, (letter, load, size) in enumerate(
        zip(letters(loads), loads, made.loads.given, strict=True)
    ):
        largest = max(map(abs, sizes_of(load)), default=0.0)
        if varies(load) and largest > 0.0:
            reach, base = _reach(drawn, load, size)
            unit = "N·m/mm" if load.point is None else "N/mm"
            yield Pictured(k, braced(letter), load, size, reach, largest, base, unit)


def _reach(drawn: Drawn, load: Load, size: Mark) -> tuple[float, str]:
    """Return how far the base of a diagram reaches, and the unit of its scale factor."""
    if load.travel is not None:
        stroke = travelled(drawn, size)[1]
        return float(drawn.reading[stroke][0, 0]) * mu_l(drawn), "m/mm"
    if load.by_angle:
        return 360.0, "°/mm"
    return float(len(sizes_of(load)) - 1 or 1), ""


def travelled(drawn: Drawn, size: Mark) -> tuple[Mark, Mark]:
    """Return the way from the zero position and the whole stroke (mm) that the size of a load depends on."""
    *_, way, stroke = next(step.uses for step in drawn.construction.steps if step.it == size)
    return way, stroke


def mu_l(drawn: Drawn) -> float:
    """Return the scale factor of lengths, m a mm."""
    return float(drawn.reading[KINEMATICS_PLAN.on(drawn).mu_l][0, 0])
