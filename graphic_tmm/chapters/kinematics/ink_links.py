"""The links of a plan of positions in ink: each as what it is, in any of its positions.

The points of a link make its rigid figure, a rod or a plate. A guide of its own is a line rigidly joined to it,
as long as the stone's whole path over the turn; the stone stands on it, turned with it. A cylinder is a tube
about its guide, in which a piston stands on its rod. A main line of a link is as long in one position as in any
other. All of it is ink of bodies: it stands on the marks of its link.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import NamedTuple

import shapely

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Construction, Figure, Mark
from graphic_tmm.chapters.kinematics.figures import CONTENTS, SLIDING, rigid
from graphic_tmm.chapters.kinematics.ink_cylinder import Placed, cylinder
from graphic_tmm.chapters.kinematics.ink_supports import supports
from graphic_tmm.chapters.kinematics.reaches import VIEW, Reach
from graphic_tmm.paper.arithmetic import bearing, coordinates, decided, larger, smaller
from graphic_tmm.paper.drawing import Ink, Stroke, circle, line
from graphic_tmm.paper.figure import body
from graphic_tmm.paper.labels import TOGETHER
from graphic_tmm.paper.symbols.kinematic import (
    PISTON_WIDTH,
    SLIDER_WIDTH,
    STONE_WIDTH,
    guide,
    rigid_joint,
    slider,
    stone,
    turning_pair,
)
from graphic_tmm.paper.traced import value_at
from graphic_tmm.readers.equations import ends_of

MAIN = ("rod", "main")
"""Pens of rods and of guides in a main position: a rod runs over what slides, a guide under it."""
WIDTHS = {"slider": SLIDER_WIDTH, "stone": STONE_WIDTH, "piston": PISTON_WIDTH}
"""Of what slides, mm."""
OVERRUN = 12.0
"""How far a guide of the frame goes on behind the outermost places of its slider, mm."""
THROUGH = 9.0
"""How far a guide of a moving link does behind its stone, mm."""
CENTRE_RADIUS = 0.9
"""A mass centre is a small circle, mm."""
HELD = 8.0
"""A guide that its link holds no farther off, mm, has no filled corner: it would hide the pair there."""
ACROSS = 0.25
"""Sine of the least angle (14°) between two lines that hold a point of a link; less
reads as one line; chosen by eye."""
POINT_RADIUS = 1.1
"""A point of a link that is neither a pair nor a mass centre is a dot, mm."""


class Bar(NamedTuple):
    """A guide of a moving link in one position: its ends, where the link holds it, and the holding point."""

    ends: tuple[complex, complex]
    foot: complex
    holder: complex


class LinksInk:
    """The links of the log and their numbers while they are inked."""

    def __init__(
        self, construction: Construction, reading: Reading, reaches: Mapping[Figure, Reach]
    ) -> None:
        self.construction, self.reading, self.reaches = construction, reading, reaches
        self.figures = [f for f in construction.figures if f.view == VIEW]
        count = Counter(
            mark for f in self.figures if f.kind in ("link", "frame") for mark in f.marks
        )
        self.joined = {mark for mark, times in count.items() if times > 1}
        self.frame = next(f for f in self.figures if f.kind == "frame")
        tubes = {f.marks: f for f in self.figures if f.kind in CONTENTS}
        self.tubes = {
            f.marks[:2]: f for f in self.figures if f.kind == "guide" and f.marks[:2] in tubes
        }

    @property
    def names(self) -> tuple[str, ...]:
        """The numbers of the moving links."""
        return tuple(f.name for f in self.figures if f.kind == "link")

    def of(self, name: str, *kinds: str) -> Iterator[Figure]:
        """Yield what is told of a link."""
        return (f for f in self.figures if f.name == name and f.kind in kinds)

    def at(self, mark: Mark, index: int) -> complex:
        """Return where a point is in one position."""
        return value_at(self.reading[mark], index)

    def way(self, line: Mark, index: int) -> complex:
        """Return the direction of a line in one position."""
        return value_at(self.reading[line].along, index)

    def along(self, figure: Figure, index: int) -> complex:
        """Return the direction of a guide or of what slides on it, in one position."""
        _, path, *side = figure.marks
        sense = value_at(self.reading[side[0]], index) if side else 1.0
        return value_at(self.reading[path].along, index) * sense

    def spots(self, name: str, index: int) -> list[complex]:
        """Return where the points of a link's rigid figure are."""
        return [self.at(mark, index) for mark in rigid(self.figures, name)]

    def bars(self, name: str, index: int) -> list[Bar]:
        """Return the guides of a moving link."""
        spots, found = self.spots(name, index), []
        for figure in self.of(name, "guide"):
            if figure in self.tubes.values():
                continue
            reach, way = self.reaches[figure], self.along(figure, index)
            foot, holder = self._held(figure, index)
            lift = ((foot - holder) / way).imag
            own = [(z - holder) / way for z in spots]
            ends = [z.real for z in own if abs(z.imag - lift) <= TOGETHER]
            ends += [0.0, reach.low - THROUGH, reach.high + THROUGH]
            found.append(
                Bar((foot + smaller(*ends) * way, foot + larger(*ends) * way), foot, holder)
            )
        return found

    def _held(self, figure: Figure, index: int) -> tuple[complex, complex]:
        """Return where a guide of a moving link is held: on it, and at the point of its link."""
        way, through = self.along(figure, index), self.foot(figure, index)
        holder = self.spots(figure.name, index)[self.reaches[figure].anchor]
        return holder + 1j * ((through - holder) / way).imag * way, holder

    @cached_property
    def supports(self) -> dict[Mark, float]:
        """By how much the support of each fixed pivot is turned, degrees; see `supports`."""
        pivots = [mark for mark in self.frame.marks if mark in self.joined]
        rails = [self.rail(figure) for figure in self.of(self.frame.name, "guide")]
        return supports(self.figures, self.reading, pivots, rails)

    def cylinder(self, figure: Figure, index: int) -> Placed:
        """Return the cylinder in which a piston slides or that a guide is, in one position."""
        guide = self.tubes[figure.marks[:2]]
        foot, _ = self._held(guide, index)
        return cylinder(self.reaches[guide]).place(foot, self.along(guide, index))

    def _tubes(self, name: str, index: int) -> list[tuple[Figure, Placed]]:
        """Return what is told of the cylinders that a link is, and each of them in one position."""
        return [(one, self.cylinder(one, index)) for one in self.of(name, *CONTENTS)]

    def rods(self, name: str, index: int, *, heavy: bool = True) -> list[Bar]:
        """Return the rods of a link's pistons, each from the pin, or a point behind it, to the piston.

        ``heavy``: the piston is drawn, else only where its middle is.
        """
        spots, found = self.spots(name, index), []
        for figure in self.of(name, "piston"):
            pin, placed = self.foot(figure, index), self.cylinder(figure, index)
            own = [(z - pin) / placed.way for z in spots]
            behind = smaller(0.0, *(z.real for z in own if abs(z.imag) <= TOGETHER))
            end = placed.face(pin) if heavy else placed.piston(pin)
            found.append(Bar((pin + behind * placed.way, end), pin, pin))
        return found

    def foot(self, figure: Figure, index: int) -> complex:
        """Return where a stone stands on its line: at its point, or at the foot of a square from there."""
        at, path, *_ = figure.marks
        spot, way = self.at(at, index), value_at(self.reading[path].along, index)
        through = value_at(self.reading[path].at, index)
        return through + ((spot - through) / way).real * way

    def marks(self, name: str) -> list[Mark]:
        """Return the marks that a link stands on: its points, its guides, where it slides on others."""
        told = self.of(name, "guide", *SLIDING)
        return [*rigid(self.figures, name), *(mark for one in told for mark in one.marks)]

    def lines(self, name: str, index: int, pens: tuple[str, str]) -> list[Ink]:
        """Return the main lines of a link; ``pens``: of its rods, and of its guides. Tubes are drawn `MAIN`."""
        made, marks = self._lines(name, index, pens), self.marks(name)
        tubes = [s for _, one in self._tubes(name, index) for s in one.tube() if pens == MAIN]
        return [*body(made, "link", marks, index), *body(tubes, "cylinder", marks, index)]

    def _lines(self, name: str, index: int, pens: tuple[str, str]) -> list[Stroke]:
        bars, spots = self.bars(name, index), self.spots(name, index)
        made: list[Stroke] = [line(pens[1], *bar.ends) for bar in bars]
        made += [
            line(pens[0], bar.holder, bar.foot)
            for bar in bars
            if abs(bar.holder - bar.foot) > TOGETHER
        ]
        for figure in self.of(name, *SLIDING):
            spot, foot = self.at(figure.marks[0], index), self.foot(figure, index)
            if abs(spot - foot) > TOGETHER:
                made.append(line(pens[0], spot, foot))
        rods = self.rods(name, index, heavy=pens == MAIN)
        made += [line(pens[0], *rod.ends) for rod in rods]
        if (tubes := self._tubes(name, index)) and pens == MAIN:
            return made + [held for _, one in tubes for held in one.held(spots, pens[0])]
        axes = [one.axis(self.foot(figure, index)) for figure, one in tubes]
        made += [line(pens[0], *ends) for ends in axes if abs(ends[1] - ends[0]) > TOGETHER]
        held = any(all(_on(spot, bar) for spot in spots) for bar in (*bars, *rods))
        if arms := self.arms(name, index):
            return made + [stroke for arm in arms for stroke in rigid_figure(arm, pens[0])]
        return made if held else made + rigid_figure(spots, pens[0])

    def arms(self, name: str, index: int) -> list[list[complex]]:
        """Return where the points of the arms of a link are; none of a link without arms."""
        return [[self.at(mark, index) for mark in arm.marks] for arm in self.of(name, "arm")]

    def notches(self, name: str, index: int) -> list[Ink]:
        """Return a notch across the guide wherever a slider or a stone stands in a thin position."""
        made = list[Ink]()
        for figure in self.of(name, *SLIDING):
            half = WIDTHS[figure.kind] / 2
            foot, way = self.foot(figure, index), self.along(figure, index)
            if figure.kind == "piston":
                foot = self.cylinder(figure, index).piston(foot)
            notch = line("thin", foot - 1j * half * way, foot + 1j * half * way)
            made += body([notch], figure.kind, figure.marks, index)
        return made

    def symbols(self, names: Sequence[str], index: int) -> list[Ink]:
        """Return the sliders, stones, rigid corners, pairs, points and mass centres of links."""
        made = list[Ink]()
        for name in names:
            made += self.ties(name, index)
            made += body(self.corners(name, index), "link", self.marks(name), index)
            for figure in self.of(name, *SLIDING):
                made += body(self._sliding(figure, index), figure.kind, figure.marks, index)
            for figure, placed in self._tubes(name, index):
                made += body(placed.filled(figure.kind), "cylinder", figure.marks, index)
                if named(figure):
                    axis = line("centre", *placed.guide(self.foot(figure, index)))
                    made += body([axis], "guide", figure.marks, index)
            made += self.centre(name, index)
        marks = dict.fromkeys(m for name in names for f in self.of(name, "link") for m in f.marks)
        for mark in marks:
            made += self.point(mark, index)
        return made

    def _sliding(self, figure: Figure, index: int) -> Iterable[Stroke]:
        """Return the sign of what slides."""
        foot = self.foot(figure, index)
        if figure.kind == "piston":
            return self.cylinder(figure, index).head(foot)
        angle = bearing(self.along(figure, index))
        return (slider if figure.kind == "slider" else stone)(foot, angle, pin=False)

    def point(self, mark: Mark, index: int | None) -> list[Ink]:
        """Return the sign of a point: a turning pair, or an ordinary point of its link; None: of the frame."""
        at = self.at(mark, index or 0)
        if mark in self.joined:
            return [*body(turning_pair(at), "pair", [mark], index)]
        tubes = {f.name for f in self.figures if f.kind in CONTENTS}
        over = any(mark in f.marks for name in tubes for f in self.of(name, "link"))
        pen = "rod" if over else "main"
        return [*body([circle(pen, at, POINT_RADIUS, filled=True)], "point", [mark], index)]

    def corners(self, name: str, index: int) -> list[Stroke]:
        """Return the filled corners where a guide and the rest of its link are one, if there is room."""
        made = list[Stroke]()
        spots = self.spots(name, index)
        first, *others = self.arms(name, index) or [[]]
        for arm in others:
            made += _welded(first, arm)
        for bar in self.bars(name, index):
            off = [z for z in (bar.holder, *spots) if abs(z - bar.foot) >= HELD and not _on(z, bar)]
            along = max((end - bar.foot for end in bar.ends), key=abs)
            for other in off[:1]:
                made += rigid_joint(bar.foot, along, other - bar.foot)
        return made

    def centre(self, name: str, index: int) -> list[Ink]:
        """Return the mass centre of a link."""
        made = list[Ink]()
        for figure in self.of(name, "centre"):
            spot = self.at(figure.marks[0], index)
            made += body([circle("joint", spot, CENTRE_RADIUS)], "centre", figure.marks, index)
        return made

    def ties(self, name: str, index: int) -> list[Ink]:
        """Return what joins a mass centre to its link where it lies off its ink.

        Thin lines from two of its points; of a link that has no line of its own, a rod.
        """
        made = list[Ink]()
        for figure in self.of(name, "centre"):
            spot = self.at(figure.marks[0], index)
            spots = self.spots(name, index)
            inked: list[Sequence[complex]] = [bar.ends for bar in self.bars(name, index)]
            inked += [rod.ends for rod in self.rods(name, index)]
            inked += [tube.corners for _, tube in self._tubes(name, index)]
            inked += [spots] if spots else []
            ink = shapely.union_all(
                [shapely.MultiPoint(coordinates(part)).convex_hull for part in inked]
            )
            if ink.distance(shapely.Point(*coordinates([spot]))) > 2 * CENTRE_RADIUS:
                pen = "main" if len(inked) == len(spots) == 1 else "thin"
                ties = [line(pen, end, spot) for end in spots[:2]]
                made += body(ties, "centre", [*self.marks(name), *figure.marks], index)
        return made

    def guides(self) -> list[Ink]:
        """Return the guides of the frame, over the travel of their sliders, hatched on the far side."""
        made = list[Ink]()
        for figure in self.of(self.frame.name, "guide"):
            made += body(guide(*self.rail(figure)), "guide", figure.marks[1:2])
        return made

    def rail(self, figure: Figure) -> tuple[complex, complex]:
        """Return the ends of a guide of the frame."""
        reach, path = self.reaches[figure], figure.marks[1]
        way, through = self.along(figure, 0), value_at(self.reading[path].at, 0)
        anchor = self.spots(self.frame.name, 0)[reach.anchor]
        foot = through + ((anchor - through) / way).real * way
        return foot + (reach.low - OVERRUN) * way, foot + (reach.high + OVERRUN) * way


def named(guide: Figure) -> str:
    """Return the name that a guide bears on a plan; two letters of points are none."""
    name = guide.marks[1].name.rstrip("′").strip("()")
    return "" if len(ends_of(name)) > 1 else name


def _on(spot: complex, bar: Bar) -> bool:
    """Whether a point lies on the line of a bar."""
    way = bar.ends[1] - bar.ends[0]
    return abs(((spot - bar.ends[0]) / way).imag) * abs(way) <= TOGETHER


def _welded(first: Sequence[complex], second: Sequence[complex]) -> list[Stroke]:
    """Return the filled corner in which two arms of a link are one, if there is room."""
    at = next((z for z in second if any(abs(z - y) <= TOGETHER for y in first)), None)
    if at is None:
        return []
    ways = [max((z - at for z in arm), key=abs) for arm in (first, second)]
    return list(rigid_joint(at, *ways, times=1.5)) if min(map(abs, ways)) >= HELD else []


def rigid_figure(spots: Sequence[complex], pen: str) -> list[Stroke]:
    """Return the line between points, or the outline of those out of line, every one held by it."""
    apart = [z for k, z in enumerate(spots) if all(abs(z - y) > TOGETHER for y in spots[:k])]
    if len(apart) < 2:
        return []
    far = max(
        ((a, b) for k, a in enumerate(apart) for b in apart[k + 1 :]),
        key=lambda ends: round(abs(ends[1] - ends[0]), 6),
    )
    way = (far[1] - far[0]) / abs(far[1] - far[0])
    if all(abs(((z - far[0]) / way).imag) <= TOGETHER for z in apart):
        return [line(pen, *far)]
    edge = shapely.MultiPoint(coordinates(apart)).convex_hull.boundary
    own = dict(zip(coordinates(apart), apart, strict=True))
    corners = [own[x, y] for x, y in shapely.get_coordinates(edge)[:-1].tolist()]
    # wherever the link lies, its outline begins with the same point
    first = min(range(len(corners)), key=lambda k: apart.index(corners[k]))
    corners = [*corners[first:], *corners[:first]]
    decided(*_hull(corners, apart))
    made = [line(pen, *corners, closed=True)]
    for spot in apart:
        if edge.distance(shapely.Point(*coordinates([spot]))) > TOGETHER:
            made.append(line(pen, *_tied(spot, corners)))
    return made


def _hull(corners: Sequence[complex], spots: Sequence[complex]) -> Iterator[bool]:
    """Yield the comparisons by which an outline has its corners: all lies on its right."""
    for a, b in zip(corners, (*corners[1:], corners[0]), strict=True):
        yield from (((z - a) * (b - a).conjugate()).imag > TOGETHER for z in spots)


def _tied(spot: complex, corners: Sequence[complex]) -> tuple[complex, complex, complex]:
    """Return a point inside an outline between the two corners that hold it: the nearest, the nearest across.

    By one line alone it would read as a link that turns at the corner.
    """
    first, *others = sorted(corners, key=lambda z: round(abs(z - spot), 6))

    def across(corner: complex) -> bool:
        way = (corner - spot) / (first - spot)
        return abs(way.imag) > ACROSS * abs(way)

    return first, spot, next(filter(across, others), others[0])
