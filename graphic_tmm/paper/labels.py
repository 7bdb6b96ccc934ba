"""Places for letters: no label on a label, as few lines crossed as possible, close to what they name."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from graphic_tmm.board.values import Reals
from graphic_tmm.paper.clipping import Frame, broken
from graphic_tmm.paper.drawing import Ink, Label, Stroke, Wanted, line
from graphic_tmm.paper.lettering.letters import letter
from graphic_tmm.paper.occupied import NEXT, Line, Occupied, Rect, upright
from graphic_tmm.paper.raster import FAR, Raster, Spots
from graphic_tmm.paper.shapes import box, frame, outline, shape

CLEAR = 0.8
"""Clear space about a label, mm."""
APART = 0.9
"""Clear space between two labels beyond that, mm."""
ASIDE = 0.9
"""Still more clear space between labels beside each other, mm, or they would be read as one."""
HEAVY_HALF = 0.4
"""Half the width of a main line, mm."""
RINGS = ((0.0, 1.2, 6.0, 8.0, 11.0), (15.0, 21.0, 29.0, 36.0))
"""How much farther than next to its point a label is tried, mm; and where all that is dear. Chosen by eye."""
DIRECTIONS = 24
"""Directions in which a label is tried, every 15°; chosen by eye."""
WEIGHED = 48
"""Of so many of the cheapest places it is found out what their leaders cross; of all, if all of these do."""
BESIDE = 2.2
"""A label farther than this from the ink of its point, mm, gets a leader line."""
SHORTEST, FLAT = 6.0, 20.0
"""A leader is no shorter, mm, and rises by more degrees than this, or it would be read as a minus."""
_SOFT, HEAVY = (
    ("thin", "centre", "dashed", "phantom"),
    ("main", "medium", "joint", "body", "rod", "over"),
)
"""Pens whose lines give way to letters; pens of lines that no letter may stand on."""
LEADER = "leader"
"""The part of a view that leads from points to letters: of one that letters break the longest piece stays."""
HATCHING = "hatching"
"""The part of a view whose strokes may vanish under a letter."""
DOT = 0.2
"""Half of what stands for a point that is to be lettered, mm: no other letter may hide it."""
SHORT = 8.0
"""Of a line shorter than this, mm, nothing may be left where a letter stands on it: letters keep off it."""
RINGED = "number"
"""The part of a view that is circles about numbers, and lines to them: no letter may stand on it."""
_LABEL, _CROSSED, _MISREAD, _ASTRAY = 1000.0, 460.0, 600.0, 450.0
"""What it costs to stand on a label, to cross one with a leader, to have one that is read as a minus, to be
taken for the name of another line."""
_PAST, _PASSED, _ALONG, _THROUGH = 0.6, 120.0, {"heavy": 3.0, "firm": 3.0, "soft": 0.5}, 60.0
"""A leader passes other labels with so much room more, mm; what it costs that one does not, that it runs on a
line, per mm, and that it passes through another point that is lettered."""
_FOOT, _TOUCH, _SAMPLES = 1.5, 1.0, 24
"""So far from its point a leader may run on lines, mm; so near to another point it seems to lead there, mm; of
so many places of it it is found out whether they are on a line."""
_VALUE, _MINUS, _STROKE = 12.0, 150.0, 0.35
"""What it costs to stand level beside another label, as if they were one term; with a stroke between them that
reads as a minus; of how much of the way between them there is one."""
_NEARER = 0.94
"""The middle of a name is so many times nearer to its own line than to another, at least."""
_COSTS = {"heavy": 480.0, "firm": 60.0, "soft": 4.0, "ring": 2.0, "turn": 2.4}
"""What it costs to stand on a line once, to be a millimetre farther, to stand 60° off where it is wanted."""


_DEAR = 30.0
"""A place that costs more is left for one farther away, if there is a better one."""
_GRAZED = 0.5
"""What it costs to come near a line that gives way, of what it costs to stand on it."""
_TURNS = np.exp(2j * np.pi * np.arange(DIRECTIONS) / DIRECTIONS)


class _Lines(NamedTuple):
    """Lines of a kind: where they lie, how clear of them a box keeps (mm), what it costs to stand on one.

    ``graze``: the least share of that which it costs to come near one; ``along``: what it costs that a leader
    runs on one, per mm.
    """

    raster: Raster
    clear: float
    cost: float
    graze: float
    along: float


class _Boxes(NamedTuple):
    """The boxes in which a label is tried, mm: left, bottom; their size; what each of them costs by itself."""

    x: Reals
    y: Reals
    width: float
    height: float
    cost: Reals

    def grown(self, by: float) -> tuple[Reals, Reals, Reals, Reals]:
        """Return their left, lower, right and upper edges with ``by`` mm more on each side."""
        x, y, w, h = self.x, self.y, self.width, self.height
        return x - by, y - by, x + w + by, y + h + by

    def chosen(self, which: NDArray[np.int64]) -> _Boxes:
        """Return some of them."""
        x, y, cost = self.x[which], self.y[which], self.cost[which]
        return self._replace(x=x, y=y, cost=cost)

    def rect(self, k: int) -> Rect:
        """Return one of them."""
        left, bottom = float(self.x[k]), float(self.y[k])
        return Rect(left, bottom, left + self.width, bottom + self.height)


def place(
    wanted: Sequence[Wanted], strokes: Sequence[Ink], taken: Sequence[Label] = ()
) -> tuple[Label, ...]:
    """Return the labels at their places, in the order wanted; ``taken`` labels stand already."""
    occupied = Occupied()
    for label in taken:
        occupied.letter(*upright(frame(label)))
    inks = _inks(wanted, strokes)
    spots = np.array([one.at for one in wanted])
    return tuple(_placed(one, inks, occupied, spots) for one in wanted)


def gives_way(stroke: Ink) -> bool:
    """Whether a stroke is broken where a letter stands on it; one whose length a page tells is not."""
    solid = isinstance(stroke, Stroke) and stroke.filled
    return stroke.pen in _SOFT and not solid and not stroke.data and stroke.part != RINGED


def _inks(wanted: Sequence[Wanted], strokes: Sequence[Ink]) -> list[_Lines]:
    """Return the lines that letters keep off, by kind, as far as they run about the letters."""
    kinds: dict[str, list[list[complex]]] = {}
    for stroke in strokes:
        if stroke.pen != "paper":
            corners = outline(stroke)
            kept = stroke.pen in HEAVY or stroke.part == RINGED
            soft = gives_way(stroke) and not _lost(stroke, corners)
            kinds.setdefault("heavy" if kept else "soft" if soft else "firm", []).append(corners)
    if not wanted:
        return []
    kinds.setdefault("firm", []).extend([one.at - DOT, one.at + DOT] for one in wanted)
    about = _about(wanted, [z for lines in kinds.values() for points in lines for z in points])
    wide = {"heavy": HEAVY_HALF}
    return [
        _Lines(
            Raster(lines, about),
            CLEAR / 2 + wide.get(kind, 0.0),
            _COSTS[kind],
            _GRAZED if kind == "soft" else 1.0,
            _ALONG[kind],
        )
        for kind, lines in kinds.items()
    ]


def _lost(stroke: Ink, corners: Sequence[complex]) -> bool:
    """Whether nothing might be left of a line on which a letter stands, though it says something."""
    long = sum(abs(b - a) for a, b in pairwise(corners))
    return stroke.part != HATCHING and long < SHORT


def _about(wanted: Sequence[Wanted], ink: Sequence[complex]) -> Rect:
    """Return where letters may come to stand on ink: about their points, no farther than there is any."""
    reaches = []
    for one in wanted:
        made = letter(one.text, size=one.size)
        size = max(made.right - made.left, made.ascent + made.descent)
        reaches.append(one.radius + max(map(max, RINGS)) + 2 * (size + CLEAR + HEAVY_HALF))
    reach, spots = np.array(reaches), np.array([one.at for one in wanted])
    corners = np.array(ink)
    corners = corners[np.abs(corners) < FAR]
    edges = []
    for letters, lines in ((spots.real, corners.real), (spots.imag, corners.imag)):
        low, high = float((letters - reach).min()), float((letters + reach).max())
        first, last = float(lines.min(initial=FAR)), float(lines.max(initial=-FAR))
        edges.append((max(low, first), max(low, first, min(high, last))))
    (left, right), (bottom, top) = edges
    return Rect(left, bottom, right, top)


def _tried(one: Wanted, rings: Reals, inks: Sequence[_Lines]) -> _Boxes:
    """Return the boxes in which a label is tried; ``rings``: how much farther than beside its point, mm."""
    made = letter(one.text, size=one.size)
    width, height = made.right - made.left, made.ascent + made.descent
    turns = _TURNS
    reach = 1.0 / np.maximum(2 * np.abs(turns.real) / width, 2 * np.abs(turns.imag) / height)
    ways = one.radius + CLEAR + reach[None, :] + rings[:, None]
    centres = (one.at + turns[None, :] * ways).ravel()
    x, y = centres.real - width / 2, centres.imag - height / 2
    cost = np.repeat(rings * _COSTS["ring"], DIRECTIONS)
    if one.toward:
        aim = one.toward / abs(one.toward)
        cost += _COSTS["turn"] * np.tile(np.abs(turns - aim) ** 2, len(rings))
    boxes = _Boxes(x, y, width, height, cost)
    for raster, by, weight, least, _ in inks:
        w, h = width + 2 * by, height + 2 * by
        length = raster.length(*boxes.grown(by))
        chord = math.pi * w * h / (2 * (w + h))  # of a line through a box, in the mean
        cost += weight * np.where(length > 0, np.maximum(least, length / chord), 0.0)
    cost += _MISREAD * _misread(one, _way(one, boxes)) + _ASTRAY * _astray(one, boxes)
    return boxes._replace(cost=np.minimum(cost, 0.9 * _LABEL))


def _misread(one: Wanted, way: NDArray[np.complex128]) -> NDArray[np.bool_]:
    """Return which of the ways to a label leave a leader that is read as a minus before or behind it."""
    there = np.abs(way) > one.radius + BESIDE
    length = np.abs(way) - one.radius - CLEAR / 2
    level = np.abs(way.imag) <= math.tan(math.radians(FLAT)) * np.abs(way.real)
    return np.asarray(there & (level | (length < SHORTEST)))


def _astray(one: Wanted, boxes: _Boxes) -> NDArray[np.bool_]:
    """Return at which places a label would be taken to name another line than its own."""
    others = polylines(one.others)
    if others.is_empty:
        return np.zeros(boxes.x.shape, dtype=bool)
    left, low, right, high = boxes.grown(0.0)
    frames = shapely.box(left, low, right, high)
    ends = np.clip(one.at.real, left, right) + 1j * np.clip(one.at.imag, low, high)
    led = np.abs(ends - one.at) > one.radius + BESIDE
    away = shapely.distance(frames, others)
    own, middles = polylines([one.line]), shapely.points((left + right) / 2, (low + high) / 2)
    nearer = shapely.distance(frames, own) <= away + 1e-9
    nearer &= shapely.distance(middles, own) <= _NEARER * shapely.distance(middles, others)
    leads = shapely.linestrings(
        np.stack([np.full(ends.shape, one.at), ends], axis=-1).view(float).reshape(-1, 2, 2)
    )
    clear = ~shapely.intersects(leads, others) & (away > CLEAR)
    return np.asarray(~np.where(led, clear, nearer))


def polylines(lines: Sequence[Sequence[complex]]) -> shapely.MultiLineString:
    """Return lines as one shape; what is no line is left out."""
    there = [line for line in lines if len(line) > 1]
    return shapely.MultiLineString([[(z.real, z.imag) for z in line] for line in there])


def _placed(one: Wanted, inks: Sequence[_Lines], occupied: Occupied, spots: Spots) -> Label:
    """Return a label at the place that costs least, and take it; ``spots``: all points that are lettered."""
    found: list[tuple[float, Rect]] = []
    for rings in RINGS:
        found.append(_cheapest(one, _tried(one, np.array(rings), inks), inks, occupied, spots))
        if found[-1][0] <= _DEAR:
            break
    _, rect = min(found, key=lambda one: one[0])
    occupied.letter(rect.grown(CLEAR / 2))
    line = _leader(one, rect)
    if line is not None:
        occupied.leader(line)
    made = letter(one.text, size=one.size)
    at = complex(rect.left - made.left, rect.bottom + made.descent)
    return Label(one.text, at, one.size, of=one.of, position=one.position)


def _cheapest(
    one: Wanted, tried: _Boxes, inks: Sequence[_Lines], occupied: Occupied, spots: Spots
) -> tuple[float, Rect]:
    """Return what the best of some places costs, and the place."""
    left, low, right, high = tried.grown(CLEAR / 2 + APART)
    standing = occupied.letters_at(left - ASIDE, low, right + ASIDE, high)
    tried = tried._replace(cost=np.round(tried.cost + _LABEL * standing, 6))
    order = np.argsort(tried.cost, kind="stable")
    cost, rect = _weighed(one, tried.chosen(order[:WEIGHED]), inks, occupied, spots)
    if cost < _CROSSED:
        return cost, rect
    more = _weighed(one, tried.chosen(order[WEIGHED:]), inks, occupied, spots)
    return min((cost, rect), more, key=lambda found: found[0])


def _weighed(
    one: Wanted, few: _Boxes, inks: Sequence[_Lines], occupied: Occupied, spots: Spots
) -> tuple[float, Rect]:
    """Return what the best of some places costs with its neighbours and its leader, and the place."""
    cost = few.cost + _CROSSED * occupied.leaders_at(*few.grown(CLEAR / 2))
    cost += _PASSED * occupied.leaders_at(*few.grown(CLEAR / 2 + _PAST))
    cost += _beside(few, inks, occupied)
    way, best = _way(one, few), int(np.argmin(cost))
    led = np.flatnonzero(np.abs(way) > one.radius + BESIDE)
    if best in led:  # leaders only cost more: they matter where the best place so far has one
        unit = way[led] / np.abs(way[led])
        starts, ends = one.at + one.radius * unit, one.at + way[led] - CLEAR / 2 * unit
        cost[led] += _PASSED * occupied.crossing(starts, ends, _PAST)
        cost[led] += _CROSSED * occupied.crossing(starts, ends)
        cost[led] += _run(starts, ends, inks) + _THROUGH * _through(one, starts, ends, spots)
        best = int(np.argmin(np.round(cost, 6)))
    return float(cost[best]), few.rect(best)


def _beside(boxes: _Boxes, inks: Sequence[_Lines], occupied: Occupied) -> Reals:
    """Return what it costs that labels stand level with others, as one term or with a minus between."""
    which, *gap = occupied.level(*boxes.grown(CLEAR / 2))
    if not which.size:
        return np.zeros(boxes.x.shape)
    left, low, right, high = gap
    middle, half = (low + high) / 2, (high - low) / 3
    inked = sum(lines.raster.length(left, middle - half, right, middle + half) for lines in inks)
    minus = (inked > _STROKE * (right - left)) & (inked > CLEAR)
    costs = np.where(minus, _MINUS, np.where(right - left < NEXT, _VALUE, 0.0))
    return np.asarray(np.bincount(which, costs, minlength=boxes.x.size), dtype=float)


def _run(starts: Spots, ends: Spots, inks: Sequence[_Lines]) -> Reals:
    """Return what it costs that leaders cross lines and run on them."""
    way, cost = ends - starts, np.zeros(starts.shape)
    far = np.abs(way)
    first = np.minimum(_FOOT / np.maximum(far, _FOOT), 1.0)
    share = first[:, None] + (1 - first[:, None]) * (np.arange(_SAMPLES) + 0.5) / _SAMPLES
    at, by = starts[:, None] + way[:, None] * share, CLEAR / 2
    for lines in inks:
        x, y = at.real, at.imag
        met = lines.raster.length(x - by, y - by, x + by, y + by) > 0
        cost += lines.along * met.mean(axis=1) * (1 - first) * far
    return cost


def _through(one: Wanted, starts: Spots, ends: Spots, spots: Spots) -> NDArray[np.bool_]:
    """Whether leaders touch another point that is lettered."""
    reach = float(np.abs(ends - one.at).max()) + _TOUCH
    away = np.abs(spots - one.at)
    others = spots[(away < reach) & (away > one.radius + _TOUCH)]
    way = ends - starts
    far = np.maximum(np.abs(way), _TOUCH)
    seen = (others - starts[:, None]) * (way / far).conjugate()[:, None]
    along = np.clip(seen.real, 0.0, far[:, None])
    return np.asarray((np.abs(seen - along) < _TOUCH).any(axis=1))


def _way(one: Wanted, boxes: _Boxes) -> NDArray[np.complex128]:
    """Return the shortest ways from a point to boxes."""
    x = np.clip(one.at.real, boxes.x, boxes.x + boxes.width)
    return np.asarray(x + 1j * np.clip(one.at.imag, boxes.y, boxes.y + boxes.height) - one.at)


def _leader(one: Wanted, rect: Rect) -> Line | None:
    """Return the leader from the ink of a point to its label; None to one beside it."""
    end = rect.nearest(one.at)
    away = abs(end - one.at)
    if away <= one.radius + BESIDE:
        return None
    way = (end - one.at) / away
    return Line(one.at + one.radius * way, end - CLEAR / 2 * way)


def leaders(wanted: Sequence[Wanted], labels: Sequence[Label]) -> tuple[Stroke, ...]:
    """Return thin lines from points to those of their labels that found no place beside them."""
    made = []
    for one, label in zip(wanted, labels, strict=True):
        (rect,) = upright(frame(label))
        found = _leader(one, rect)
        if found is not None:
            ink = line("thin", *found)
            made.append(ink._replace(part=LEADER, of=one.of, position=one.position))
    return tuple(made)


def interrupt(strokes: Sequence[Ink], labels: Sequence[Label]) -> tuple[Ink, ...]:
    """Return the strokes with thin lines broken where a label stands on them."""
    soft = [k for k, stroke in enumerate(strokes) if gives_way(stroke)]
    if not labels or not soft:
        return tuple(strokes)
    frames = [frame(label).grown(CLEAR / 2) for label in labels]
    shapes = np.array([shape(strokes[k]) for k in soft], dtype=object)
    tree = shapely.STRtree([box(label) for label in labels])
    hits: dict[int, list[Frame]] = {}
    for i, j in tree.query(shapes, predicate="dwithin", distance=CLEAR).T.tolist():
        hits.setdefault(soft[i], []).append(frames[j])
    made: list[Ink] = []
    for k, stroke in enumerate(strokes):
        left = broken(stroke, hits[k], CLEAR) if k in hits else [stroke]
        if stroke.part == LEADER and left:
            left = [max(left, key=lambda piece: float(shape(piece).length))]
        made += left if left or stroke.part == HATCHING else [stroke]  # what would vanish stays
    return tuple(made)
