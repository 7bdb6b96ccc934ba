"""Where a letter may stand: the places about its point in which it is tried, and what each costs by itself.

All labels of a view are tried at once: what a place costs hangs on the lines of the view, on no other label.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from graphic_tmm.board.values import Reals
from graphic_tmm.paper.drawing import Ink, Stroke, Wanted
from graphic_tmm.paper.lettering.letters import letter
from graphic_tmm.paper.occupied import FAR, Raster, Rect, Spots
from graphic_tmm.paper.shapes import outline

CLEAR = 0.8
"""Clear space about a label, mm."""
HEAVY_HALF = 0.4
"""Half the width of a main line, mm."""
RINGS = ((0.0, 1.2, 6.0, 8.0, 11.0), (15.0, 21.0, 29.0, 36.0), (44.0, 54.0, 66.0, 80.0))
"""How much farther than next to its point a label is tried, mm; where all that is dear; where it stands on a
main line or a letter. Chosen by eye."""
AT_ONCE = 256
"""Places of labels are computed in blocks of this many: arrays of some MB, however many labels there are."""
DIRECTIONS = 24
"""Directions in which a label is tried, every 15°; chosen by eye."""
BESIDE = 2.2
"""A label farther than this from the ink of its point, mm, gets a leader line."""
SHORTEST, FLAT = 6.0, 20.0
"""A leader is no shorter, mm, and rises by more degrees than this, or it would be read as a minus."""
_SOFT, HEAVY = (
    ("thin", "centre", "dashed", "phantom"),
    ("main", "medium", "joint", "body", "rod", "over"),
)
"""Pens whose lines give way to letters; pens of lines that no letter may stand on."""
HATCHING = "hatching"
"""The part of a view whose strokes may vanish under a letter."""
DOT = 0.2
"""Half of what stands for a point that is to be lettered, mm: no other letter may hide it."""
SHORT = 8.0
"""Of a line shorter than this, mm, nothing may be left where a letter stands on it: letters keep off it."""
RINGED = "number"
"""The part of a view that is circles about numbers, and lines to them: no letter may stand on it."""
LABEL, _MISREAD, _ASTRAY = 1000.0, 600.0, 450.0
"""What it costs to stand on a label, to have a leader that is read as a minus, to be taken for the name of
another line."""
_ALONG = {"heavy": 3.0, "firm": 3.0, "soft": 0.5}
"""What it costs that a leader runs on a line, per mm."""
_NEARER = 0.94
"""The middle of a name is nearer to its own line than to any other by this factor at least."""
_COSTS = {"heavy": 480.0, "firm": 60.0, "soft": 4.0, "ring": 2.0, "turn": 2.4}
"""What it costs to stand on a line once, to be a millimetre farther, to stand 60° off where it is wanted."""
_GRAZED = 0.5
"""What it costs to come near a line that gives way, of what it costs to stand on it."""
_TURNS = np.exp(2j * np.pi * np.arange(DIRECTIONS) / DIRECTIONS)


class Lines(NamedTuple):
    """Lines of a kind: where they lie, how clear of them a box keeps (mm), what it costs to stand on one.

    ``graze``: the least share of that which it costs to come near one; ``along``: what it costs that a leader
    runs on one, per mm.
    """

    raster: Raster
    clear: float
    cost: float
    graze: float
    along: float


class Boxes(NamedTuple):
    """The boxes in which a label is tried, mm: left, bottom; their size; what each of them costs by itself.

    Of many labels together: a row of boxes for each, sizes as columns.
    """

    x: Reals
    y: Reals
    width: Reals
    height: Reals
    cost: Reals

    def grown(self, by: float) -> tuple[Reals, Reals, Reals, Reals]:
        """Return their left, lower, right and upper edges with ``by`` mm more on each side."""
        x, y, w, h = self.x, self.y, self.width, self.height
        return x - by, y - by, x + w + by, y + h + by

    def chosen(self, which: NDArray[np.int64]) -> Boxes:
        """Return some of them."""
        x, y, cost = self.x[which], self.y[which], self.cost[which]
        return self._replace(x=x, y=y, cost=cost)

    def rect(self, k: int) -> Rect:
        """Return one of them."""
        left, bottom = float(self.x[k]), float(self.y[k])
        return Rect(left, bottom, left + float(self.width), bottom + float(self.height))

    def of(self, k: int) -> Boxes:
        """Return those of one of many labels, which share its memory."""
        return Boxes(self.x[k], self.y[k], self.width[k, 0], self.height[k, 0], self.cost[k])


def gives_way(stroke: Ink) -> bool:
    """Whether a stroke is broken where a letter stands on it; one whose length is shown on a page is not."""
    solid = isinstance(stroke, Stroke) and stroke.filled
    return stroke.pen in _SOFT and not solid and not stroke.data and stroke.part != RINGED


def inks(wanted: Sequence[Wanted], strokes: Sequence[Ink]) -> list[Lines]:
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
        Lines(
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


def tried(wanted: Sequence[Wanted], rings: Sequence[float], inks: Sequence[Lines]) -> list[Boxes]:
    """Return the boxes in which labels are tried; ``rings``: distances beyond the nearest places, mm."""
    blocks = (wanted[k : k + AT_ONCE] for k in range(0, len(wanted), AT_ONCE))
    return [boxes for block in blocks for boxes in _tried(block, np.array(rings), inks)]


def _tried(wanted: Sequence[Wanted], rings: Reals, inks: Sequence[Lines]) -> list[Boxes]:
    """Return the boxes in which labels are tried: arrays of a row for each label on the way."""
    made = [letter(one.text, size=one.size) for one in wanted]
    width = np.array([[one.right - one.left] for one in made])
    height = np.array([[one.ascent + one.descent] for one in made])
    at, radius = np.array([[one.at] for one in wanted]), np.array([[one.radius] for one in wanted])
    turns = _TURNS
    reach = 1.0 / np.maximum(2 * np.abs(turns.real) / width, 2 * np.abs(turns.imag) / height)
    ways = (radius + CLEAR + reach)[:, None, :] + rings[:, None]
    centres = at + (turns * ways).reshape(len(wanted), -1)
    x, y = centres.real - width / 2, centres.imag - height / 2
    cost = np.tile(np.repeat(rings * _COSTS["ring"], DIRECTIONS), (len(wanted), 1))
    for row, one in zip(cost, wanted, strict=True):
        if one.toward:
            aim = one.toward / abs(one.toward)
            row += _COSTS["turn"] * np.tile(np.abs(turns - aim) ** 2, len(rings))
    boxes = Boxes(x, y, width, height, cost)
    for raster, by, weight, least, _ in inks:
        w, h = width + 2 * by, height + 2 * by
        length = raster.length(*boxes.grown(by))
        chord = math.pi * w * h / (2 * (w + h))  # of a line through a box, in the mean
        cost += weight * np.where(length > 0, np.maximum(least, length / chord), 0.0)
    cost += _MISREAD * _misread(radius, way(at, boxes))
    found = [boxes.of(k) for k in range(len(wanted))]
    for row, one, own in zip(cost, wanted, found, strict=True):
        row += _ASTRAY * _astray(one, own)
    np.minimum(cost, 0.9 * LABEL, out=cost)
    return found


def way(at: Spots | complex, boxes: Boxes) -> NDArray[np.complex128]:
    """Return the shortest ways from points to boxes."""
    spot = np.asarray(at)
    x = np.clip(spot.real, boxes.x, boxes.x + boxes.width)
    return np.asarray(x + 1j * np.clip(spot.imag, boxes.y, boxes.y + boxes.height) - spot)


def _misread(radius: Reals, way: NDArray[np.complex128]) -> NDArray[np.bool_]:
    """Return which of the ways to labels leave a leader that is read as a minus before or behind it."""
    far = np.abs(way)
    level = np.abs(way.imag) <= math.tan(math.radians(FLAT)) * np.abs(way.real)
    return np.asarray((far > radius + BESIDE) & (level | (far - radius - CLEAR / 2 < SHORTEST)))


def _astray(one: Wanted, boxes: Boxes) -> NDArray[np.bool_]:
    """Return at which places a label would be taken to name another line than its own."""
    others = polylines(one.others) if one.others else None
    if others is None or others.is_empty:
        return np.zeros(boxes.x.shape, dtype=bool)
    left, low, right, high = boxes.grown(0.0)
    frames = shapely.box(left, low, right, high)
    ends = np.clip(one.at.real, left, right) + 1j * np.clip(one.at.imag, low, high)
    led = np.abs(ends - one.at) > one.radius + BESIDE
    away, fine = shapely.distance(frames, others), led.copy()
    beside = ~led
    middles = shapely.points(((left + right) / 2)[beside], ((low + high) / 2)[beside])
    own = polylines([one.line])
    nearer = shapely.distance(frames[beside], own) <= away[beside] + 1e-9
    nearer &= shapely.distance(middles, own) <= _NEARER * shapely.distance(middles, others)
    leads = shapely.linestrings(
        np.stack([np.full(ends.shape, one.at), ends], axis=-1).view(float).reshape(-1, 2, 2)[led]
    )
    fine[led] = ~shapely.intersects(leads, others) & (away[led] > CLEAR)
    fine[beside] = nearer
    return np.asarray(~fine)


def polylines(lines: Sequence[Sequence[complex]]) -> shapely.MultiLineString:
    """Return lines as one shape; what is no line is left out."""
    there = [line for line in lines if len(line) > 1]
    return shapely.MultiLineString([[(z.real, z.imag) for z in line] for line in there])
