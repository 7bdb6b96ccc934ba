"""Random mechanisms for property tests: a crank and one to three dyads of any of the five kinds.

A mechanism is drawn from an assembled configuration outward: first the places of the pins and the
directions of the guides at one angle of the crank, then, from them, the local coordinates, offsets
and sides. So everything drawn assembles at the drawn angle, and nothing is rejected. There the
closing lines of every dyad meet at an angle whose sine is 0.26 or more.

Lengths are drawn near 1 and scaled at the end; all numbers lie on grids, so that special positions
come up (parallel, in line, offset 0) and examples shrink to plain ones.
"""

from __future__ import annotations

import cmath
import math
import random
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import NamedTuple, TypeVar

from hypothesis import strategies as st

from graphic_tmm.mechanism.records import Drive, Guide, Link, Mechanism, Side, Slide

T = TypeVar("T")
Pose = tuple[float, float, float]
KINDS = ("RRR", "RRP", "RPR", "PRP", "RPP")
LETTERS = "BCDEFGHKLMRTUVXYZNJ"  # O and A stand on the crank; P, Π are poles, S centres of mass


class Sampled(NamedTuple):
    """A mechanism and the position it was drawn in.

    ``phi`` is the crank's angle (degrees), ``points`` the places (m) of all letters, ``poses``
    (x m, y m, θ rad) by link number, ``kinds`` the dyads in the order they were put on.
    """

    mechanism: Mechanism
    phi: float
    points: Mapping[str, complex]
    poses: Mapping[int, Pose]
    kinds: tuple[str, ...]


@dataclass
class _Body:
    """A link while it is drawn: origin, angle (rad) and letters in the plane of the drawing."""

    number: int
    z: complex
    theta: float
    letters: list[str] = field(default_factory=list)
    guides: list[Guide] = field(default_factory=list)
    slides: list[Slide] = field(default_factory=list)
    side: Side | None = None


@dataclass
class _Plane:
    """The drawing: scale (m per unit), bodies (the frame first) and the places of the letters."""

    scale: float
    bodies: list[_Body]
    places: dict[str, complex]

    def put(self, place: complex, *bodies: _Body) -> str:
        """A new letter on these bodies."""
        letter = next(letter for letter in LETTERS if letter not in self.places)
        self.places[letter] = place
        for body in bodies:
            body.letters.append(letter)
        return letter

    def middle(self, body: _Body) -> complex:
        """A place about which to put new letters of a body."""
        return self.places[body.letters[0]] if body.letters else body.z

    def own(self, body: _Body, place: complex) -> complex:
        """A place in the axes of a body, m."""
        seen = (place - body.z) * cmath.rect(1.0, -body.theta)
        return complex(_plain(seen.real), _plain(seen.imag)) * self.scale

    def slide(
        self, slider: _Body, on: _Body, place: complex, along: float, side: Side | None = None
    ) -> None:
        """Lay a guide on a body through a place; the slider's pose gives its angle and offset."""
        number = 1 + sum(len(body.guides) for body in self.bodies)
        guide = Guide(f"g{number}", self.own(on, place), _degrees(along - on.theta))
        on.guides.append(guide)
        offset = _plain(((slider.z - place) * cmath.rect(1.0, -along)).imag) * self.scale
        turn = _degrees(slider.theta - along)
        slider.slides.append(Slide(on.number, guide, offset, turn, side))


def _plain(length: float) -> float:
    """A length of the order of 1, without what rounding left of a zero."""
    return length if abs(length) > 1e-15 else 0.0


def _degrees(angle: float) -> float:
    """Degrees in [-180, 180]; a multiple of 0.1 that was meant is given exactly."""
    turned = math.degrees(math.remainder(angle, 2 * math.pi))
    near = round(turned, 1)
    return near + 0.0 if abs(turned - near) < 1e-12 else turned


@dataclass
class _Hand:
    """Draws one dyad after the other; ``pick(n)`` is a free choice of a whole number 0 ... n."""

    pick: Callable[[int], int]
    plane: _Plane
    driven: bool = False  # whether a dyad hangs on the crank's A already

    def between(self, low: float, high: float) -> float:
        return low + (high - low) * self.pick(1000) / 1000

    def around(self, middle: float, reach: float, steps: int = 500) -> float:
        half, odd = divmod(self.pick(2 * steps), 2)  # a small choice lies near the middle
        return middle + reach * (-half - 1 if odd else half) / steps

    def angle(self) -> float:
        return math.radians(self.around(0.0, 180.0, 1800))

    def sign(self) -> int:
        return (1, -1)[self.pick(1)]

    def choose(self, among: Sequence[T]) -> T:
        return among[self.pick(len(among) - 1)]

    def shuffled(self, among: Sequence[T]) -> list[T]:
        left = list(among)
        return [left.pop(self.pick(len(left) - 1)) for _ in among]

    def near(self) -> complex:
        return complex(self.around(0.0, 1.0), self.around(0.0, 1.0))

    def apart(self) -> complex:
        return cmath.rect(self.between(0.4, 1.5), self.angle())

    def lean(self) -> float:
        """An angle to a line that is not near a right one: |cos| > 0.26."""
        return self.around(0.0, 1.3) + math.pi * self.pick(1)

    def slant(self) -> float:
        """An angle of 0.27 ... 2.87 rad: sin > 0.26."""
        return self.around(math.pi / 2, 1.3)

    def pivot(self, body: _Body, other: _Body, far: complex | None = None) -> str:
        """A letter on a body for an outer pivot: one that is there, or a new one.

        Not one that lies on the other outer body too; with ``far``, one that keeps away from it.
        """
        there = [
            letter
            for letter in body.letters
            if letter not in other.letters
            and not letter.startswith("S")
            and (far is None or 0.3 <= abs(self.plane.places[letter] - far) <= 3)
        ]
        if far is None and body.number == 1 and not self.driven:
            self.driven = True
            return "A"
        if there and self.pick(1):
            return self.choose(there)
        if far is not None:
            return self.plane.put(far + self.apart(), body)
        return self.plane.put(self.plane.middle(body) + self.apart(), body)

    def body(self, number: int, place: complex, direction: float) -> _Body:
        """A new link with its origin near a place and its x axis near a direction."""
        place += self.near() if self.pick(1) else 0
        return _Body(number, place, direction + (self.angle() if self.pick(1) else 0))

    def through(self, place: complex, along: float) -> complex:
        """A place for a guide to run through: with the pin on the guide, or aside of it."""
        aside = self.around(0.0, 1.0) if self.pick(1) else 0.0
        return place + complex(self.around(0.0, 1.0), aside) * cmath.rect(1.0, along)

    def rrr(self, first: _Body, second: _Body, numbers: Sequence[int]) -> list[_Body]:
        plane = self.plane
        a = self.pivot(first, second)
        c = self.pivot(second, first, far=plane.places[a])
        sign, beta = self.sign(), self.slant()
        alpha = self.between(0.2, 0.8) * (math.pi - beta)
        chord = plane.places[c] - plane.places[a]
        arm = chord * cmath.rect(math.sin(alpha + beta) / math.sin(beta), sign * alpha)
        place = plane.places[a] + arm
        two = self.body(numbers[0], plane.places[a], cmath.phase(arm))
        three = self.body(numbers[1], plane.places[c], cmath.phase(place - plane.places[c]))
        two.letters.append(a)
        three.letters.append(c)
        plane.put(place, two, three)
        ends, sense = ((a, c), sign) if self.pick(1) else ((c, a), -sign)
        (two if self.pick(1) else three).side = Side(sense, left_of=ends)
        return [two, three]

    def rrp(self, first: _Body, second: _Body, numbers: Sequence[int]) -> list[_Body]:
        plane = self.plane
        a = self.pivot(first, second)
        arm = self.apart()
        place = plane.places[a] + arm
        along = cmath.phase(arm) + self.lean()
        two = self.body(numbers[0], plane.places[a], cmath.phase(arm))
        three = self.body(numbers[1], place, along)
        two.letters.append(a)
        plane.put(place, two, three)
        sign = 1 if (arm * cmath.rect(1.0, -along)).real > 0 else -1
        plane.slide(three, second, self.through(place, along), along, Side(sign))
        return [two, three]

    def rpr(self, first: _Body, second: _Body, numbers: Sequence[int]) -> list[_Body]:
        plane = self.plane
        a = self.pivot(first, second)
        c = self.pivot(second, first, far=plane.places[a])
        if self.pick(1):
            a, c = c, a
        chord = plane.places[a] - plane.places[c]
        along = cmath.phase(chord) + self.lean()
        slider = self.body(numbers[0], plane.places[a], along)
        owner = self.body(numbers[1], plane.places[c], along)
        slider.letters.append(a)
        owner.letters.append(c)
        sign = 1 if (chord * cmath.rect(1.0, -along)).real > 0 else -1
        plane.slide(slider, owner, self.through(plane.places[c], along), along, Side(sign))
        return [slider, owner]

    def prp(self, first: _Body, second: _Body, numbers: Sequence[int]) -> list[_Body]:
        plane, along = self.plane, self.angle()
        place = plane.places["O"] + 1.5 * self.near()
        across = along + self.sign() * self.slant()
        two = self.body(numbers[0], place, along)
        three = self.body(numbers[1], place, across)
        plane.put(place, two, three)
        plane.slide(two, first, self.through(place, along), along)
        plane.slide(three, second, self.through(place, across), across)
        return [two, three]

    def rpp(self, first: _Body, second: _Body, numbers: Sequence[int]) -> list[_Body]:
        plane = self.plane
        a = self.pivot(first, second)
        place, along = plane.places[a], self.angle()
        inner = along + self.sign() * self.slant()
        two = self.body(numbers[0], place, inner)
        three = self.body(numbers[1], place + self.near(), along)
        two.letters.append(a)
        plane.slide(three, second, self.through(three.z, along), along)
        if self.pick(1):
            plane.slide(two, three, self.through(place, inner), inner)
        else:
            plane.slide(three, two, self.through(place, inner), inner)
            if self.pick(1):
                three.slides.reverse()
        return [two, three]

    def dyad(self, kind: str) -> None:
        """Put a dyad on two of the bodies that are there."""
        bodies = self.plane.bodies
        number = max(body.number for body in bodies[1:]) + 1
        # the crank's A is to drive something
        first = bodies[1] if kind != "PRP" and not self.driven else self.choose(bodies)
        second = self.choose([body for body in bodies if body is not first])
        numbers = self.shuffled((number, number + 1))
        ways = (self.rrr, self.rrp, self.rpr, self.prp, self.rpp)
        bodies += dict(zip(KINDS, ways, strict=True))[kind](first, second, numbers)

    def extras(self, body: _Body) -> None:
        """A centre of mass, and sometimes one more letter off the line of the others."""
        around = self.plane.middle(body)
        body.letters.append(f"S{body.number}")
        self.plane.places[body.letters[-1]] = around + self.apart()
        if self.pick(1):
            self.plane.put(around + self.near(), body)


def _link(plane: _Plane, body: _Body, mass: float) -> Link:
    return Link(
        body.number,
        {letter: plane.own(body, plane.places[letter]) for letter in body.letters},
        tuple(body.guides),
        tuple(body.slides),
        mass=mass,
        inertia=mass * (0.3 * plane.scale) ** 2,
        centre=f"S{body.number}",
        side=body.side,
    )


def _pose(plane: _Plane, body: _Body) -> Pose:
    """The pose of a body seen from the frame, m and rad."""
    z, turn = plane.own(plane.bodies[0], body.z), body.theta - plane.bodies[0].theta
    return z.real, z.imag, math.remainder(turn, 2 * math.pi)


def _start(pick: Callable[[int], int], dyads: int) -> _Hand:
    """A hand before a plane with the frame and the crank."""
    scale = (1.0, 0.1, 10.0, 0.01, 100.0, 1e-3, 1e3)[pick(6)]
    hand = _Hand(pick, _Plane(scale, [], {}))
    frame = hand.body(pick(1) * (2 * dyads + 2), hand.near(), 0.0)
    turn = hand.angle()
    crank = hand.body(1, 0j, turn)
    frame.letters.append("O")
    crank.letters += ["O", "A"]
    hand.plane.bodies += [frame, crank]
    hand.plane.places |= {"O": 0j, "A": cmath.rect(hand.between(0.4, 1), turn)}
    return hand


def assemble(
    pick: Callable[[int], int], dyads: tuple[int, int] = (1, 3), kinds: Sequence[str] = KINDS
) -> Sampled:
    """Draw a mechanism of W = 1 by choices ``pick(n)`` of whole numbers 0 ... n.

    It is a crank (link 1: O on the frame, A) and dyads (least, most; at most 3). A dyad may stand
    on any two bodies that are there (frame, crank, links of earlier dyads), at letters that are
    there (a multiple pin) or at new ones. Something hangs on the crank's A, unless ``kinds`` is PRP
    alone, which has no outer pivots.
    """
    chosen = [kinds[pick(len(kinds) - 1)] for _ in range(dyads[0] + pick(dyads[1] - dyads[0]))]
    turning = [kind for kind in kinds if kind != "PRP"]
    if turning and not set(chosen) & set(turning):
        chosen[-1] = turning[0]
    hand = _start(pick, len(chosen))
    plane, frame = hand.plane, hand.plane.bodies[0]
    for kind in chosen:
        hand.dyad(kind)
    for body in plane.bodies[1:]:
        hand.extras(body)
    # the frame's axes are the sheet's: every place is seen from the frame's pose
    points = {letter: plane.own(frame, place) for letter, place in plane.places.items()}
    grounded = {letter: points[letter] for letter in frame.letters}
    links = [_link(plane, body, hand.between(0.1, 10)) for body in plane.bodies[1:]]
    speed = hand.sign() * hand.between(0.5, 50)
    return Sampled(
        Mechanism(
            Link(frame.number, grounded, tuple(frame.guides)),
            tuple(hand.shuffled(links)),
            Drive(1, speed, hand.around(0.0, 500.0) if pick(1) else 0.0),
        ),
        _degrees(cmath.phase(plane.places["A"]) - frame.theta),
        points,
        {body.number: _pose(plane, body) for body in plane.bodies},
        tuple(chosen),
    )


@cache
def _choices(most: int) -> st.SearchStrategy[int]:
    return st.integers(0, most)


@st.composite
def mechanisms(
    draw: st.DrawFn, *, dyads: tuple[int, int] = (1, 3), kinds: Sequence[str] = KINDS
) -> Sampled:
    """Strategy of mechanisms as `assemble` makes them: number of dyads (least, most), kinds."""
    return assemble(lambda most: draw(_choices(most)), dyads, kinds)


def sample(
    count: int, seed: int = 0, *, dyads: tuple[int, int] = (1, 3), kinds: Sequence[str] = KINDS
) -> list[Sampled]:
    """Draw many mechanisms without hypothesis (no shrinking, but below a millisecond each)."""
    source = random.Random(seed)
    return [assemble(lambda most: source.randint(0, most), dyads, kinds) for _ in range(count)]


def sides(drawn: Sampled, poses: Mapping[int, Pose]) -> list[tuple[str, float]]:
    """By dyad with a side: its kind, and how far (m or m²) it is on the side its record asks for.

    RRR: the inner pin to the left of ``left_of``; RRP: from the foot of the outer pivot to the pin,
    RPR: from the pivot of the guide's owner to that of the slider, along the guide.
    """
    found, links = [], drawn.mechanism.by_number

    def seen(link: Link, letter: str) -> complex:
        x, y, turn = poses[link.number]
        return complex(x, y) + link.points[letter] * cmath.rect(1.0, turn)

    for number, kind in zip(range(2, 100, 2), drawn.kinds, strict=False):
        pair = links[number], links[number + 1]
        pivots = {next(iter(link.points)): link for link in pair}
        for link, other in (pair, pair[::-1]):
            if link.side is not None and link.side.left_of is not None:
                a, c = (seen(pivots[letter], letter) for letter in link.side.left_of)
                (inner,) = set(link.points) & set(other.points)
                arm = (seen(link, inner) - a) * (c - a).conjugate()
                found.append((kind, arm.imag * link.side.sign))
            for slide in (slide for slide in link.slides if slide.side is not None):
                along = cmath.rect(1.0, poses[slide.on][2] + math.radians(slide.guide.angle))
                c, a = (seen(one, next(iter(one.points))) for one in (other, link))
                reach = ((a - c) * along.conjugate()).real
                found.append((kind, reach * (slide.side.sign if slide.side else 0)))
    return found


def sides_kept(drawn: Sampled, poses: Mapping[int, Pose]) -> bool:
    """Whether all dyads stand on the sides their records ask for."""
    return all(reach > 0 for _, reach in sides(drawn, poses))
