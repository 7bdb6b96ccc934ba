"""Who draws two plates that links join (class IV) by hand, in mm on his sheet; he knows nothing of the package.

The place is found by a locus: the first plate is turned until the second link fits. Velocities he draws by
Assur's point of both plates, accelerations by calculation of what closes both loops, as by any way of a book.
"""

from __future__ import annotations

import cmath
import math
import random
from collections.abc import Callable
from itertools import pairwise

import numpy as np

from support.plate_by_hand import HEAD, Read, Spots, arcs, meeting

FRAME = {"O": 0j, "D": 0.26 - 0.02j}
CRANK, THIRD, FOURTH = 0.05, 0.22, 0.145
PLATES = {2: {"B": 0.145 + 0j, "E": 0.06 - 0.15j}, 5: {"C": 0.11 + 0j, "F": 0.155 + 0.085j}}
"""Points of the plates from their pivots A and D, along their lines AB and DC and to the left, m."""
LINKS = {3: ("B", "C"), 4: ("E", "F")}
BEGUN, OMEGA = math.radians(73.0), 4 * math.pi
PLACES = (3, 9, 10)
"""The positions that he draws, of twelve."""


def laid(angle: float, third: float, fourth: float) -> list[Spots]:
    """Return all places of both plates at an angle of the crank, m."""
    a, d = CRANK * cmath.exp(1j * angle), FRAME["D"]

    def tried(turned: float, side: float) -> tuple[Spots, float] | None:
        b, e = (a + arm * cmath.exp(1j * turned) for arm in PLATES[2].values())
        c = arcs(b, third, d, 0.11, side)
        if c is None:
            return None
        f = d + (c - d) / abs(c - d) * PLATES[5]["F"]
        return {**FRAME, "A": a, "B": b, "C": c, "E": e, "F": f}, abs(f - e) - fourth

    found = []
    for side in (1.0, -1.0):
        for low, high in pairwise(2 * math.pi * k / 720 for k in range(721)):
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


def row_of_places(third: float, fourth: float) -> dict[int, Spots]:
    """Return the place in each position, followed from the first by small steps."""
    found, last = {}, BEGUN
    for k in range(10 * PLACES[-1] + 1):
        every = laid(math.radians(3.0 * k), third, fourth)
        turned = [cmath.phase(at["B"] - at["A"]) for at in every]
        near = min(range(len(every)), key=lambda n: abs(cmath.exp(1j * (turned[n] - last)) - 1))
        last = turned[near]
        if k % 10 == 0:
            found[k // 10] = every[near]
    return {k: found[k] for k in PLACES}


class Student:
    """Who draws it in his own scale factors; what he mistakes is set from outside."""

    def __init__(self, seed: int, mu: tuple[float, float, float] = (0.002, 0.0125, 0.1)) -> None:
        self.chance, self.mu = random.Random(seed), mu
        self.slip, self.ruler = 0.15, 0.5
        self.third, self.fourth = THIRD, FOURTH
        self.crossing = ("B", "C"), ("E", "F")
        self.way_of_plate = 1j
        self.similar: Callable[[complex], complex] = lambda share: share
        self.rates: Callable[[Read], object] = lambda of: None

    def pricked(self, spot: complex) -> complex:
        return spot + complex(self.chance.gauss(0, self.slip), self.chance.gauss(0, self.slip))

    def read(self, length: float) -> float:
        return round(round(length / self.ruler) * self.ruler, 3)

    def velocities(self, on: Spots) -> Spots:
        """Return the plan of velocities, from its pole 0, mm."""
        a = self.pricked(1j * on["A"] / abs(on["A"]) * OMEGA * CRANK / self.mu[1])
        (p, q), (r, s) = self.crossing
        w = on["W"] = meeting(on[p], on[q] - on[p], on[r], on[s] - on[r])
        image = self.pricked(meeting(a, self.way_of_plate * (w - on["A"]), 0j, 1j * (w - on["D"])))
        images = {"a": a, "w": image}
        for letters, pivot, start in (("BE", "A", a), ("CF", "D", 0j)):
            for letter in letters:
                share = self.similar((on[letter] - on[pivot]) / (w - on[pivot]))
                images[letter.lower()] = self.pricked(start + (image - start) * share)
        return images

    def rates_of(self, on: Spots, v: Spots) -> Read:
        """Return the angular velocities, 1/s, of lengths that are read."""
        mu_l, mu = self.mu[:2]
        ends = {
            2: (v["a"], v["w"], on["W"] - on["A"], abs(on["W"] - on["A"]) * mu_l),
            5: (0j, v["w"], on["W"] - on["D"], abs(on["W"] - on["D"]) * mu_l),
            3: (v["b"], v["c"], on["C"] - on["B"], self.third),
            4: (v["e"], v["f"], on["F"] - on["E"], self.fourth),
        }
        of = {}
        for k, (start, end, arm, size) in ends.items():
            sign = math.copysign(1.0, (arm.conjugate() * (end - start)).imag)
            of[f"omega{k}"] = sign * self.read(abs(end - start)) * mu / size
        self.rates(of)
        return of

    def accelerations(self, on: Spots, of: Read) -> Spots:
        """Return the plan of accelerations, from its pole 0, mm: both loops close."""
        mu_l, _, mu = self.mu
        a = -(OMEGA**2) * on["A"] * mu_l
        arm = {k: on[k] - on["A" if k in "BE" else "D"] for k in "BCEF"}
        rows, right = [], []
        for k, (p, q) in LINKS.items():
            rod = on[q] - on[p]
            turned = {2: 1j * arm[p], k: 1j * rod, 5: -1j * arm[q]}
            due = (
                of["omega5"] ** 2 * -arm[q]
                + of["omega2"] ** 2 * arm[p]
                + of[f"omega{k}"] ** 2 * rod
            )
            due -= a / mu_l
            for part in ("real", "imag"):
                rows.append([getattr(turned.get(n, 0j), part) for n in (2, 3, 4, 5)])
                right.append(getattr(due, part))
        two, _, _, five = np.linalg.solve(np.array(rows), np.array(right))
        images = {"a": a / mu}
        for letter, one in arm.items():
            number, gain = (2, two) if letter in "BE" else (5, five)
            own = complex(-(of[f"omega{number}"] ** 2), gain) * one * mu_l
            images[letter.lower()] = (own + (a if number == 2 else 0j)) / mu
        return {k: self.pricked(z) for k, z in images.items()}

    def csv(self) -> str:
        mu_l, mu_v, mu_a = self.mu
        rows = [
            HEAD,
            f"positions,,μ_l,,{mu_l},m/mm,,",
            f"velocities,,μ_v,,{mu_v},(m/s)/mm,,",
            f"accelerations,,μ_a,,{mu_a},(m/s²)/mm,,",
        ]
        for place, spots in row_of_places(self.third, self.fourth).items():
            on = {k: self.pricked(z / mu_l) if z else 0j for k, z in spots.items()}
            v = self.velocities(on)
            of = self.rates_of(on, v)
            gains = self.accelerations(on, of)
            every = (
                ("positions", {k: on[k] for k in "ABCEF"}),
                ("velocities", {k: v[k] for k in "abcef"}),
                ("accelerations", gains),
            )
            for plan, images in every:
                for name, spot in images.items():
                    rows.append(
                        f"{plan},{place},{name},,,,{self.read(spot.real)},{self.read(spot.imag)}"
                    )
            read = {
                "aw25": v["w"] - v["a"],
                "pw25": v["w"],
                "bc": v["c"] - v["b"],
                "ef": v["f"] - v["e"],
            }
            read |= {f"p{k}": v[k] for k in "abcef"}
            rows += [f"velocities,{place},{k},{self.read(abs(z))},,,," for k, z in read.items()]
            rows += [f"velocities,{place},{k},,{x:.4g},1/s,," for k, x in of.items()]
            rows += [f"accelerations,{place},π{k},{self.read(abs(gains[k]))},,,," for k in "abcef"]
        return "\n".join(rows) + "\n"
