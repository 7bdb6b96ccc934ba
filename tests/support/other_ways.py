"""The other hand's mechanisms, with points that it finds by other constructions than the package's.

A point of a link, and its image on a plan, can be found in several ways that are all right: by two arcs, by an
angle and a length, by the ratios of the lengths, by the angles of the triangle, by two perpendiculars. Each
slips in its own way: a ray by N(0, 0.6°) or so, a length that is measured first by the slip of the ruler, an
opening of the compass by 0.15 mm.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from support.another_hand import MACHINES, POSITIONS, Pencil, Sheet, met

P = "positions"
COMPASS = 0.15
"""Standard deviation of an opening, mm."""


class Compass(Pencil):
    """Who draws with a compass too: ``longer``: an opening of the ratios that is so many mm too large."""

    longer = 0.0

    def opened(self, length: float) -> float:
        """Return an opening of the compass that should be a length."""
        return length + COMPASS * bool(self.slip) * float(self.rng.standard_normal())


Way = Callable[[Compass, complex, complex, complex, complex, complex], complex]
"""Finds the image of a third point: of the images of the first two, and of the three points themselves."""


def rotated(pen: Compass, name: str, along: complex, by: complex) -> complex:
    """Return the direction that is turned from another as one vector is: by protractor or square."""
    return pen.ray(name, along / abs(along) * by / abs(by))


def crossed(a: complex, r: float, b: complex, s: float, left: bool) -> complex:
    """Return where two arcs cross, to the left of the way between their centres or to its right."""
    base = b - a
    foot = (r * r - s * s + abs(base) ** 2) / (2.0 * abs(base))
    high = np.sqrt(max(r * r - foot * foot, 0.0))
    return complex(a + base / abs(base) * (foot + (1j if left else -1j) * high))


def by_length_and_angle(
    pen: Compass, a: complex, b: complex, A: complex, B: complex, E: complex
) -> complex:
    way = (E - A) / (B - A)
    long = pen.read(b - a) * abs(way)
    return a + pen.opened(long) * rotated(pen, "ae", b - a, way)


def by_ratios(pen: Compass, a: complex, b: complex, A: complex, B: complex, E: complex) -> complex:
    base = pen.read(b - a)
    r, s = (pen.opened(base * abs(E - Q) / abs(B - A)) for Q in (A, B))
    return crossed(a, r + pen.longer, b, s, ((E - A) / (B - A)).imag > 0.0)


def by_angles(pen: Compass, a: complex, b: complex, A: complex, B: complex, E: complex) -> complex:
    u = rotated(pen, "ae", b - a, (E - A) / (B - A))
    v = rotated(pen, "be", b - a, (E - B) / (B - A))
    return met(a, u, b, v)


def by_sides(pen: Compass, a: complex, b: complex, A: complex, B: complex, E: complex) -> complex:
    """Square (or parallel) to the link's own sides: its triangle is turned by the angle of ab from AB."""
    turn = (b - a) / (B - A)
    return met(a, pen.ray("ae", turn * (E - A)), b, pen.ray("be", turn * (E - B)))


def by_dimensions(
    pen: Compass, a: complex, b: complex, A: complex, B: complex, E: complex
) -> complex:
    """Of the link itself: an angle by the protractor, a length that is known."""
    way = (E - A) / (B - A)
    return a + pen.opened(abs(b - a) * abs(way)) * rotated(pen, "AE", b - a, way)


def by_arcs(pen: Compass, a: complex, b: complex, A: complex, B: complex, E: complex) -> complex:
    scale = abs(b - a) / abs(B - A)
    r, s = (pen.opened(scale * abs(E - Q)) for Q in (A, B))
    return crossed(a, r, b, s, ((E - A) / (B - A)).imag > 0.0)


class Third(NamedTuple):
    """A link's third point: its letter, those of the two others; "" for the pole or a pivot at ``pivot``."""

    letter: str
    base: tuple[str, str]
    pivot: complex = 0j


THIRDS = {
    "sc": Third("S2", ("A", "B")),
    "fb": Third("E", ("A", "B")),
    "rpr": Third("C", ("", "A"), -100j),
}
LINKS: dict[str, Way] = {"arcs": by_arcs, "angle and length": by_dimensions}
"""How the point of the link itself is found."""
IMAGES: dict[str, Way] = {
    "ratios": by_ratios,
    "angles": by_angles,
    "sides": by_sides,
    "length and angle": by_length_and_angle,
}
"""How its image is found on a plan."""


def redrawn(name: str, pen: Compass, sheet: Sheet, link: str, image: str) -> Sheet:
    """Return a sheet whose third points were found otherwise; what is found from them is not drawn anew."""
    third = THIRDS[name]
    points, lengths = dict(sheet.points), dict(sheet.lengths)
    A, B = (points[P, one] if one else third.pivot for one in third.base)
    exact = points[P, third.letter]
    if link and name == "fb":
        points[P, third.letter] = LINKS[link](pen, A, B, A, B, exact)
    E = points[P, third.letter]
    for plan in ("velocities", "accelerations"):
        small = third.letter.lower()
        if (plan, small) not in points:
            continue
        far = "a3" if name == "rpr" else "b"
        near = points[plan, "a"] if third.base[0] else 0j
        found = IMAGES[image](pen, near, points[plan, far], A, B, E)
        points[plan, small] = found
        pole = "p" if plan == "velocities" else "π"
        lengths[plan, pole + small] = pen.read(found)
    return Sheet(lengths, sheet.rates, points)


def otherwise(
    name: str, pen: Compass, link: str, image: str, *, only: int | None = None
) -> dict[int, Sheet]:
    """Draw a mechanism in all positions, its third points by other constructions."""
    machine, turned, longer, found = MACHINES[name], pen.turned, pen.longer, {}
    for k in range(POSITIONS):
        here = only in (None, k)
        pen.turned, pen.longer = (turned, longer) if here else ((), 0.0)
        drawn = machine.draw(pen, k * np.pi / 4.0, k in machine.accelerated, 1)
        found[k] = redrawn(name, pen, drawn, link, image)
    return found
