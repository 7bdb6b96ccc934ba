"""A hand that is not the package's: four mechanisms drawn by plane geometry, with numpy and nothing else.

It draws as a student does: every ray is off by N(0, 0.6°), every length that is measured by N(0, 0.8 mm) and
rounded to the ruler; what is calculated follows from what was measured. It knows the mechanisms of
tests/cases/check by their dimensions in mm on the sheet, and their μ, not by their scenes.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

RULERS = (0.1, 0.5, 1.0)
MODES = ("mm", "quantities", "points", "both")
HEAD = "plan,position,segment,mm,value,unit,x,y"
UNITS = {"positions": "m", "velocities": "m/s", "accelerations": "m/s^2"}
POSITIONS = 8


class Pencil:
    """Who draws: ``swing`` in degrees, ``slip`` and ``pointing`` in mm; ``turned``: rays that slip by 5°."""

    def __init__(
        self,
        rng: np.random.Generator,
        ruler: float,
        *,
        swing: float = 0.6,
        slip: float = 0.8,
        pointing: float = 0.5,
        turned: tuple[str, ...] = (),
    ) -> None:
        self.rng, self.ruler = rng, ruler
        self.swing, self.slip, self.pointing, self.turned = swing, slip, pointing, turned
        self.long: dict[str, float] = {}

    def ray(self, name: str, along: complex) -> complex:
        """Return the direction in which a ray is drawn that should go along a vector."""
        off = self.swing * self.rng.standard_normal() + (5.0 if name in self.turned else 0.0)
        return complex(along / abs(along) * np.exp(1j * np.radians(off)))

    def drawn(self, name: str, way: complex) -> None:
        """Remember how far a ray reaches."""
        self.long[name] = abs(way)

    def read(self, way: complex) -> float:
        """Return a distance as it is read off the ruler."""
        return self.rounded(abs(abs(way) + self.slip * self.rng.standard_normal()))

    def spot(self, z: complex) -> tuple[float, float]:
        """Return the coordinates of a point as they are read."""
        x, y = self.pointing * self.rng.standard_normal(2)
        return self.rounded(z.real + x), self.rounded(z.imag + y)

    def rounded(self, length: float) -> float:
        if not self.ruler:
            return length
        return round(float(np.floor(length / self.ruler + 0.5)) * self.ruler, 6)


class Sheet(NamedTuple):
    """What is read of one position: lengths (mm) that were measured or calculated, rates, points."""

    lengths: dict[tuple[str, str], float]
    rates: dict[tuple[str, str], float]
    points: dict[tuple[str, str], complex]


class Machine(NamedTuple):
    """A mechanism: μ of its plans (SI per mm), where accelerations are drawn, how one position is drawn."""

    mu: dict[str, float]
    accelerated: tuple[int, ...]
    draw: Callable[[Pencil, float, bool, int], Sheet]


def met(p: complex, u: complex, q: complex, v: complex) -> complex:
    """Return where the line through p along u and the line through q along v meet."""
    way = np.linalg.solve([[u.real, -v.real], [u.imag, -v.imag]], [(q - p).real, (q - p).imag])
    return complex(p + way[0] * u)


def sense(way: complex, along: complex) -> float:
    return float(np.sign((way / along).real)) or 1.0


V, A, P = "velocities", "accelerations", "positions"


def slider_crank(pen: Pencil, phi: float, accelerated: bool, side: int) -> Sheet:
    mu_l, mu_v, mu_a, rod = 0.002, 0.025, 0.5, 175.0
    a_ = 50.0 * pen.ray("OA", np.exp(1j * phi))
    b_ = complex(a_.real + side * np.sqrt(rod**2 - a_.imag**2))
    along = (b_ - a_) / rod
    a = 80.0 * pen.ray("pa", 1j * a_)
    b = met(a, pen.ray("ab", 1j * along), 0j, pen.ray("pb", 1.0))
    pen.drawn("pa", a), pen.drawn("ab", b - a), pen.drawn("pb", b)
    s = a + 0.4 * (b - a)
    ab = pen.read(b - a)
    lengths = {(V, "pa"): 80.0, (V, "ab"): ab, (V, "pb"): pen.read(b), (V, "ps2"): pen.read(s)}
    rates = {(V, "omega2"): sense(b - a, 1j * along) * ab * mu_v / (rod * mu_l)}
    points = {(P, "A"): a_, (P, "B"): b_, (P, "S2"): a_ + 0.4 * (b_ - a_)}
    points |= {(V, "a"): a, (V, "b"): b, (V, "s2"): s}
    if accelerated:
        a = 80.0 * pen.ray("πa", -a_)
        n = (ab * mu_v) ** 2 / (rod * mu_l) / mu_a
        n2 = a + n * pen.ray("an2", -along)
        b = met(n2, pen.ray("n2b", 1j * along), 0j, pen.ray("πb", 1.0))
        pen.drawn("πa", a), pen.drawn("n2b", b - n2), pen.drawn("πb", b), pen.drawn("an2", n)
        s, t = a + 0.4 * (b - a), pen.read(b - n2)
        lengths |= {(A, "πa"): 80.0, (A, "an2"): n, (A, "n2b"): t}
        lengths |= {(A, "πb"): pen.read(b), (A, "πs2"): pen.read(s)}
        rates[A, "epsilon2"] = sense(b - n2, 1j * along) * t * mu_a / (rod * mu_l)
        points |= {(A, "a"): a, (A, "n2"): n2, (A, "b"): b, (A, "s2"): s}
    return Sheet(lengths, rates, points)


def four_bar(pen: Pencil, phi: float, accelerated: bool, side: int) -> Sheet:
    mu_l, mu_v, mu_a, rod, rocker, c_ = 0.002, 0.015, 0.25, 130.0, 90.0, 150.0 + 0j
    a_ = 40.0 * pen.ray("OA", np.exp(1j * phi))
    base = c_ - a_
    foot = (rod**2 - rocker**2 + abs(base) ** 2) / (2.0 * abs(base))
    b_ = a_ + base / abs(base) * (foot + side * 1j * np.sqrt(rod**2 - foot**2))
    u, w = (b_ - a_) / rod, (b_ - c_) / rocker
    e_ = a_ + u * (75.0 + 50.0j)
    shape = (e_ - a_) / (b_ - a_)
    a = 80.0 * pen.ray("pa", 1j * a_)
    b = met(a, pen.ray("ab", 1j * u), 0j, pen.ray("pb", 1j * w))
    pen.drawn("pa", a), pen.drawn("ab", b - a), pen.drawn("pb", b)
    e = a + shape * (b - a)
    ab, pb = pen.read(b - a), pen.read(b)
    lengths = {(V, "pa"): 80.0, (V, "ab"): ab, (V, "pb"): pb, (V, "pe"): pen.read(e)}
    rates = {
        (V, "omega2"): sense(b - a, 1j * u) * ab * mu_v / (rod * mu_l),
        (V, "omega3"): sense(b, 1j * w) * pb * mu_v / (rocker * mu_l),
    }
    points = {(P, "A"): a_, (P, "B"): b_, (P, "E"): e_, (V, "a"): a, (V, "b"): b, (V, "e"): e}
    if accelerated:
        a = 72.0 * pen.ray("πa", -a_)
        n = (ab * mu_v) ** 2 / (rod * mu_l) / mu_a
        m = (pb * mu_v) ** 2 / (rocker * mu_l) / mu_a
        n2, n3 = a + n * pen.ray("an2", -u), m * pen.ray("πn3", -w)
        b = met(n2, pen.ray("n2b", 1j * u), n3, pen.ray("n3b", 1j * w))
        pen.drawn("πa", a), pen.drawn("n2b", b - n2), pen.drawn("n3b", b - n3)
        pen.drawn("an2", n), pen.drawn("πn3", m)
        e, t, s = a + shape * (b - a), pen.read(b - n2), pen.read(b - n3)
        lengths |= {(A, "πa"): 72.0, (A, "an2"): n, (A, "πn3"): m, (A, "n2b"): t, (A, "n3b"): s}
        lengths |= {(A, "πb"): pen.read(b), (A, "πe"): pen.read(e)}
        rates[A, "epsilon2"] = sense(b - n2, 1j * u) * t * mu_a / (rod * mu_l)
        rates[A, "epsilon3"] = sense(b - n3, 1j * w) * s * mu_a / (rocker * mu_l)
        points |= {(A, "a"): a, (A, "n2"): n2, (A, "n3"): n3, (A, "b"): b, (A, "e"): e}
    return Sheet(lengths, rates, points)


class Slotted(NamedTuple):
    """A crank that drives a rocker by a stone: mm on the sheet, μ; ``arm``: C on the rocker, from its pivot."""

    crank: float
    pivot: complex
    arm: float
    pa: float
    mu_l: float
    mu_v: float
    mu_a: float


def rocker(pen: Pencil, phi: float, accelerated: bool, side: int, by: Slotted) -> Sheet:
    a_ = by.crank * pen.ray("OA", np.exp(1j * phi))
    u = (a_ - by.pivot) / abs(a_ - by.pivot)
    c_ = by.pivot + side * by.arm * u
    shape = (c_ - by.pivot) / (a_ - by.pivot)
    long = pen.read(a_ - by.pivot)
    a = by.pa * pen.ray("pa", 1j * a_)
    a3 = met(a, pen.ray("aa3", u), 0j, pen.ray("pa3", 1j * u))
    pen.drawn("pa", a), pen.drawn("aa3", a3 - a), pen.drawn("pa3", a3)
    aa3, pa3, c = pen.read(a3 - a), pen.read(a3), a3 * shape
    omega = sense(a3, 1j * u) * pa3 * by.mu_v / (long * by.mu_l)
    lengths = {(P, "BA"): long, (V, "pa"): by.pa, (V, "aa3"): aa3, (V, "pa3"): pa3}
    lengths[V, "pc"] = pen.read(c)
    rates = {(V, "omega2"): omega, (V, "omega3"): omega}
    points = {(P, "A"): a_, (P, "C"): c_, (V, "a"): a, (V, "a3"): a3, (V, "c"): c}
    if accelerated:
        slides = sense(a3 - a, u)
        pi_a = by.pa * by.mu_v
        pi_a = pi_a**2 / (by.crank * by.mu_l) / by.mu_a
        a = pi_a * pen.ray("πa", -a_)
        k = 2.0 * abs(omega) * aa3 * by.mu_v / by.mu_a
        n = (pa3 * by.mu_v) ** 2 / (long * by.mu_l) / by.mu_a
        k2 = a + k * pen.ray("ak2", sense(omega, 1.0) * slides * 1j * u)
        n3 = n * pen.ray("πn3", -u)
        a3 = met(k2, pen.ray("k2a3", u), n3, pen.ray("n3a3", 1j * u))
        pen.drawn("πa", a), pen.drawn("k2a3", a3 - k2), pen.drawn("n3a3", a3 - n3)
        pen.drawn("ak2", k), pen.drawn("πn3", n)
        r, t, c = pen.read(a3 - k2), pen.read(a3 - n3), a3 * shape
        lengths |= {(A, "πa"): pi_a, (A, "ak2"): k, (A, "πn3"): n, (A, "k2a3"): r, (A, "n3a3"): t}
        lengths[A, "πc"] = pen.read(c)
        epsilon = sense(a3 - n3, 1j * u) * t * by.mu_a / (long * by.mu_l)
        rates |= {(A, "epsilon2"): epsilon, (A, "epsilon3"): epsilon}
        points |= {(A, "a"): a, (A, "k2"): k2, (A, "n3"): n3, (A, "a3"): a3, (A, "c"): c}
    return Sheet(lengths, rates, points)


def slotted_lever(pen: Pencil, phi: float, accelerated: bool, side: int) -> Sheet:
    by = Slotted(30.0, -100.0j, 162.5, 60.0, 0.004, 0.02, 0.2)
    return rocker(pen, phi, accelerated, side, by)


def six_bar(pen: Pencil, phi: float, accelerated: bool, side: int) -> Sheet:
    by, rod, low = Slotted(27.5, -112.5j, 50.0, 82.5, 0.004, 0.04, 1.0), 55.0, -170.0
    sheet = rocker(pen, phi, accelerated, -1, by)
    c_, c = sheet.points[P, "C"], sheet.points[V, "c"]
    d_ = complex(c_.real + side * np.sqrt(rod**2 - (c_.imag - low) ** 2), low)
    u = (d_ - c_) / rod
    d = met(c, pen.ray("cd", 1j * u), 0j, pen.ray("pd", 1.0))
    pen.drawn("cd", d - c), pen.drawn("pd", d)
    cd = pen.read(d - c)
    sheet.lengths.update({(V, "cd"): cd, (V, "pd"): pen.read(d)})
    sheet.rates[V, "omega4"] = sense(d - c, 1j * u) * cd * by.mu_v / (rod * by.mu_l)
    sheet.points.update({(P, "D"): d_, (V, "d"): d})
    if accelerated:
        c = sheet.points[A, "c"]
        n = (cd * by.mu_v) ** 2 / (rod * by.mu_l) / by.mu_a
        n4 = c + n * pen.ray("cn4", -u)
        d = met(n4, pen.ray("n4d", 1j * u), 0j, pen.ray("πd", 1.0))
        pen.drawn("n4d", d - n4), pen.drawn("πd", d)
        t = pen.read(d - n4)
        sheet.lengths.update({(A, "cn4"): n, (A, "n4d"): t, (A, "πd"): pen.read(d)})
        sheet.rates[A, "epsilon4"] = sense(d - n4, 1j * u) * t * by.mu_a / (rod * by.mu_l)
        sheet.points.update({(A, "n4"): n4, (A, "d"): d})
    return sheet


MACHINES = {
    "sc": Machine({P: 0.002, V: 0.025, A: 0.5}, (1, 3, 5), slider_crank),
    "fb": Machine({P: 0.002, V: 0.015, A: 0.25}, (1, 3, 6), four_bar),
    "rpr": Machine({P: 0.004, V: 0.02, A: 0.2}, (1, 3, 6), slotted_lever),
    "six": Machine({P: 0.004, V: 0.04, A: 1.0}, (1, 3, 6), six_bar),
}
CALCULATED = frozenset({"pa", "πa", "an2", "πn3", "ak2", "cn4"})
Rows = dict[tuple[str, str, str], list[str]]
"""The cells mm, value, unit, x, y of a file of readings, by plan, position and segment."""


def sheets(name: str, pen: Pencil, *, side: int = 1, only: int | None = None) -> dict[int, Sheet]:
    """Draw a mechanism in all positions; ``only``: rays slip in this one alone."""
    machine, turned, found = MACHINES[name], pen.turned, {}
    for k in range(POSITIONS):
        pen.turned = turned if only in (None, k) else ()
        found[k] = machine.draw(pen, k * np.pi / 4.0, k in machine.accelerated, side)
    return found


def rows_of(
    name: str, pen: Pencil, drawn: dict[int, Sheet], mode: str, *, all_measured: bool = False
) -> Rows:
    """Return what is written down of a drawing: lengths in mm, as quantities or both, points as x and y.

    ``all_measured``: what was calculated and laid off is measured on the drawing, too.
    """
    rows: Rows = {}
    for k, sheet in drawn.items():
        for (plan, segment), length in sheet.lengths.items():
            mm = length
            if segment in CALCULATED:
                # a calculated length is written to a tenth
                mm = pen.read(complex(length)) if all_measured else round(length, 1)
            value = f"{mm * MACHINES[name].mu[plan]:.4g}" if mode in ("quantities", "both") else ""
            written = "" if mode == "quantities" else f"{mm:g}"
            rows[plan, str(k), segment] = [written, value, UNITS[plan] if value else "", "", ""]
        for (plan, rate), value in sheet.rates.items():
            unit = "1/s" if plan == V else "1/s^2"
            rows[plan, str(k), rate] = ["", f"{value:.4g}", unit, "", ""]
        if mode == "points":
            for (plan, letter), z in sheet.points.items():
                x, y = pen.spot(z)
                rows[plan, str(k), letter] = ["", "", "", f"{x:g}", f"{y:g}"]
    return rows


def csv_of(rows: Rows) -> str:
    """Return a file of readings."""
    return "\n".join([HEAD, *(",".join([*key, *cells]) for key, cells in rows.items())]) + "\n"


class Gross(NamedTuple):
    """A gross error planted in a drawing: what it is, where, and the readings."""

    kind: str
    position: int
    of: str
    rows: Rows


def gross(
    name: str,
    rng: np.random.Generator,
    ruler: float,
    mode: str,
    kind: str,
    *,
    pointing: float = 0.5,
) -> Gross:
    """Draw a mechanism with one gross error: "ray" (5°, 30 mm long at least), "length" (10 mm), "decimal"."""
    straight = Pencil(rng, 0.0, swing=0.0, slip=0.0)
    machine = MACHINES[name]
    if kind == "ray":
        long = []
        for k in range(POSITIONS):
            straight.long = {}
            machine.draw(straight, k * np.pi / 4.0, k in machine.accelerated, 1)
            long += [(k, ray) for ray, way in straight.long.items() if way >= 30.0]
        k, ray = long[rng.integers(len(long))]
        pen = Pencil(rng, ruler, pointing=pointing, turned=(ray,))
        return Gross(kind, k, ray, rows_of(name, pen, sheets(name, pen, only=k), mode))
    pen = Pencil(rng, ruler, pointing=pointing)
    rows = rows_of(name, pen, sheets(name, pen), mode)
    column = 1 if mode == "quantities" else 0
    least = 5.0
    chosen = [
        key
        for key, cells in rows.items()
        if cells[column] and key[2] not in CALCULATED and not key[2].startswith(("omega", "eps"))
        if float(cells[column]) / (machine.mu[key[0]] if column else 1.0) > least
    ]
    key = chosen[rng.integers(len(chosen))]
    was = float(rows[key][column])
    by = machine.mu[key[0]] if column else 1.0
    now = was * (10.0 if rng.random() < 0.5 else 0.1) if kind == "decimal" else was + 10.0 * by
    rows[key][column] = f"{now:.4g}"
    return Gross(kind, int(key[1]), key[2], rows)
