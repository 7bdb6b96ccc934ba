"""A plan of positions as its ink tells it, judged against poses by the vector loops.

What is seen is taken from the strokes of the sheet that is written. A heavy line is one of a link if it moves
with that link: turned into the link's own axes and out again in another position, it lies on what is drawn.
"""

from __future__ import annotations

import cmath
import math
import re
from functools import cached_property
from itertools import pairwise

import shapely

from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.mechanism.records import Link, Slide
from graphic_tmm.paper.drawing import Drawing, Sheet, Stroke
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.shapes import box
from graphic_tmm.paper.symbols.kinematic import GROUND_LENGTH
from support.oracle import Pose, solve_from_points

CLOSE = 0.01
"""Ink that is farther from its place, mm, is elsewhere."""
MERGED = 0.36
"""Points nearer to a line than this are taken for points of it, mm."""
GAP = 1.25
"""Thin lines are broken so far about a letter: 0.4 mm, and a rest of up to 0.8 mm is left out."""


class Seen:
    """The plan of positions of a sheet, and the poses of the links by the vector loops (mm on that sheet)."""

    def __init__(self, work: Drawn, paper: tuple[Sheet, ...]) -> None:
        self.work, self.mechanism = work, KINEMATICS_PLAN.on(work).mechanism
        self.view: Drawing = next(d for s in paper for d in s.drawings if d.name == "positions")
        self.mu = work.scales["positions"].value
        names = work.project.names
        self.places = [k for k in range(len(names)) if k not in work.undrawn]
        self.point = heights(work.scene, "positions").point
        told = (re.sub(r"^[A-Z]_\{(.*)\}$", r"\1", label.text) for label in self.view.labels)
        texts = {number for text in told for number in text.split(", ")}
        assert texts >= {part for k in self.places for part in names[k].split(", ")}
        self.poses = {k: self.pose(k) for k in self.places}

    def pose(self, place: int) -> dict[int, Pose]:
        """Solve the vector loops from what the plan shows, which must be where they close."""
        start = {}
        origin = self.mechanism.frame.points[KINEMATICS_PLAN.on(self.work).structure.origin]
        for body in KINEMATICS_PLAN.on(self.work).positions.bodies.values():
            for letter in body.link.points:
                row = self.work.reading[body.marks[letter]][0]
                start[letter] = origin + row[place if row.size > 1 else 0] * self.mu
        angle = self.work.project.coordinates[place]
        state = solve_from_points(self.mechanism, angle, start, tolerance=1e-6)
        return {**state.pose, self.mechanism.frame.number: (0.0, 0.0, 0.0)}

    @cached_property
    def shift(self) -> complex:
        """Where the crank's pivot stands on the sheet: in the middle of the crank circle."""
        structure = KINEMATICS_PLAN.on(self.work).structure
        crank = self.mechanism.by_number[structure.first.link].points
        radius = abs(crank[structure.first.pin] - crank[structure.origin]) / self.mu
        centres = [
            centre for centre, size in self.arcs("thin") if abs(size - radius) < 1e-6 * radius
        ]
        (found,) = {complex(round(z.real, 5), round(z.imag, 5)) for z in centres}
        return found - self.mechanism.frame.points[structure.origin] / self.mu

    def strokes(self, *pens: str) -> list[Stroke]:
        """Strokes of pens; what only joins a mass centre to its link is no line of it."""
        there = (s for s in self.view.strokes if isinstance(s, Stroke))
        return [s for s in there if s.pen in pens and (s.closed or s.part != "centre")]

    def arcs(self, *pens: str) -> list[tuple[complex, float]]:
        """Centres and radii of the arcs of pens: a circle is broken where a letter stands on it."""
        found = []
        for stroke in self.strokes(*pens):
            ends = [*stroke.path, *stroke.path[:1]] if stroke.closed else stroke.path
            for (x1, y1, bulge), (x2, y2, _) in pairwise(ends):
                if bulge:
                    a, b, turn = complex(x1, y1), complex(x2, y2), 4 * math.atan(bulge)
                    centre = (b - a * cmath.exp(1j * turn)) / (1 - cmath.exp(1j * turn))
                    found.append((centre, abs(a - centre)))
        return found

    def lines(self, *pens: str) -> list[tuple[complex, complex]]:
        """The straight lines of pens, seen from the frame's axes (mm)."""
        found = []
        for stroke in self.strokes(*pens):
            if stroke.filled or any(bulge for *_, bulge in stroke.path):
                continue
            z = [complex(x, y) - self.shift for x, y, _ in stroke.path]
            found += list(zip(z, z[1:] + z[:1] * stroke.closed, strict=False))
        return found

    def circles(self, radius: float, *pens: str) -> list[complex]:
        found = [s.path for s in self.strokes(*pens) if s.closed and len(s.path) == 2]
        return [
            complex(a[0] + b[0], a[1] + b[1]) / 2 - self.shift
            for a, b in found
            if abs(abs(complex(b[0] - a[0], b[1] - a[1])) / 2 - radius) < 1e-6
        ]

    def boxes(self) -> list[tuple[complex, complex]]:
        """Sliders and stones: their middle, and the direction of their long side."""
        found = []
        for stroke in self.strokes("body"):
            z = [complex(x, y) - self.shift for x, y, _ in stroke.path]
            assert len(z) == 4
            found.append((sum(z) / 4, (z[1] - z[0]) / abs(z[1] - z[0])))
        return found

    def seen(self, number: int, own: complex, place: int) -> complex:
        """Where a point of a link (own axes, mm) is in one position."""
        x, y, turn = self.poses[place][number]
        return complex(x, y) / self.mu + own * cmath.rect(1.0, turn)

    def own(self, number: int, spot: complex, place: int) -> complex:
        x, y, turn = self.poses[place][number]
        return (spot - complex(x, y) / self.mu) * cmath.rect(1.0, -turn)

    @cached_property
    def main(self) -> int:
        """The position in heavy lines, found by the pins: all of them stand on white circles."""
        pins = self.circles(1.5, "joint")

        def off(place: int) -> float:
            return sum(
                min(abs(self.seen(link.number, z / self.mu, place) - pin) for pin in pins)
                for link in self.mechanism.links
                for letter, z in link.points.items()
                if letter in self.shared
            )

        return min(self.places, key=off)

    @cached_property
    def shared(self) -> set[str]:
        bodies = list(self.mechanism.by_number.values())
        letters = [k for body in bodies for k in body.points]
        return {k for k in letters if letters.count(k) > 1}

    @cached_property
    def thin(self) -> shapely.Geometry:
        """All thin lines and those of extremes, with their breaks at letters closed, and what hides them."""
        lines = [_line(*ends) for ends in self.lines("thin", "medium")]
        hidden = [
            shapely.affinity.translate(box(label), -self.shift.real, -self.shift.imag)
            for label in self.view.labels
        ]
        return shapely.union_all(
            [shapely.buffer(g, CLOSE) for g in lines] + [shapely.buffer(g, GAP) for g in hidden]
        )

    def moves_with(self, number: int, ends: tuple[complex, complex]) -> bool:
        """Whether a line of the main position is drawn at its place in every other one."""
        own = [self.own(number, z, self.main) for z in ends]
        for place in self.places:
            if place == self.main:
                continue
            due = _line(*(self.seen(number, z, place) for z in own))
            if due.difference(self.thin).length > CLOSE:
                return False
        return True

    @cached_property
    def heavy(self) -> dict[tuple[complex, complex], set[int]]:
        """The heavy lines that are not the frame's, each with the links that it moves with."""
        found = {}
        bars = [
            ends
            for ends in self.lines("main")
            if abs(ends[0] - ends[1]) > GROUND_LENGTH + CLOSE
            and not any(_along(self, ends, slide) for slide in self.fixed)
        ]
        for ends in [*self.lines("rod"), *bars]:
            links = {k.number for k in self.mechanism.links if self.moves_with(k.number, ends)}
            found[ends] = links
        return found

    @cached_property
    def fixed(self) -> list[tuple[Link, Slide]]:
        frame = self.mechanism.frame.number
        return [(k, s) for k in self.mechanism.links for s in k.slides if s.on == frame]


def _line(a: complex, b: complex) -> shapely.LineString:
    return shapely.LineString([(a.real, a.imag), (b.real, b.imag)])


def _off(spot: complex, ends: tuple[complex, complex]) -> float:
    return float(shapely.distance(_line(*ends), shapely.Point(spot.real, spot.imag)))


def _along(seen: Seen, ends: tuple[complex, complex], pair: tuple[Link, Slide]) -> bool:
    """Whether a heavy line is a guide of the frame: its direction, and the whole travel of its slider."""
    link, slide = pair
    way = cmath.rect(1.0, math.radians(slide.guide.angle))
    run = (ends[1] - ends[0]) / way
    if abs(run.imag) > CLOSE:
        return False
    home = seen.own(link.number, (ends[0] + ends[1]) / 2, seen.main)
    levels = [((seen.seen(link.number, home, k) - ends[0]) / way).imag for k in seen.places]
    return max(map(abs, levels)) < CLOSE


def judge(seen: Seen) -> None:
    """Say what is wrong with a plan of positions."""
    loose = {ends: links for ends, links in seen.heavy.items() if not links}
    assert not loose, f"heavy lines that change: {loose}"
    letters(seen)
    stones(seen)
    for link in seen.mechanism.links:
        own = [ends for ends, links in seen.heavy.items() if link.number in links]
        held = [k for k in link.points if k != link.centre or k in seen.shared]
        spots = {k: seen.seen(link.number, link.points[k] / seen.mu, seen.main) for k in held}
        apart = max((abs(a - b) for a in spots.values() for b in spots.values()), default=0.0)
        if apart > 2 * MERGED:
            for letter, spot in spots.items():
                off = min((_off(spot, ends) for ends in own), default=math.inf)
                assert off < MERGED, (link.number, letter)
        if not own:
            rides = bool(link.slides) or any(
                s.on == link.number for k in seen.mechanism.links for s in k.slides
            )
            assert rides, f"link {link.number} has no ink"


def letters(seen: Seen) -> None:
    """Every point is lettered, and is what it is: a pair, a mass centre, or a point."""
    told = {
        part.replace("_{", "").replace("}", "")
        for label in seen.view.labels
        if label.size == seen.point
        for part in label.text.split(", ")
    }
    for link in seen.mechanism.by_number.values():
        for letter, own in link.points.items():
            assert letter in told, letter
            spot = seen.seen(link.number, own / seen.mu, seen.main)
            if letter in seen.shared:
                drawn = seen.circles(1.5, "joint")
            elif letter == link.centre:
                drawn = seen.circles(0.9, "joint")
            else:
                drawn = seen.circles(1.1, "main")
            assert min(abs(spot - z) for z in drawn) < CLOSE, (letter, link.number)


def stones(seen: Seen) -> None:
    """On every guide there is a stone, turned with it, fixed in its link, with a notch in every position."""
    boxes = seen.boxes()
    pairs = [(k, s) for k in seen.mechanism.links for s in k.slides]
    assert len(boxes) == len(pairs)
    for link, slide in pairs:
        angle = math.radians(slide.guide.angle) + seen.poses[seen.main][slide.on][2]
        found = [
            at
            for at, way in boxes
            if abs((way / cmath.rect(1.0, angle)).imag) < 1e-6 and rides(seen, at, link, slide)
        ]
        assert found, f"no stone of link {link.number} on link {slide.on}"


def rides(seen: Seen, at: complex, link: Link, slide: Slide) -> bool:
    """Whether a stone in the main position is seen on its guide in all of them."""
    own = seen.own(link.number, at, seen.main)
    bars = [ends for ends, links in seen.heavy.items() if slide.on in links]
    if slide.on == seen.mechanism.frame.number:
        bars = [ends for ends in seen.lines("main") if _along(seen, ends, (link, slide))]
    for bar in bars:
        home = [seen.own(slide.on, z, seen.main) for z in bar]
        if all(
            _off(seen.seen(link.number, own, k), tuple(seen.seen(slide.on, z, k) for z in home))
            < CLOSE
            for k in seen.places
        ):
            break
    else:
        return False
    for place in seen.places:
        spot, turn = seen.seen(link.number, own, place), seen.poses[place][slide.on][2]
        across = 2.4j * cmath.rect(1.0, math.radians(slide.guide.angle) + turn)
        notch = _line(spot - across, spot + across)
        if place != seen.main and notch.difference(seen.thin).length > CLOSE:
            return False
    return True
