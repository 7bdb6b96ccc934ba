"""The centres of all pairs of links: those of pairs, then each where two lines meet (Aronhold and Kennedy)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.geometry import wedge
from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.operations.carried import carry_over
from graphic_tmm.board.operations.instruments import (
    join,
    lay_off,
    measure_along,
    meet,
    parallel,
    similar,
    square,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Line
from graphic_tmm.chapters.centres import formulas as f
from graphic_tmm.chapters.centres import words as why
from graphic_tmm.chapters.kinematics.bodies import incline_by
from graphic_tmm.chapters.kinematics.closings import GuideLeg, PinLeg
from graphic_tmm.chapters.kinematics.drives.slider import Slider
from graphic_tmm.chapters.kinematics.motion import Motion
from graphic_tmm.chapters.kinematics.plan import KinematicPlans
from graphic_tmm.mechanism.records import Slide

Pair = tuple[int, int]
Course = Line | str | None
SAME = 1e-9
"""Points no farther apart than this share of the mechanism are one; so much is the sine of parallel lines."""
SQUARE = 0.5
"""Lines that cross at 30° or more cross well: beyond that nothing is gained."""
SURE = 1e-3
"""A mean sine below this: lines that hardly cross at any position asked for."""
PIN, GUIDE, WHEEL, LINES, PARALLEL = "pin", "guide", "wheel", "lines", "parallel lines"
NORMALS, IMAGE, RATES = "normals", "image", "rates"
"""How a centre was found."""


@dataclass(frozen=True)
class Centre:
    """The centre of two links, the frame the second of them: ``mark`` is a Point, or a Line that leads there.

    ``far``: at infinity; ``way``: how it was found; ``over``: the links by which two lines lead to it,
    ``lines``: these, one of them fewer where one is the line at infinity.
    """

    links: Pair
    mark: Mark
    far: bool
    way: str
    over: tuple[int, ...] = ()
    lines: tuple[Mark, ...] = ()

    @property
    def name(self) -> str:
        """Its letter, with the numbers of both links."""
        return letter_of(self.links)


def letter_of(links: Pair) -> str:
    """Return the letter of a centre: P_{20}; P_{10,2} where a link has two figures."""
    return f"P_{{{('' if max(links) < 10 else ',').join(map(str, links))}}}"


class Network:
    """The centres while they are being found, each step recorded and tried at the positions of the row."""

    def __init__(
        self,
        draft: Draft,
        links: Sequence[int],
        frame: int,
        values: dict[Mark, Any],
        places: Sequence[int],
        size: float,
    ) -> None:
        """``values``: what is drawn already, at 1 m a mm; ``places``: the positions asked for (indices)."""
        self.draft, self.frame, self.values = draft, frame, values
        self.links = [number for number in links if number != frame] + [frame]
        self.places, self.size = list(places), size
        self.centres: dict[Pair, Centre] = {}
        self._lines: dict[frozenset[Mark], Mark] = {}
        self._rays: dict[Mark, Mark] = {}

    def pair(self, first: int, second: int) -> Pair:
        """Return two links in the order of their letter: the frame stands behind, else the lesser before."""
        if self.frame in (first, second):
            return (second if first == self.frame else first), self.frame
        return min(first, second), max(first, second)

    def of(self, first: int, second: int) -> Centre | None:
        """Return a centre that is there."""
        return self.centres.get(self.pair(first, second))

    def finite(self, first: int, second: int) -> Mark | None:
        """Return the point of a centre; None where it is none, or at infinity."""
        found = self.of(first, second)
        return found.mark if found is not None and not found.far else None

    @property
    def missing(self) -> list[Pair]:
        """The pairs of links whose centre is not there."""
        every = (self.pair(*both) for both in combinations(self.links, 2))
        return [one for one in every if one not in self.centres]

    def draw(self, op: Operation, letter: str, *uses: Mark, **named: Any) -> Mark:
        """Record a step and try it where what it uses is known."""
        mark = self.draft.draw(op, letter, *uses, **named)
        choice = {name: named[name] for name in op.choices if name in named}
        used = self.draft.uses(mark)
        if all(one in self.values for one in used):
            with np.errstate(all="ignore"):
                self.values[mark] = op.run(*(self.values[one] for one in used), **choice)
        return mark

    def enter(self, centre: Centre) -> None:
        """Keep a centre, but for one that is there already."""
        self.centres.setdefault(centre.links, centre)

    def close(self) -> None:
        """Find all centres to which two lines lead, the surest first."""
        while True:
            found = [(one, links) for links in self.missing if (one := self._best(links))]
            if not found:
                return
            most = max(score for (score, *_), _ in found)
            self._meet(*next(pair for pair in found if pair[0][0] >= 0.99 * most))

    def _best(self, links: Pair) -> tuple[float, bool, Pair] | None:
        """Return how squarely the best two lines to a centre cross, or if they are parallel; by which links."""
        i, j = links
        there = [k for k in self.links if k not in links and self.of(i, k) and self.of(k, j)]
        best: tuple[float, bool, Pair] | None = None
        for over in combinations(there, 2):
            crossing = self._crossing(*(self._course(i, k, j) for k in over))
            if crossing is not None and (best is None or crossing[0] > best[0] + SAME):
                best = (*crossing, over)
        return best

    def _course(self, i: int, k: int, j: int) -> Course:
        """Return the line through P_ik and P_kj in numbers; "infinity", or None where both are one."""
        first, second = self.centres[self.pair(i, k)], self.centres[self.pair(k, j)]
        p, q = self.values[first.mark], self.values[second.mark]
        with np.errstate(all="ignore"):
            if first.far and second.far:
                sine = np.abs(wedge(p.along, q.along))
                return "infinity" if np.nanmax(sine, initial=0.0) > SAME else None
            if first.far or second.far:
                return Line(q, p.along) if first.far else Line(p, q.along)
            way = q - p
            apart = np.abs(way) > SAME * self.size
            return Line(p, np.where(apart, way / np.abs(way), np.nan)) if apart.any() else None

    def _crossing(self, first: Course, second: Course) -> tuple[float, bool] | None:
        """Return how squarely two lines cross, and whether they are parallel; None where they tell nothing."""
        if first is None or second is None or (isinstance(first, str) and isinstance(second, str)):
            return None
        if isinstance(first, str) or isinstance(second, str):
            return 1.0, True
        sine = np.abs(wedge(first.along, second.along))[0]
        if not np.isfinite(sine).any():
            return None
        if np.nanmax(sine) <= SAME:
            off = np.abs(wedge(second.at - first.at, first.along))[0]
            return (1.0, True) if np.nanmax(off, initial=0.0) > SAME * self.size else None
        own = np.broadcast_to(sine, (max(sine.size, max(self.places) + 1),))[self.places]
        score = float(np.mean(np.nan_to_num(np.minimum(own, SQUARE)))) / SQUARE
        return (score, False) if score > SURE else None

    def _meet(self, crossing: tuple[float, bool, Pair], links: Pair) -> None:
        (i, j), (_, far, over) = links, crossing
        ends = [(self.centres[self.pair(i, k)], self.centres[self.pair(k, j)]) for k in over]
        says = " × ".join(f"({p.name} {q.name})" for p, q in ends)
        self.draft.say(f"{letter_of(links)} = {says}")
        lines = [self.line(p, q) for p, q in ends if not (p.far and q.far)]
        mark, way = lines[0], PARALLEL
        if not far:
            mark = self.draw(meet, letter_of(links), *lines, free=True, why=why.TWO_LINES)
            way = LINES
        self.enter(Centre(links, mark, far, way, over, tuple(lines)))

    def line(self, first: Centre, second: Centre) -> Mark:
        """Draw the line through two centres, once."""
        if first.far:
            first, second = second, first
        key = frozenset((first.mark, second.mark))
        if key not in self._lines:
            end = second.name if second.far else second.mark.name
            name = f"({first.mark.name}{end})"
            if not second.far:
                because = why.KENNEDY_LINE
                line = self.draw(join, name, first.mark, second.mark, why=because)
            elif self.draft.uses(second.mark)[0] == first.mark:
                line = second.mark
            else:
                line = self.draw(parallel, name, first.mark, second.mark, why=why.TO_INFINITY)
            self._lines[key] = line
        return self._lines[key]

    def ray(self, pole: Mark, image: Mark) -> Mark:
        """Draw the line of a velocity on its plan, once."""
        if image not in self._rays:
            name = f"(p{image.name})"
            self._rays[image] = self.draw(join, name, pole, image, why=why.VELOCITY)
        return self._rays[image]

    def by_normals(
        self, link: int, points: Mapping[Mark, Mark], pole: Mark, *, turned: bool
    ) -> bool:
        """Find P_i0 of a link by the velocities of its points; ``points``: to the marks of their images."""
        letter, ways = letter_of(self.pair(link, self.frame)), dict[Mark, Line]()
        for k, image in points.items():
            if image != pole:
                with np.errstate(all="ignore"):
                    off = self.values[image] - self.values[pole]
                    ways[k] = Line(self.values[k], (1.0 if turned else 1j) * off / np.abs(off))
        tried = ((self._crossing(*map(ways.get, pair)), pair) for pair in combinations(ways, 2))
        found = [(*crossing, pair) for crossing, pair in tried if crossing is not None]
        lines = list[Mark]()
        _, far, pair = max(found, default=(0.0, False, None), key=lambda k: k[0])
        if pair is not None:
            for k in pair:
                ray = self.ray(pole, points[k])
                op = parallel if turned else square
                lines.append(self.draw(op, f"(⊥v_{k.name})", k, ray, why=why.NORMAL))
            mark = lines[0]
            if not far:
                mark = self.draw(meet, letter, *lines, free=True, why=why.TWO_NORMALS)
        else:
            pair = next((p for p in combinations(points, 2) if points[p[0]] != points[p[1]]), None)
            if pair is None:
                return False
            uses = (*pair, *(points[k] for k in pair), pole)
            mark = self.draw(similar, letter, *uses, free=True, why=why.IMAGE)
        way = NORMALS if lines else IMAGE
        self.enter(Centre(self.pair(link, self.frame), mark, far, way, (), tuple(lines)))
        return True

    def by_rates(self, plan: Motion) -> None:
        """Find what is missing where both links turn about centres that are there: by their ω of the plan."""
        for links in self.missing:
            ends = [self.finite(k, self.frame) for k in links]
            rates = [plan.rates[k] for k in links if k in plan.rates]
            there = [mark for mark in ends if mark is not None]
            if len(there) < 2 or len(rates) < 2 or there[0] == there[1]:
                continue
            called, name = "".join(mark.name for mark in there), letter_of(links)
            line = self.draw(join, f"({called})", *there, why=why.DIVIDED)
            whole = self.draw(measure_along, called, *there, line)
            part = self.draw(f.divided, f"{there[0].name}{name}", whole, *rates)
            mark = self.draw(lay_off, name, line, part, free=True, why=why.DIVIDED)
            self.enter(Centre(links, mark, False, RATES, (), (line,)))


class Scheme:
    """The scheme of centres: points of the plan of positions as they stand in it, each carried over once."""

    def __init__(self, draft: Draft, plans: KinematicPlans, network: Network, mu: Mark) -> None:
        self.draft, self.plans, self.network, self.mu = draft, plans, network, mu
        self.points: dict[Mark, Mark] = {}
        assert plans.velocities is not None
        self.velocities: Motion = plans.velocities

    def point(self, of: Mark) -> Mark:
        """Return a point of the plan of positions in the scheme."""
        if of not in self.points:
            factors = self.draft.mu_l, self.mu
            self.points[of] = self.network.draw(carry_over, of.letter, of, *factors, free=True)
        return self.points[of]

    def images(self, link: int) -> Mapping[Mark, Mark]:
        """Return the points of a link in the scheme, with their images on the plan of velocities."""
        body, images = self.plans.positions.bodies[link], self.velocities.images.by_letter[link]
        return {
            self.point(mark): images[letter]
            for letter, mark in body.marks.items()
            if letter in images and letter in body.link.points
        }

    def primary(self) -> None:
        """Enter the centres of all pairs."""
        pinned: dict[str, list[int]] = {}
        for number, body in self.plans.positions.bodies.items():
            for letter in body.link.points:
                pinned.setdefault(letter, []).append(number)
        for letter, links in pinned.items():
            for both in combinations(links, 2):
                mark = self.point(self.plans.positions.bodies[both[0]].marks[letter])
                self.network.enter(Centre(self.network.pair(*both), mark, False, PIN))
        for wheel in self.plans.positions.wheels:
            if wheel.span is None:
                pair = self.network.pair(wheel.rolling.on, wheel.leg.link)
                self.network.enter(Centre(pair, self.point(wheel.pitch), False, WHEEL))
        for first, second, through, guide in self._guides():
            pair = self.network.pair(first, second)
            if pair not in self.network.centres:
                if guide not in self.network.values:
                    self.network.values |= trial_values(self.draft, [guide])
                name = f"({through.name}{letter_of(pair)})"
                line = self.network.draw(square, name, through, guide, why=why.AT_INFINITY)
                self.network.enter(Centre(pair, line, True, GUIDE))

    def _guides(self) -> Iterator[tuple[int, int, Mark, Mark]]:
        """Yield two links that slide on each other, a point of the scheme there, the line of the guide."""
        positions, mechanism = self.plans.positions, self.plans.mechanism
        along = dict[tuple[int, int], Mark]()
        for closing in positions.closings:
            for leg in closing.legs:
                if isinstance(leg, GuideLeg):
                    along[leg.link, leg.on] = leg.line
                elif isinstance(leg, PinLeg) and leg.rod:
                    yield leg.link, leg.rod, self.point(leg.pivot), leg.line
        for pair in self.plans.pairs:
            if isinstance(pair, Slider):
                along[pair.link, mechanism.frame.number] = pair.path(positions, self.draft.uses)
        for number, body in positions.bodies.items():
            for slide in body.link.slides:
                if self.network.of(number, slide.on) is not None:
                    continue
                marks = [*body.marks.values(), *positions.bodies[slide.on].marks.values()]
                through = self.point(marks[0])
                line = along.get((number, slide.on)) or self._drawn(slide, through)
                yield number, slide.on, through, line

    def _drawn(self, slide: Slide, through: Mark) -> Mark:
        """Draw a guide that no plan has drawn yet."""
        body = self.plans.positions.bodies[slide.on]
        bend = slide.guide.angle - body.angle
        return incline_by(self.draft, slide.guide.name, through, body.axis, bend)


def trial_values(draft: Draft, marks: Sequence[Mark]) -> dict[Mark, Any]:
    """Return marks in the positions of the row, at 1 m and 1 m/s a mm."""
    log = draft.board.construction()
    reading = execute(log, {**dict.fromkeys(log.given, 1.0), **draft.given}, marks)
    return {mark: reading[mark] for mark in marks}
