"""Where the centre of a cam with a translating follower may stand, in ink: tangents, region, radii."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.chapters.cam.centre import VIEW, Centre
from graphic_tmm.chapters.cam.ink_numbers import (
    LEAST,
    OVER,
    SIZE,
    SMALL,
    Numbers,
    arrow_axis,
    finished,
    numbered,
    segments,
)
from graphic_tmm.chapters.cam.plan import Cam
from graphic_tmm.paper.drawing import Drawing, Ink, Label, Wanted, arc, circle, line
from graphic_tmm.paper.symbols.dimensions import dimension
from graphic_tmm.paper.symbols.kinematic import hatching

BELOW = 30.0
"""How far the limits of the region go on below the point where they meet, mm."""
ABOVE = 12.0
"""How far a tangent goes on behind the point of contact, mm."""
ANGLE = 24.0
"""Radius of the arc that shows an allowed pressure angle, mm."""
ASIDE = 12.0
"""From the outermost point of the curve to the dimension of a radius, mm."""


class CentreNames(NamedTuple):
    """What is lettered: positions, the axes of displacement and derivative, the two radii with their values.

    ``limits``: the allowed pressure angles towards the rise and the return; ``offset``: e with its value.
    """

    positions: Sequence[str]
    up: str
    out: str
    least: str
    r0: str
    limits: tuple[str, str] = ("[α]", "[α]")
    offset: str = "e"


def draw_centre_ink(
    reading: Reading,
    cam: Cam,
    names: CentreNames,
    title: str,
    *,
    lettered: bool = True,
) -> Drawing:
    """Return the S–dS/dφ diagram of a translating roller with the region of allowed centres."""
    made = cam.centre
    assert isinstance(made, Centre)
    ink, out = Numbers(reading, cam), complex(-cam.sense)
    points = ink.all(made.points)
    side = (points * np.conj(out)).real
    near, far = float(np.nanmin(side, initial=0.0)), float(np.nanmax(side, initial=0.0))
    top = float(np.nanmax(points.imag, initial=0.0))
    strokes: list[Ink] = segments(ink.all(made.roller), points)
    for mark in made.curves:
        strokes += ink.curve(mark)
    strokes += ink.dots(points)
    strokes += arrow_axis(out * (near - OVER), out * (far + OVER))
    strokes += arrow_axis(0j, complex(0, top + OVER))
    wanted = [
        Wanted(names.up, complex(0, top + OVER), SIZE, 1.5, -out),
        Wanted(names.out, out * (far + OVER), SIZE, 1.5, -1j),
        Wanted("B_{0}", 0j, SMALL, 1.0, -out - 1j),
    ]
    centre, least = ink.one(made.centre), ink.one(made.least_centre)
    low = _region(ink, cam, made, strokes)
    figures = _radii(strokes, wanted, (centre, least), names, out, (near, far))
    foot = min(centre.imag, least.imag) - 3.0 if np.isfinite(centre) else low
    aside = centre.real if np.isfinite(centre) else 0.0
    strokes.append(line("centre", complex(aside, 8.0), complex(aside, foot)))
    _angles(ink, cam, made, strokes, wanted, names.limits)
    wanted += numbered(names.positions, points, points - 0.5j * top)
    return finished(VIEW, title, strokes, wanted, figures, lettered)


def _region(ink: Numbers, cam: Cam, made: Centre, strokes: list[Ink]) -> float:
    """Ink the tangents and hatch the region between them; return how low it reaches."""
    assert made.apex is not None
    apex, bottom = ink.one(made.apex), 0.0
    for mark, phase in zip(made.limits, cam.diagrams.turn.phases, strict=True):
        limit = ink.reading[mark]
        spot, way = complex(limit.at[0, 0]), complex(limit.along[0, 0])
        if not (np.isfinite(spot) and np.isfinite(apex)):
            continue
        deepest = [z.imag - ABOVE for z in (ink.one(made.least_centre), ink.one(made.centre))]
        bottom = min([apex.imag - BELOW, *(y for y in deepest if math.isfinite(y))])
        foot = spot + way * ((bottom - spot.imag) / way.imag)
        strokes.append(line("main", foot, spot + ABOVE * way))
        strokes += hatching(foot, apex, -1 if phase.sign * cam.sense < 0 else 1)
    return bottom


def _radii(
    strokes: list[Ink],
    wanted: list[Wanted],
    centres: tuple[complex, complex],
    names: CentreNames,
    out: complex,
    reach: tuple[float, float],
) -> list[Label]:
    """Ink the chosen centre and the least one, the dimensions of their radii on either side."""
    centre, least = centres
    figures = []
    rows = (
        (least, names.least, "O_{min}", -out, -reach[0]),
        (centre, names.r0, "O", out, reach[1]),
    )
    for spot, text, letter, way, room in rows:
        if not np.isfinite(spot):
            continue
        big = letter == "O"
        strokes.append(
            circle("joint" if big else "main", spot, 1.2 if big else 0.7, filled=not big)
        )
        wanted.append(Wanted(letter, spot, SIZE if big else SMALL, 1.4, way))
        if abs(spot.real) > LEAST:  # a radius that leans is lettered along itself
            if big:
                strokes.append(line("thin", spot, 0j))
                wanted.append(Wanted(text, 0.45 * spot, SMALL, 0.5, out))
                low = complex(0, spot.imag)
                ends = (low, spot) if spot.real > 0 else (spot, low)
                made = dimension(*ends, -(ABOVE + ASIDE), names.offset)
                strokes += [line("thin", 0j, low), *made.strokes]
                figures.append(made.label)
            continue
        left = 1.0 if (1j * (0j - spot) * np.conj(way)).real > 0 else -1.0
        made = dimension(spot, 0j, left * (min(room, 40.0) + ASIDE), text)
        strokes += made.strokes
        figures.append(made.label)
    return figures


def _angles(
    ink: Numbers,
    cam: Cam,
    made: Centre,
    strokes: list[Ink],
    wanted: list[Wanted],
    texts: tuple[str, str],
) -> None:
    """Ink the allowed pressure angles where the limits cut the line of the centres."""
    for limit, mark, text in zip(made.limits, made.ends, texts, strict=True):
        spot, way = ink.one(mark), complex(ink.reading[limit].along[0, 0])
        if not np.isfinite(spot):
            continue
        sweep = math.degrees(cmath.phase(way / 1j))
        strokes.append(arc("thin", spot, ANGLE, 90.0, sweep))
        middle = spot + cmath.rect(ANGLE, math.radians(90.0 + sweep / 2))
        wanted.append(Wanted(text, middle, SMALL, 0.5, middle - spot))
