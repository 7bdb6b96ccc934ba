"""Plans as a student of his own makes them, right or with a mistake: plane geometry alone.

Mechanisms of tests/cases/check; rays are off, lengths too; what is drawn after a mistake follows from it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from support.another_hand import met

V, A = "velocities", "accelerations"


class Board:
    """One plan as a student draws it: mm from its pole; rays off by ``swing``°, lengths by ``slip`` mm."""

    def __init__(self, rng: np.random.Generator | None, swing: float = 0.6, slip: float = 0.4):
        self.rng, self.swing, self.slip = rng, swing, slip
        self.points: dict[str, complex] = {"": 0j}
        self.lines: list[tuple[complex, complex, str]] = []

    def ray(self, along: complex) -> complex:
        off = 0.0 if self.rng is None else self.swing * self.rng.standard_normal()
        return complex(along / abs(along) * np.exp(1j * np.radians(off)))

    def lay(self, name: str, start: str, along: complex, length: float) -> None:
        """Lay a length off from a point: a vector."""
        off = 0.0 if self.rng is None else self.slip * self.rng.standard_normal()
        begin = self.points[start]
        self.points[name] = begin + (length + off) * self.ray(along)
        self.lines.append((begin, self.points[name], "vector"))

    def meet(self, name: str, one: str, u: complex, two: str, v: complex) -> None:
        """Draw a line through each of two points; they meet in a third: both are vectors up to there."""
        p, q = self.points[one], self.points[two]
        z = met(p, self.ray(u), q, self.ray(v))
        self.points[name] = z
        for begin in (p, q):
            if abs(z - begin) > 0.5:
                beyond = z + (z - begin) / abs(z - begin) * 4.0
                self.lines += [(begin, beyond, "thin"), (begin, z, "vector")]

    def join(self, one: str, two: str) -> None:
        p, q = self.points[one], self.points[two]
        if abs(p - q) > 0.5:
            self.lines.append((p, q, "thin"))

    def put(self, name: str, at: complex, *sides: str) -> None:
        """Put a point where it belongs, and draw it from the pole, and the sides of its figure."""
        off = 0j if self.rng is None else 0.2 * complex(*self.rng.standard_normal(2))
        self.points[name] = at + off
        self.lines.append((0j, at + off, "vector"))
        for side in sides:
            self.join(side, name)


Mu = dict[str, float]
Plan = Callable[[Board, str, float, Mu, str], None]


def slider_crank(board: Board, plan: str, phi: float, mu: Mu, kind: str) -> None:
    r, rod, share, omega = 0.1, 0.35, 0.4, 20.0
    side = -1 if kind == "other assembly" else 1
    oa = r * np.exp(1j * phi)
    u = (complex(oa.real + side * np.sqrt(rod**2 - oa.imag**2), 0) - oa) / rod
    if kind == "s2 in the middle":
        share = 0.5
    va = 1j * omega * oa
    vb = met(va, 1j * u, 0j, 1.0)
    vba = abs(vb - va)
    if plan == V:
        board.lay("a", "", va, abs(va) / mu[V])
        board.meet("b", "a", u if kind == "ab along AB" else 1j * u, "", 1.0)
    else:
        board.lay("a", "", oa if kind == "a outwards" else -oa, omega**2 * r / mu[A])
        n = vba**2 / rod / mu[A]
        n *= {"n too long": 1.8, "n halved": 0.5}.get(kind, 1.0)
        board.lay("n2", "a", u if kind == "n from the wrong end" else -u, n)
        board.meet("b", "a" if kind == "t from a" else "n2", 1j * u, "", 1.0)
        board.join("a", "b")
    a, b = board.points["a"], board.points["b"]
    board.put("s2", a + share * (b - a))


def four_bar(board: Board, plan: str, phi: float, mu: Mu, kind: str) -> None:
    r, rod, rocker, c_, omega = 0.08, 0.26, 0.18, 0.3, 15.0
    side = -1 if kind == "other assembly" else 1
    oa = r * np.exp(1j * phi)
    base = c_ - oa
    foot = (rod**2 - rocker**2 + abs(base) ** 2) / 2 / abs(base)
    b_ = oa + base / abs(base) * (foot + side * 1j * np.sqrt(rod**2 - foot**2))
    u, w = (b_ - oa) / rod, (b_ - c_) / rocker
    shape = (0.15 + 0.1j) / rod
    if kind == "e mirrored":
        shape = np.conj(shape)
    va = 1j * omega * oa
    vb = met(va, 1j * u, 0j, 1j * w)
    if plan == V:
        board.lay("a", "", va, abs(va) / mu[V])
        board.meet("b", "a", u if kind == "ab along AB" else 1j * u, "", 1j * w)
    else:
        board.lay("a", "", oa if kind == "a outwards" else -oa, omega**2 * r / mu[A])
        n = abs(vb - va) ** 2 / rod / mu[A]
        n *= {"n too long": 1.8, "n halved": 0.5}.get(kind, 1.0)
        board.lay("n2", "a", u if kind == "n from the wrong end" else -u, n)
        board.lay("n3", "", w if kind == "n3 outwards" else -w, abs(vb) ** 2 / rocker / mu[A])
        start = "a" if kind == "t from a" else "n2"
        board.meet("b", start, 1j * u, "" if kind == "n3 left out" else "n3", 1j * w)
        board.join("", "b")
    a, b = board.points["a"], board.points["b"]
    board.join("a", "b")
    board.put("e", a + shape * (b - a), "a", "b")


def slotted_lever(board: Board, plan: str, phi: float, mu: Mu, kind: str) -> None:
    r, pivot, arm, omega = 0.12, -0.4j, 0.65, 10.0
    oa = r * np.exp(1j * phi)
    long = abs(oa - pivot)
    u = (oa - pivot) / long
    va = 1j * omega * oa
    va3 = met(va, u, 0j, 1j * u)
    share = arm / long
    if kind == "c not so far":
        share = (arm - 0.15) / long
    if plan == V:
        board.lay("a", "", va, abs(va) / mu[V])
        board.meet("a3", "a", u, "", 1j * u)
    else:
        rate = float((va3 / (1j * u)).real) / long
        slide = va3 - va
        board.lay("a", "", oa if kind == "a outwards" else -oa, omega**2 * r / mu[A])
        k = 2j * rate * slide * {"k the other way": -1, "k halved": 0.5}.get(kind, 1.0)
        board.lay("k2", "a", k, abs(k) / mu[A])
        out = 1 if kind == "n3 outwards" else -1
        board.lay("n3", "", out * u, rate**2 * long / mu[A])
        board.meet("a3", "a" if kind == "k left out" else "k2", u, "n3", 1j * u)
        board.join("", "a3")
    board.put("c", share * board.points["a3"])


class Machine(NamedTuple):
    """A mechanism: μ of its scene's plans, how it is drawn, where accelerations are, its wrong kinds."""

    mu: Mu
    draw: Plan
    accelerated: tuple[int, ...]
    wrong: tuple[str, ...]


MACHINES = {
    "sc": Machine(
        {V: 0.025, A: 0.5},
        slider_crank,
        (1, 3, 5),
        (
            *("n from the wrong end", "t from a", "other assembly", "s2 in the middle"),
            *("ab along AB", "a outwards", "n too long", "n halved"),
        ),
    ),
    "fb": Machine(
        {V: 0.015, A: 0.25},
        four_bar,
        (1, 3, 6),
        (
            *("n from the wrong end", "t from a", "other assembly", "e mirrored", "n3 left out"),
            *("n3 outwards", "a outwards", "n too long"),
        ),
    ),
    "rpr": Machine(
        {V: 0.02, A: 0.2},
        slotted_lever,
        (1, 3, 6),
        ("k the other way", "k left out", "k halved", "n3 outwards", "c not so far", "a outwards"),
    ),
}
