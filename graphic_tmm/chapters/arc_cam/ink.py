"""A cam given by arcs in ink: its contour, the circles of the construction, the follower going round it.

What the steps leave is rubbed out but for the centres' circles; contours, rollers, levers and faces are bodies.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.arc_cam.contour import VIEW, Arc
from graphic_tmm.chapters.arc_cam.formulas import line_on_arc, on_arc, turn_between
from graphic_tmm.chapters.arc_cam.plan import ArcCam
from graphic_tmm.chapters.cam.ink import TURN, shaft
from graphic_tmm.chapters.cam.operations import slant
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, arc, circle, line
from graphic_tmm.paper.figure import body, figure, showing
from graphic_tmm.paper.labels import Named, shared
from graphic_tmm.paper.seen import Seen, Subject, finite
from graphic_tmm.paper.symbols.dimensions import ARROW
from graphic_tmm.paper.symbols.kinematic import arrowhead, channel, fixed_pivot

TRACELESS = frozenset({on_arc.name, line_on_arc.name, slant.name, turn_between.name})
"""Operations that leave no trace: what only chooses, angles measured with the protractor."""
BEYOND, DOT, PIN = 4.0, 0.4, 1.2
"""How far a guide goes on behind its roller, radius of a point, of the roller's pin, mm."""
ROD, GUIDE, WIDTH = 30.0, 14.0, 5.0
"""Length of the rod above its roller, of its guide, width of the rod, mm."""
CROSS = 5.0
"""How far centre lines go on behind the contour, mm."""
LED, ROOMY, AT = 12.0, 30.0, 0.65
"""How long the leader of a radius is, mm; about what radius, mm, it has room inside; where on its arc it ends:
no ray of a position leads there along it. In the middle on the base, where there are none."""
LEAST = 0.02
"""What is shorter is no arc, mm."""


class ArcNames(NamedTuple):
    """What is lettered: the positions; the radii with their values, by the arcs' names; the roller's."""

    positions: Sequence[str]
    radii: dict[str, str]
    omega: str = "ω_{1}"


class ContourInk(Seen):
    """The view of the contour and its numbers while it is inked."""

    def __init__(self, on: Subject, made: ArcCam) -> None:
        super().__init__(on.construction, on.reading, (VIEW,), range(len(made.angles)))
        self.made, self.heights = made, on.heights
        self.points = self.all(made.follower.points)

    def length(self, mark: Mark | None) -> float:
        """Return a length that does not vary, mm; 0 for none."""
        return self.fixed_number(mark) if mark is not None else 0.0

    def near(self, mark: Mark) -> bool:
        """Whether a centre stands among what is drawn; a flank's may be far off."""
        return abs(self.fixed_place(mark)) <= float(np.nanmax(np.abs(self.points)))

    @property
    def roller(self) -> float:
        """The radius of the roller on the drawing."""
        base = self.made.contour.arcs["base"]
        return self.length(base.reach) - self.length(base.radius)


def draw_contour_ink(on: Subject, made: ArcCam, names: ArcNames) -> Drawing:
    """Return the contour with its follower in reversed motion."""
    ink = ContourInk(on, made)
    traces = figure(ink, showing({}))
    strokes = [
        *traces.staying,
        *contour_body(ink),
        *contour_ways(ink),
        *_inverted(ink),
        *_lowest(ink),
    ]
    reach = float(np.nanmax(np.abs(ink.points))) + CROSS
    strokes += shaft(made.contour.origin, reach, made.sense)
    radii = {name: _radius(ink, name) for name in names.radii}
    strokes += [stroke for one in radii.values() for stroke in one.strokes]
    told = [Wanted(names.radii[name], *one.text) for name, one in radii.items()]
    wanted = [*_letters(ink, names), *told, *_numbers(ink, names.positions)]
    return traces.drawing(on, strokes, wanted, (), enumerate(names.positions))


def from_to(pen: str, centre: complex, start: complex, end: complex, sense: int) -> list[Ink]:
    """Return the arc about a centre from one place to another; none where it has no length."""
    if not finite(centre, start, end):
        return []
    radius = abs(start - centre)
    if radius < LEAST:
        return []
    begin = math.degrees(cmath.phase(start - centre))
    turn = (sense * math.degrees(cmath.phase((end - centre) / (start - centre)))) % 360.0
    if turn * radius < LEAST or turn > 360.0 - 1e-6:
        return []
    return [arc(pen, centre, radius, begin, sense * turn)]


def contour_body(ink: ContourInk) -> Iterator[Ink]:
    """The contour: base circle, flanks, nose, each from where it touches the one before; or one circle."""
    contour, sense = ink.made.contour, -ink.made.sense
    if ink.made.order.eccentric:
        nose = contour.arcs["nose"]
        yield from _whole(ink, nose, nose.radius, "main", "contour")
        return
    spots = [ink.fixed_place(mark) for mark in contour.touches]
    ends = {"base": (3, 0), "rise": (0, 1), "nose": (1, 2), "return": (2, 3)}
    for name, (start, end) in ends.items():
        one = contour.arcs[name]
        of = [contour.touches[start], contour.touches[end]]
        if one.centre is None:
            yield from body([line("main", spots[start], spots[end])], "contour", of)
            continue
        turned = -sense if one.hollow else sense
        made = from_to("main", ink.fixed_place(one.centre), spots[start], spots[end], turned)
        yield from body(made, "contour", [one.centre, *of])


def _whole(ink: ContourInk, one: Arc, radius: Mark | None, pen: str, part: str) -> Iterator[Ink]:
    """The whole circle about the centre of an arc."""
    assert one.centre is not None
    assert radius is not None
    made = [circle(pen, ink.fixed_place(one.centre), ink.fixed_number(radius))]
    yield from body(made, part, [one.centre, radius])


def contour_ways(ink: ContourInk) -> Iterator[Ink]:
    """What the roller's centre goes along, the base circle in full, the centres of the arcs."""
    contour = ink.made.contour
    base = contour.arcs["base"]
    assert base.centre is not None
    assert base.radius is not None
    whole = circle("thin", ink.fixed_place(base.centre), ink.fixed_number(base.radius))
    yield from body([whole], "circle", [base.centre, base.radius])
    if ink.roller > 0.0 and not ink.made.order.flat:
        yield from _pitch(ink)
    for one in contour.arcs.values():
        if one.centre is not None and one.name != "base" and ink.near(one.centre):
            dot = circle("main", ink.fixed_place(one.centre), DOT, filled=True)
            yield from body([dot], "pivot", [one.centre])


def _pitch(ink: ContourInk) -> Iterator[Ink]:
    """The path of the roller's centre: each arc goes on from where the one before it ended."""
    contour, sense = ink.made.contour, -ink.made.sense
    if ink.made.order.eccentric:
        yield from _whole(ink, contour.arcs["nose"], contour.arcs["nose"].reach, "medium", "path")
        return
    touches = [ink.fixed_place(mark) for mark in contour.touches]
    flanks = [contour.arcs[name] for name in ("rise", "rise", "return", "return")]
    low = [touches[0], touches[0], touches[3], touches[3]]
    spots = [
        spot + ink.roller * _outward(ink, flank, spot, near)
        for flank, spot, near in zip(flanks, touches, low, strict=True)
    ]
    ends = {"base": (3, 0), "rise": (0, 1), "nose": (1, 2), "return": (2, 3)}
    for name, (start, end) in ends.items():
        one = contour.arcs[name]
        of = [mark for mark in (one.way, contour.touches[start], contour.touches[end]) if mark]
        if one.centre is None:
            yield from body([line("medium", spots[start], spots[end])], "path", of)
            continue
        turned = -sense if one.hollow else sense
        made = from_to("medium", ink.fixed_place(one.centre), spots[start], spots[end], turned)
        yield from body(made, "path", of)


def _outward(ink: ContourInk, flank: Arc, spot: complex, low: complex) -> complex:
    """Return the direction out of the cam at a place of a flank; ``low``: where it touches the base."""
    if flank.centre is None:
        return low / abs(low)
    way = spot - ink.fixed_place(flank.centre)
    return (-way if flank.hollow else way) / abs(way)


def _inverted(ink: ContourInk) -> Iterator[Ink]:
    """Guides, rollers, levers, faces in all positions."""
    follower, contour = ink.made.follower, ink.made.contour
    lines = ink.reading[follower.guides]
    starts = np.broadcast_to(lines.at[0], ink.points.shape)
    ways = np.broadcast_to(lines.along[0], ink.points.shape)
    pivots = ink.all(follower.pivots) if follower.pivots is not None else None
    contacts = ink.all(follower.contacts) if follower.contacts is not None else None
    for k, at in enumerate(map(complex, ink.points)):
        if not finite(at):
            continue
        if pivots is not None and follower.pivots is not None:
            pivot = complex(pivots[k])
            strokes: list[Ink] = [circle("thin", pivot, 0.8)]
            if contacts is None:
                strokes.append(line("thin", pivot, at))
            yield from body(strokes, "lever", [follower.pivots, follower.points], k)
        else:
            top = at + (ink.roller + BEYOND) * complex(ways[k])
            rod = [line("thin", complex(starts[k]), top)]
            yield from body(rod, "guide", [follower.guides, follower.points], k)
        if contacts is not None and follower.contacts is not None and pivots is not None:
            face = lever_face(complex(pivots[k]), at, complex(contacts[k]), "thin")
            yield from body(face, "face", [follower.points, follower.contacts], k)
        elif contacts is not None and follower.contacts is not None:
            half = (abs(complex(contacts[k]) - at) + 2 * BEYOND) * 1j * complex(ways[k])
            face = [line("thin", at - half, at + half)]
            yield from body(face, "face", [follower.points, follower.contacts], k)
        elif ink.roller > 0.0:
            base = contour.arcs["base"].reach
            assert base is not None
            made = [circle("thin", at, ink.roller)]
            yield from body(made, "roller", [follower.points, base], k)
    if follower.pivots is not None and finite(pivot := complex(ink.all(follower.pivots)[0])):
        yield from body([circle("thin", 0j, abs(pivot))], "circle", [follower.pivots])


def lever_face(pivot: complex, at: complex, contact: complex, pen: str) -> list[Ink]:
    """Return the face of a lever through its contact, and the arm to it from the pivot."""
    way, off = (at - pivot) / abs(at - pivot), contact - at
    return [
        line(pen, pivot + off, contact + 2 * BEYOND * way),
        *([line(pen, pivot, pivot + off)] if abs(off) > LEAST else []),
    ]


def _lowest(ink: ContourInk) -> Iterator[Ink]:
    """The follower in the first position in full."""
    follower, start = ink.made.follower, complex(ink.points[0])
    if not finite(start):
        return
    of, flat = [follower.points], ink.made.order.flat
    if ink.roller > 0.0 and not flat:
        pins: list[Ink] = [circle("main", start, ink.roller), circle("joint", start, PIN)]
        yield from body(pins, "roller", of, 0)
    if follower.pivots is not None:
        pivot = complex(ink.all(follower.pivots)[0])
        strokes: list[Ink] = [*fixed_pivot(pivot)]
        if flat and follower.contacts is not None:
            strokes += lever_face(pivot, start, complex(ink.all(follower.contacts)[0]), "main")
            of.append(follower.contacts)
        else:
            strokes.append(line("main", pivot, start))
        yield from body(strokes, "lever", [follower.pivots, *of], 0)
        return
    if flat:
        wide = 0.5 * float(np.nanmax(np.abs(ink.points))) + BEYOND
        yield from body([line("main", start - wide, start + wide)], "face", of, 0)
    yield from body(
        rod(start, ink.roller, pointed=not flat and ink.roller <= 0.0), "follower", of, 0
    )


def rod(at: complex, roller: float, *, pointed: bool, length: float = ROD) -> list[Ink]:
    """Return the rod of a follower that slides, upright in its guide; ``roller``: its radius, mm."""
    half, top = 0.5 * WIDTH, at + 1j * (length + roller)
    corners = [at - half, at + half, top + half, top - half]
    if pointed:
        corners = [at, at + half + 1j * WIDTH, top + half, top - half, at - half + 1j * WIDTH]
    guide = channel(top - 0.5j * GUIDE - 4j, 90.0, GUIDE, width=WIDTH)
    return [line("body", *corners, closed=True), *guide]


def _letters(ink: ContourInk, names: ArcNames) -> Iterator[Wanted]:
    """The letters of the centres, the radii beside their arcs."""
    contour, high = ink.made.contour, ink.heights
    free = complex(-ink.made.sense)
    yield Wanted("O", 0j, high.point, 2.5, 1j - free, (contour.origin.slot,))
    yield Wanted(
        "C", ink.fixed_place(contour.nose), high.point, 1.0, -1j - free, (contour.nose.slot,)
    )
    for one in contour.arcs.values():
        if one.name in ("rise", "return") and one.centre is not None and ink.near(one.centre):
            spot = ink.fixed_place(one.centre)
            yield Wanted(one.centre.name, spot, high.point, 1.0, spot, (one.centre.slot,))
    out = cmath.rect(1.0, math.radians(90.0 - ink.made.sense * 145.0))
    yield Wanted(names.omega, TURN * out, high.point, 1.0, out, (contour.origin.slot,))


class _Radius(NamedTuple):
    """The leader of a radius; what its text names, as `Wanted` has it: point, height, clear, way, marks."""

    strokes: tuple[Ink, ...]
    text: tuple[complex, float, float, complex, tuple[int, ...]]


def _radius(ink: ContourInk, name: str) -> _Radius:
    """Return the leader of an arc's radius: towards its centre, or from outside where that is too near."""
    contour = ink.made.contour
    one, spots = contour.arcs[name], [ink.fixed_place(mark) for mark in contour.touches]
    assert one.centre is not None
    assert one.radius is not None
    ends = {"base": (3, 0), "rise": (0, 1), "nose": (1, 2), "return": (2, 3)}[name]
    start, end = (spots[k] - ink.fixed_place(one.centre) for k in ends)
    radius, turned = abs(start), ink.made.sense if one.hollow else -ink.made.sense
    whole = (turned * cmath.phase(end / start)) % (2 * math.pi) or 2 * math.pi
    share = 0.5 if name == "base" else AT
    out = start / radius * cmath.exp(1j * turned * share * whole)
    spot, inside = ink.fixed_place(one.centre) + radius * out, radius >= ROOMY
    tail = spot + LED * (-out if inside else out)
    way = spot - tail
    strokes = body(
        [line("thin", tail, spot), *arrowhead(spot, way, pen="thin", length=ARROW)],
        "dimension",
        [one.radius, one.centre],
    )
    return _Radius(tuple(strokes), (tail, ink.heights.number, 0.8, -way, (one.radius.slot,)))


def _numbers(ink: ContourInk, names: Sequence[str]) -> Iterator[Wanted]:
    """The numbers of the positions, behind the rollers."""
    follower, named = ink.made.follower, []
    lines = ink.reading[follower.guides]
    ways = np.broadcast_to(lines.along[0], ink.points.shape)
    pivots = ink.all(follower.pivots) if follower.pivots is not None else None
    for k, (name, at) in enumerate(zip(names, ink.points, strict=True)):
        spot = complex(at) + (ink.roller + BEYOND) * complex(ways[k])
        if pivots is not None:
            spot = complex(pivots[k])
        if k and finite(spot):
            named.append(Named(spot, name, (follower.points.slot,), k))
    for one in shared(named):
        at = one.at
        yield Wanted(one.text, at, ink.heights.number, 0.8, at, one.of, one.position)
