"""Keys of variants of the shaper held against its vector loop, written without the package."""

from __future__ import annotations

import csv
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

import numpy as np

H = 1e-4
"""The step of the crank, rad, by differences over which the loop is differentiated."""


class Off(NamedTuple):
    """How far the ram's vector in a key is from its due, mm on the sheet; how long it is due."""

    position: str
    segment: str
    off: float
    due: float


def ram(values: Mapping[str, float], angle: float) -> float:
    """Where the ram stands (mm), by the crank's angle (rad): the loop O A B C D."""
    pivot = -1j * values["OB"]
    pin = values["OA"] * np.exp(1j * angle)
    top = pivot + values["BC"] * (pin - pivot) / abs(pin - pivot)
    height = values["BC"] - values["OB"] - 20.0
    return float(top.real - np.sqrt(values["CD"] ** 2 - (height - top.imag) ** 2))


def offs(values: Mapping[str, float], table: Path) -> list[Off]:
    """Return how far speeds and accelerations of the ram in a key's table are from those of the loop."""
    rows = list(csv.DictReader(table.read_text("utf-8-sig").splitlines()))
    omega = values["drive.speed"] * np.pi / 30
    found = []
    for segment in ("pd", "πd"):
        some = [row for row in rows if row["segment"] == segment and row["mm"]]
        longest = max(some, key=lambda row: float(row["mm"]))
        mu = float(longest["value"]) / float(longest["mm"])
        for row in some:
            at = np.radians(float(row["angle_deg"]))
            before, here, behind = (ram(values, at + k * H) for k in (-1, 0, 1))
            speed = (behind - before) / (2 * H) * omega
            change = (behind - 2 * here + before) / H**2 * omega**2
            due = abs(speed if segment == "pd" else change) / 1000.0 / mu
            found.append(Off(row["position"], segment, abs(float(row["mm"]) - due), due))
    return found
