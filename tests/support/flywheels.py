"""An oracle of the flywheel's graphs: numpy alone; what a careful student would draw, and the fine truth.

Curves are Hermite arcs on even intervals: the moment's with tangents kept between 0 and three chords, that of
the links' energy smooth, that of the flywheel's energy with the slopes of both.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

Rows = tuple[np.ndarray, np.ndarray]


def slopes(y: np.ndarray) -> np.ndarray:
    """Rises over an interval of the periodic C² cubic spline, by a dense linear system."""
    one = np.eye(y.size)
    matrix = 4 * one + np.roll(one, 1, axis=1) + np.roll(one, -1, axis=1)
    return np.linalg.solve(matrix, 3 * (np.roll(y, -1) - np.roll(y, 1)))


def taut(y: np.ndarray) -> np.ndarray:
    """The same, but 0 at corners and turns, and three times the lesser chord at the most."""
    found = slopes(y)
    for k in range(y.size):
        before, after = y[k] - y[k - 1], y[(k + 1) % y.size] - y[k]
        sign = np.sign(after)
        if before * after <= 0.0:
            found[k] = 0.0
        else:
            found[k] = sign * min(max(sign * found[k], 0.0), 3 * min(abs(before), abs(after)))
    return found


def smooth(y: np.ndarray) -> np.ndarray:
    """The spline's, brought between 0, three chords, and the chord and the lesser bend beside it."""
    n, found = y.size, slopes(y)

    def chord(k: int) -> float:
        return float(y[(k + 1) % n] - y[k % n])

    def lesser(k: int) -> float:
        a, b = chord(k) - chord(k - 1), chord(k + 1) - chord(k)
        return float(np.sign(a) * min(abs(a), abs(b))) if a * b > 0 else 0.0

    for k in range(n):
        for at, sense in ((k, -1), (k - 1, 1)):
            reach = (0.0, 3 * chord(at), chord(at) + sense * lesser(at))
            found[k] = min(max(found[k], min(reach)), max(reach))
    return found


def along(y: np.ndarray, m: np.ndarray, parts: int) -> np.ndarray:
    """Ordinates of a closed row of Hermite arcs, ``parts`` to an interval."""
    t, found = np.arange(parts) / parts, []
    for k in range(y.size):
        p, q, a, b = y[k], y[(k + 1) % y.size], m[k], m[(k + 1) % y.size]
        h = (1 + 2 * t) * (1 - t) ** 2 * p + t**2 * (3 - 2 * t) * q
        found.append(h + t * (1 - t) ** 2 * a - t**2 * (1 - t) * b)
    return np.concatenate(found)


class Graphs(NamedTuple):
    """What the graphs show: ΔT at the positions; ΔT, energies of links and flywheel along their curves."""

    surplus: np.ndarray
    ahead: np.ndarray
    links: np.ndarray
    own: np.ndarray


def graphs(
    moment: np.ndarray,
    t_links: np.ndarray,
    mean: str = "areas",
    parts: int = 400,
    turns: int = 1,
) -> Graphs:
    """The graphs through the ordinates of a row over so many turns."""
    n, m = moment.size, taut(moment)
    step = 2 * np.pi * turns / n
    after = np.roll(moment, -1)
    means = {
        "chords": (moment + after) / 2,
        "middles": along(moment, m, 2)[1::2],
        "areas": (moment + after) / 2 + (m - np.roll(m, -1)) / 12,
    }[mean]
    works = np.concatenate([[0.0], np.cumsum(means) * step])
    surplus = (works - works[-1] * np.arange(n + 1) / n)[:n]
    steep = (moment - works[-1] / (2 * np.pi * turns)) * step
    ahead, links = along(surplus, steep, parts), along(t_links, smooth(t_links), parts)
    return Graphs(surplus, ahead, links, ahead - links)


def at_positions(moment: np.ndarray, t_links: np.ndarray) -> float:
    """The range of T as it was found before: ordinates of the spline's middles, extremes at the positions."""
    n = moment.size
    works = np.concatenate(
        [[0.0], np.cumsum(along(moment, slopes(moment), 2)[1::2]) * 2 * np.pi / n]
    )
    return float(np.ptp((works - works[-1] * np.arange(n + 1) / n)[:n] - t_links))


def truth(machine: Callable[[np.ndarray], Rows], count: int = 14400) -> float:
    """The range of the flywheel's energy from a fine row, by rectangles of the middles."""
    step = 2 * np.pi / count
    moment, _ = machine((np.arange(count) + 0.5) * step)
    _, t_links = machine(np.arange(count) * step)
    works = np.concatenate([[0.0], np.cumsum(moment) * step])
    return float(np.ptp(works[:-1] - works[-1] * np.arange(count) / count - t_links))


class Crank(NamedTuple):
    """A crank mechanism whose piston is driven: lengths (m), masses (kg), the face (m²), the speed (1/s).

    ``pressure``: of the crank's angle, Pa.
    """

    r: float
    l: float  # noqa: E741
    offset: float
    s: float
    masses: tuple[float, float]
    inertia: float
    face: float
    omega: float
    pressure: Callable[[np.ndarray], np.ndarray]

    def __call__(self, phi: np.ndarray) -> Rows:
        """The reduced moment (N·m), the energy of the links (J); angles count from the outer dead centre."""
        pressure = self.pressure(phi)
        phi = phi + np.arcsin(self.offset / (self.r + self.l))
        sine = (self.offset - self.r * np.sin(phi)) / self.l
        cosine = np.sqrt(1 - sine**2)
        rod = -self.r * self.omega * np.cos(phi) / (self.l * cosine)
        pin = 1j * self.omega * self.r * np.exp(1j * phi)
        way = cosine + 1j * sine
        v = (pin + 1j * rod * self.l * way).real
        centre = np.abs(pin + 1j * rod * self.s * way)
        energy = self.masses[0] * centre**2 + self.inertia * rod**2 + self.masses[1] * v**2
        return -pressure * self.face * v / self.omega, energy / 2


def crank(seed: int) -> Crank:
    """A machine drawn at random: a smooth gas pressure that drives and is driven, over the crank's angle."""
    rng = np.random.default_rng(seed)
    r = rng.uniform(0.05, 0.3)
    long = r / rng.uniform(0.18, 0.4)
    mean, waves = rng.uniform(2e5, 8e5), rng.uniform(0.1, 0.45, 2)
    late = rng.uniform(0, 2 * np.pi, 2)

    def pressure(phi: np.ndarray) -> np.ndarray:
        return mean * (1 + waves[0] * np.cos(phi - late[0]) + waves[1] * np.cos(2 * phi - late[1]))

    offset = float(rng.choice([0.0, rng.uniform(-0.25, 0.25)])) * r
    return Crank(
        r, long, offset, 0.4 * long, (rng.uniform(0.2, 3), rng.uniform(0.2, 3)),
        rng.uniform(0.01, 0.2) * long**2, float(np.pi) * rng.uniform(0.06, 0.2) ** 2 / 4,
        rng.uniform(10, 50), pressure,
    )  # fmt: skip


def scene_of(
    of: Crank, count: int, delta: float = 0.05, more: str = "", format_: str = "A1"
) -> str:
    """The scene of such a machine, its pressures position by position."""
    pressures = of.pressure(np.arange(count) * 2 * np.pi / count)
    bore = float(np.sqrt(4 * of.face / np.pi))
    return f"""
title = "A machine"
language = "en"
[frame]
O = [0, 0]
x = {{ through = [0, {of.offset!r}], angle = "0 deg" }}
[[link]]
number = 1
points = {{ O = [0, 0], A = [{of.r!r}, 0] }}
[[link]]
number = 2
points = {{ A = [0, 0], B = [{of.l!r}, 0], S2 = [{of.s!r}, 0] }}
mass = {of.masses[0]!r}
centre = "S2"
J = {of.inertia!r}
[[link]]
number = 3
points = {{ B = [0, 0] }}
slides = {{ on = "frame", along = "x", side = "right" }}
mass = {of.masses[1]!r}
centre = "B"
[drive]
link = 1
speed = {of.omega!r}
positions = {count}
zero = {{ point = "B", at = "right" }}
[indicator]
point = "B"
bore = {bore!r}
cover = {[float(p) for p in pressures]}
[flywheel]
delta = {delta}
{more}
[hand]
ruler = "exact"
[[sheet]]
format = "{format_}"
place = ["positions", "velocities", "flywheel"]
"""
