"""A drawing of a mechanism that grows outward: drives, and groups of all kinds that hang on them.

Pins and directions of guides are put down first; what a scene says of links, offsets and sides follows from
them. Lengths are near 1 and scaled as they are told.
"""

from __future__ import annotations

import cmath
import math
import random
from dataclasses import dataclass, field
from typing import Any

LETTERS = [*"ABCDEFGHKLMNRTUVXYZJ", *(f"{letter}1" for letter in "ABCDEFGHKLMN")]


@dataclass
class Body:
    number: int
    z: complex
    theta: float
    letters: list[str] = field(default_factory=list)
    guides: dict[str, tuple[complex, float]] = field(default_factory=dict)
    slides: list[dict[str, Any]] = field(default_factory=list)
    side: str | None = None


class Plane:
    """The drawing while it grows; the frame is its first body."""

    def __init__(self, pick: random.Random, scale: float) -> None:
        self.pick, self.scale = pick, scale
        self.places: dict[str, complex] = {}
        self.bodies = [Body(0, 0j, 0.0)]
        self.driven: list[Body] = []
        self.free: list[Body] = []
        self.closed: list[Body] = []

    @property
    def frame(self) -> Body:
        return self.bodies[0]

    def body(self, place: complex) -> Body:
        """A new link with its origin somewhere near a place, turned anyhow."""
        near = (
            cmath.rect(self.pick.uniform(0, 0.7), self.angle()) if self.pick.random() < 0.5 else 0
        )
        body = Body(len(self.bodies), place + near, self.angle())
        self.bodies.append(body)
        return body

    def angle(self) -> float:
        return self.pick.uniform(-math.pi, math.pi)

    def lean(self) -> float:
        """An angle to a line that is not near a right one."""
        return self.pick.uniform(-1.1, 1.1) + self.pick.choice((0.0, math.pi))

    def slant(self) -> float:
        return self.pick.choice((1, -1)) * self.pick.uniform(0.5, 2.6)

    def apart(self) -> complex:
        return cmath.rect(self.pick.uniform(0.6, 1.5), self.angle())

    def put(self, place: complex, *bodies: Body) -> str:
        letter: str = next(letter for letter in LETTERS if letter not in self.places)
        self.places[letter] = place
        for body in bodies:
            body.letters.append(letter)
        return letter

    def pivot(self, body: Body, link: Body | None = None, far: complex | None = None) -> str:
        """A letter on a body for an outer pivot: a loose point that is there, else a new one."""
        loose: list[str] = [
            x
            for x in body.letters
            if sum(x in b.letters for b in self.bodies) == 1
            and (far is None or 0.5 <= abs(self.places[x] - far) <= 2.5)
        ]
        if loose:
            return loose[0]
        middle = self.places[body.letters[0]] if body.letters else body.z
        return self.put((middle if far is None else far) + self.apart(), body)

    def slide(
        self, slider: Body, on: Body, place: complex, along: float, side: str | None = None
    ) -> None:
        """A guide on a body through a place or beside it."""
        aside = complex(
            self.pick.uniform(-1, 1), self.pick.choice((0, self.pick.uniform(-0.6, 0.6)))
        )
        self.guide(slider, on, place + aside * cmath.rect(1.0, along), along, side)

    def guide(
        self, slider: Body, on: Body, through: complex, along: float, side: str | None
    ) -> dict[str, Any]:
        name = f"g{1 + sum(len(body.guides) for body in self.bodies)}"
        on.guides[name] = (through, along)
        told: dict[str, Any] = {
            "on": on.number if on.number else "frame",
            "along": name,
            "offset": ((slider.z - through) * cmath.rect(1.0, -along)).imag * self.scale,
            "angle": math.degrees(slider.theta - along),
        }
        slider.slides.append(told | ({"side": side} if side else {}))
        return told

    def crank(self) -> None:
        place = self.apart() * 1.3 if self.driven else 0j
        letter = self.put(place, self.frame)
        link = self.body(place)
        link.letters.append(letter)
        self.put(place + cmath.rect(self.pick.uniform(0.4, 0.8), self.angle()), link)
        self.driven.append(link)

    def slider(self) -> None:
        if not self.frame.letters:
            self.places["O"] = self.apart()
            self.frame.letters.append("O")
        place, along = self.apart(), self.angle()
        link = self.body(place)
        self.put(place, link)
        through = place - cmath.rect(self.pick.uniform(0.8, 2.0), along)
        through += 1j * cmath.rect(self.pick.choice((0.0, self.pick.uniform(-0.5, 0.5))), along)
        self.guide(link, self.frame, through, along, None)
        self.driven.append(link)

    def rod(self) -> None:
        """A cylinder and its rod that turn a lever, or push a block along a guide."""
        first = self.pick.choice([self.frame, *self.driven])
        second = self.pick.choice(
            [b for b in (self.frame, *self.driven) if b is not first] or [first]
        )
        g = self.put(self.apart(), first) if second is first else self.pivot(first)
        turning = self.pick.random() < 0.6
        way = self.apart()
        n = self.places[g] + way
        cylinder, rod, other = self.body(self.places[g]), self.body(n), self.body(n)
        cylinder.letters.append(g)
        side = self.pick.choice("+-")
        along = cmath.phase(way) + (math.pi if side == "-" else 0.0)
        rod.z = n
        self.closed += [cylinder, rod]
        letter = self.put(n, rod, other)
        self.guide(rod, cylinder, self.places[g], along, side)
        if turning:
            o = self.put(
                n + cmath.rect(self.pick.uniform(0.6, 1.4), cmath.phase(way) + self.slant()), second
            )
            other.letters.append(o)
            left = ((n - self.places[g]) * (self.places[o] - self.places[g]).conjugate()).imag > 0
            other.side = f"{'left' if left else 'right'} of {g}{o}"
            other.letters.sort(key=lambda x: x != letter)
        else:
            line = cmath.phase(way) + self.lean()
            sign = "+" if (way * cmath.rect(1.0, -line)).real > 0 else "-"
            self.slide(other, second, n, line, sign)
        self.put(n + self.apart() * 0.7, other)
        self.driven.append(other)

    def group(self, kind: str) -> None:
        """A group on two of the bodies that are there; the last ones that nothing hangs on come first."""
        there = [body for body in self.bodies if body in self.free or body is self.frame]
        there += [
            body
            for body in self.bodies[1:]
            if body not in [*there, *self.closed] and not body.slides
        ]
        first = self.free[0] if self.free else self.pick.choice(there[1:])
        rest = self.free[1:] or [body for body in there if body is not first]
        second = self.pick.choice(rest)
        self.free = [body for body in self.free if body not in (first, second)]
        getattr(self, kind.lower())(first, second)
        self.free.append(self.bodies[-self.pick.choice((1, 2))])

    def rrr(self, first: Body, second: Body) -> None:
        a = self.pivot(first)
        c = self.pivot(second, far=self.places[a])
        chord = self.places[c] - self.places[a]
        sign = self.pick.choice((1, -1))
        beta = self.pick.uniform(0.5, 2.3)
        alpha = self.pick.uniform(0.25, 0.75) * (math.pi - beta)
        arm = chord * cmath.rect(math.sin(alpha + beta) / math.sin(beta), sign * alpha)
        place = self.places[a] + arm
        two, three = self.body(self.places[a]), self.body(place)
        two.letters.append(a)
        three.letters.append(c)
        self.put(place, two, three)
        words = f"left of {a}{c}", f"right of {a}{c}"
        if self.pick.random() < 0.5:
            words = f"right of {c}{a}", f"left of {c}{a}"
        self.pick.choice((two, three)).side = words[0 if sign > 0 else 1]

    def rrp(self, first: Body, second: Body) -> None:
        a = self.pivot(first)
        arm = self.apart()
        place, along = self.places[a] + arm, cmath.phase(arm) + self.lean()
        two, three = self.body(self.places[a]), self.body(place)
        two.letters.append(a)
        self.put(place, two, three)
        sign = "+" if (arm * cmath.rect(1.0, -along)).real > 0 else "-"
        self.slide(three, second, place, along, sign)

    def rpr(self, first: Body, second: Body) -> None:
        a = self.pivot(first)
        c = self.pivot(second, far=self.places[a])
        if self.pick.random() < 0.5:
            a, c = c, a
        chord = self.places[a] - self.places[c]
        along = cmath.phase(chord) + self.lean()
        stone, owner = self.body(self.places[a]), self.body(self.places[c])
        stone.letters.append(a)
        owner.letters.append(c)
        sign = "+" if (chord * cmath.rect(1.0, -along)).real > 0 else "-"
        self.slide(stone, owner, self.places[c], along, sign)

    def prp(self, first: Body, second: Body) -> None:
        place, along = first.z + self.apart(), self.angle()
        across = along + self.slant()
        two, three = self.body(place), self.body(place)
        self.put(place, two, three)
        self.slide(two, first, place, along)
        self.slide(three, second, place, across)

    def rpp(self, first: Body, second: Body) -> None:
        a = self.pivot(first)
        place, along = self.places[a], self.angle()
        inner = along + self.slant()
        two, three = self.body(place), self.body(place + self.apart())
        two.letters.append(a)
        self.slide(three, second, three.z, along)
        if self.pick.random() < 0.5:
            self.slide(two, three, place, inner)
        else:
            self.slide(three, two, place, inner)

    def own(self, body: Body, place: complex) -> list[float]:
        z = (place - body.z) * cmath.rect(self.scale, -body.theta)
        return [z.real, z.imag]

    def guides(self, body: Body) -> dict[str, Any]:
        return {
            name: {"through": self.own(body, place), "angle": math.degrees(along - body.theta)}
            for name, (place, along) in body.guides.items()
        }
