"""Where the centre of a cam with a rocking roller may stand, in ink: levers, limits, circle of centres."""

from __future__ import annotations

import cmath
import math

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.chapters.cam.centre import VIEW, Centre
from graphic_tmm.chapters.cam.ink_centre import CentreNames
from graphic_tmm.chapters.cam.ink_numbers import (
    SIZE,
    SMALL,
    Numbers,
    finished,
    numbered,
    segments,
)
from graphic_tmm.chapters.cam.plan import Cam
from graphic_tmm.chapters.cam.rocker import Lever
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, arc, circle, line
from graphic_tmm.paper.symbols.kinematic import fixed_pivot

AROUND = 12.0
"""How far, in degrees, the arc of the centres is drawn behind what stands on it."""
BEYOND = 10.0
"""How far the limit that binds goes on behind the circle of the centres, mm."""
ANGLE = 18.0
"""Radius of the arc that shows the allowed pressure angle, mm."""


def draw_rocker_ink(
    reading: Reading,
    cam: Cam,
    names: CentreNames,
    title: str,
    *,
    lettered: bool = True,
) -> Drawing:
    """Return the levers with dS/dφ laid off along them, the limits, and the centres on their circle."""
    made, path = cam.centre, cam.path
    assert isinstance(made, Centre)
    assert isinstance(path, Lever)
    ink = Numbers(reading, cam)
    roller, points = ink.all(made.roller), ink.all(made.points)
    centre, least, lowest = (
        ink.one(mark) for mark in (made.centre, made.least_centre, made.lowest)
    )
    distance = ink.length(path.centres)
    strokes: list[Ink] = segments(np.zeros_like(roller), roller)
    strokes += segments(roller, points)
    wanted: list[Wanted] = []
    spots = _limits(ink, cam, made, strokes, wanted, names.limits)
    for mark in made.curves:
        strokes += ink.curve(mark)
    strokes += ink.dots(points)
    strokes += _arcs(roller, lowest, distance, [*spots, centre, least])
    strokes.append(line("main", 0j, lowest))
    wanted += [
        Wanted("O_{1}", 0j, SIZE, 2.0, -lowest),
        Wanted("B_{0}", lowest, SMALL, 1.0, lowest - 1j * abs(lowest)),
    ]
    if np.isfinite(least):
        strokes.append(circle("main", least, 0.7, filled=True))
        wanted.append(Wanted("O_{min}", least, SMALL, 1.2, least - lowest))
    if np.isfinite(centre):
        strokes += [line("thin", 0j, centre), line("thin", lowest, centre)]
        strokes.append(circle("joint", centre, 1.2))
        wanted.append(Wanted("O", centre, SIZE, 1.8, centre))
        wanted.append(Wanted(names.r0, (lowest + centre) / 2, SMALL, 0.5, lowest))
    strokes += fixed_pivot(0j)
    wanted += numbered(names.positions, points, points - complex(np.nanmean(points)))
    return finished(VIEW, title, strokes, wanted, (), lettered)


def _limits(
    ink: Numbers,
    cam: Cam,
    made: Centre,
    strokes: list[Ink],
    wanted: list[Wanted],
    texts: tuple[str, str],
) -> list[complex]:
    """Ink the limits from the points Q to the circle below the lever, the one that binds heavily.

    Returns where they end on the circle.
    """
    path, found = cam.path, list[tuple[float, complex, complex, str]]()
    assert isinstance(path, Lever)
    points, lowest = ink.all(made.points), ink.one(made.lowest)
    for mark, text, phase in zip(made.ends, texts, cam.diagrams.turn.phases, strict=True):
        part = slice(phase.first, phase.last + 1)
        for q, end in zip(points[part], ink.all(mark)[part], strict=True):
            turn = -path.sense * cmath.phase(end / lowest) if np.isfinite(end) else -1.0
            if turn > 0.0 and np.isfinite(q):
                found.append((turn, complex(q), complex(end), text))
    for _, q, end, _ in found:
        strokes.append(line("thin", q, end))
    if found:
        _, q, end, text = max(found)
        way = (end - q) / abs(end - q)
        strokes.append(line("main", q - 6.0 * way, end + BEYOND * way))
        square = 1j * q / abs(q)  # the path at Q, turned to the side of the centre
        square *= 1.0 if (square * way.conjugate()).real > 0 else -1.0
        strokes.append(line("thin", q, q + (ANGLE + 6.0) * square))
        sweep = math.degrees(cmath.phase(way / square))
        strokes.append(arc("thin", q, ANGLE, math.degrees(cmath.phase(square)), sweep))
        middle = ANGLE * square * cmath.exp(1j * math.radians(sweep / 2))
        wanted.append(Wanted(text, q + middle, SMALL, 0.5, middle))
    return [end for _, _, end, _ in found]


def _arcs(roller: np.ndarray, lowest: complex, distance: float, spots: list[complex]) -> list[Ink]:
    """Ink the path of the roller and the part of the circle of the centres that is needed, about the pivot."""
    begin = math.degrees(cmath.phase(lowest))

    def swept(z: complex) -> float:
        return math.degrees(cmath.phase(z / lowest))

    turns = [swept(complex(z)) for z in roller if np.isfinite(z)]
    made: list[Ink] = []
    if turns:
        low, high = min(turns), max(turns)
        made.append(arc("thin", 0j, abs(lowest), begin + low, high - low))
    ends = [swept(z) for z in spots if np.isfinite(z)]
    if ends:
        low, high = min(ends) - AROUND, max(ends) + AROUND
        made.append(arc("thin", 0j, distance, begin + low, high - low))
    return made
