"""The mechanisms that the student is set: lengths in m, as the task sheet gives them."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import numpy as np

HERE = Path(__file__).parent


class Machine(NamedTuple):
    """A mechanism: ``kind`` of its first group, its lengths, and the scene's scale factors."""

    name: str
    scene: Path
    kind: str
    """``slider`` AB on the x axis, ``rocker`` AB and BC, ``slot``: a stone A on the lever through B."""
    OA: float
    omega: float
    count: int
    at: tuple[int, ...]
    """The positions whose accelerations are drawn."""
    mu_l: float
    mu_v: float
    mu_a: float
    AB: float = 0.0
    BC: float = 0.0
    """Of a slot: from B to C, behind B where it is negative."""
    pivot: complex = 0j
    S2: float = 0.0
    E: complex = 0j
    CD: float = 0.0
    guide: float = 0.0
    start: float = 0.0
    S1: float = 0.0
    S3: bool = False
    loads: tuple[int, ...] = ()
    """The positions whose forces are found."""
    mu_F: float = 4.0
    travel: str = ""
    rates_of_stone: bool = True

    def angle(self, k: float) -> float:
        """Return the angle of the crank in position ``k``, rad."""
        return float(np.radians(self.start) + 2 * np.pi * k / self.count)

    @property
    def points(self) -> int:
        """How many positions there are."""
        return self.count


def _header() -> Machine:
    """Find OA and BC of the swath header's drive by its K_v and stroke."""
    half = np.pi / 2 * (1.45 - 1) / (1.45 + 1)
    arm = 0.095 / (2 * np.sin(half))
    return Machine(
        "header",
        HERE / "scenes/header.toml",
        "slot",
        0.48 * np.sin(half),
        380 * np.pi / 30,
        12,
        (2, 6, 8),
        0.004,
        0.075,
        2.0,
        BC=-arm,
        pivot=-0.48j,
        CD=arm,
        guide=-0.48 - 1.25 * arm,
        start=-np.degrees(half),
        S1=0.5,
        S3=True,
        loads=(8,),
        mu_F=50.0,
        travel="sD",
    )


def _slider(name: str, *, loads: tuple[int, ...] = ()) -> Machine:
    return Machine(
        name,
        HERE / f"scenes/{name}.toml",
        "slider",
        0.1,
        20,
        8,
        (1, 3, 5),
        0.002,
        0.025,
        0.5,
        AB=0.35,
        S2=0.14,
        loads=loads,
        travel="sB" if loads else "",
    )


MACHINES = {
    one.name: one
    for one in (
        _slider("sc"),
        Machine(
            "fb",
            HERE / "scenes/fb.toml",
            "rocker",
            0.08,
            15,
            8,
            (1, 3, 6),
            0.002,
            0.015,
            0.25,
            AB=0.26,
            BC=0.18,
            pivot=0.3 + 0j,
            E=0.15 + 0.1j,
        ),
        Machine(
            "rpr",
            HERE / "scenes/rpr.toml",
            "slot",
            0.12,
            10,
            8,
            (1, 3, 6),
            0.004,
            0.02,
            0.2,
            BC=0.65,
            pivot=-0.4j,
        ),
        Machine(
            "six",
            HERE / "scenes/six.toml",
            "slot",
            0.11,
            30,
            8,
            (1, 3, 6),
            0.004,
            0.04,
            1.0,
            BC=-0.2,
            pivot=-0.45j,
            CD=0.22,
            guide=-0.68,
        ),
        _header(),
        _slider("frc", loads=(1, 3)),
    )
}
