"""Random mechanisms with a plate on three legs (class III): on any bodies, legs that turn and that slide.

A crank and a dyad stand before it; behind it a dyad of turning pairs may hang on the plate or on a leg.
"""

from __future__ import annotations

import cmath
import math
import random
from dataclasses import dataclass, field, replace
from itertools import combinations
from typing import NamedTuple

import numpy as np

from graphic_tmm.chapters.kinematics.tracings import Branch, Tracing
from graphic_tmm.chapters.kinematics.wheels import Wheels
from graphic_tmm.mechanism.groups import PlateGroup
from graphic_tmm.mechanism.guides import direction
from graphic_tmm.mechanism.records import Guide, Link, Mechanism, Near, Side, Slide, Sweep
from graphic_tmm.mechanism.structure import dissect
from support.mechanisms import Pose, Sampled, assemble

FREE = "ZYXWVUTRNMLKJHGFEDC"
SQUARE = 0.25
"""How well a plate is held at least: the determinant of the lines of its legs."""


class Held(NamedTuple):
    """A mechanism, and where its plate lies: its place (`Branch`) by the name of its group."""

    drawn: Sampled
    places: dict[str, Branch]

    def branches(self, wheels: Wheels, tracing: Tracing) -> Branch:
        """Return which of its places the plate keeps."""
        return self.places[tracing.group.name]


@dataclass
class _Sheet:
    """The plane while links are put on: bodies by number, their poses, places of letters (m)."""

    source: random.Random
    bodies: dict[int, Link]
    poses: dict[int, Pose]
    places: dict[str, complex]
    size: float
    free: list[str] = field(default_factory=list)

    def letter(self, place: complex) -> str:
        name = next(k for k in FREE if k not in self.places)
        self.places[name] = place
        return name

    def near(self, place: complex, least: float = 0.4, most: float = 1.6) -> complex:
        way = self.source.uniform(-math.pi, math.pi)
        return place + self.size * cmath.rect(self.source.uniform(least, most), way)

    def own(self, number: int, place: complex) -> complex:
        x, y, turned = self.poses[number]
        return (place - complex(x, y)) * cmath.rect(1.0, -turned)

    def mark(self, number: int, letter: str) -> None:
        body = self.bodies[number]
        points = {**body.points, letter: self.own(number, self.places[letter])}
        self.bodies[number] = replace(body, points=points)

    def put(self, number: int, *letters: str) -> None:
        """Put a new link on letters, in axes of its own."""
        at = self.near(self.places[letters[0]], 0.0, 0.5)
        self.poses[number] = (at.real, at.imag, self.source.uniform(-math.pi, math.pi))
        self.bodies[number] = Link(number, {})
        for letter in letters:
            self.mark(number, letter)
        centre = f"S{number}"
        self.places[centre] = self.near(self.places[letters[0]], 0.1, 0.8)
        self.mark(number, centre)
        mass = self.source.uniform(0.1, 10.0)
        self.bodies[number] = replace(
            self.bodies[number], mass=mass, inertia=mass * (0.3 * self.size) ** 2, centre=centre
        )

    def pivot(self, number: int, around: complex) -> str:
        """A letter on a body for an outer pivot: one that is there, or a new one."""
        letters = [k for k in self.bodies[number].points if not k.startswith("S")]
        apart = [k for k in letters if 0.3 <= abs(self.places[k] - around) / self.size <= 3.0]
        if apart and self.source.random() < 0.5:
            return self.source.choice(apart)
        letter = self.letter(self.near(around))
        self.mark(number, letter)
        return letter

    def slide(self, number: int, on: int, pin: str) -> None:
        """Let a link slide on a guide of a body through, or beside, a pin."""
        body, way = self.bodies[on], self.source.uniform(-math.pi, math.pi)
        at = self.near(self.places[pin], 0.0, 0.5)
        turned = math.degrees(way - self.poses[on][2])
        name = f"q{number}" if not self.bodies[number].slides else f"q{number}{on}"
        guide = Guide(name, self.own(on, at), turned)
        self.bodies[on] = replace(body, guides=(*body.guides, guide))
        x, y, own = self.poses[number]
        offset = ((complex(x, y) - at) * cmath.rect(1.0, -way)).imag
        slide = Slide(on, guide, offset, math.degrees(own - way))
        self.bodies[number] = replace(
            self.bodies[number], slides=(*self.bodies[number].slides, slide)
        )

    def normal(self, number: int, pin: str, pivot: str, plate: int) -> complex:
        """The direction along which a leg holds its pin, or a plate that slides along it."""
        if pivot:
            way = self.places[pin] - self.places[pivot]
            return way / abs(way)
        slide = next(
            one
            for k in (number, plate)
            if k
            for one in self.bodies[k].slides
            if k == number or one.on == number
        )
        angle = math.radians(slide.guide.angle) + self.poses[slide.on][2]
        return 1j * cmath.rect(1.0, angle)


def held_plate(seed: int, guides: int = 0, behind: int = 0, slots: int = 0) -> Held:
    """Draw one of a seed: so many legs of a plate slide, so many along it; so many dyads hang behind it."""
    source = random.Random(seed)
    while True:
        drawn = assemble(lambda most: source.randint(0, most), (1, 1))
        found = _with_plate(drawn, source, (guides, slots), behind)
        if found is not None:
            return found


def _with_plate(
    drawn: Sampled, source: random.Random, sliders: tuple[int, int], behind: int
) -> Held | None:
    guides, slots = sliders
    mechanism = drawn.mechanism
    frame = mechanism.frame.number
    x, y, _ = drawn.poses[1]
    points = mechanism.by_number[1].points
    turned = math.radians(drawn.phi) - cmath.phase(points["A"] - points["O"])
    poses: dict[int, Pose] = {**drawn.poses, 1: (x, y, turned), frame: (0.0, 0.0, 0.0)}
    size = abs(points["A"] - points["O"])
    sheet = _Sheet(source, dict(mechanism.by_number), poses, dict(drawn.points), size)
    there, number = list(sheet.bodies), max(sheet.bodies) + 1
    numbers = source.sample(range(number, number + 4), 4)
    plate, legs = numbers[0], sorted(numbers[1:])
    middle = sheet.near(drawn.points["A"], 0.5, 2.0)
    pins = [sheet.letter(sheet.near(middle, 0.4, 1.4)) for _ in legs]
    sliding = source.sample(legs, guides)
    slotted = source.sample([leg for leg in legs if leg not in sliding], slots)
    own = [pin for leg, pin in zip(legs, pins, strict=True) if leg not in slotted]
    sheet.put(plate, *(own or [sheet.letter(middle)]))
    bodies = [source.choice(there) for _ in legs]
    if set(bodies) == {frame}:
        return None
    pivots = []
    for leg, body, pin in zip(legs, bodies, pins, strict=True):
        if leg in sliding:
            sheet.put(leg, pin)
            sheet.slide(leg, body, pin)
            pivots.append("")
        elif leg in slotted:
            pivots.append("")
            sheet.mark(body, pin)
            sheet.put(leg, pin)
            sheet.slide(*((leg, plate) if source.random() < 0.6 else (plate, leg)), pin)
        else:
            pivots.append(sheet.pivot(body, sheet.places[pin]))
            sheet.put(leg, pivots[-1], pin)
    ways = {
        leg: (sheet.places[pin], sheet.normal(leg, pin, pivot, plate if leg in slotted else 0))
        for leg, pin, pivot in zip(legs, pins, pivots, strict=True)
    }
    rows = [[u.real, u.imag, ((p - middle).conjugate() * u).imag / size] for p, u in ways.values()]
    if (
        abs(np.linalg.det(np.array(rows))) < SQUARE
        or len({p for p in pivots if p}) < 3 - guides - slots
    ):
        return None
    for _ in range(behind):
        _hang(sheet, source.choice([plate, *legs]), source.choice(there))
    links = [sheet.bodies[k] for k in sheet.bodies if k != frame]
    own = sheet.poses[plate]
    links = [
        replace(k, near=Near(math.degrees(own[2]), drawn.phi)) if k.number == plate else k
        for k in links
    ]
    source.shuffle(links)
    whole = Mechanism(sheet.bodies[frame], tuple(links), mechanism.drive)
    (group,) = (one for one in dissect(whole).groups if isinstance(one, PlateGroup))
    assert group.plate == plate
    order = [leg.link for leg in group.legs]
    along = [ways[link][1] for link in order]
    crosses = {
        pair: abs((along[pair[0]].conjugate() * along[pair[1]]).imag)
        for pair in combinations(range(3), 2)
    }
    first = dict(zip(legs, zip(pins, pivots, strict=True), strict=True))
    pin, pivot = first[order[0]]
    second, _ = first[order[1]]
    along_plate = sheet.places[second] - sheet.places[pin]
    if group.inner[1].kind == "P":
        turned = math.radians(direction(group.inner[1], plate)) + sheet.poses[plate][2]
        along_plate = cmath.rect(1.0, turned)
    near = [
        math.degrees(
            cmath.phase(sheet.places[pin] - sheet.places[pivot] if pivot else along_plate)
        ),
        math.degrees(cmath.phase(along_plate)),
    ]
    at = np.array([drawn.phi - 1.0, drawn.phi + 1.0])
    sweep = Sweep("φ", "°", 0.0, 360.0, True)
    best = max(crosses, key=lambda pair: crosses[pair])
    swung, laid = (np.full(2, one) for one in near)
    branch = Branch(at, swung, laid, sweep, False, best)
    found = Sampled(whole, drawn.phi, sheet.places, sheet.poses, (*drawn.kinds, "plate"))
    return Held(found, {group.name: branch})


def _hang(sheet: _Sheet, first: int, second: int) -> None:
    """Hang a dyad of turning pairs on two bodies."""
    number, source = max(sheet.bodies) + 1, sheet.source
    a = source.choice([k for k in sheet.bodies[first].points if not k.startswith("S")])
    c = sheet.letter(sheet.near(sheet.places[a], 0.8, 1.6))
    sheet.mark(second, c)
    chord = sheet.places[c] - sheet.places[a]
    sign = source.choice((1, -1))
    arch = cmath.rect(source.uniform(0.4, 1.0), sign * source.uniform(0.5, 1.2))
    pin = sheet.letter(sheet.places[a] + chord * arch)
    sheet.put(number, a, pin)
    sheet.put(number + 1, c, pin)
    side = Side(sign, (a, c))
    sheet.bodies[number] = replace(sheet.bodies[number], side=side)
