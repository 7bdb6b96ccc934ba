"""The profile of a cam in ink: both profiles, the follower in its place and in its inverted places."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.values import Complexes
from graphic_tmm.chapters.cam.centre import Path
from graphic_tmm.chapters.cam.ink_numbers import (
    LEAST,
    SIZE,
    SMALL,
    Numbers,
    directions,
    finished,
    numbered,
    segments,
)
from graphic_tmm.chapters.cam.plan import Cam
from graphic_tmm.chapters.cam.profile import VIEW, Contour
from graphic_tmm.chapters.cam.rocker import Lever
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, arc, circle, line
from graphic_tmm.paper.symbols.kinematic import arrowhead, channel, fixed_pivot, round_arrow

BEYOND = 4.0
"""How far a guide goes on behind its roller, to the number of its position, mm."""
ROD = 34.0
"""Length of the rod of a translating follower above its roller or face, mm."""
GUIDE, WIDTH = 16.0, 5.0
"""Length of the guide of a rod, width of the rod, mm."""
CROSS = 5.0
"""How far centre lines go on behind the circle of r0, mm."""
PIN = 1.2
"""Radius of the roller's pin, mm."""
ROOMY = 40.0
"""The least lower dwell, degrees, beside which letters find room."""
TURN = 9.0
"""Radius of the arrow of the cam's turning, mm."""


class ProfileNames(NamedTuple):
    """What is lettered: positions, the radius r0, the roller's radius with its value, the two profiles."""

    positions: Sequence[str]
    r0: str
    roller: str
    theoretical: str
    working: str
    omega: str = "ω"


def draw_profile_ink(
    reading: Reading, cam: Cam, names: ProfileNames, title: str, *, lettered: bool = True
) -> Drawing:
    """Return the profiles of a cam with the rollers (or faces) whose envelope the working one is."""
    ink, made = Numbers(reading, cam), cam.profile
    working, theoretical = made.working, made.theoretical
    rollers = ink.all((theoretical or working).points)
    strokes: list[Ink] = [*_inverted(ink, cam, rollers)]
    strokes += contour(ink, working, "main")
    if theoretical is not None:
        strokes += contour(ink, theoretical, "medium")
        radius = ink.length(made.roller) if made.roller is not None else 0.0
        strokes += [circle("thin", complex(z), radius) for z in rollers if np.isfinite(z)]
    strokes += _follower(ink, cam, rollers)
    strokes += _centre(ink, cam)
    wanted = _letters(ink, cam, names, rollers, strokes)
    return finished(VIEW, title, strokes, wanted, (), lettered)


def contour(ink: Numbers, of: Contour, pen: str) -> Iterator[Ink]:
    """Ink a closed profile: the curves of its stretches, the arcs of its dwells."""
    turn, points = ink.cam.diagrams.turn, ink.all(of.points)
    for mark in of.curves:
        yield from ink.curve(mark, pen)
    order = ink.cam.order
    rows = (
        (of.upper, turn.rise.last, order.upper_dwell),
        (of.lower, turn.fall.last, order.lower_dwell),
    )
    for mark, at, dwell in rows:
        circle_, start = ink.reading[mark], complex(points[at])
        if dwell > LEAST / 60.0 and np.isfinite(start):
            begin = math.degrees(cmath.phase(start))
            yield arc(pen, 0j, float(circle_.radius[0, 0]), begin, of.sense * dwell)


def _inverted(ink: Numbers, cam: Cam, points: Complexes) -> Iterator[Ink]:
    """The guides of the follower turned back, the circles on which they stand."""
    made = cam.profile
    feet = ink.all(made.feet) if made.feet is not None else np.zeros_like(points)
    if isinstance(cam.path, Lever):
        distance = ink.length(cam.path.centres)
        yield circle("thin", 0j, distance)
        yield from segments(feet, points)
        for z in feet:
            if np.isfinite(z):
                yield circle("thin", complex(z), 0.8)
    elif isinstance(cam.path, Path):
        reach = BEYOND + (ink.length(made.roller) if made.roller is not None else 0.0)
        yield from segments(feet, points + reach * directions(points - feet))
        if cam.path.offset is not None:
            yield circle("thin", 0j, abs(ink.length(cam.path.offset)))
    else:
        yield from segments(np.zeros_like(feet), feet)
        along = ink.reading[made.guides].along[0]
        half = np.abs(points - feet) + 8.0
        yield from segments(feet - half * along, feet + half * along)
    lower = made.theoretical or made.working
    radius = float(ink.reading[lower.lower].radius[0, 0])
    if math.isfinite(radius):
        yield circle("thin", 0j, radius)


def _follower(ink: Numbers, cam: Cam, points: Complexes) -> Iterator[Ink]:
    """The follower in its lowest place, in full: roller and rod in a guide, lever, or face."""
    start, made = complex(points[0]), cam.profile
    if not np.isfinite(start):
        return
    radius = ink.length(made.roller) if made.roller is not None else 0.0
    if isinstance(cam.path, Lever):
        assert made.feet is not None
        pivot = complex(ink.all(made.feet)[0])
        yield circle("main", start, radius)
        yield line("main", pivot, start)
        yield from fixed_pivot(pivot)
        yield circle("joint", start, PIN)
        return
    if made.roller is None:
        assert made.feet is not None
        feet = ink.all(made.feet)
        start = complex(feet[0])
        half = float(np.nanmax(np.abs(points - feet))) + 5.0
        yield line("main", start - half, start + half)
    else:
        yield circle("main", start, radius)
    top, half = start + 1j * (ROD + radius), 0.5 * WIDTH
    yield line("body", start - half, start + half, top + half, top - half, closed=True)
    yield from channel(top - 0.5j * GUIDE - 4j, 90.0, GUIDE, width=WIDTH)
    if made.roller is not None:
        yield circle("joint", start, PIN)


def _centre(ink: Numbers, cam: Cam) -> Iterator[Ink]:
    """Centre lines, the cam's shaft, the arrow of its turning."""
    reach = float(ink.reading[cam.profile.working.upper].radius[0, 0]) + CROSS
    if not math.isfinite(reach):
        return
    for way in (1.0, 1j):
        yield line("centre", -reach * way, reach * way)
    yield circle("joint", 0j, 2.0)
    yield from round_arrow(0j, TURN, 90.0 - cam.sense * 200.0, cam.sense * 110.0)


def _ends(ink: Numbers, cam: Cam, points: Complexes) -> tuple[Complexes, Complexes]:
    """Where the numbers of the positions stand, and in which direction from there."""
    feet = ink.all(cam.profile.feet) if cam.profile.feet is not None else 0j * points
    if isinstance(cam.path, Lever):
        return feet, directions(feet)
    if cam.profile.roller is None:
        return feet, directions(feet)
    ways = directions(points - feet)
    return points + (ink.length(cam.profile.roller) + BEYOND) * ways, ways


def _letters(
    ink: Numbers, cam: Cam, names: ProfileNames, points: Complexes, strokes: list[Ink]
) -> list[Wanted]:
    """What the profile is lettered with; the arrows of radii are added to the strokes."""
    spots, ways = _ends(ink, cam, points)
    aside = np.array(ways)
    free = complex(-cam.sense)  # beside the follower no positions stand on this side
    if not isinstance(cam.path, Lever) and np.isfinite(points[0]):
        spots = np.array(spots)
        spots[0] += (0.5 * WIDTH + 0.5) * free - 3.0j
        aside[0] = free
    wanted = [
        Wanted("O", 0j, SIZE, 2.5, free - 1j),
        Wanted(
            names.omega, TURN * cmath.rect(1.0, math.radians(-90 + cam.sense * 15)), SMALL, 1.0, -1j
        ),
        *numbered(
            names.positions, spots, aside, radius=1.6 if isinstance(cam.path, Lever) else 0.6
        ),
    ]
    if cam.profile.roller is not None and np.isfinite(points[0]):
        start, radius = complex(points[0]), ink.length(cam.profile.roller)
        way = cmath.exp(1j * math.radians(90.0 + cam.sense * 55.0))
        edge = start + radius * way
        strokes += [line("thin", start, edge + 5.0 * way)]
        strokes += arrowhead(edge, way, pen="thin")
        wanted.append(Wanted(names.roller, edge + 5.0 * way, SMALL, 0.5, free))
    return [*wanted, *_dwell_letters(ink, cam, names, points, strokes)]


def _dwell_letters(
    ink: Numbers, cam: Cam, names: ProfileNames, points: Complexes, strokes: list[Ink]
) -> Iterator[Wanted]:
    """The names of the profiles and the radius r0, where the lower dwell leaves room for them."""
    dwell, made = cam.order.lower_dwell, cam.profile
    last = complex(points[cam.diagrams.turn.fall.last])
    if dwell < ROOMY or not np.isfinite(last) or last == 0:
        return

    def at(*shares: float) -> complex:
        """Return the direction of the share of the dwell that keeps farthest from the centre lines."""
        turns = [made.working.sense * math.radians(share * dwell) for share in shares]
        ways = [last / abs(last) * cmath.exp(1j * turn) for turn in turns]
        return max(ways, key=lambda way: round(abs((way * way).imag), 6))

    radius = float(ink.reading[made.working.lower].radius[0, 0])
    way = at(0.5, 0.55, 0.6)
    yield Wanted(names.working, radius * way, SMALL, 0.5, -way)
    if made.theoretical is not None:
        radius = float(ink.reading[made.theoretical.lower].radius[0, 0])
        way = at(0.7, 0.75)
        yield Wanted(names.theoretical, radius * way, SMALL, 0.5, way)
    way = at(0.15, 0.25, 0.35)
    strokes += [line("thin", 0j, radius * way), *arrowhead(radius * way, way, pen="thin")]
    yield Wanted(names.r0, 0.45 * radius * way, SMALL, 0.5, 1j * way)
