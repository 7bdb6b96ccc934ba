"""Numbers and names about a plan of positions: of links, of positions along every path, of guides.

A link bears its number in a thin circle with a line to it. The numbers of the positions stand at the crank pin,
at every slider and at every end of a rocker; those within the height of a number share a label. A guide bears
at both ends the name that the equations call it by.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from itertools import combinations, pairwise
from types import MappingProxyType
from typing import NamedTuple

import numpy as np
import shapely

from graphic_tmm.board.record import Figure, Mark
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.kinematics.figures import SLIDING
from graphic_tmm.chapters.kinematics.ink_links import MAIN, LinksInk, named
from graphic_tmm.paper.drawing import Ink, Label, Stroke, Wanted, circle, line
from graphic_tmm.paper.figure import body
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.shapes import box, shape
from graphic_tmm.paper.symbols.kinematic import (
    FOOT_HEIGHT,
    GROUND_LENGTH,
    SLIDER_LENGTH,
    SLIDER_WIDTH,
    STONE_LENGTH,
    STONE_WIDTH,
)

PIN = 1.2
"""How far a pin of a thin position reaches, with some room, mm."""
CLOSE = 2.4
"""A position nearer than twice this to its crank pin, mm, bears no number beside that of the pin."""
FIELD = 1.5
"""Rows of numbers stand in one field where what their points enclose comes so near, in heights of a number."""
TICK, RIVAL = 6.0, 40.0
"""Half of the line across a path where a number stands, mm; of those farther off, mm, none is taken for it."""
MOST, RANGE = 2, "…"
"""Of more positions than this that follow each other a label gives first and last, and this between them."""
ROUND = 0.85
"""Radius of the circle about the number of a link, of the height of its figure."""
LEAST = 6.0
"""A shorter line of a link bears no number, mm."""
BOX = {
    "slider": complex(SLIDER_LENGTH, SLIDER_WIDTH) / 2,
    "stone": complex(STONE_LENGTH, STONE_WIDTH) / 2,
}
"""Half the length and the width of what slides, mm."""
LIGHTER = ("thin", "dashed", "centre", "paper")
"""Pens whose lines a circle may hide."""
SHARES = (0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8)
"""Where along a line of the link the number is tried."""
AWAY = (3.0, 5.0, 8.0, 12.0, 17.0)
"""How far from the link the circle is tried, mm; chosen by eye."""
KEPT = 7.0
"""Room for a letter about a point, mm."""
HEAVY, LIGHT, LETTER, FAR = 60.0, 3.0, 40.0, 1.0
"""What it costs to cross a heavy or a thin line or the room of a letter, and to stand a millimetre off."""


class Numbered(NamedTuple):
    """The number of a link as it stands: circle, line to the link, figure."""

    strokes: tuple[Ink, ...]
    label: Label


def path_numbers(
    ink: LinksInk,
    crank: tuple[Mark, Mark],
    names: Sequence[str],
    places: Sequence[int],
    first: Sequence[int],
    letters: Letters,
) -> Iterator[Wanted]:
    """Yield the numbers of positions along the paths of sliders and rocker ends.

    ``first``: the positions numbered before all others, the main one at their head. What stands on the crank
    pin of its own position bears no number.
    """
    size = letters.small
    order = [*first, *(k for k in places if k not in first)]
    for path in _paths(ink, crank):
        ticks = {k: path.aside(k) for k in order}
        clear = [k for k, (z, _) in ticks.items() if abs(z - ink.at(crank[1], k)) >= 2 * CLOSE]
        groups = together([ticks[k][0] for k in clear], size)
        drawn = [_ticks([ticks[clear[i]] for i in group]) for group in groups]
        for group, own in zip(groups, drawn, strict=True):
            found = [clear[i] for i in group]
            spots = [ticks[k][0] for k in found]
            middle, away = sum(spots) / len(spots), ticks[found[0]][1]
            others = tuple(one for one in drawn if one is not own and abs(one[0] - own[0]) < RIVAL)
            told, high = letters.of(path.mark, _listed(names, found))
            of = (path.mark.slot,)
            yield Wanted(told, middle, high, path.reach, away, of, max(found), own, others)


class Letters(NamedTuple):
    """How numbers of positions are lettered: bare, or behind the letters of their points, A₀, A₁, … C₀.

    ``small``, ``large``: heights of bare numbers and of letters whose indices are as high, mm.
    """

    small: float
    large: float
    behind: bool = False

    def of(self, mark: Mark, number: str) -> tuple[str, float]:
        """Return the number of a mark as it is lettered, and how high."""
        letter = markup(mark.name)
        if not self.behind or "_" in letter:
            return number, self.small
        return f"{letter}_{{{number}}}", self.large


def letters_apart(
    ink: LinksInk,
    crank: tuple[Mark, Mark],
    names: Sequence[str],
    places: Sequence[int],
    heights: tuple[float, float],
) -> Letters:
    """Return how numbers are lettered: behind letters where two rows of them stand in one field.

    ``heights``: of numbers and of letters of points, mm. They stay bare where a point is called A1 itself.
    """
    small, large = heights
    fields = [[ink.at(crank[1], k) for k in places]]
    fields += [[path.aside(k)[0] for k in places] for path in _paths(ink, crank)]
    hulls = [
        shapely.MultiPoint([(z.real, z.imag) for z in spots if cmath.isfinite(z)]).convex_hull
        for spots in fields
    ]
    near = any(one.dwithin(other, FIELD * small) for one, other in combinations(hulls, 2))
    points = {markup(mark.name) for figure in ink.figures for mark in figure.marks}
    rows = (crank[1], *(path.mark for path in _paths(ink, crank)))
    taken = any(f"{markup(m.name)}_{{{names[k]}}}" in points for m in rows for k in places)
    return Letters(small, large, near and not taken)


def together(spots: Sequence[complex], within: float) -> list[list[int]]:
    """Return points in groups, those nearest each other first: none holds two farther apart than ``within``.

    Of points alike up to a scale the groups of the one are made of whole groups of the other.
    """
    z = np.array(spots, dtype=complex)
    away = np.round(np.abs(z[:, None] - z), 6)
    group = {k: [k] for k in range(len(spots))}
    pairs = np.argwhere(np.triu(away <= within, 1))
    for i, j in sorted(pairs.tolist(), key=lambda pair: (away[*pair], pair)):
        one, other = group[i], group[j]
        if one is not other and (away[np.ix_(one, other)] <= within).all():
            one += other
            group |= dict.fromkeys(other, one)
    found = {id(one): one for one in group.values()}
    return [sorted(one) for one in sorted(found.values(), key=min)]


def _ticks(ends: Sequence[tuple[complex, complex]]) -> tuple[complex, ...]:
    """Return lines across a path where positions stand that share a number, as one line."""
    first, last = (f(ends, key=lambda one: (one[0].real, one[0].imag)) for f in (min, max))
    corners = [z + side * TICK * way / abs(way) for z, way in (first, last) for side in (-1, 1)]
    return (*corners[:2], *corners[:1:-1])


def _listed(names: Sequence[str], found: Sequence[int]) -> str:
    """Return the numbers of positions that share a label; of many that follow each other, first and last."""
    runs: list[list[int]] = []
    for k in sorted(found):
        if runs and _follows(names[runs[-1][-1]], names[k]):
            runs[-1].append(k)
        else:
            runs.append([k])
    told = [
        [names[run[0]] + RANGE + names[run[-1]]] if len(run) > MOST else [names[k] for k in run]
        for run in runs
    ]
    return ", ".join(name for run in told for name in run)


def _follows(one: str, other: str) -> bool:
    """Whether a position is the next one of the row."""
    return one.isdecimal() and other.isdecimal() and int(other) == int(one) + 1


class Path(NamedTuple):
    """What is numbered beside the crank pin: its mark; how far its sign reaches, mm.

    ``aside``: a position (index) -> where it stands then, and to which side its number goes.
    """

    mark: Mark
    reach: float
    aside: Callable[[int], tuple[complex, complex]]


def _paths(ink: LinksInk, crank: tuple[Mark, Mark]) -> Iterator[Path]:
    for slid in (one for one in ink.figures if one.kind == "slider"):
        box, aside = BOX[slid.kind], partial(_off_guide, ink, slid)
        yield Path(slid.marks[0], box.imag, aside)
    for pivot, pin in _ends(ink, crank):
        yield Path(pin, PIN, partial(_outside, ink, pivot, pin))


def _off_guide(ink: LinksInk, slid: Figure, k: int) -> tuple[complex, complex]:
    """Beside a guide, off its hatching."""
    return ink.foot(slid, k), 1j * ink.along(slid, k)


def _outside(ink: LinksInk, pivot: Mark, pin: Mark, k: int) -> tuple[complex, complex]:
    """Outside the arc on which the end of a rocker moves."""
    at = ink.at(pin, k)
    return at, at - ink.at(pivot, k)


def _ends(ink: LinksInk, crank: tuple[Mark, Mark]) -> Iterator[tuple[Mark, Mark]]:
    """Yield the pivot and each further pair of a link that turns on the frame, but for the crank."""
    seen = {one.marks[0] for one in ink.figures if one.kind == "slider"} | {crank[1]}
    for link in (one for one in ink.figures if one.kind == "link"):
        pivot = next((mark for mark in link.marks if mark in ink.frame.marks), None)
        for pin in link.marks if pivot is not None else ():
            if pin in ink.joined and pin not in ink.frame.marks and pin not in seen:
                assert pivot is not None
                seen.add(pin)
                yield pivot, pin


def guide_names(ink: LinksInk, main: int, size: float) -> Iterator[Wanted]:
    """Yield the names of guides at their ends, as the equations call them."""
    told = set[tuple[str, complex]]()
    for guide in (one for one in ink.figures if one.kind == "guide"):
        path, name = guide.marks[1], named(guide)
        if not name:
            continue
        fixed = guide.name == ink.frame.name
        rails = [ink.rail(guide)] if fixed else [bar.ends for bar in ink.bars(guide.name, main)]
        ways = [way for ends in rails for way in (ends, ends[::-1])]
        if guide.marks[:2] in ink.tubes:
            ways = [ink.cylinder(guide, main).guide(ink.foot(guide, main))[::-1]]
        for end, other in ways:
            key = (name, complex(round(end.real, 3), round(end.imag, 3)))
            if key not in told:
                told.add(key)
                place = None if fixed else main
                yield Wanted(markup(name), end, size, 0.5, end - other, (path.slot,), place)


def link_numbers(
    ink: LinksInk,
    main: int,
    strokes: Sequence[Ink],
    letters: Sequence[Wanted],
    size: float,
    names: Sequence[str] = (),
    lines: Mapping[str, tuple[complex, complex]] = MappingProxyType({}),
) -> list[Numbered]:
    """Return the numbers of links in circles, clear of what is drawn and of where letters will stand.

    ``names``: of these links; left out, of all of them and of the frame. ``lines``: of links with none else.
    """
    heavy = [shape(one) for one in strokes if one.pen not in LIGHTER]
    light = [shape(one) for one in strokes if one.pen in LIGHTER]
    spots = shapely.MultiPoint([(one.at.real, one.at.imag) for one in letters])
    made = []
    for name in names or (*ink.names, ink.frame.name):
        tried = [*_tried(ink, name, main)]
        tried = tried or [
            *(_along(*lines[name]) if name in lines else _about_wheels(ink, name, main))
        ]
        if not tried:
            continue
        costs = _costs(tried, heavy, light, spots, ROUND * size)
        at, way, _ = tried[int(np.argmin(np.round(costs, 6)))]
        centre = at + way * (1.0 + ROUND * size / abs(way))
        marks = ink.frame.marks if name == ink.frame.name else ink.marks(name)
        place = None if name == ink.frame.name else main
        made.append(_circled(name, at, centre, size, marks, place))
        heavy.append(shape(made[-1].strokes[0]))
        heavy.append(shape(made[-1].strokes[1]))
    return made


Tried = tuple[complex, complex, float]
"""Where a line leaves its link, the way to the circle (mm), what it costs to be off the middle."""


def _tried(ink: LinksInk, name: str, main: int) -> Iterator[Tried]:
    """Yield where the number of a link may stand: beside its lines, about its slider, beside a fixed pivot."""
    if name == ink.frame.name:
        for mark, angle in ink.supports.items():
            turn = cmath.rect(1.0, math.radians(angle))
            for side in (turn, -turn):
                foot = ink.at(mark, main) + side * GROUND_LENGTH / 2 - 1j * turn * FOOT_HEIGHT
                yield from ((foot, side * away, 0.0) for away in AWAY)
        return
    for stroke in ink.lines(name, main, MAIN):
        assert isinstance(stroke, Stroke)
        corners = [complex(x, y) for x, y, _ in stroke.path]
        for a, b in pairwise([*corners, *corners[:1]] if stroke.closed else corners):
            if abs(b - a) >= LEAST:
                yield from _along(a, b)
    for slid in (one for one in ink.of(name, *SLIDING) if one.kind in BOX):
        yield from _about(ink.foot(slid, main), ink.along(slid, main), BOX[slid.kind])


def _about_wheels(ink: LinksInk, name: str, main: int) -> Iterator[Tried]:
    """All about the pitch circles of a link."""
    for wheel in ink.of(name, "wheel"):
        centre, pitch = (ink.at(mark, main) for mark in wheel.marks)
        for turn in range(0, 360, 15):
            out = cmath.rect(1.0, math.radians(turn))
            yield from ((centre + out * abs(pitch - centre), out * away, 0.0) for away in AWAY)


def _along(a: complex, b: complex) -> Iterator[Tried]:
    """Both sides of a line."""
    for share in SHARES:
        at, off = a + share * (b - a), 6.0 * abs(share - 0.5)
        for normal in (1j, -1j):
            way = normal * (b - a) / abs(b - a)
            yield from ((at, way * away, off) for away in AWAY)


def _about(middle: complex, way: complex, half: complex) -> Iterator[Tried]:
    """All about a slider, of half its length and width, that lies along ``way``."""
    for turn in range(0, 360, 15):
        out = cmath.rect(1.0, math.radians(turn))
        reach = min(half.real / max(abs(out.real), 1e-9), half.imag / max(abs(out.imag), 1e-9))
        at = middle + out * way * reach
        yield from ((at, out * way * away, 2.0) for away in AWAY)


def _costs(
    tried: Sequence[Tried],
    heavy: Sequence[shapely.Geometry],
    light: Sequence[shapely.Geometry],
    spots: shapely.Geometry,
    radius: float,
) -> Reals:
    """Return what each place costs: lines crossed by the circle and the line to it, letters, the way."""
    at, way, off = (np.asarray(row) for row in zip(*tried, strict=True))
    one = way / np.abs(way)
    centre, near, far = at + way + one * radius, at + 0.8 * one, at + way
    middles = shapely.points(centre.real, centre.imag)
    ends = [[near.real, near.imag], [far.real, far.imag]]
    links = shapely.linestrings(np.moveaxis(np.asarray(ends), 2, 0))
    costs = off.real + FAR * np.abs(way)
    for shapes, weight in ((heavy, HEAVY), (light, LIGHT)):
        tree = shapely.STRtree(shapes)
        crossed = tree.query(middles, predicate="dwithin", distance=radius + 1.0)[0]
        met = tree.query(links, predicate="intersects")[0]
        for hits in (crossed, met):
            costs = costs + weight * np.bincount(hits, minlength=len(tried))
    room = (shapely.distance(middles, spots) - radius) / KEPT
    return np.asarray(costs + LETTER * np.clip(1.0 - np.nan_to_num(room, nan=1.0), 0.0, 1.0))


def _circled(
    name: str, at: complex, centre: complex, size: float, marks: Sequence[Mark], place: int | None
) -> Numbered:
    """Return a number in its circle, which hides thin lines under it, and the line from its link."""
    radius = ROUND * size
    edge = centre + (at - centre) / abs(at - centre) * radius
    ring = [circle("thin", centre, radius), circle("paper", centre, radius), line("thin", at, edge)]
    of = tuple(dict.fromkeys(mark.slot for mark in marks))
    label = Label(name, centre, size, "middle", of=of, position=place)
    middle = box(label).centroid
    label = label._replace(at=2 * centre - complex(middle.x, middle.y))
    return Numbered(tuple(body(ring, "number", marks, place)), label)
