"""Machines of which the motion is known otherwise: their equation, integrated in time by Runge and Kutta.

J(φ) and M(φ) come from the vector loop of `flywheels.Crank`; nothing of the graphs is used, nor T = ∫M·dφ.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from support.flywheels import Crank, crank, scene_of

STEP = 0.02
"""So far, rad, the crank turns in a step: halved, no speed changes by 1e-7 of itself."""
NUDGE = 1e-4
"""By so much, rad, the crank is turned for dJ/dφ."""


class Machine(NamedTuple):
    """A crank mechanism that gas, or a force on its slider, and a moment on the crank set going.

    ``moment``: constant, N·m; ``inertia``: on the crank, kg·m²; ``start``: 1/s. ``motor``: of ω, on the crank.
    """

    crank: Crank
    moment: float
    inertia: float
    start: float
    motor: Callable[[float], float] = lambda omega: 0.0

    def J(self, phi: np.ndarray | float) -> np.ndarray:
        """The reduced moment of inertia."""
        return self.inertia + 2.0 * self.crank(np.asarray(phi))[1] / self.crank.omega**2

    def M(self, phi: np.ndarray | float) -> np.ndarray:
        """The reduced moment but for the motor's."""
        return self.crank(np.asarray(phi))[0] + self.moment

    def gain(self, phi: float, omega: float) -> float:
        """The angular acceleration: J·ε = M − ω²/2·dJ/dφ."""
        at = phi + NUDGE * np.array([-1.0, 0.0, 1.0])
        low, middle, high = self.J(at)
        slope = (high - low) / (2.0 * NUDGE)
        return float((self.M(phi) + self.motor(omega) - slope * omega**2 / 2.0) / middle)


class Motion(NamedTuple):
    """ω (1/s) and t (s) at angles, NaN where they are not reached; where and when it comes to rest, or NaN."""

    omega: np.ndarray
    time: np.ndarray
    rest: tuple[float, float]


def _step(machine: Machine, state: np.ndarray, h: float) -> np.ndarray:
    def slope(at: np.ndarray) -> np.ndarray:
        return np.array([at[1], machine.gain(at[0], at[1])])

    a = slope(state)
    b = slope(state + h / 2.0 * a)
    c = slope(state + h / 2.0 * b)
    return np.asarray(state + h / 6.0 * (a + 2.0 * b + 2.0 * c + slope(state + h * c)))


def _states(machine: Machine, until: float) -> Iterator[tuple[float, np.ndarray]]:
    """Yield times and states (φ, ω) up to an angle, or to rest: the last then has ω = 0."""
    t, state = 0.0, np.array([0.0, machine.start])
    yield t, state
    while state[0] < until:
        gain = machine.gain(*state)
        h = STEP / max(state[1], np.sqrt(STEP * abs(gain)), 1e-9)
        after = _step(machine, state, h)
        if after[1] <= 0.0:
            low, high = 0.0, h
            for _ in range(60):
                h = (low + high) / 2.0
                low, high = (h, high) if _step(machine, state, h)[1] > 0.0 else (low, h)
            yield t + low, _step(machine, state, low) * np.array([1.0, 0.0])
            return
        t, state = t + h, after
        yield t, state


def _when(first: np.ndarray, last: np.ndarray, h: float, angle: float) -> float:
    """Return after which time of a step of ``h`` the cubic between its states comes to an angle."""
    low, high, rise = 0.0, 1.0, last[0] - first[0]
    for _ in range(50):
        u = (low + high) / 2.0
        bend = 3.0 * rise - h * (2.0 * first[1] + last[1])
        way = u * (h * first[1] + u * (bend + u * (h * (first[1] + last[1]) - 2.0 * rise)))
        low, high = (u, high) if way < angle - first[0] else (low, u)
    return high * h


def motion(machine: Machine, angles: np.ndarray) -> Motion:
    """Integrate the equation of motion; angles between two steps are sought on the step itself."""
    omega, time = np.full(angles.shape, np.nan), np.full(angles.shape, np.nan)
    omega[0], time[0] = machine.start, 0.0
    rest, k, before = (np.nan, np.nan), 1, (0.0, np.array([0.0, machine.start]))
    for t, state in _states(machine, float(angles[-1])):
        while k < len(angles) and state[0] >= angles[k]:
            h = _when(before[1], state, t - before[0], float(angles[k]))
            omega[k], time[k] = _step(machine, before[1], h)[1], before[0] + h
            k += 1
        if t > 0.0 and state[1] == 0.0:
            rest = (float(state[0]), t)
        before = (t, state)
    return Motion(omega, time, rest)


def machine(seed: int) -> Machine:
    """A machine drawn at random: from rest, running, or braked until it stands."""
    rng = np.random.default_rng(1000 + seed)
    own = crank(seed)
    row = own(np.arange(720) * np.pi / 360)
    size, links = float(np.ptp(row[0])), 2.0 * row[1].max() / own.omega**2
    inertia = float(rng.uniform(0.5, 6.0) * links)
    kind = seed % 3
    share = {0: rng.uniform(0.1, 0.8), 1: rng.uniform(-0.05, 0.3), 2: rng.uniform(-0.5, -0.1)}[kind]
    moment = float(share * size - row[0].mean() - min(0.0, row[0][0] - row[0].mean()) * (kind == 0))
    start = (
        0.0 if kind == 0 else float(np.sqrt(2.0 * rng.uniform(1.0, 4.0) * size / (inertia + links)))
    )
    return Machine(own, moment, inertia, start)


class Catalogue(NamedTuple):
    """A motor as its catalogue has it: power (W), nominal and synchronous speed (1/s), M_k/M_n; on the crank.

    ``straight``: its characteristic goes straight through the nominal point.
    """

    power: float
    nominal: float
    synchronous: float
    overload: float
    ratio: float
    straight: bool

    def __call__(self, omega: float) -> float:
        """The moment on the crank: Kloss's formula by the slip, of which a quadratic equation gives s_k."""
        turns, nominal = omega * self.ratio, self.power / self.nominal
        slip, own = (1.0 - one / self.synchronous for one in (turns, self.nominal))
        if self.straight:
            return self.ratio * nominal * slip / own
        # 2λ/(s/k + k/s) = 1 at the nominal slip: k² − 2λs·k + s² = 0, the greater root
        critical = max(np.roots([1.0, -2.0 * self.overload * own, own**2]).real)
        return float(
            2.0 * self.ratio * self.overload * nominal * slip * critical / (slip**2 + critical**2)
        )

    def written(self, step: int = 1) -> str:
        """Its section of a scene."""
        own = f"power = {self.power!r}\nnominal = {self.nominal!r}\nratio = {self.ratio!r}\nstep = {step}\n"
        if self.straight:
            return f"[motor]\nno_load = {self.synchronous!r}\n{own}"
        return f"[motor]\nsynchronous = {self.synchronous!r}\noverload = {self.overload!r}\n{own}"


def driven(seed: int) -> tuple[Machine, Catalogue]:
    """A machine drawn at random that a motor drives against its load; every other one starts from rest."""
    rng = np.random.default_rng(5000 + seed)
    own = crank(seed)
    row = own(np.arange(720) * np.pi / 360)
    size = float(np.ptp(row[0]))
    load = float(rng.uniform(0.1, 0.4)) * size
    idle, ratio = float(rng.uniform(10.0, 40.0)), float(rng.uniform(1.0, 40.0))
    slip, due = float(rng.uniform(0.03, 0.1)), load * float(rng.uniform(1.2, 2.0))
    nominal = idle * ratio * (1.0 - slip)
    motor = Catalogue(due / ratio * nominal, nominal, idle * ratio, float(rng.uniform(1.8, 3.0)), ratio,
                      straight=seed % 3 == 2)  # fmt: skip
    inertia = float(rng.uniform(10.0, 60.0)) * due / idle**2 + size / idle**2 * 8.0
    start = 0.0 if seed % 2 else idle * float(rng.uniform(0.5, 0.95))
    moment = -load - float(row[0].mean())
    if not start:
        moment = min(moment, 0.8 * motor(0.0) - float(row[0][0]) if row[0][0] < 0 else moment)
        moment = max(moment, -float(row[0].min()) - 0.8 * motor(0.0)) if motor.straight else moment
    return Machine(own, moment, inertia, start, motor), motor


def written(of: Machine, count: int, turns: int = 1, *, gas: bool = True, more: str = "") -> str:
    """The scene of a machine: the gas position by position, or the same force as a load on the slider."""
    text = scene_of(of.crank, count)
    head, _, tail = text.partition("[flywheel]")
    tail = tail[tail.index("[hand]") :].replace('"flywheel"', '"motion_law"')
    if not gas:
        angles = np.arange(count) * 2 * np.pi / count
        forces = [float(p) for p in of.crank.pressure(angles) * of.crank.face]
        head = head.partition("[indicator]")[0] + (
            f'[[load]]\nlink = 3\npoint = "B"\nby_position = {forces}\ndirection = "180 deg"\n[forces]\n'
        )
    start = f"start = {of.start!r}\n" if of.start else ""
    own = f"M = {of.moment!r}\n" if of.moment else ""
    if isinstance(of.motor, Catalogue):
        more += of.motor.written()
    return f"{head}[motion_law]\n{start}{own}J = {of.inertia!r}\nturns = {turns}\n{more}{tail}"
