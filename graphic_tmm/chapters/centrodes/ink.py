"""Centrodes in ink: the fixed one in a main line, the moving one dashed, both tangent in one position."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.operations.curve import bezier
from graphic_tmm.board.record import Construction, Step
from graphic_tmm.board.values import Line, Point
from graphic_tmm.chapters.centrodes import operations as o
from graphic_tmm.chapters.centrodes.record import Centrodes, Side
from graphic_tmm.chapters.centrodes.scales import window_of
from graphic_tmm.paper.clipping import points
from graphic_tmm.paper.drawing import Bezier, Drawing, Ink, Wanted, arc, circle, line
from graphic_tmm.paper.figure import Manner, body, figure
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.seen import Rule, Seen, Subject, finite
from graphic_tmm.paper.symbols.dimensions import arrow
from graphic_tmm.paper.symbols.kinematic import fixed_pivot, turning_pair

FIXED, MOVING = "main", "dashed"
"""Pens of both centrodes."""
DOT = 0.7
"""Radius of the dot of a centre, mm."""
PIVOT = 3.0
"""How far the symbols of pivots and pins reach, mm."""
CHORDS = 3
"""Chords of each arc of a centrode that rolls on the page."""
TANGENT = 40.0
"""Half the length of the common tangent, mm."""
AWAY, NICK = 9.0, 2.5
"""Length of an arrow to a centre outside; half an arc of the compass about where it was cut, mm."""


class CentrodesInk(Seen):
    """The view of a link's centrodes while it is inked."""

    def __init__(
        self, log: Construction, reading: Reading, made: Centrodes, places: list[int]
    ) -> None:
        super().__init__(log, reading, (made.view,), places)
        self.made, self.window = made, window_of(made, reading)

    def holds(self, spot: complex) -> bool:
        """Whether a place is shown."""
        return finite(spot) and bool(self.window.holds(np.asarray(spot)))

    def straight(self, pen: str, start: complex, end: complex) -> Iterator[Ink]:
        """A straight line as far as it is shown."""
        part = self.window.segment(start, end) if finite(start, end) else None
        if part is not None and part[0] != part[1]:
            yield line(pen, *part)

    def branches(self, side: Side) -> list[tuple[complex, ...]]:
        """The branches of a centrode as far as they are shown."""
        runs = bezier(self.reading[side.curve])
        return [part for run in runs for part in self.window.parts([complex(z) for z in run])]

    def curve(self, side: Side, pen: str) -> Iterator[Ink]:
        """A centrode."""
        for part in self.branches(side):
            yield Bezier(pen, part, side.curve.name)

    def pose(self, side: Side, k: int) -> tuple[complex, complex]:
        """Return the turn and the shift of a body from where it stands in the drawing to a position."""
        if not side.points:
            return 1.0 + 0j, 0j
        a, b = (self.point(mark, 0) for mark in side.stood)
        p, q = (self.point(mark, k) for mark in side.points)
        turn = (q - p) / (b - a)
        return turn, p - a * turn

    def rolled(self, k: int) -> Iterator[Ink]:
        """The moving centrode, link, normals and centre in a position, seen from what it rolls on."""
        made = self.made
        (turn, shift), (own, far) = (self.pose(side, k) for side in made.sides)
        if not finite(turn, shift, own, far):
            return

        def there(spot: complex) -> complex:
            return (spot - shift) / turn

        for part in self.branches(made.moving):
            spots = points(part, CHORDS * (len(part) // 3) + 1)
            yield line(MOVING, *(there(own * complex(z) + far) for z in spots))
        pins, centre = [self.point(m, k) for m in made.moving.points], self.point(made.centre, k)
        yield line("main", *map(there, pins))
        for pin in pins:
            yield from turning_pair(there(pin))
            yield from self.straight("thin", there(pin), there(centre))
        if self.holds(there(centre)):
            yield circle(FIXED, there(centre), DOT, filled=True)

    def normals(self, k: int) -> Iterator[Ink]:
        """Both normals in a position, from what they begin at to the centre."""
        centre = self.point(self.made.centre, k)
        for mark, pin in zip(self.made.normals, self.made.moving.points, strict=True):
            start, at = self.line(mark, k)[0], self.point(pin, k)
            yield from self.straight("thin", start, at)
            if finite(centre):
                yield from self.straight("thin", at, centre)
            elif finite(at):
                along = self.line(mark, k)[1] * 2.0 * self.window.reach
                yield from self.straight("thin", at - along, at + along)


def draw_centrodes(
    on: Subject, made: Centrodes, names: Sequence[str], places: list[int]
) -> Drawing:
    """Return both centrodes of a link in one drawing; ``places``: the positions (indices) that are drawn."""
    ink, at = CentrodesInk(on.construction, on.reading, made, places), made.touching
    traces = figure(ink, _manner(ink))
    strokes: list[Ink] = [*traces.staying, *_pivots(ink)]
    for k in places:
        for side, filled in ((made.fixed, True), (made.moving, False)):
            spot = ink.point(side.centre, k)
            dot = [circle(FIXED, spot, DOT, filled=True) if filled else circle("thin", spot, DOT)]
            strokes += body(dot if ink.holds(spot) else (), "centre", [side.centre], k)
    strokes += body(ink.normals(at), "normal", made.normals, at)
    for side in made.sides:
        strokes += body(_bar(ink, side, at), "link", side.points, at)
    outside = [_outside(ink, k, names[k], on.heights.number) for k in places]
    strokes += [stroke for drawn, _ in outside for stroke in drawn]
    wanted = [*_letters(ink, names, on), *(one for _, some in outside for one in some)]
    return traces.drawing(on, strokes, wanted, (), [(k, names[k]) for k in places])


def _manner(ink: CentrodesInk) -> Manner:
    """Both curves and the tangent stay; what helped is rubbed out, and is drawn only as far as it is shown."""
    made = ink.made

    def lined(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        at, along = seen.line(step.it, k)
        used = [use.it for use in seen.uses.get(step.it, ()) if use.it.kind is Point]
        marks = [*(mark for mark in step.uses if mark.kind is Point), *used]
        spots = [seen.point(mark, k) for mark in marks if mark.view == made.view]
        ways = [0.0, *(((z - at) / along).real for z in spots if finite(z, at, along))]
        yield from ink.straight("thin", at + min(ways) * along, at + max(ways) * along)

    def pricked(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        spot = seen.point(step.it, k)
        if ink.holds(spot):
            yield circle("thin", spot, DOT / 2.0)

    def struck(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        spot = seen.point(step.it, k)
        for mark in step.uses[:2]:
            away = spot - seen.point(mark, 0)
            if ink.holds(spot) and abs(away) > 2.0 * NICK:
                half = math.degrees(NICK / abs(away))
                start = math.degrees(cmath.phase(away)) - half
                yield arc("thin", spot - away, abs(away), start, 2.0 * half)

    def touched(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        at, along = seen.line(step.it, k)
        yield from ink.straight("thin", at - TANGENT * along, at + TANGENT * along)

    def drawn(side: Side, pen: str) -> Rule:
        return lambda seen, step, k: ink.curve(side, pen)

    rules: dict[str, Rule] = {
        step.op.name: lined if step.it.kind is Line else pricked
        for step in ink.steps
        if step.it.kind in (Line, Point)
    }
    rules |= {o.swing_over.name: struck, o.curve_tangent.name: touched}
    curves = {
        made.fixed.curve: drawn(made.fixed, FIXED),
        made.moving.curve: drawn(made.moving, MOVING),
    }
    stays = (*curves, made.fixed.tangent)
    return Manner(rules, lambda seen, step: step.it in stays, curves)


def draw_fixed(ink: CentrodesInk) -> list[Ink]:
    """Return what stands as the moving centrode rolls: the fixed one, pivots."""
    side = ink.made.fixed
    pivots = () if side.points else _pivots(ink)
    return [*body(ink.curve(side, FIXED), "curve", [side.curve]), *pivots]


def _pivots(ink: CentrodesInk) -> Iterator[Ink]:
    for mark in ink.made.pivots:
        spot = ink.fixed_place(mark)
        yield from body(fixed_pivot(spot) if ink.holds(spot) else (), "pivot", [mark])


def _bar(ink: CentrodesInk, side: Side, k: int) -> Iterator[Ink]:
    """The two points of a link in a position, and the link between them."""
    spots = [ink.point(mark, k) for mark in side.points]
    if spots and finite(*spots):
        yield line("main", *spots)
        for spot in spots:
            yield from turning_pair(spot)


def _outside(ink: CentrodesInk, k: int, name: str, size: float) -> tuple[list[Ink], list[Wanted]]:
    """Return the arrow that points to a centre outside the drawing, and its number."""
    made = ink.made
    centre, start = ink.point(made.fixed.centre, k), ink.point(made.moving.points[0], k)
    if made.fixed.points:
        start = ink.point(made.touch, 0)
    if not finite(centre, start) or ink.holds(centre):
        return [], []
    part = ink.window.segment(start, centre)
    if part is None or abs(part[1] - part[0]) < AWAY:
        return [], []
    tip, way = part[1], (part[1] - part[0]) / abs(part[1] - part[0])
    strokes = body(arrow(tip - AWAY * way, tip, "thin"), "outside", [made.fixed.centre], k)
    slots = (made.fixed.centre.slot,)
    return [*strokes], [Wanted(name, tip, size, 1.0, toward=way, of=slots, position=k)]


def _letters(ink: CentrodesInk, names: Sequence[str], on: Subject) -> Iterator[Wanted]:
    made, high = ink.made, on.heights
    at, ends = made.touching, [mark for side in made.sides for mark in side.points]
    pins = [Named(ink.point(m, at), m.name, (m.slot,), at) for m in ends if m not in made.pivots]
    pins += [Named(ink.fixed_place(mark), mark.name, (mark.slot,)) for mark in made.pivots]
    pins = shared(one for one in pins if ink.holds(one.at))
    yield from lettered(pins, high.point, PIVOT)
    spot, along = ink.line(made.fixed.tangent, 0)
    yield Wanted("τ", spot + TANGENT * along, high.number, of=(made.fixed.tangent.slot,))
    spots = [
        Named(spot, f"{names[k]}{prime}", (side.centre.slot,), k)
        for side, prime in ((made.fixed, ""), (made.moving, "′"))
        for k in ink.positions
        if ink.holds(spot := ink.point(side.centre, k))
    ]
    yield from lettered(shared(spots), high.number, DOT)
