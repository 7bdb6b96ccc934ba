"""Places for letters: no label on a label, as few lines crossed as possible, close to what they name."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import TypeGuard

import numpy as np
import shapely
from numpy.typing import NDArray

from graphic_tmm.paper.drawing import Bezier, Label, Stroke, Wanted, line
from graphic_tmm.paper.lettering.letters import (
    letter,
)

CLEAR = 0.8
"""Clear space about a label, mm."""
RINGS = (0.0, 1.2, 3.0, 6.0, 10.0, 15.0)
"""How much farther than next to its point a label is tried, mm; chosen by eye."""
DIRECTIONS = 24
"""Directions in which a label is tried, every 15°; chosen by eye."""
_HEAVY = ("main", "medium", "joint", "body", "rod", "paper")
HEAVY_HALF = 0.4
"""Half the width of a main line, mm."""
LEADER = 2.2
"""A label farther than this from the ink of its point, mm, gets a leader line."""
APART = 0.9
"""Clear space between two labels beyond that, mm."""
_COST = {"label": 1000.0, "heavy": 36.0, "light": 4.0, "ring": 2.0, "turn": 0.6}


@lru_cache(maxsize=4096)
def box(label: Label) -> shapely.Polygon:
    """Return the ink box of a label, turned as the label is."""
    made = letter(label.text, size=label.size, inclined=label.inclined)
    start = {"start": 0.0, "middle": -made.width / 2, "end": -made.width}[label.anchor]
    corners = [
        complex(start, -made.descent),
        complex(start + made.width, -made.descent),
        complex(start + made.width, made.ascent),
        complex(start, made.ascent),
    ]
    turn = complex(math.cos(math.radians(label.turn)), math.sin(math.radians(label.turn)))
    placed = [label.at + corner * turn for corner in corners]
    return shapely.Polygon([(z.real, z.imag) for z in placed])


def shape(stroke: Stroke | Bezier) -> shapely.LineString | shapely.Polygon:
    """Return a stroke as a shape; curves by points near enough for placing."""
    if isinstance(stroke, Bezier):
        return shapely.LineString([(z.real, z.imag) for z in flat(stroke.controls)])
    points: list[complex] = []
    count = len(stroke.path)
    for k, (x, y, bulge) in enumerate(stroke.path):
        points.append(complex(x, y))
        if bulge and (stroke.closed or k + 1 < count):
            nx, ny, _ = stroke.path[(k + 1) % count]
            points += _bow(complex(x, y), complex(nx, ny), bulge)
    if stroke.closed:
        points.append(points[0])
    corners = [(z.real, z.imag) for z in points]
    return shapely.Polygon(corners) if stroke.filled else shapely.LineString(corners)


def flat(controls: Sequence[complex]) -> list[complex]:
    """Return points along a chain of cubic arcs, eight to an arc."""
    t = np.linspace(0.0, 1.0, 9)[1:]
    points = [controls[0]]
    for k in range(0, len(controls) - 1, 3):
        a, b, c, d = controls[k : k + 4]
        points += list(
            (1 - t) ** 3 * a + 3 * (1 - t) ** 2 * t * b + 3 * (1 - t) * t**2 * c + t**3 * d
        )
    return points


def _bow(start: complex, end: complex, bulge: float) -> list[complex]:
    """Return points inside an arc given by its bulge."""
    quarter = math.atan(bulge)
    centre = (start + end) / 2 + (end - start) * 0.5j / math.tan(2 * quarter)
    count = max(2, math.ceil(abs(4 * quarter) / math.radians(20)))
    turns = [4 * quarter * k / count for k in range(1, count)]
    return [centre + (start - centre) * complex(math.cos(t), math.sin(t)) for t in turns]


def place(
    wanted: Sequence[Wanted],
    strokes: Sequence[Stroke | Bezier],
    taken: Sequence[Label] = (),
) -> tuple[Label, ...]:
    """Return the labels at their places, in the order wanted; ``taken`` labels stand already."""
    heavy = [shape(s) for s in strokes if s.pen in _HEAVY]
    light = [shape(s) for s in strokes if s.pen not in _HEAVY]
    lines = (shapely.STRtree(heavy), shapely.STRtree(light))
    boxes = [box(label) for label in taken]
    placed = []
    for one in wanted:
        label, made = _best(one, lines, boxes)
        placed.append(label)
        boxes.append(made)
    return tuple(placed)


def _best(
    one: Wanted, lines: tuple[shapely.STRtree, shapely.STRtree], boxes: list[shapely.Polygon]
) -> tuple[Label, shapely.Polygon]:
    made = letter(one.text, size=one.size)
    width, height = made.width, made.ascent + made.descent
    turns = np.exp(2j * np.pi * np.arange(DIRECTIONS) / DIRECTIONS)
    reach = 1.0 / np.maximum(2 * np.abs(turns.real) / width, 2 * np.abs(turns.imag) / height)
    rings = np.array(RINGS)
    centres = (
        one.at + turns[None, :] * (one.radius + CLEAR + reach[None, :] + rings[:, None])
    ).ravel()
    x, y = centres.real - width / 2, centres.imag - height / 2

    def grown(by: float) -> NDArray[np.object_]:
        return np.asarray(shapely.box(x - by, y - by, x + width + by, y + height + by))

    tried = grown(CLEAR / 2)
    cost = np.repeat(rings * _COST["ring"], DIRECTIONS)
    if one.toward:
        aim = one.toward / abs(one.toward)
        cost += _COST["turn"] * np.tile(np.abs(turns - aim) ** 2, len(rings)) * 4
    heavy, light = lines
    for tree, boxes_tried, weight in (
        (heavy, grown(CLEAR / 2 + HEAVY_HALF), _COST["heavy"]),
        (light, tried, _COST["light"]),
    ):
        hits = tree.query(boxes_tried, predicate="intersects")[0]
        cost += weight * np.bincount(hits, minlength=tried.size)
    if boxes:
        tree = shapely.STRtree(boxes)
        hits = tree.query(grown(CLEAR / 2 + APART), predicate="intersects")[0]
        cost += _COST["label"] * np.bincount(hits, minlength=tried.size)
    best = int(np.argmin(np.round(cost, 6)))
    spot = complex(x[best], y[best] + made.descent)
    label = Label(one.text, spot, one.size, of=one.of, position=one.position)
    return label, tried[best]


def leaders(wanted: Sequence[Wanted], labels: Sequence[Label]) -> tuple[Stroke, ...]:
    """Return thin lines from points to those of their labels that found no place beside them."""
    made = []
    for one, label in zip(wanted, labels, strict=True):
        spot, frame = shapely.Point(one.at.real, one.at.imag), box(label)
        if frame.distance(spot) > one.radius + LEADER:
            near = shapely.get_coordinates(shapely.shortest_line(spot, frame))
            start, end = (complex(x, y) for x, y in near)
            reach = (end - start) / abs(end - start)
            ink = line("thin", start + one.radius * reach, end - 0.5 * CLEAR * reach)
            made.append(ink._replace(part="leader", of=one.of, position=one.position))
    return tuple(made)


def interrupt(
    strokes: Sequence[Stroke | Bezier], labels: Sequence[Label]
) -> tuple[Stroke | Bezier, ...]:
    """Return the strokes with straight thin lines broken where a label stands on them."""
    if not labels:
        return tuple(strokes)
    boxes = [shapely.buffer(box(label), CLEAR / 2, join_style="mitre") for label in labels]
    tree = shapely.STRtree(boxes)
    made: list[Stroke | Bezier] = []
    for stroke in strokes:
        if not _breakable(stroke):
            made.append(stroke)
            continue
        whole = shape(stroke)
        hits = np.sort(tree.query(whole, predicate="intersects"))
        if not hits.size:
            made.append(stroke)
            continue
        left = shapely.difference(whole, shapely.union_all([boxes[k] for k in hits]))
        for piece in shapely.get_parts(left):
            if piece.length > CLEAR:
                ends = [(float(x), float(y), 0.0) for x, y in piece.coords]
                made.append(stroke._replace(path=tuple(ends)))
    return tuple(made)


def _breakable(stroke: Stroke | Bezier) -> TypeGuard[Stroke]:
    return (
        isinstance(stroke, Stroke)
        and stroke.pen == "thin"
        and not stroke.filled
        and not stroke.closed
        and not stroke.data
        and all(bulge == 0.0 for _, _, bulge in stroke.path)
    )
