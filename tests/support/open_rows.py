"""Scenes whose row goes from one end to another, with places outside of it: when they come to each place."""

from __future__ import annotations

import math
from pathlib import Path
from typing import NamedTuple

import numpy as np

from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.scene.read import read
from support.boards import drawn_of
from support.drives import BOOM, LEVER, RACK, SLIDER
from support.scenes import written

FORCES = '[forces]\npositions = "all"\nbalance = "force"\n'


class Stroke(NamedTuple):
    """A scene of an open row: its ends and rate (° and °/s, or mm and mm/s), places outside, a loaded link."""

    text: str
    first: float
    last: float
    rate: float
    outside: tuple[float, float]
    link: int
    unit: str = "mm"

    @property
    def time(self) -> float:
        """How long the row takes, s."""
        return abs(self.last - self.first) / self.rate

    def scene(self, more: str, keys: str = "", count: int = 6) -> str:
        head, drive = self.text.split("[drive]")
        dropped = ("accel", "from", "to", "positions", "speed")
        kept = [line for line in drive.splitlines() if not line.startswith(dropped)]
        speed = f"{math.radians(self.rate)!r} rad/s" if self.unit == "deg" else f"{self.rate} mm/s"
        ends = f'from = "{self.first} {self.unit}"\nto = "{self.last} {self.unit}"\n'
        row = f'speed = "{speed}"\n{keys or f"{ends}positions = {count}"}\n'
        return "\n".join((f"{head}[drive]", row, *kept, more, FORCES))

    def times(self, places: np.ndarray) -> np.ndarray:
        """When it comes to places, s."""
        return (places - self.first) / self.rate * math.copysign(1.0, self.last - self.first)


STROKES = {
    "crank": Stroke(LEVER, 20.0, 75.0, 115.0, (12.0, 79.0), 3, "deg"),
    "crank back": Stroke(LEVER, 75.0, 20.0, 115.0, (79.0, 12.0), 3, "deg"),
    "crank past 360°": Stroke(LEVER, 340.0, 390.0, 115.0, (333.0, 397.0), 3, "deg"),
    "slider": Stroke(SLIDER, 250.0, 350.0, 500.0, (240.0, 370.0), 3),
    "slider back": Stroke(SLIDER, 350.0, 250.0, 500.0, (370.0, 240.0), 3),
    "rod": Stroke(BOOM, 600.0, 850.0, 50.0, (550.0, 880.0), 1),
    "rack": Stroke(RACK, 10.0, 120.0, 200.0, (4.0, 126.0), 3),
}


def drawn(text: str, folder: Path) -> Drawn:
    return drawn_of(read(written(folder, text)), exact=True)


def sizes(made: Drawn) -> np.ndarray:
    (mark,) = FORCES_PLAN.on(made).loads.given
    return np.asarray(made.reading[mark][0])
