"""The scheme of a cam mechanism in ink: cam, follower and frame in one position, base circle, pressure angle.

It is the profile turned back by the angle of the cam, so that the follower stands as it does in the machine:
the same marks, in the position in which the pressure angle of the rise is largest.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.operations.curve import bezier
from graphic_tmm.board.values import Arc
from graphic_tmm.chapters.cam.ink import PIN, TURN, dwells, face_lever, rod
from graphic_tmm.chapters.cam.ink_rules import CamInk
from graphic_tmm.chapters.cam.plan import Cam
from graphic_tmm.chapters.cam.profile import THEORETICAL, VIEW
from graphic_tmm.paper.drawing import Bezier, Drawing, Ink, Wanted, circle, line
from graphic_tmm.paper.figure import added, body
from graphic_tmm.paper.seen import Subject, finite
from graphic_tmm.paper.symbols.dimensions import angular
from graphic_tmm.paper.symbols.kinematic import fixed_pivot, round_arrow

NAME = "cam scheme"
BEYOND, ASIDE = 26.0, 12.0
"""How far the normal and the way go on behind the roller, how far centre lines go on behind the cam, mm."""
FACE = 6.0
"""How far a face goes on behind the point where it touches, mm."""
ARC = 20.0
"""How far beyond the roller the arc of the pressure angle stands, mm."""
CENTRED = 1e-6
"""A normal nearer to the way, degrees, is no angle to be drawn."""


class SchemeNames(NamedTuple):
    """What is lettered: the pressure angle and the base circle's radius with their values."""

    pressure: str
    r0: str
    omega: str = "ω"


def position_of(reading: Reading, cam: Cam) -> int:
    """Return the position shown: where the pressure angle of the rise is largest, or S grows fastest."""
    turn = cam.diagrams.turn
    mark = getattr(cam.centre, "pressure", None) or cam.diagrams.V.reading
    row = np.abs(reading.figure(mark)[0])
    there = [k for k in turn.among(turn.rise) if np.isfinite(row[k])]
    return max(there, key=lambda k: row[k], default=turn.rise.first + turn.rise.parts // 2)


def draw_scheme_ink(on: Subject, cam: Cam, names: SchemeNames) -> Drawing:
    """Return the mechanism in one position."""
    ink = CamInk(on, cam, VIEW)
    k = position_of(on.reading, cam)
    angle = ink.number(cam.diagrams.angle, k)
    turn = cmath.exp(1j * cam.sense * math.radians(angle))
    cam_, letters = [*cam_body(ink, turn)], [*_letters(ink, names)]
    follower, more = _follower(ink, k, turn, names)
    strokes, wanted = (*cam_, *follower, *_shaft(ink)), (*letters, *more)
    return Drawing(NAME, on.title, strokes, shows=(VIEW,), wanted=wanted)


def _turned(stroke: Ink, turn: complex) -> Ink:
    """Return a stroke turned about the cam's centre."""
    if isinstance(stroke, Bezier):
        return stroke._replace(controls=tuple(c * turn for c in stroke.controls))
    spots = [(complex(x, y) * turn, bulge) for x, y, bulge in stroke.path]
    return stroke._replace(path=tuple((z.real, z.imag, bulge) for z, bulge in spots))


def cam_body(ink: CamInk, turn: complex) -> Iterator[Ink]:
    """The contour as the cam stands, the path of the roller's centre thin; the base circle."""
    for contour in ink.figures("contour"):
        pen = "thin" if contour.name == THEORETICAL else "main"
        for mark in contour.marks:
            if mark.kind is Arc:
                continue
            runs = bezier(ink.reading[mark])
            curves = [Bezier(pen, tuple(complex(z) for z in run), mark.name) for run in runs]
            yield from body((_turned(one, turn) for one in curves), "contour", [mark])
        yield from (_turned(one, turn)._replace(pen=pen) for one in dwells(ink, contour))
    made = ink.cam.profile
    lower = (made.theoretical or made.working).lower
    radius = ink.arc(lower, 0)[1]
    if math.isfinite(radius):
        yield from body([circle("dashed", 0j, radius)], "circle", [lower])


def _follower(
    ink: CamInk, k: int, turn: complex, names: SchemeNames
) -> tuple[list[Ink], list[Wanted]]:
    """The follower upright in its guide (or its lever on its pivot), the normal, the pressure angle."""
    made, sense = ink.cam.profile, ink.cam.sense
    points = (made.theoretical or made.working).points
    swung = ink.figures("face lever")
    flat = made.theoretical is None and made.feet is not None and not swung
    mark = made.feet if flat and made.feet is not None else points
    at = complex(ink.all(mark)[k]) * turn
    if not finite(at):
        return [], []
    strokes: list[Ink] = []
    radius = ink.fixed_number(made.roller) if made.roller is not None else 0.0
    if made.roller is not None:
        pins: list[Ink] = [circle("main", at, radius), circle("joint", at, PIN)]
        strokes += body(pins, "roller", [points, made.roller], k)
    if swung:
        spots = (complex(ink.all(one)[k]) * turn for one in swung[0].marks)
        strokes += body(face_lever(ink, *spots), "lever", swung[0].marks, k)
        return strokes, [Wanted("K", at, ink.heights.point, 2.0, -1j, (points.slot,), k)]
    lever = ink.figures("lever")
    if lever:
        pivot = complex(ink.all(lever[0].marks[0])[k]) * turn
        bars: list[Ink] = [line("main", pivot, at), *fixed_pivot(pivot)]
        strokes += body(bars, "lever", lever[0].marks, k)
        way = -sense * 1j * (at - pivot) / abs(at - pivot)
        way = way if (way * at.conjugate()).real > 0 else -way
    else:
        way = 1j
        edge = made.roller is None and made.theoretical is not None
        strokes += body(rod(at, radius, edge=edge), "follower", [mark], k)
    if made.theoretical is None:
        half = abs(complex(ink.all(points)[k]) * turn - at) + FACE
        strokes += body([line("main", at - half, at + half)], "face", [mark, points], k)
        return strokes, [Wanted("B", at, ink.heights.point, 2.0, 1 + 0j, (mark.slot,), k)]
    more, wanted = draw_pressure_angle(ink, k, turn, (at, way, radius), names.pressure)
    letter = Wanted("B", at, ink.heights.point, 2.0, complex(-sense), (points.slot,), k)
    return [*strokes, *more], [letter, *wanted]


def draw_pressure_angle(
    ink: CamInk,
    k: int,
    turn: complex,
    on: tuple[complex, complex, float],
    text: str,
) -> tuple[list[Ink], list[Wanted]]:
    """The normal n–n through the roller's centre, the way of the follower, the angle between them."""
    at, way, radius = on
    made = ink.cam.profile
    normal = -ink.line(made.normals, k)[1] * turn
    if not finite(normal) or normal == 0:
        return [], []
    reach = radius + BEYOND
    far = at + reach * normal
    lines = [line("thin", at - (radius + ASIDE) * normal, far)]
    strokes: list[Ink] = list(body(lines, "normal", [made.normals], k))
    by = math.degrees(cmath.phase(normal / way))
    wanted = [Wanted("n", far, ink.heights.number, 1.0, normal, (made.normals.slot,), k)]
    if abs(by) > CENTRED:
        start = math.degrees(cmath.phase(way))
        arcs = angular(at, start, by, radius + ARC)
        strokes += body(arcs, "dimension", [made.normals], k)
        middle = at + (radius + ARC) * way * cmath.exp(0.5j * math.radians(by))
        wanted.append(
            Wanted(
                text,
                middle,
                ink.heights.number,
                1.5,
                middle - at,
                (made.normals.slot,),
                k,
            )
        )
    return strokes, wanted


def _shaft(ink: CamInk) -> Iterator[Ink]:
    """Centre lines, the cam's pivot on the frame, the arrow of its turning."""
    cam = ink.cam
    reach = ink.arc((cam.profile.outer or cam.profile.working).upper, 0)[1] + ASIDE
    if not math.isfinite(reach):
        return
    yield from added([line("centre", -reach * way, reach * way) for way in (1 + 0j, 1j)], "axis")
    yield from body(fixed_pivot(0j), "pivot", [cam.profile.centre])
    yield from added(round_arrow(0j, TURN, 90.0 - cam.sense * 60.0, cam.sense * 120.0), "sense")


def _letters(ink: CamInk, names: SchemeNames) -> Iterator[Wanted]:
    """The letters of the cam's centre, of its turning, of the base circle's radius."""
    made, sense = ink.cam.profile, ink.cam.sense
    lower = (made.theoretical or made.working).lower
    radius = ink.arc(lower, 0)[1]
    yield Wanted("O", 0j, ink.heights.point, 2.5, complex(-sense, -1), (made.centre.slot,))
    yield Wanted(names.omega, 1j * TURN, ink.heights.number, 1.0, complex(-sense))
    if math.isfinite(radius):
        edge = radius * cmath.rect(1.0, math.radians(90.0 - sense * 130.0))
        yield Wanted(names.r0, edge, ink.heights.number, 1.0, edge, (lower.slot,))
