"""Places for letters: no label on a label, few lines crossed, close to what they name; a view made ready.

Thin lines give way to letters. Points in one place share a label.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from graphic_tmm.board.values import Reals
from graphic_tmm.paper.clipping import Frame, broken
from graphic_tmm.paper.drawing import Drawing, Ink, Label, Stroke, Wanted, line
from graphic_tmm.paper.label_places import (
    BESIDE,
    CLEAR,
    HATCHING,
    LABEL,
    RINGS,
    Boxes,
    Lines,
    gives_way,
    inks,
    tried,
    way,
)
from graphic_tmm.paper.lettering.letters import letter
from graphic_tmm.paper.occupied import NEXT, Line, Occupied, Rect, Spots, upright
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.shapes import box, frame, shape, shapes

APART = 0.9
"""Clear space between two labels beyond that, mm."""
ASIDE = 0.9
"""Additional space between labels side by side, mm, or they would be read as one."""
WEIGHED = (3, 48)
"""Numbers of cheapest places for which neighbours and crossings of leaders are computed: the first number, if
one of these stays cheaper than the next place alone; else the second; all, if these all cross something."""
LEADER = "leader"
"""The part of a view that leads from points to letters: of one that letters break the longest piece stays."""
_CROSSED = 460.0
"""What it costs to cross a label with a leader."""
_PAST, _PASSED, _THROUGH = 0.6, 120.0, 60.0
"""A leader passes other labels with so much room more, mm; what it costs that one does not, and that it passes
through another point that is lettered."""
_FOOT, _TOUCH, _SAMPLES = 1.5, 1.0, 24
"""How far from its point a leader may run on lines, mm; how near to another point it seems to lead there, mm;
the number of its places that are tested against lines."""
_VALUE, _MINUS, _STROKE = 12.0, 150.0, 0.35
"""Costs of a place: level with another label, as if both were one term; with a stroke between that reads as a
minus; the share of the gap that such a stroke fills."""
_DEAR = (30.0, 440.0)
"""A place that costs more is left for one farther away, if there is a better one; and for one farther still:
there a letter stands on a main line or on another."""

_ANEW = 4
"""How often the labels of a view are placed at most."""


def place(
    wanted: Sequence[Wanted], strokes: Sequence[Ink], taken: Sequence[Label] = ()
) -> tuple[Label, ...]:
    """Return the labels at their places, in the order wanted; ``taken`` labels stand already.

    Each takes the best place that those before it leave. Where that is on a main line, on a letter or across a
    leader, all are placed anew with this one first; the arrangement that costs least stays.
    """
    lines = inks(wanted, strokes)
    spots = np.array([one.at for one in wanted])
    nearest = tried(wanted, RINGS[0], lines)
    order, least = list(range(len(wanted))), np.inf
    best: tuple[Label, ...] = ()
    for _ in range(_ANEW):
        occupied = Occupied()
        for label in taken:
            occupied.letter(*upright(frame(label)))
        placed = {k: _placed(wanted[k], nearest[k], lines, occupied, spots) for k in order}
        cost = sum(cost for cost, _ in placed.values())
        if cost < least:
            least, best = cost, tuple(placed[k][1] for k in sorted(placed))
        worst = max(order, key=lambda k: placed[k][0], default=0)
        if not placed or placed[worst][0] <= _DEAR[1] or order[0] == worst:
            break
        order = [worst, *(k for k in order if k != worst)]
    return best


def _placed(
    one: Wanted, nearest: Boxes, inks: Sequence[Lines], occupied: Occupied, spots: Spots
) -> tuple[float, Label]:
    """Return what the best place of a label costs, and the label, which takes the place.

    ``nearest``: the nearest places; farther ones are tried where all of these cost much. ``spots``: all
    lettered points.
    """
    found = _cheapest(one, nearest, inks, occupied, spots)
    for dear, rings in zip(_DEAR, RINGS[1:], strict=True):
        if found[0] <= dear:
            break
        (farther,) = tried([one], rings, inks)
        found = min(
            found, _cheapest(one, farther, inks, occupied, spots), key=lambda found: found[0]
        )
    cost, rect = found
    occupied.letter(rect.grown(CLEAR / 2))
    line = _leader(one, rect)
    if line is not None:
        occupied.leader(line)
    made = letter(one.text, size=one.size)
    at = complex(rect.left - made.left, rect.bottom + made.descent)
    return cost, Label(one.text, at, one.size, of=one.of, position=one.position)


def _cheapest(
    one: Wanted, tried: Boxes, inks: Sequence[Lines], occupied: Occupied, spots: Spots
) -> tuple[float, Rect]:
    """Return what the best of some places costs, and the place."""
    left, low, right, high = tried.grown(CLEAR / 2 + APART)
    standing = occupied.letters_at(left - ASIDE, low, right + ASIDE, high)
    tried = tried._replace(cost=np.round(tried.cost + LABEL * standing, 6))
    order = np.argsort(tried.cost, kind="stable")
    rect = tried.rect(order[0])
    away = abs(rect.nearest(one.at) - one.at)
    if away <= one.radius + BESIDE and occupied.alone(rect.grown(CLEAR / 2), _PAST):
        return float(tried.cost[order[0]]), rect
    few, many = WEIGHED
    cost, rect = _weighed(one, tried.chosen(order[:few]), inks, occupied, spots)
    if cost <= tried.cost[order[few]]:  # the others are no cheaper, and only become dearer
        return cost, rect
    cost, rect = _weighed(one, tried.chosen(order[:many]), inks, occupied, spots)
    if cost < _CROSSED:
        return cost, rect
    more = _weighed(one, tried.chosen(order[many:]), inks, occupied, spots)
    return min((cost, rect), more, key=lambda found: found[0])


def _weighed(
    one: Wanted, few: Boxes, inks: Sequence[Lines], occupied: Occupied, spots: Spots
) -> tuple[float, Rect]:
    """Return what the best of some places costs with its neighbours and its leader, and the place."""
    cost = few.cost + _CROSSED * occupied.leaders_at(*few.grown(CLEAR / 2))
    cost += _PASSED * occupied.leaders_at(*few.grown(CLEAR / 2 + _PAST))
    cost += _level_cost(few, inks, occupied)
    ways, best = way(one.at, few), int(np.argmin(cost))
    led = np.flatnonzero(np.abs(ways) > one.radius + BESIDE)
    if best in led:  # leaders only cost more: they matter where the best place so far has one
        unit = ways[led] / np.abs(ways[led])
        starts, ends = one.at + one.radius * unit, one.at + ways[led] - CLEAR / 2 * unit
        cost[led] += _PASSED * occupied.crossing(starts, ends, _PAST)
        cost[led] += _CROSSED * occupied.crossing(starts, ends)
        cost[led] += _run(starts, ends, inks) + _THROUGH * _through(one, starts, ends, spots)
        best = int(np.argmin(np.round(cost, 6)))
    return float(cost[best]), few.rect(best)


def _level_cost(boxes: Boxes, inks: Sequence[Lines], occupied: Occupied) -> Reals:
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


def _run(starts: Spots, ends: Spots, inks: Sequence[Lines]) -> Reals:
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


def _leader(one: Wanted, rect: Rect) -> Line | None:
    """Return the leader from the ink of a point to its label; None if the label is next to it."""
    end = rect.nearest(one.at)
    away = abs(end - one.at)
    if away <= one.radius + BESIDE:
        return None
    way = (end - one.at) / away
    return Line(one.at + one.radius * way, end - CLEAR / 2 * way)


def leaders(wanted: Sequence[Wanted], labels: Sequence[Label]) -> tuple[Stroke, ...]:
    """Return thin lines from points to labels that had to move away from them."""
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
    lines = shapes([strokes[k] for k in soft])
    tree = shapely.STRtree([box(label) for label in labels])
    hits: dict[int, list[Frame]] = {}
    for i, j in tree.query(lines, predicate="dwithin", distance=CLEAR).T.tolist():
        hits.setdefault(soft[i], []).append(frames[j])
    made: list[Ink] = []
    for k, stroke in enumerate(strokes):
        left = broken(stroke, hits[k], CLEAR) if k in hits else [stroke]
        if stroke.part == LEADER and left:
            left = [max(left, key=lambda piece: float(shape(piece).length))]
        made += left if left or stroke.part == HATCHING else [stroke]  # what would vanish stays
    return tuple(made)


TOGETHER = 0.35
"""Points nearer than this, mm, share one label."""


def finished(view: Drawing, lettered: bool = True) -> Drawing:
    """Return a view with its wanted letters placed; not ``lettered``: with about the room that they take.

    What is wanted nowhere (NaN, infinite) is left out.
    """
    view = view._replace(wanted=tuple(one for one in view.wanted if cmath.isfinite(one.at)))
    if not view.wanted:
        return view
    if not lettered:
        boxes = [_about(one) for one in view.wanted]
        if view.strokes or view.labels or view.cell is not None:
            boxes.append(bounds(view._replace(wanted=())))
        sides = list(zip(*boxes, strict=True))
        cell = (min(sides[0]), min(sides[1]), max(sides[2]), max(sides[3]))
        return view._replace(cell=cell, wanted=())
    labels = place(view.wanted, view.strokes, view.labels)
    whole = (*view.labels, *labels)
    strokes = interrupt([*view.strokes, *leaders(view.wanted, labels)], whole)
    return view._replace(strokes=strokes, labels=whole, wanted=())


def _about(one: Wanted) -> tuple[float, float, float, float]:
    """Return roughly where a letter will stand: next to its point, on the preferred side if there is one."""
    made = letter(one.text, size=one.size)
    wide, high = made.width / 2 + CLEAR, (made.ascent + made.descent) / 2 + CLEAR
    at = one.at
    if one.toward:
        way = one.toward / abs(one.toward)
        reach = 1.0 / max(abs(way.real) / wide, abs(way.imag) / high, 1e-9)
        at += way * (one.radius + reach)
    else:
        wide, high = wide + one.radius, high + one.radius
    return at.real - wide, at.imag - high, at.real + wide, at.imag + high


class Named(NamedTuple):
    """A point that is to be lettered: where it is, mm; what it is called (mark-up); its mark and position."""

    at: complex
    text: str
    of: tuple[int, ...] = ()
    position: int | None = None


def shared(points: Iterable[Named], together: float = TOGETHER) -> list[Named]:
    """Return points with those in one place as one, their names in the order met, each name once.

    It belongs to the last of their positions: then all of them are there. What is not there is left out.
    """
    groups: list[list[Named]] = []
    for one in points:
        if not cmath.isfinite(one.at):
            continue
        near = next((group for group in groups if abs(group[0].at - one.at) < together), None)
        if near is None:
            groups.append([one])
        else:
            near.append(one)
    return [_joined(group) for group in groups]


def _joined(group: Sequence[Named]) -> Named:
    texts = dict.fromkeys(one.text for one in group)
    slots = dict.fromkeys(slot for one in group for slot in one.of)
    position = max((one.position for one in group if one.position is not None), default=None)
    return Named(group[0].at, ", ".join(texts), tuple(slots), position)


def lettered(
    points: Iterable[Named], size: float, radius: float = 1.0, away_from: complex | None = None
) -> list[Wanted]:
    """Return the letters wanted at points, preferably on the side away from a given place (mm)."""
    return [
        Wanted(
            one.text,
            one.at,
            size,
            radius,
            0j if away_from is None else one.at - away_from,
            one.of,
            one.position,
        )
        for one in points
    ]
