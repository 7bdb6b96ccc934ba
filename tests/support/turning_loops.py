"""The scenes that come with ranges, as vector loops in numpy over a turn: written without the package.

Of the values of a variant (mm): whether it assembles at every crank angle, and its least transmission angle.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple

import numpy as np

PHI = np.radians(np.arange(0.0, 360.0, 0.25))
"""The crank angles tried: those at which a least angle is taken are among them, or near."""
Values = Mapping[str, float]
OA, AB, CB, BD = (
    "link 1, points.A[1]",
    "link 2, points.B[1]",
    "link 3, points.B[1]",
    "link 4, points.D[1]",
)


class Turn(NamedTuple):
    """Whether it assembles over the turn, and its least transmission angle, degrees (NaN if it does not)."""

    whole: bool
    least: float


def of_sines(*sines: np.ndarray) -> Turn:
    """Return a turn by the sines of the transmission angles, NaN where it does not assemble."""
    every = np.stack(np.broadcast_arrays(*sines))
    if np.isnan(every).any():
        return Turn(False, np.nan)
    return Turn(True, float(np.degrees(np.arcsin(np.minimum(every, 1.0).min()))))


def four_bar(
    crank: float, coupler: float, rocker: float, pivot: complex, side: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return where the pin between coupler and rocker is, and the sine of the angle there.

    ``side``: 1 where the pin lies to the left of the way from the crank's pin to the rocker's pivot.
    """
    pin = crank * np.exp(1j * PHI)
    way = pivot - pin
    far = np.abs(way)
    with np.errstate(invalid="ignore"):
        cosine = (coupler**2 + far**2 - rocker**2) / (2 * coupler * far)
        between = (coupler**2 + rocker**2 - far**2) / (2 * coupler * rocker)
        turned = np.arccos(np.where(np.abs(cosine) <= 1, cosine, np.nan))
        sine = np.sqrt(np.where(np.abs(between) <= 1, 1 - between**2, np.nan))
    return pin + coupler * way / far * np.exp(1j * side * turned), sine


def on_a_guide(off: np.ndarray, rod: float) -> np.ndarray:
    """Return the sine of the angle between a rod and what is square to a guide so far off."""
    with np.errstate(invalid="ignore"):
        return np.sqrt(np.where(np.abs(off) <= rod, 1 - (off / rod) ** 2, np.nan))


def shaper(v: Values) -> Turn:
    """Crank OA in a rocker about B, OB below O; rod CD to a guide 20 mm below C's highest place."""
    pin = v["OA"] * np.exp(1j * PHI) + 1j * v["OB"]
    height = v["BC"] * (pin / np.abs(pin)).imag
    return of_sines(on_a_guide(height - (v["BC"] - 20.0), v["CD"]))


def offset_slider(v: Values) -> Turn:
    """Crank r, rod l, a guide e off the crank's pivot."""
    return of_sines(on_a_guide(v["r"] * np.sin(PHI) + v["e"], v["l"]))


def crank_press(v: Values) -> Turn:
    """Crank and rod to a guide through the crank's pivot."""
    return of_sines(on_a_guide(v[OA] * np.cos(PHI), v[AB]))


def crank_rocker(v: Values) -> Turn:
    """A four-bar by the condition of Grashof and the law of cosines, at both ends of the crank's line."""
    pivot = np.hypot(v["frame.C[1]"], 10.0)
    sides = sorted((v[OA], v[AB], v[CB], pivot))
    if not (sides[0] == v[OA] and sides[0] + sides[3] <= sides[1] + sides[2]):
        return Turn(False, np.nan)
    far = np.array([pivot - v[OA], pivot + v[OA]])
    cosine = (v[AB] ** 2 + v[CB] ** 2 - far**2) / (2 * v[AB] * v[CB])
    return Turn(True, float(np.degrees(np.arccos(np.abs(cosine).max()))))


def toggle_press(v: Values) -> Turn:
    """A four-bar, and a rod from its rocker's pin to a guide below the rocker's pivot."""
    pin, sine = four_bar(v[OA], v[AB], v[CB], 320 + 220j, -1)
    return of_sines(sine, on_a_guide(pin.real - 320.0, v[BD]))


def lever(v: Values) -> Turn:
    """A four-bar, and a rod from a point of its rocker, 220 mm from its pivot, to a level guide."""
    pivot = 330 - 90j
    pin, sine = four_bar(v["OA"], v["AB"], v["CB"], pivot, 1)
    point = pivot + 220 * (pin - pivot) / v["CB"]
    return of_sines(sine, on_a_guide(point.imag - 90.0, v["DE"]))


LOOPS: Mapping[str, Callable[[Values], Turn]] = {
    "shaper": shaper,
    "offset-slider": offset_slider,
    "crank-press": crank_press,
    "crank-rocker": crank_rocker,
    "toggle-press": toggle_press,
    "lever": lever,
}
