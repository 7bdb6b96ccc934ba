"""Who draws a plate on three legs by hand, in mm on his sheet; he knows nothing of the package.

The place is found by a locus: the first leg is turned until the third pin comes to its circle. He takes Assur's
point of any two legs, and goes on with what he has, so that of a mistake only those rows are his that it makes.
"""

from __future__ import annotations

import cmath
import math
import random
from collections.abc import Callable
from itertools import pairwise

Spots = dict[str, complex]
Read = dict[str, float]
HEAD = "plan,position,segment,mm,value,unit,x,y"
FIXED = {"A": "O", "C": "D", "F": "E"}
LEGS = {2: ("A", "B"), 4: ("D", "C"), 5: ("E", "F")}
"""The legs by their links, from the pivot to the pin of the plate."""
LENGTHS = {"OA": 0.05, "AB": 0.2, "BC": 0.12, "DC": 0.18, "EF": 0.2}
PIN = 0.07 + 0.08j
"""The third pin of the plate, along BC and to the left, m."""
FRAME = {"O": 0j, "D": 0.3 - 0.05j, "E": 0.42 + 0.12j}
BEGUN = math.radians(-114.0)
"""How BC stands at 0°, nearly."""
OMEGA = 10.0
TRIAD = """
[frame]
O = [0, 0]
D = [0.3, -0.05]
E = [0.42, 0.12]
[[link]]
number = 1
points = { O = [0, 0], A = [0.05, 0] }
[[link]]
number = 2
points = { A = [0, 0], B = [0.2, 0] }
[[link]]
number = 3
points = { B = [0, 0], C = [0.12, 0], F = [0.07, 0.08] }
near = "-114 deg"
[[link]]
number = 4
points = { C = [0, 0], D = [0.18, 0] }
[[link]]
number = 5
points = { F = [0, 0], E = [0.2, 0] }
[drive]
link = 1
speed = 10
"""
"""His mechanism as a scene, but for how many positions it has."""
SCENE = f"""
title = "Triad"
language = "{{language}}"
{TRIAD.replace("{", "{{").replace("}", "}}")}positions = 12
accelerations = [0, 1, 2, 3]
[hand]
ruler = "0.5 mm"
"""
PLACES = (0, 1, 2, 3)
"""The positions in which it can be laid, but for one where it hardly can."""


def meeting(p: complex, u: complex, q: complex, v: complex) -> complex:
    """Return where two lines meet, each a point and a direction."""
    return p + u * ((q - p).conjugate() * v).imag / (u.conjugate() * v).imag


def arcs(p: complex, r: float, q: complex, s: float, side: float) -> complex | None:
    """Return where two arcs meet, to the left (1) or right (−1) of p → q; None if they do not."""
    off = abs(q - p)
    along = (r * r - s * s + off * off) / (2 * off)
    if r < abs(along):
        return None
    return p + (q - p) / off * complex(along, side * math.sqrt(r * r - along * along))


def laid(angle: float, size: dict[str, float]) -> list[Spots]:
    """Return all places of the plate at an angle of the crank, m."""
    a = size["OA"] * cmath.exp(1j * angle)

    def tried(beta: float, side: float) -> tuple[Spots, float] | None:
        b = a + size["AB"] * cmath.exp(1j * beta)
        c = arcs(b, size["BC"], FRAME["D"], size["DC"], side)
        if c is None:
            return None
        f = b + (c - b) / abs(c - b) * PIN
        return {**FRAME, "A": a, "B": b, "C": c, "F": f}, abs(f - FRAME["E"]) - size["EF"]

    found = []
    for side in (1.0, -1.0):
        row = [2 * math.pi * k / 720 for k in range(721)]
        for low, high in pairwise(row):
            ends = tried(low, side), tried(high, side)
            if ends[0] is None or ends[1] is None or ends[0][1] * ends[1][1] > 0:
                continue
            below = ends[0][1]
            for _ in range(60):
                middle = (low + high) / 2
                at = tried(middle, side)
                if at is None:
                    break
                low, high = (middle, high) if at[1] * below > 0 else (low, middle)
            last = tried((low + high) / 2, side)
            if last is not None and abs(last[1]) < 1e-9:
                found.append(last[0])
    return found


def turned(at: Spots) -> float:
    """Return how BC stands, rad."""
    return cmath.phase(at["C"] - at["B"])


def rows_of_places(size: dict[str, float]) -> dict[int, Spots]:
    """Return the place in each position, followed from one to the next by small steps."""
    found, last = {}, BEGUN
    for k in range(10 * PLACES[-1] + 1):
        every = laid(math.radians(3.0 * k), size)
        best = min(every, key=lambda at: abs(cmath.exp(1j * (turned(at) - last)) - 1))
        last = turned(best)
        if k % 10 == 0:
            found[k // 10] = best
    return found


class Student:
    """Who draws the triad in his own scale factors; what he mistakes is set from outside."""

    def __init__(
        self,
        seed: int,
        mu: tuple[float, float, float] = (0.002, 0.01, 0.15),
        pair: tuple[int, int] = (2, 4),
    ) -> None:
        """``pair``: the legs in whose crossing he takes Assur's point."""
        self.chance, self.mu, self.pair = random.Random(seed), mu, pair
        self.slip, self.ruler = 0.15, 0.5
        self.size = dict(LENGTHS)
        self.omega = OMEGA
        self.places: Callable[[int, Spots], Spots] = lambda place, at: at
        self.ways: Callable[[dict[str, complex]], object] = lambda ways: None
        self.similar: Callable[[complex], complex] = lambda share: share
        self.normal: Callable[[dict[str, float]], object] = lambda mm: None
        self.amiss: Callable[[Read, int], object] = lambda mm, place: None
        self.rates: Callable[[dict[str, float], int], object] = lambda of, place: None
        self.crank_way = 1j
        self.out = -1.0
        self.special = True
        """Whether he hands in what is drawn of Assur's point."""

    def pricked(self, spot: complex) -> complex:
        return spot + complex(self.chance.gauss(0, self.slip), self.chance.gauss(0, self.slip))

    def read(self, length: float) -> float:
        return round(round(length / self.ruler) * self.ruler, 3)

    @property
    def kept_back(self) -> set[str]:
        """The names that the scene, which takes another of Assur's points, does not have."""
        return {f"n3{LEGS[k][1].lower()}" for k in self.pair} - {"n3b", "n3c"}

    @property
    def third(self) -> int:
        return next(k for k in LEGS if k not in self.pair)

    def drawn(self, place: int, at: Spots) -> Spots:
        """Return the positions in mm as pricked, W3 among them."""
        on = {k: self.pricked(z / self.mu[0]) if z else 0j for k, z in at.items()}
        (p, b), (q, c) = (LEGS[k] for k in self.pair)
        on["W3"] = meeting(on[p], on[b] - on[p], on[q], on[c] - on[q])
        return on

    def velocities(self, on: Spots) -> Spots:
        """Return the plan of velocities, from its pole 0, mm."""
        pa = self.omega * LENGTHS["OA"] / self.mu[1]
        a = self.pricked(on["A"] / abs(on["A"]) * self.crank_way * pa)
        bases = {"A": a, "D": 0j, "E": 0j}
        ways = {f"leg{k}": 1j * (on[pin] - on[pivot]) for k, (pivot, pin) in LEGS.items()}
        pivot, pin = LEGS[self.third]
        ways["plate"] = 1j * (on[pin] - on["W3"])
        self.ways(ways)
        first, second = self.pair
        w = meeting(
            bases[LEGS[first][0]], ways[f"leg{first}"], bases[LEGS[second][0]], ways[f"leg{second}"]
        )
        w = self.pricked(w)
        third = self.pricked(meeting(w, ways["plate"], bases[pivot], ways[f"leg{self.third}"]))
        images = {"a": a, "w3": w, pin.lower(): third}
        for other in "BCF":
            if other != pin:
                share = self.similar((on[other] - on["W3"]) / (on[pin] - on["W3"]))
                images[other.lower()] = self.pricked(w + (third - w) * share)
        return images

    def rates_of(self, on: Spots, v: Spots, place: int) -> dict[str, float]:
        """Return the angular velocities, 1/s, of lengths that are read."""
        of = {"omega1": self.omega}
        base = {"A": v["a"], "D": 0j, "E": 0j}
        mu_l, mu = self.mu[:2]
        for k, (pivot, pin) in LEGS.items():
            moved, arm = v[pin.lower()] - base[pivot], on[pin] - on[pivot]
            sign = math.copysign(1.0, (arm.conjugate() * moved).imag)
            of[f"omega{k}"] = sign * self.read(abs(moved)) * mu / self.size[pivot + pin]
        pin = LEGS[self.third][1]
        moved, arm = v[pin.lower()] - v["w3"], on[pin] - on["W3"]
        sign = math.copysign(1.0, (arm.conjugate() * moved).imag)
        of["omega3"] = sign * self.read(abs(moved)) * mu / (abs(arm) * mu_l)
        self.rates(of, place)
        return of

    def accelerations(
        self, on: Spots, v: Spots, of: dict[str, float]
    ) -> tuple[Spots, dict[str, float]]:
        """Return the plan of accelerations, from its pole 0, mm, and the angular accelerations, 1/s²."""
        mu_l, _, mu = self.mu
        scale = mu_l / mu
        a = self.pricked(self.out * on["A"] / abs(on["A"]) * self.omega**2 * LENGTHS["OA"] / mu)
        base = {"A": a, "D": 0j, "E": 0j}
        mm = {
            f"n{k}": of[f"omega{k}"] ** 2 * abs(on[pin] - on[pivot]) * scale
            for k, (pivot, pin) in LEGS.items()
        }
        for k in self.pair:
            pin = LEGS[k][1]
            mm[f"n3{pin.lower()}"] = of["omega3"] ** 2 * abs(on[pin] - on["W3"]) * scale
        pin = LEGS[self.third][1]
        mm["n3"] = of["omega3"] ** 2 * abs(on[pin] - on["W3"]) * scale
        self.normal(mm)
        normals, ends = {}, {}
        for k, (outer, inner) in LEGS.items():
            arm = on[inner] - on[outer]
            normals[f"n{k}"] = self.pricked(base[outer] - arm / abs(arm) * mm[f"n{k}"])
        for k in self.pair:
            inner = LEGS[k][1]
            arm = on[inner] - on["W3"]
            name = f"n3{inner.lower()}"
            ends[k] = normals[name] = self.pricked(normals[f"n{k}"] + arm / abs(arm) * mm[name])
        first, second = self.pair
        ways = {k: 1j * (on[i] - on[o]) for k, (o, i) in LEGS.items()}
        w = self.pricked(meeting(ends[first], ways[first], ends[second], ways[second]))
        arm = on[pin] - on["W3"]
        normals["n3"] = self.pricked(w - arm / abs(arm) * mm["n3"])
        third = self.pricked(
            meeting(normals["n3"], 1j * arm, normals[f"n{self.third}"], ways[self.third])
        )
        images = {"a": a, "w3": w, pin.lower(): third}
        for other in "BCF":
            if other != pin:
                share = (on[other] - on["W3"]) / arm
                images[other.lower()] = self.pricked(w + (third - w) * share)
        eps = {}
        for k, (outer, inner) in LEGS.items():
            moved, along = images[inner.lower()] - normals[f"n{k}"], on[inner] - on[outer]
            sign = math.copysign(1.0, (along.conjugate() * moved).imag)
            eps[f"epsilon{k}"] = sign * self.read(abs(moved)) * mu / self.size[outer + inner]
        moved = third - normals["n3"]
        sign = math.copysign(1.0, (arm.conjugate() * moved).imag)
        eps["epsilon3"] = sign * self.read(abs(moved)) * mu / (abs(arm) * mu_l)
        return images | normals, eps

    def csv(self, kinds: str = "points lengths figures") -> str:
        mu_l, mu_v, mu_a = self.mu
        rows = [
            HEAD,
            f"positions,,μ_l,,{mu_l},m/mm,,",
            f"velocities,,μ_v,,{mu_v},(m/s)/mm,,",
            f"accelerations,,μ_a,,{mu_a},(m/s²)/mm,,",
        ]
        for place, spots in rows_of_places(self.size).items():
            on = self.drawn(place, self.places(place, spots))
            velocities = self.velocities(on)
            of = self.rates_of(on, velocities, place)
            gains, eps = self.accelerations(on, velocities, of)
            if "points" in kinds:
                every = (
                    ("positions", {k: on[k] for k in "ABCF"}),
                    ("velocities", velocities),
                    ("accelerations", gains),
                )
                for plan, images in every:
                    for name, spot in images.items():
                        if name in self.kept_back or (not self.special and "3" in name):
                            continue
                        x, y = self.read(spot.real), self.read(spot.imag)
                        rows.append(f"{plan},{place},{name},,,,{x},{y}")
            if "lengths" in kinds:
                mm = self._lengths(velocities)
                self.amiss(mm, place)
                rows += [f"velocities,{place},{k},{x},,,," for k, x in mm.items()]
                mm = {f"π{k}": self.read(abs(gains[k])) for k in "abcf"}
                rows += [f"accelerations,{place},{k},{x},,,," for k, x in mm.items()]
            if "figures" in kinds:
                rows += [f"velocities,{place},{k},,{x:.4g},1/s,," for k, x in of.items()]
                rows += [f"accelerations,{place},{k},,{x:.4g},1/s²,," for k, x in eps.items()]
        return "\n".join(rows) + "\n"

    def _lengths(self, v: Spots) -> Read:
        ends = {
            "pa": ("", "a"),
            "ab": ("a", "b"),
            "pb": ("", "b"),
            "pc": ("", "c"),
            "pf": ("", "f"),
        }
        if self.special and self.pair == (2, 4):
            pin = LEGS[self.third][1].lower()
            ends[f"w3{pin}"] = ("w3", pin)
        return {k: self.read(abs(v.get(p, 0j) - v[q])) for k, (p, q) in ends.items()}
