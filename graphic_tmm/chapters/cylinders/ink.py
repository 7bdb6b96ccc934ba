"""An engine's cranks in ink: along the shaft with the axes of its banks; from the side."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from itertools import pairwise

from graphic_tmm.board.operations.instruments import lay_off
from graphic_tmm.chapters.cylinders.plan import Inertia
from graphic_tmm.chapters.cylinders.task import VEE
from graphic_tmm.chapters.cylinders.words import SHAFT, STAR
from graphic_tmm.language.numbers import number
from graphic_tmm.language.units import small
from graphic_tmm.paper.drawing import Drawing, Ink, line
from graphic_tmm.paper.figure import Manner, added, body, figure
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.rules import laid_off
from graphic_tmm.paper.seen import Subject
from graphic_tmm.paper.symbols.dimensions import dimension
from graphic_tmm.paper.symbols.kinematic import turning_pair

BEYOND = 10.0
"""How far axes go on behind the cranks, mm."""
LEAST, WIDEST = 1.5, 7.0
"""Half the width of a crank from the side, mm."""
BELOW = 17.0
"""From the lowest pin down to the dimension, mm."""
BESIDE = cmath.rect(1.0, -0.8)
"""How far letters turn aside from their cranks."""
JOINT = 2.2
"""What letters keep from a pin, mm."""


def draw_star(on: Subject, made: Inertia) -> Drawing:
    """Return the cranks along the shaft; chain lines are the axes of the cylinders."""
    seen = on.seen((STAR,), [0])
    traces = figure(seen, Manner({lay_off.name: laid_off}, lambda seen, step: step.op is lay_off))
    spots = {name: seen.point(mark, 0) for name, mark in made.pins.items()}
    far = max(abs(spot) for spot in spots.values()) + BEYOND
    axes = dict.fromkeys(row.of.axis for row in made.rows)
    chains: list[Ink] = []
    for angle in axes:
        chains.append(line("centre", 0j, cmath.rect(far, math.radians(90.0 + angle))))
    if not made.order.banked:
        chains.append(line("centre", 0j, -far * 1j))
    strokes = [*traces.staying, *added(chains, "axis")]
    strokes += body(turning_pair(0j), "pair", list(made.pins.values())[:1])
    for name, spot in spots.items():
        strokes += body(turning_pair(spot), "pair", [made.pins[name]])
    names = [Named(spot, name, (made.pins[name].slot,)) for name, spot in spots.items()]
    wanted = [  # beside the axis that a crank may lie on
        one._replace(toward=one.toward * BESIDE)
        for one in lettered(shared(names), on.heights.point, JOINT, away_from=0j)
    ]
    return traces.drawing(on, strokes, wanted)


def draw_shaft(on: Subject, made: Inertia) -> Drawing:
    """Return the shaft from the side: each crank as high as it reaches up, the pins' numbers."""
    seen = on.seen((SHAFT,), [0])
    traces = figure(seen, Manner({}, lambda seen, step: False))
    spots = {name: seen.point(mark, 0) for name, mark in made.stations.items()}
    marks = list(made.stations.values())
    throws = _throws(made, spots)
    strokes: list[Ink] = list(body(_zigzag(throws), "shaft", marks))
    low = min(spot.real for spot in spots.values()) - WIDEST
    high = max(spot.real for spot in spots.values()) + WIDEST
    strokes += added([line("centre", complex(low - BEYOND), complex(high + BEYOND))], "axis")
    labels = []
    first, last = throws[0][0], throws[-1][0]
    if len(throws) > 1 and last.real - first.real > LEAST:
        foot = min([0.0, *(spot.imag for spot in spots.values())]) * 1j
        ends = first.real + foot, last.real + foot
        size = made.order.spacing * (len(throws) - 1)
        if len(throws) == made.order.pins:
            text = number(small(size, on.language)[0], on.language)
            told = dimension(*ends, -BELOW, text, on.heights.number)
            strokes += body(told.strokes, "dimension", marks)
            labels.append(told.label._replace(of=tuple(mark.slot for mark in marks)))
    names = [
        Named(spot + (1j if spot.imag >= 0 else -1j), name, (made.stations[name].slot,))
        for name, spot in spots.items()
    ]
    wanted = [
        one._replace(toward=1j if one.at.imag >= 0 else -1j)
        for one in lettered(shared(names), on.heights.point)
    ]
    return traces.drawing(on, strokes, wanted, labels)


def _throws(made: Inertia, spots: dict[str, complex]) -> list[tuple[complex, float, float]]:
    """Return the crank pins from left to right: their middles, their reach to a side, half a crank."""
    groups: dict[int, list[complex]] = {}
    for k, spot in enumerate(spots.values()):
        alone = made.order.layout != VEE or made.order.firing
        groups.setdefault(k if alone else k % made.order.pins, []).append(spot)
    found = sorted(_middles(groups), key=lambda one: one[0].real)
    gaps = [b[0].real - b[1] - a[0].real - a[1] for a, b in pairwise(found)]
    half = min([WIDEST, *(max(LEAST, gap / 4) for gap in gaps)])
    return [(middle, reach + half, half) for middle, reach in found]


def _middles(groups: dict[int, list[complex]]) -> Iterator[tuple[complex, float]]:
    for group in groups.values():
        xs = [spot.real for spot in group]
        yield complex((max(xs) + min(xs)) / 2, group[0].imag), (max(xs) - min(xs)) / 2


def _zigzag(throws: list[tuple[complex, float, float]]) -> Iterator[Ink]:
    """The shaft in one line, with journals at both ends."""
    corners = []
    first, last = throws[0], throws[-1]
    corners.append(complex(first[0].real - first[1] - WIDEST))
    for middle, reach, _ in throws:
        for side in (-1, 1):
            foot, top = complex(middle.real + side * reach), middle + side * reach
            corners += [foot, top] if side < 0 else [top, foot]
    corners.append(complex(last[0].real + last[1] + WIDEST))
    yield line("main", *corners)
