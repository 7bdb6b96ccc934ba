"""The bodies of a cam mechanism in ink: contours over the dwells, rollers, levers, the follower, the shaft."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

import numpy as np

from graphic_tmm.board.record import Figure
from graphic_tmm.board.values import Arc, Complexes
from graphic_tmm.chapters.cam.ink_rules import CamInk
from graphic_tmm.chapters.cam.profile import THEORETICAL
from graphic_tmm.paper.drawing import Ink, arc, circle, line
from graphic_tmm.paper.figure import added, body
from graphic_tmm.paper.seen import finite
from graphic_tmm.paper.symbols.kinematic import channel, fixed_pivot, round_arrow

ROD = 34.0
"""Length of the rod of a translating follower above its roller or face, mm."""
GUIDE, WIDTH = 16.0, 5.0
"""Length of the guide of a rod, width of the rod, mm."""
CROSS = 5.0
"""How far centre lines go on behind the circle of r0, mm."""
PIN, PIVOT = 1.2, 0.8
"""Radius of the roller's pin, and of the lever's pivot in an inverted place, mm."""
TURN = 9.0
"""Radius of the arrow of the cam's turning, mm."""
DWELL = 1e-6
"""What is shorter is no dwell, degrees."""


def inverted(ink: CamInk) -> Iterator[Ink]:
    """Rollers and pivots in their inverted places, the circles on which pivots and guides stand."""
    for roller in ink.figures("roller"):
        centre, radius = roller.marks
        for k, at in enumerate(ink.all(centre)):
            if np.isfinite(at):
                made = circle("thin", complex(at), ink.length(radius))
                yield from body([made], "roller", roller.marks, k)
    for lever in ink.figures("lever"):
        pivots = lever.marks[0]
        for k, at in enumerate(ink.all(pivots)):
            if np.isfinite(at):
                yield from body([circle("thin", complex(at), PIVOT)], "pivot", [pivots], k)
    for stand in ink.figures("lever") + ink.figures("guide"):
        mark = stand.marks[0]
        reach = abs(complex(ink.all(mark)[0]))
        if len(stand.marks) > 1 and math.isfinite(reach):
            yield from body([circle("thin", 0j, reach)], "circle", [mark])


def dwells(ink: CamInk, contour: Figure) -> Iterator[Ink]:
    """The arcs of a contour: each goes on from the end of the curve before it to the beginning of the next."""
    pen = "medium" if contour.name == THEORETICAL else "main"
    sense = -ink.cam.sense
    for n, mark in enumerate(contour.marks):
        if mark.kind is not Arc:
            continue
        before, after = contour.marks[n - 1], contour.marks[(n + 1) % len(contour.marks)]
        ends = ink.seen.reading[before].knots[0, -1], ink.seen.reading[after].knots[0, 0]
        start, end = (complex(z) for z in ends)
        radius = ink.seen.arc(mark, 0)[1]
        if not finite(start, end, radius):
            continue
        turn = (sense * math.degrees(cmath.phase(end / start))) % 360.0
        if DWELL < turn < 360.0 - DWELL:
            begin = math.degrees(cmath.phase(start))
            made = arc(pen, 0j, radius, begin, sense * turn)
            yield from body([made], "contour", [mark, before, after])


def follower(ink: CamInk, points: Complexes) -> Iterator[Ink]:
    """The follower in its lowest place, in full: roller and rod in a guide, lever, or face."""
    start, made = complex(points[0]), ink.cam.profile
    if not np.isfinite(start):
        return
    radius = 0.0
    for roller in ink.figures("roller"):
        radius = ink.length(roller.marks[1])
        strokes = (circle("main", start, radius), circle("joint", start, PIN))
        yield from body(strokes, "roller", roller.marks, 0)
    for lever in ink.figures("lever"):
        pivot = complex(ink.all(lever.marks[0])[0])
        strokes_ = (line("main", pivot, start), *fixed_pivot(pivot))
        yield from body(strokes_, "lever", lever.marks, 0)
        return
    for face in ink.figures("face"):
        feet = ink.all(face.marks[0])
        start = complex(feet[0])
        half = float(np.nanmax(np.abs(points - feet))) + 5.0
        yield from body([line("main", start - half, start + half)], "face", face.marks, 0)
    top, half = start + 1j * (ROD + radius), 0.5 * WIDTH
    rod = line("body", start - half, start + half, top + half, top - half, closed=True)
    stand = channel(top - 0.5j * GUIDE - 4j, 90.0, GUIDE, width=WIDTH)
    yield from body([rod, *stand], "follower", [(made.theoretical or made.working).points], 0)


def shaft(ink: CamInk) -> Iterator[Ink]:
    """Centre lines, the cam's shaft, the arrow of its turning."""
    cam = ink.cam
    reach = ink.seen.arc(cam.profile.working.upper, 0)[1] + CROSS
    if not math.isfinite(reach):
        return
    cross = [line("centre", -reach * way, reach * way) for way in (1 + 0j, 1j)]
    yield from added(cross, "axis")
    centre = [cam.profile.centre]
    yield from body([circle("joint", 0j, 2.0)], "pivot", centre)
    bow = round_arrow(0j, TURN, 90.0 - cam.sense * 200.0, cam.sense * 110.0)
    yield from body(bow, "sense", centre)
