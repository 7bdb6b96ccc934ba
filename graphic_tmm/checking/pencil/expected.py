"""What should be on a sheet: of each view its points, the straight lines through them, their rings.

The log's own ink tells: a stroke knows its position, a point where it stands; which lines go through which
points is plane geometry. Lines that cover one another are one line of pencil.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.hand import Hand
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Complexes, Point, Reals
from graphic_tmm.board.values import Line as Drawable
from graphic_tmm.checking.cells import pointed
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.paper.drawing import Drawing, Sheet, Stroke

Name = tuple[str, str, str]
"""Plan, letter, position."""
ON = 0.3
"""A point is on a line that passes it as near, mm."""
HEAD = 6.0
"""The line of a vector ends in its head, so far from its point at most, mm."""
SHORTEST = 4.0
"""A shorter stroke is part of a sign, no line, mm."""
ALIKE = 0.3
"""Two lines are one if their ends are so near to the other's axis, mm."""
DRAWINGS = 400
"""So many drawings of a hand tell how its points err together."""
LOST = 20.0
"""A point farther off than this, mm, was drawn in the other assembly."""
RING = 2.5
"""A small sign (a ring, a head) belongs to the point that it is about, so near, mm."""
FILLED = (0.75, 0.5, 0.25)
"""A filled sign, a head, is pencil on lines about its edges, so many times as large."""
ASIDE = ("leader", "number", "dimension", "hatching", "turning", "sliding", "axis")
"""Parts of a view that name its points, and are none of their signs."""
LINES = ("", "link", "guide")
"""Parts of a view whose strokes are lines of its construction."""


class ExpectedPlace(NamedTuple):
    """A place of a view, mm on the sheet, and the points that stand there; none: a pole, a pivot."""

    at: complex
    names: tuple[Name, ...]


class ExpectedLine(NamedTuple):
    """A straight line of a view, mm on the sheet; the places (indices) on it, the steps (slots) of it."""

    start: complex
    end: complex
    places: tuple[int, ...]
    of: frozenset[int] = frozenset()

    @property
    def length(self) -> float:
        """How long it is, mm."""
        return abs(self.end - self.start)

    @property
    def way(self) -> complex:
        """Its direction."""
        return (self.end - self.start) / self.length

    def share(self, at: complex) -> float:
        """Return the foot of a place on it, as a share of its length."""
        return ((at - self.start) / self.way).real / self.length

    def shares(self, spots: Complexes) -> Reals:
        """Return where on it its places are, as shares of its length; ``spots``: of all places."""
        own = (spots[list(self.places)] - self.start) / self.way
        return np.asarray(own.real / self.length, dtype=np.float64)


class View(NamedTuple):
    """A view of a sheet: its places and lines; the place (index) of each pole, by plan and position.

    ``ink``: by place the straight pieces, (pieces, 2), of the signs there: lines that end, heads, rings, nicks.
    ``of``: by place the position (index) that it belongs to, None for all. ``astray``: how far drawings of a
    hand have each place from where it should be, (drawings, places), mm. ``marks``: what each place is in the
    log, and its position there (index); None for a pole. ``turn``: by which the student turned the plan.
    """

    name: str
    places: tuple[ExpectedPlace, ...]
    lines: tuple[ExpectedLine, ...]
    poles: dict[tuple[str, str], int]
    ink: tuple[Complexes, ...]
    of: tuple[int | None, ...]
    astray: Complexes
    marks: tuple[tuple[Mark, int] | None, ...] = ()
    turn: complex = 1.0

    def turned(self, by: complex) -> View:
        """Return the view turned about 0, of size 1."""
        return self._replace(
            places=tuple(one._replace(at=by * one.at) for one in self.places),
            lines=tuple(one._replace(start=by * one.start, end=by * one.end) for one in self.lines),
            ink=tuple(by * one for one in self.ink),
            astray=by * self.astray,
            turn=by * self.turn,
        )

    @property
    def at(self) -> Complexes:
        """Where its places should stand, mm on the sheet."""
        return np.array([place.at for place in self.places], dtype=np.complex128)

    @property
    def ends(self) -> Complexes:
        """Where its lines begin and end, (2, lines), mm."""
        return np.array([[one.start for one in self.lines], [one.end for one in self.lines]])

    @property
    def fan(self) -> bool:
        """Whether it shows several positions, one upon another."""
        return len(set(self.of) - {None}) > 1

    def sideways_scatter(self, line: ExpectedLine) -> float:
        """Return how far aside drawings have the places of a line at most, mm (one deviation)."""
        off = self.astray[:, list(line.places)] / line.way
        return float(np.sqrt((off.imag**2).mean(axis=0)).max(initial=0.0))


def views(made: DrawnScene, sheet: Sheet, hand: Hand) -> tuple[View, ...]:
    """Return what a sheet should show of the plans whose points can be read, if a ``hand`` draws it."""
    work, plans = made.mechanism, pointed()
    if work is None:
        return ()
    drawn = scatter_of(work, hand)
    found = []
    for drawing in sheet.drawings:
        shown = [plan for plan in drawing.shows if plan in plans]
        if shown:
            found.append(view_of(Stood(work, drawing, shown), drawing, drawn))
    return tuple(found)


def scatter_of(work: Drawn, hand: Hand) -> Reading:
    """Return the points of the plans of a board as a hand draws them again and again."""
    points = [mark for plan in pointed() for mark in _points(work, plan)]
    return execute(work.construction, work.given, points, hand=hand._replace(trials=DRAWINGS))


def view_of(stood: Stood, drawing: Drawing, drawn: Reading) -> View:
    """Return what a drawing of plans should show; ``drawn``: how a hand scatters its points."""
    spots = np.array([place.at for place in stood.places], dtype=np.complex128)
    lines = []
    for k in dict.fromkeys(stroke.position for stroke in drawing.strokes):
        segments = list(_segments(drawing, k))
        for start, end, slots in _merged(segments):
            near = stood.on(slots, k)
            lines.append(_through(spots, near, start, end)._replace(of=slots or frozenset()))
    return View(
        drawing.name,
        tuple(stood.places),
        tuple(line for line in lines if line.places),
        stood.poles,
        tuple(_signs(drawing, spots[n], stood.at[n]) for n in range(len(spots))),
        tuple(stood.at),
        stood.astray(drawn),
        tuple(one and one[:2] for one in stood.marks),
    )


class Stood:
    """Where the points of the plans of a view stand: one place for points that are one at all positions.

    ``poles``: the place (index) of each; ``at``: by place the position (index) that it is of, None for all.
    """

    def __init__(self, work: Drawn, drawing: Drawing, shown: Sequence[str]) -> None:
        self.places: list[ExpectedPlace] = []
        self.at: list[int | None] = []
        self.poles: dict[tuple[str, str], int] = {}
        self.by_slot: dict[int, dict[int | None, int]] = {}
        self.marks: list[tuple[Mark, int, complex] | None] = []
        self.steps = {step.it.slot: step for step in work.construction.steps}
        self.users: dict[int, list[int]] = {}
        for step in work.construction.steps:
            for mark in step.uses:
                if step.it.kind is Point:
                    self.users.setdefault(mark.slot, []).append(step.it.slot)
        inked = {stroke.position for stroke in drawing.strokes}
        for plan in shown:
            self._plan(work, drawing, plan, inked)

    def _plan(self, work: Drawn, drawing: Drawing, plan: str, inked: set[int | None]) -> None:
        reading, row, origin = work.of(plan), work.row(plan), drawing.origin(plan)
        places = _inked(row, inked)
        if reading is None or not places:
            return
        pole = self._put(ExpectedPlace(origin, ()), None, None)
        self.poles |= {(plan, work.names[row[k]]): pole for k in places}
        groups: dict[tuple[complex, ...], list[Mark]] = {}
        for mark in _points(work, plan):
            if mark in reading:
                groups.setdefault(tuple(np.round(reading[mark][0], 4).tolist()), []).append(mark)
        for spots, marks in groups.items():
            names = [mark.key[1] for mark in marks if mark.slot in self.steps]
            still = np.ptp(np.real(spots)) + np.ptp(np.imag(spots)) < 1e-3
            fixed = len(names) < len(marks) or (reading.positions > 1 and bool(still))
            by: dict[int | None, int] = {}
            there = [(k, spots[k if len(spots) > 1 else 0]) for k in places]
            for k, spot in filter(_finite, there):
                called = tuple((plan, name, work.names[row[k]]) for name in names)
                of = (marks[0], row[k], spot)
                if not fixed:
                    by[k] = self._put(ExpectedPlace(origin + spot, called), k, of)
                    continue
                if None not in by:
                    at_pole = abs(spot) < 1e-3
                    by[None] = (
                        pole if at_pole else self._put(ExpectedPlace(origin + spot, ()), None, of)
                    )
                one = self.places[by[None]]
                self.places[by[None]] = one._replace(names=(*one.names, *called))
            if len(row) == 1 and 0 in by:  # nothing on its drawing is of a position then
                by[None] = by[0]
            for one_of in marks:
                self.by_slot.setdefault(one_of.slot, {}).update(by)

    def _put(
        self, place: ExpectedPlace, k: int | None, mark: tuple[Mark, int, complex] | None
    ) -> int:
        self.places.append(place)
        self.at.append(k)
        self.marks.append(mark)
        return len(self.places) - 1

    def astray(self, drawn: Reading) -> Complexes:
        """Return how far drawings have each place from its due, (drawings, places), mm; 0 for none."""
        found = np.zeros((DRAWINGS, len(self.places)), dtype=np.complex128)
        for n, one in enumerate(self.marks):
            if one is not None and one[0] in drawn:
                mark, k, spot = one
                value = drawn[mark]
                found[:, n] = value[:, k if value.shape[1] > 1 else 0] - spot
        lost = ~np.isfinite(found) | (abs(found) > LOST)
        return np.where(lost, 0.0, found)

    def on(self, slots: Iterable[int] | None, k: int | None) -> list[int]:
        """Return the places that strokes of some marks go through in a position; None: any of the position."""
        if slots is None:
            return [n for n, at in enumerate(self.at) if k is None or at is None or at == k]
        marks = {mark for slot in slots for mark in self._points_of(slot)}
        found = set()
        for slot in marks:
            by = self.by_slot.get(slot, {})
            found |= {by[key] for key in (k, None) if key in by}
        return sorted(found)

    def _points_of(self, slot: int) -> set[int]:
        """Return the points (slots) that what a step left goes through, by how it was drawn and used."""
        step = self.steps.get(slot)
        if step is None:
            return {slot}
        found = {slot, *self.users.get(slot, ())} if step.it.kind is Drawable else {slot}
        for mark in step.uses:
            if mark.kind is Point:
                found.add(mark.slot)
            elif mark.kind is Drawable and step.it.kind is not Drawable:
                found |= self._points_of(mark.slot)
        return found


def _finite(one: tuple[int, complex]) -> bool:
    return cmath.isfinite(one[1])


def _inked(row: Sequence[int], inked: set[int | None]) -> list[int]:
    """Return the positions (of a plan's row) that its drawing shows; of a single one no stroke is."""
    return [k for k in range(len(row)) if len(row) == 1 or k in inked]


def _points(work: Drawn, plan: str) -> list[Mark]:
    """Return the points of a plan, given ones first."""
    log = work.construction
    given = [mark for mark in log.given if mark.view == plan and mark.kind is Point]
    steps = (step for step in log.steps if step.it.view == plan and not step.op.across)
    return [*given, *(step.it for step in steps if step.it.kind is Point)]


Segment = tuple[complex, complex, frozenset[int] | None]
"""Where it begins and ends, mm, and the marks (slots) whose steps left it; None for a body's."""


def _segments(drawing: Drawing, k: int | None) -> Iterator[Segment]:
    """Yield the straight lines of a view's construction and of its links in a position."""
    for stroke in drawing.strokes:
        if not isinstance(stroke, Stroke) or stroke.pen == "paper" or stroke.filled:
            continue
        if stroke.position == k and stroke.part in LINES:
            of = None if stroke.part else frozenset(stroke.of)
            yield from ((a, b, of) for a, b in _pieces(stroke) if abs(b - a) >= SHORTEST)


def _pieces(stroke: Stroke) -> list[tuple[complex, complex]]:
    """Return the straight pieces of a stroke."""
    path = (*stroke.path, stroke.path[0]) if stroke.closed else stroke.path
    pairs = pairwise(path)
    return [(complex(*a[:2]), complex(*b[:2])) for a, b in pairs if abs(a[2]) < 1e-9]


def _merged(segments: Iterable[Segment]) -> list[Segment]:
    """Return lines of which none covers another, in part."""
    found: list[Segment] = []
    for one in sorted(segments, key=lambda ends: -abs(ends[1] - ends[0])):
        for k, (a, b, of) in enumerate(found):
            own = (np.array(one[:2]) - a) / (b - a) * abs(b - a)
            low, high = min(own.real), max(own.real)
            if max(abs(own.imag)) < ALIKE and high > ALIKE and low < abs(b - a) - ALIKE:
                way = (b - a) / abs(b - a)
                both = None if of is None or one[2] is None else of | one[2]
                found[k] = (a + way * min(low, 0.0), a + way * max(high, abs(b - a)), both)
                break
        else:
            found.append(one)
    return found


def _through(spots: Complexes, near: Sequence[int], start: complex, end: complex) -> ExpectedLine:
    """Return a line with those of some places that are on it; it reaches those that its vectors' heads do."""
    length = abs(end - start)
    own = (spots[list(near)] - start) / (end - start) * length
    on = (abs(own.imag) < ON) & (own.real > -HEAD) & (own.real < length + HEAD)
    if on.any():
        way = (end - start) / length
        low, high = float(own.real[on].min()), float(own.real[on].max())
        start, end = start + way * min(low, 0.0), start + way * max(high, length)
    return ExpectedLine(
        start, end, tuple(int(k) for k, there in zip(near, on, strict=True) if there)
    )


def _signs(drawing: Drawing, at: complex, k: int | None) -> Complexes:
    """Return the straight pieces, (pieces, 2), of all strokes of a position that touch a place."""
    found = [
        piece
        for stroke in drawing.strokes
        if k is None or stroke.position in (None, k)
        for piece in _near(stroke, at)
    ]
    return np.array(found, dtype=np.complex128).reshape(-1, 2)


def _near(stroke: object, at: complex) -> list[tuple[complex, complex]]:
    if not isinstance(stroke, Stroke) or stroke.pen == "paper" or stroke.part in ASIDE:
        return []
    pieces = _chords(stroke)
    own = np.array(pieces, dtype=np.complex128).reshape(-1, 2)
    a, b = own[:, 0], own[:, 1]
    along = np.clip(((at - a) / (b - a + 1e-12)).real, 0, 1)
    nearest = abs(a + along * (b - a) - at)
    if not len(own) or nearest.min() > (ON if abs(b - a).max() > SHORTEST else RING):
        return []
    return pieces


def _chords(stroke: Stroke) -> list[tuple[complex, complex]]:
    """Return the pieces of a stroke, arcs as eight chords each."""
    path = (*stroke.path, stroke.path[0]) if stroke.closed else stroke.path
    found = []
    for one, other in pairwise(path):
        a, b, bulge = complex(*one[:2]), complex(*other[:2]), one[2]
        if abs(bulge) < 1e-9 or a == b:
            found.append((a, b))
            continue
        half = 2 * np.arctan(bulge)
        centre = (a + b) / 2 + 1j * (b - a) / 2 / np.tan(half)
        arc = centre + (a - centre) * np.exp(2j * half * np.linspace(0, 1, 9))
        found += [(complex(p), complex(q)) for p, q in pairwise(arc)]
    return [*found, *_filling(found)] if stroke.filled and stroke.closed else found


def _filling(edges: Sequence[tuple[complex, complex]]) -> Iterator[tuple[complex, complex]]:
    """Yield edges as those of a small filled figure, smaller and smaller: it is not only its edge."""
    if not edges:
        return
    middle = sum(a for a, _ in edges) / len(edges)
    for share in FILLED:
        yield from (
            (middle + share * (a - middle), middle + share * (b - middle)) for a, b in edges
        )
