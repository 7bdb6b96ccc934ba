"""Who draws instantaneous centres by hand: by loops, in mm on his sheet; he knows nothing of the package.

He goes on with what he has, so that of a mistake only the rows are his in which it was made; the others follow.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Mapping

Spots = dict[str, complex]
Way = tuple[str, str, str, str]
HEAD = "plan,position,segment,mm,value,unit,x,y"
FAR = "far"
"""The centre of the slider on its guide, at infinity square to it."""
NAMES = {"A": "12", "B": "23", "C": "24", "D": "30", "E": "45"}
SIX_BAR: Mapping[str, Way] = {
    "20": ("12", "10", "23", "30"),
    "40": ("20", "24", "45", FAR),
    "34": ("23", "24", "30", "40"),
    "13": ("12", "23", "10", "30"),
    "14": ("12", "24", "10", "40"),
    "15": ("14", "45", "10", FAR),
    "35": ("13", "15", "30", FAR),
    "25": ("12", "15", "20", FAR),
}
"""Each centre by two lines, through two centres each, in the order in which they are drawn."""
CRANK: Mapping[str, Way] = {"20": ("12", "10", "23", FAR), "13": ("12", "23", "10", FAR)}
SIX_LENGTHS = {
    "AO": ("12", "10"), "AP20": ("12", "20"), "P13O": ("13", "10"), "P13D": ("13", "30"),
    "P14O": ("14", "10"), "P14P40": ("14", "40"), "OP15": ("10", "15"), "DB": ("30", "23"),
    "P40C": ("40", "24"),
}  # fmt: skip
CRANK_LENGTHS = {"AO": ("12", "10"), "AP20": ("12", "20"), "OP13": ("10", "13")}
RATIOS = {
    "u21": ("AO", "AP20", "12", "10", "20"),
    "u31": ("P13O", "P13D", "13", "10", "30"),
    "u41": ("P14O", "P14P40", "14", "10", "40"),
}
"""The lengths of each ratio, and the centres that tell its sign: the common one, outside of both or between."""


def meeting(first: tuple[complex, complex], second: tuple[complex, complex]) -> complex:
    """Return where two lines meet, each a point and a direction."""
    (p, u), (q, v) = first, second
    return p + u * ((q - p).conjugate() * v).imag / (u.conjugate() * v).imag


def arcs(p: complex, r: float, q: complex, s: float) -> complex:
    """Return where two arcs meet, to the left of p → q."""
    off = abs(q - p)
    along = (r * r - s * s + off * off) / (2 * off)
    return p + (q - p) / off * complex(along, math.sqrt(r * r - along * along))


def six_bar(angle: float) -> Spots:
    """The pairs of the six-bar of the sheets, m."""
    a, d = 0.1 * complex(math.cos(angle), math.sin(angle)), 0.3 + 0j
    b = arcs(a, 0.28, d, 0.2)
    c = a + (b - a) / 0.28 * complex(0.15, 0.09)
    e = complex(c.real + math.sqrt(0.42**2 - (c.imag + 0.18) ** 2), -0.18)
    return {"10": 0j, "12": a, "30": d, "23": b, "24": c, "45": e}


def slider_crank(angle: float) -> Spots:
    """The pairs of a slider-crank whose guide is 30 mm below the crank's pivot, m."""
    a = 0.09 * complex(math.cos(angle), math.sin(angle))
    b = complex(a.real + math.sqrt(0.26**2 - (a.imag + 0.03) ** 2), -0.03)
    return {"10": 0j, "12": a, "23": b}


class Student:
    """Who draws the centres of a mechanism in his μ; what he mistakes is set from outside."""

    def __init__(self, seed: int, mu: float = 0.0025, *, six: bool = True) -> None:
        self.chance, self.mu, self.six = random.Random(seed), mu, six
        self.places = (3, 9) if six else (2, 6)
        self.omega = 10.0 if six else 20.0
        self.ways = dict(SIX_BAR if six else CRANK)
        self.lengths = dict(SIX_LENGTHS if six else CRANK_LENGTHS)
        self.square = 1j
        """The direction of the lines to the centre at infinity."""
        self.turned: Mapping[int, int] = {}
        """The positions in which he draws instead of those that are due."""
        self.amiss: Callable[[dict[str, float], int], object] = lambda mm, place: None
        self.found: Callable[[dict[str, float], dict[str, float]], object] = lambda of, mm: None
        self.ratios: Callable[[dict[str, float]], object] = lambda of: None
        self.rates: Callable[[dict[str, float]], object] = lambda of: None
        self.slip, self.ruler = 0.15, 0.1

    def pricked(self, spot: complex) -> complex:
        return spot + complex(self.chance.gauss(0, self.slip), self.chance.gauss(0, self.slip))

    def line(self, at: Spots, first: str, second: str) -> tuple[complex, complex]:
        if FAR in (first, second):
            return at[first if second == FAR else second], self.square
        return at[first], at[second] - at[first]

    def centres(self, place: int) -> Spots:
        angle = math.radians(30.0 * (self.turned.get(place, place) - 1))
        pairs = (six_bar if self.six else slider_crank)(angle)
        at = {name: self.pricked(spot / self.mu) if spot else spot for name, spot in pairs.items()}
        for name, (a, b, c, d) in self.ways.items():
            at[name] = self.pricked(meeting(self.line(at, a, b), self.line(at, c, d)))
        return at

    def read(self, length: float) -> float:
        return round(round(length / self.ruler) * self.ruler, 3)

    def figures(self, at: Spots, mm: dict[str, float]) -> dict[str, float]:
        """Return ratios, ω, 1/s, and velocities, m/s, as he calculates them of his lengths."""
        of: dict[str, float] = {}
        for name, (above, below, common, one, other) in RATIOS.items():
            if above in mm and below in mm:
                aside = ((at[one] - at[common]).conjugate() * (at[other] - at[common])).real
                of[name] = math.copysign(mm[above] / mm[below], aside)
        self.ratios(of)
        of |= {f"omega{name[1]}": u * self.omega for name, u in [*of.items()]}
        self.rates(of)
        if self.six:
            of["vE"] = self.omega * mm["OP15"] * self.mu
            of["vB"] = abs(of["omega3"]) * mm["DB"] * self.mu
            of["vC"] = abs(of["omega4"]) * mm["P40C"] * self.mu
        else:
            of["vB"] = self.omega * mm["OP13"] * self.mu
        self.found(of, mm)
        return of

    def csv(self, kinds: str = "points lengths figures") -> str:
        rows = [HEAD, f"centres,,μ_lP,,{self.mu},m/mm,,"]
        for place in self.places:
            at = self.centres(place)
            mm = {k: self.read(abs(at[a] - at[b])) for k, (a, b) in self.lengths.items()}
            self.amiss(mm, place)
            if "points" in kinds:
                spots = {name: at[pair] for name, pair in NAMES.items() if pair in at}
                spots |= {f"P{name}": at[name] for name in self.ways}
                for name, spot in spots.items():
                    x, y = self.read(spot.real), self.read(spot.imag)
                    rows.append(f"centres,{place},{name},,,,{x},{y}")
            if "lengths" in kinds:
                rows += [f"centres,{place},{name},{length},,,," for name, length in mm.items()]
            if "figures" in kinds:
                for name, value in self.figures(at, mm).items():
                    unit = {"u": "1", "o": "1/s", "v": "m/s"}[name[0]]
                    rows.append(f"centres,{place},{name},,{value:.4g},{unit},,")
        return "\n".join(rows) + "\n"
