"""Random mechanisms with a plate on three legs, as scenes and as single bodies."""

from __future__ import annotations

import cmath
import math
from typing import NamedTuple

import numpy as np

from support.single_bodies import Bodies, Guide, Pin, Reals


class Machine(NamedTuple):
    """A random mechanism: its scene, its bodies, letters by body with their places in it, where it was laid."""

    text: str
    bodies: Bodies
    letters: dict[tuple[str, int], complex]
    phi: float
    links: tuple[int, ...]


class Assembly:
    """A mechanism put together on a plane: a crank OA at some angle, and what is joined to it link by link.

    ``world``: where letters stand; ``lines``: more lines of the table of a link; ``tables``: more tables of the
    scene; ``held``: pins that are there already, each with its body.
    """

    def __init__(self, seed: int) -> None:
        self.chance = np.random.default_rng(seed)
        self.phi = self.some(0, 2 * math.pi)
        crank = self.some(0.03, 0.08)
        self.world = {"O": 0j, "A": crank * cmath.exp(1j * self.phi)}
        self.bodies = Bodies(pins=[Pin(1, 0j, 0, 0j)], poses={1: (0j, self.phi)})
        self.frame: dict[str, complex] = {"O": 0j}
        self.letters: dict[tuple[str, int], complex] = {("A", 1): complex(crank)}
        self.lines: dict[int, list[str]] = {}
        self.held = [("A", 1)]
        self.rails: dict[int, list[str]] = {}
        self.slides: dict[int, list[str]] = {}
        self.tables: list[str] = []

    def some(self, low: float, high: float) -> float:
        return float(self.chance.uniform(low, high))

    def polar(self, low: float, high: float) -> complex:
        return self.some(low, high) * cmath.exp(2j * math.pi * self.some(0, 1))

    def link(self, at: complex, angle: float, points: str) -> int:
        """Put the next link on letters that stand already."""
        number = len(self.bodies.poses) + 1
        self.bodies.poses[number] = (at, angle)
        for letter in points:
            self.letters[letter, number] = (self.world[letter] - at) * cmath.exp(-1j * angle)
        return number

    def mark(self, letter: str, number: int, place: complex) -> None:
        """Mark a point of a link that is there."""
        at, angle = self.bodies.poses[number]
        self.world[letter] = place
        self.letters[letter, number] = (place - at) * cmath.exp(-1j * angle)

    def rod(self, first: str, second: str) -> int:
        at = self.world[first]
        return self.link(at, cmath.phase(self.world[second] - at), first + second)

    def fix(self, letter: str, place: complex) -> None:
        self.world[letter] = self.frame[letter] = place

    def pin(self, letter: str, first: int, second: int) -> None:
        """Join two links, or a link and the frame (0), where a letter stands."""
        own = [self.letters[letter, k] if k else self.world[letter] for k in (first, second)]
        self.bodies.pins.append(Pin(first, own[0], second, own[1]))

    def dyad(self, start: str, on: int, inner: str, outer: str, size: tuple[float, float]) -> int:
        """Hang two links on a letter of a body and on the frame; return the second."""
        self.world[inner] = self.world[start] + self.polar(*size)
        self.fix(outer, self.world[inner] + self.polar(0.1, 0.2))
        a, b = self.rod(start, inner), self.rod(inner, outer)
        self.pin(start, a, on)
        self.pin(inner, b, a)
        self.pin(outer, b, 0)
        chord, arm = (self.world[k] - self.world[start] for k in (outer, inner))
        side = "left" if (chord.conjugate() * arm).imag > 0 else "right"
        self.lines[a] = [f'side = "{side} of {start}{outer}"']
        return b

    def before(self) -> None:
        """Let a dyad stand on the crank: what comes next holds on to its pin too."""
        self.held.append(("G", self.dyad("A", 1, "G", "H", (0.15, 0.25))))

    def near(self, plate: int, angle: float) -> None:
        """Say that a plate whose line stands at an angle (rad) is near that place."""
        self.lines[plate] = [
            f'near = "{math.degrees(angle) % 360:.9f} deg"',
            f'near_at = "{math.degrees(self.phi):.12f} deg"',
        ]

    def machine(self, title: str) -> Machine:
        """Return it as a scene."""
        self.letters["O", 1] = 0j
        tables = [f'title = "{title}"\n[frame]\n' + "".join(_frame(self.frame))]
        for k in sorted(self.bodies.poses):
            points = ", ".join(
                f"{letter} = [{z.real!r}, {z.imag!r}]"
                for (letter, on), z in self.letters.items()
                if on == k
            )
            rails = [f"guides = {{ {', '.join(found)} }}" for found in [self.rails.get(k)] if found]
            slides = [f"slides = [{', '.join(found)}]" for found in [self.slides.get(k)] if found]
            more = "".join(f"{one}\n" for one in (*self.lines.get(k, []), *rails, *slides))
            tables.append(f"[[link]]\nnumber = {k}\npoints = {{ {points} }}\n{more}")
        tables.append('[drive]\nlink = 1\nspeed = 10\npositions = 12\naccelerations = "all"\n')
        tables += self.tables
        numbers = tuple(sorted(self.bodies.poses))
        return Machine("\n".join(tables), self.bodies, self.letters, self.phi, numbers)


def machine(
    seed: int, *, guides: int = 0, slots: int = 0, before: bool = False, behind: bool = False
) -> Machine:
    """Return a random mechanism with a plate, laid at some angle of its crank.

    ``guides``: so many legs slide, if all three the first on what drives; ``slots``: so many slide along the
    plate, behind these; ``before``: one leg is held by a dyad on the crank; ``behind``: a dyad hangs on the
    plate.
    """
    one = Assembly(seed)
    world = one.world
    if before:
        one.before()
    middle = world["A"] + one.polar(0.1, 0.25)
    size = one.some(0.04, 0.1)
    turn = 2 * math.pi * one.some(0, 1)
    for k, letter in enumerate("BCF"):
        world[letter] = middle + size * one.some(0.6, 1.4) * cmath.exp(1j * (turn + 2.1 * k))
    angle = 2 * math.pi * one.some(0, 1)
    legs = []
    pins = "BCF"[: 3 - slots]
    turning = len(pins) - guides
    for k, letter in enumerate(pins):
        if k < min(turning, len(one.held)):
            outer, on = one.held[-1 - k]
            leg = one.rod(outer, letter)
            one.pin(outer, leg, on)
        elif k >= turning:
            leg = _sliding(one, letter, f"q{k}", 0 if guides < 3 or k else one.held[-1][1])
        else:
            outer = "DE"[k - 1]
            one.fix(outer, world[letter] + one.polar(0.1, 0.25))
            leg = one.rod(letter, outer)
            one.pin(outer, leg, 0)
        legs.append(leg)
    plate = one.link(world["B"], angle, "BCF")
    one.near(plate, angle)
    for leg, letter in zip(legs, pins, strict=True):
        one.pin(letter, leg, plate)
    for k in range(len(pins), 3):
        driven = one.held[0 if turning else -1] if before or not turning else None
        outer, on = driven if driven and k == len(pins) else ("DE"[k - 1], 0)
        if not on:
            one.fix(outer, world["BCF"[k]] + one.polar(0.0, 0.1))
        _slotted(one, plate, outer, on, f"s{k}")
    if behind:
        one.dyad("F", plate, "K", "M", (0.1, 0.2))
    return one.machine("Plate")


def _sliding(one: Assembly, letter: str, name: str, on: int) -> int:
    """Put a slider on a letter, along a guide of the frame (0) or of a body."""
    way = 360 * one.some(0, 1)
    one.polar(0.02, 0.05)
    through = one.world[letter] + cmath.exp(1j * math.radians(way)) * one.some(0.02, 0.06)
    leg = one.link(one.world[letter], math.radians(way), letter)
    if on:
        at, angle = one.bodies.poses[on]
        through, way = (through - at) * cmath.exp(-1j * angle), way - math.degrees(angle)
        one.rails.setdefault(on, []).append(
            f'{name} = {{ through = [{through.real!r}, {through.imag!r}], angle = "{way!r} deg" }}'
        )
    else:
        one.frame[name], one.frame[f"{name} angle"] = through, complex(way)
    one.bodies.guides.append(Guide(leg, 0j, on, through, math.radians(way)))
    where = on or '"frame"'
    one.lines[leg] = [f'slides = {{ on = {where}, along = "{name}" }}']
    return leg


def _slotted(one: Assembly, plate: int, outer: str, on: int, name: str) -> None:
    """Put a link about a pivot that slides along the plate, or the plate along it."""
    place = one.world[outer]
    start, through = place + one.polar(0.0, 0.03), place + one.polar(0.0, 0.05)
    leg = one.link(start, 2 * math.pi * one.some(0, 1), outer)
    one.pin(outer, leg, on)
    way = 2 * math.pi * one.some(0, 1)
    slider, owner = (leg, plate) if one.chance.random() < 0.6 else (plate, leg)
    at, angle = one.bodies.poses[owner]
    own, bend = (through - at) * cmath.exp(-1j * angle), way - angle
    start, angle = one.bodies.poses[slider]
    off = (start - through) * cmath.exp(-1j * way)
    point = (through - start) * cmath.exp(-1j * angle)
    one.bodies.guides.append(Guide(slider, point, owner, own, bend))
    one.rails.setdefault(owner, []).append(
        f"{name} = {{ through = [{own.real!r}, {own.imag!r}], "
        f'angle = "{math.degrees(bend)!r} deg" }}'
    )
    one.slides.setdefault(slider, []).append(
        f'{{ on = {owner}, along = "{name}", offset = {off.imag!r}, '
        f'angle = "{math.degrees(angle - way)!r} deg" }}'
    )


def _frame(frame: dict[str, complex]) -> list[str]:
    rows = []
    for name, z in frame.items():
        if name.endswith(" angle"):
            continue
        if f"{name} angle" in frame:
            way = frame[f"{name} angle"].real
            rows.append(
                f'{name} = {{ through = [{z.real!r}, {z.imag!r}], angle = "{way!r} deg" }}\n'
            )
        else:
            rows.append(f"{name} = [{z.real!r}, {z.imag!r}]\n")
    return rows


FINER = 16
"""A step that leads nowhere, or too far, is made in so many."""


def followed(one: Machine, step: float = math.radians(0.5)) -> list[tuple[float, Reals]]:
    """Return angles of the crank (rad) with poses, up to a turn each way from where it was laid."""
    row = [(one.phi, one.bodies.start())]
    sign = _sign(one, row[0][1], one.phi)
    for sense in (1, -1):
        phi, q = one.phi, one.bodies.start()
        before = q
        for _ in range(round(2 * math.pi / step)):
            reached = _ahead(one, (before, q), phi, sense * step, sign)
            if reached is None:
                break
            phi, before, q = phi + sense * step, q, reached
            row.append((phi, q))
    return sorted(row, key=lambda two: two[0])


def _sign(one: Machine, q: Reals, phi: float) -> float:
    return float(np.sign(np.linalg.det(one.bodies.equations(q, phi)[1])))


def _ahead(
    one: Machine, last: tuple[Reals, Reals], phi: float, step: float, sign: float
) -> Reals | None:
    """Return the poses a step ahead of the last two; None where the branch does not go on so far."""
    before, q = last
    reached = one.bodies.settle(2 * q - before, phi + step)
    if reached is not None and np.abs(reached - q).max() <= 0.3:
        return reached if _sign(one, reached, phi + step) == sign else None
    if abs(step) < math.radians(0.1):
        return None
    before = q - (q - before) / FINER
    for k in range(FINER):
        on = _ahead(one, (before, q), phi + k * step / FINER, step / FINER, sign)
        if on is None:
            return None
        before, q = q, on
    return q
