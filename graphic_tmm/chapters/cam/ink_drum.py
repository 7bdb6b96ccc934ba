"""A drum cam in ink: rays of the tangents, the development, the drum from its side; a cam that slides."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

import numpy as np

from graphic_tmm.board.operations.curve import bezier
from graphic_tmm.board.record import Figure, Mark
from graphic_tmm.board.values import Complexes, Curve
from graphic_tmm.chapters.cam.centre import Centre
from graphic_tmm.chapters.cam.drum import Drum
from graphic_tmm.chapters.cam.ink import (
    GUIDE,
    PENS,
    PIN,
    ROD,
    WIDTH,
    ProfileNames,
    inverted,
    rod,
)
from graphic_tmm.chapters.cam.ink_centre import CentreNames
from graphic_tmm.chapters.cam.ink_rules import OVER, CamInk, arrow_axis, between, numbered
from graphic_tmm.chapters.cam.ink_scheme import (
    NAME,
    SchemeNames,
    draw_pressure_angle,
    position_of,
)
from graphic_tmm.chapters.cam.plan import Cam
from graphic_tmm.chapters.cam.profile import THEORETICAL
from graphic_tmm.paper.axes import position_numbers
from graphic_tmm.paper.drawing import (
    Bezier,
    Drawing,
    Ink,
    Label,
    Wanted,
    arc,
    circle,
    line,
    shifted,
)
from graphic_tmm.paper.figure import added, body, figure, showing
from graphic_tmm.paper.labels import Named
from graphic_tmm.paper.mark_rules import curve, dotted, straight
from graphic_tmm.paper.seen import Rule, Subject, finite
from graphic_tmm.paper.symbols.dimensions import dimension
from graphic_tmm.paper.symbols.kinematic import arrowhead, channel, guide

DOT, ANGLE = 0.5, 20.0
"""Radius of a point; of the arc that shows an allowed pressure angle, mm."""
BELOW, APART = 12.0, 9.0
"""How far below its base the first dimension of the radius stands, and one below the other, mm."""
RIM, PLATE = 6.0, 14.0
"""How far the drum goes on beside its groove, a plate below its profile, mm."""
TANGENT = 20.0
"""How far the tangent of the steepest place goes on behind the roller, mm."""
ARROW = 16.0
"""How long the arrow of the turning is on the drum seen from its side, mm."""
FINE = 8
"""Into how many chords a piece of a flank is divided on the drum seen from its side."""


def draw_drum_radius_ink(on: Subject, cam: Cam, names: CentreNames) -> Drawing:
    """Return the axis of dS/dφ with the rays from the pole, the limits and both radii."""
    made, drum = cam.centre, cam.path
    assert isinstance(made, Centre)
    assert isinstance(drum, Drum)
    ink = CamInk(on, cam, made.view)
    points = ink.all(made.points)
    centre, least = ink.fixed_place(made.centre), ink.fixed_place(made.least_centre)
    high, low = (float(f(points.imag, initial=0.0)) for f in (np.nanmax, np.nanmin))
    left = min([z.real for z in (centre, least) if finite(z)], default=0.0)
    rules: dict[Mark, Rule] = {
        drum.along: straight("thin", complex(left - OVER), 0j),
        drum.rays: between(np.broadcast_to(centre, points.shape), points),
        made.points: dotted(DOT),
    }
    for mark in made.limits:
        spot, way = ink.line(mark, 0)
        if finite(spot, way):
            end = ink.fixed_place(made.ends[made.limits.index(mark)])
            rules[mark] = straight("main", end, spot + OVER * way)
    traces = figure(ink, showing(rules))
    axis = arrow_axis(1j * (low - OVER), 1j * (high + OVER))
    strokes, labels = [*traces.staying, *added(axis, "axis")], list[Label]()
    wanted = [Wanted(names.out, 1j * (high + OVER), ink.heights.point, 1.5, 1 + 0j)]
    rows = (
        (made.centre, centre, names.r0, "O", ink.heights.point),
        (made.least_centre, least, names.least, "", ink.heights.number),
    )
    for n, (mark, spot, text, letter, size) in enumerate(rows):
        if not finite(spot):
            continue
        pen = circle("joint", spot, 1.2) if letter else circle("main", spot, 0.7, filled=True)
        strokes += body([pen], "pivot" if letter else "point", [mark])
        row = dimension(spot, 0j, low - BELOW - n * APART, text, ink.heights.number)
        strokes += body(row.strokes, "dimension", [mark])
        labels.append(row.label._replace(of=(mark.slot,)))
        if letter:
            wanted.append(Wanted(letter, spot, size, 1.6, -1 + 1j, (mark.slot,)))
    wanted += numbered(ink, names.positions, made.points, points, np.ones_like(points))
    for limit, mark, text in zip(made.limits, made.ends, names.limits, strict=False):
        spot, way = ink.fixed_place(mark), ink.line(limit, 0)[1]
        if finite(spot, way):
            turn = math.degrees(cmath.phase(way))
            strokes += body([arc("thin", spot, ANGLE, 0.0, turn)], "dimension", [mark, limit])
            middle = cmath.rect(ANGLE, math.radians(turn / 2))
            of = (mark.slot, limit.slot)
            wanted.append(Wanted(text, spot + middle, ink.heights.number, 0.5, middle, of))
    return traces.drawing(on, strokes, wanted, labels, enumerate(names.positions))


def draw_development_ink(on: Subject, cam: Cam, names: ProfileNames) -> Drawing:
    """Return the development: the roller's path, its circles, both flanks, the steepest tangent."""
    made, drum = cam.profile, cam.path
    assert isinstance(drum, Drum)
    assert drum.base is not None
    assert drum.length is not None
    assert made.feet is not None
    ink = CamInk(on, cam, made.view)
    points, feet = ink.all(_path(cam)), ink.all(made.feet)
    length, (low, high) = ink.fixed_number(drum.length), _rim(ink, cam)
    rules: dict[Mark, Rule] = {
        drum.base: straight("thin", 0j, complex(length)),
        made.guides: between(feet + 1j * low, points),
    }
    for contour in ink.figures("contour"):
        curves = [mark for mark in contour.marks if mark.kind is Curve]
        rules |= dict.fromkeys(curves, curve(PENS[contour.name]))
    traces = figure(ink, showing(rules))
    strokes = [*traces.staying, *inverted(ink)]
    for contour in ink.figures("contour"):
        strokes += _rests(ink, contour, length)
    corners = [complex(x, y) for x, y in ((0, low), (length, low), (length, high), (0, high))]
    if cam.order.slides:
        strokes += _sides(ink, cam, length)
    else:
        strokes += body([line("thin", *corners, closed=True)], "drum", [drum.length])
    k = position_of(on.reading, cam)
    steepest, wanted = _steepest(ink, cam, k, names.pressure)
    strokes += steepest
    size = dimension(corners[0], corners[1], -BELOW, names.length, ink.heights.number)
    strokes += body(size.strokes, "dimension", [drum.length])
    label = size.label._replace(of=(drum.length.slot,))
    wanted += _letters(ink, cam, names)
    slot = made.feet.slot
    named = [
        Named(complex(foot), name, (slot,), n)
        for n, (foot, name) in enumerate(zip(feet, names.positions, strict=True))
    ]
    numbers = position_numbers(named, (), (), ink.heights.number)
    labels = [label, *(one._replace(at=one.at + 1j * low) for one in numbers)]
    return traces.drawing(on, strokes, wanted, labels, enumerate(names.positions))


def _path(cam: Cam) -> Mark:
    """The centres of the roller, or the points of the edge."""
    assert cam.profile.theoretical is not None
    return cam.profile.theoretical.points


def _rim(ink: CamInk, cam: Cam) -> tuple[float, float]:
    """How low and how high the drum reaches beside its groove, or a plate, mm."""
    radius, points = _roller(ink, cam), ink.all(_path(cam)).imag
    below = PLATE if cam.order.slides else RIM
    return -radius - below, float(np.nanmax(points, initial=0.0)) + radius + RIM


def _roller(ink: CamInk, cam: Cam) -> float:
    """The radius of the roller, 0 of an edge, mm."""
    return ink.fixed_number(cam.profile.roller) if cam.profile.roller is not None else 0.0


def _gaps(ink: CamInk, contour: Figure, length: float) -> Iterator[tuple[Mark, complex, complex]]:
    """Where a contour is straight: each line with its ends, from the curve before it to that behind it."""
    for n, mark in enumerate(contour.marks):
        if mark.kind is Curve:
            continue
        before, after = contour.marks[n - 1], contour.marks[(n + 1) % len(contour.marks)]
        start = complex(ink.reading[before].knots[0, -1])
        end = complex(ink.reading[after].knots[0, 0])
        if not finite(start, end):
            continue
        if n + 1 < len(contour.marks):
            yield mark, start, end
            continue
        yield mark, start, complex(length, start.imag)
        yield mark, complex(0.0, end.imag), end


def _rests(ink: CamInk, contour: Figure, length: float) -> Iterator[Ink]:
    """The straight pieces of a contour: while the follower rests."""
    for mark, start, end in _gaps(ink, contour, length):
        if abs(end - start) > 1e-9:
            yield from body([line(PENS[contour.name], start, end)], "contour", [mark])


def _sides(ink: CamInk, cam: Cam, length: float) -> Iterator[Ink]:
    """The sides and the bottom of a plate, of one with a groove its top too."""
    made, turn, (low, high) = cam.profile, cam.diagrams.turn, _rim(ink, cam)
    start, *_, end = (complex(spot) for spot in ink.all(made.working.points))
    if made.outer is not None:
        start, end = 1j * high, complex(length, high)
    # the follower may rest before its first position, and behind its last
    start = complex(0.0, start.imag) if turn.angles[0] else start
    end = complex(length, end.imag) if turn.angles[-1] < turn.whole else end
    if finite(start, end):
        # a roller on a slope touches beside the end of the plate
        foot = (complex(0.0, start.imag), 1j * low, complex(length, low), complex(length, end.imag))
        spots = dict.fromkeys((start, *foot, end))
        outline = line("main", *spots, closed=made.outer is not None)
        yield from body([outline], "plate", [made.feet or made.guides])


def plate(ink: CamInk, cam: Cam, length: float) -> Iterator[Ink]:
    """Yield a cam that slides, where it begins: its contours, its sides."""
    for contour in ink.figures("contour"):
        pen = "thin" if contour.name == THEORETICAL else "main"
        for mark in (one for one in contour.marks if one.kind is Curve):
            runs = (tuple(map(complex, run)) for run in bezier(ink.reading[mark]))
            yield from body((Bezier(pen, run, mark.name) for run in runs), "contour", [mark])
        yield from (one._replace(pen=pen) for one in _rests(ink, contour, length))
    yield from _sides(ink, cam, length)


def ground(ink: CamInk, cam: Cam, left: float, right: float) -> Iterator[Ink]:
    """Yield what a plate slides on, between two places."""
    low = _rim(ink, cam)[0]
    yield from added(guide(complex(left, low), complex(right, low)), "guide")


def _steepest(ink: CamInk, cam: Cam, k: int, text: str) -> tuple[list[Ink], list[Wanted]]:
    """The tangent and the normal of the path where the pressure angle is largest, and that angle."""
    made = cam.profile
    spot, way = ink.line(made.normals, k)
    radius = _roller(ink, cam)
    if not finite(spot, way):
        return [], []
    strokes, wanted = draw_pressure_angle(ink, k, 1 + 0j, (spot, 1j, radius), text)
    ends = [spot + sign * (radius + TANGENT) * 1j * way for sign in (-1, 1)]
    strokes += body([line("thin", *ends)], "normal", [made.normals], k)
    of = (made.normals.slot,)
    wanted.append(Wanted("t", ends[1], ink.heights.number, 0.8, 1j * way, of, k))
    return strokes, wanted


def _letters(ink: CamInk, cam: Cam, names: ProfileNames) -> Iterator[Wanted]:
    """The radius of the roller."""
    made, small = cam.profile, ink.heights.number
    if made.roller is None:
        return
    radius = ink.fixed_number(made.roller)
    high = ink.all(_path(cam))[cam.diagrams.turn.rise.last]
    if finite(high):
        at = complex(high) + 1j * radius
        yield Wanted(names.roller, at, small, 0.8, 1j, (made.roller.slot,))


def draw_drum_scheme_ink(on: Subject, cam: Cam, names: SchemeNames) -> Drawing:
    """Return the drum from its side, or the plate, the follower where the rise's pressure angle is largest."""
    made, drum, slides = cam.profile, cam.path, cam.order.slides
    assert isinstance(drum, Drum)
    assert drum.length is not None
    ink, k = CamInk(on, cam, made.view), position_of(on.reading, cam)
    mark, length = _path(cam), ink.fixed_number(drum.length)
    at = complex(ink.all(mark)[k])
    low, high = _rim(ink, cam)
    mean, strokes = length / math.tau, list[Ink]()
    if not finite(at, complex(mean)):
        return Drawing(NAME, on.title, (), shows=(made.view,))
    spot, radius, top, wide = complex(0.0, at.imag), _roller(ink, cam), high + ROD, 0.5 * WIDTH
    left, right = (-at.real, length - at.real) if slides else (-mean, mean)
    if slides:
        strokes += [shifted(one, complex(left)) for one in plate(ink, cam, length)]
        strokes += ground(ink, cam, left - OVER, right + OVER)
        rods = rod(spot, radius, edge=made.roller is None, length=top - at.imag)
        way = complex(left - ARROW - 2.0, low + 0.5 * PLATE)
    else:
        corners = (
            complex(x, y) for x, y in ((left, low), (right, low), (right, high), (left, high))
        )
        strokes += body([line("main", *corners, closed=True)], "drum", [drum.length])
        for contour in ink.figures("contour"):
            pen = "thin" if contour.name == THEORETICAL else "main"
            for one, places in _pieces(ink, contour, length):
                for run in _seen_from_side(places, at.real, mean):
                    strokes += body([line(pen, *run)], "contour", [one])
        strokes += added([line("centre", 1j * (low - OVER), 1j * (top + OVER))], "axis")
        foot, end = spot + 1j * radius, 1j * top
        rods = [line("body", foot - wide, foot + wide, end + wide, end - wide, closed=True)]
        rods += channel(1j * (high + 0.5 * ROD), 90.0, GUIDE, width=WIDTH)
        way = complex(left, high + 0.5 * OVER)
    if made.roller is not None:
        pins: list[Ink] = [circle("main", spot, radius), circle("joint", spot, PIN)]
        strokes += body(pins, "roller", [mark, made.roller], k)
    strokes += body(rods, "follower", [mark], k)
    more, wanted = draw_pressure_angle(ink, k, 1 + 0j, (spot, 1j, radius), names.pressure)
    strokes += added(
        [line("thin", way + ARROW, way), *arrowhead(way, -1 + 0j, pen="thin")], "sense"
    )
    wanted.append(Wanted(names.omega, way + 0.5 * ARROW, ink.heights.number, 0.5, 1j))
    ends = (complex(left if slides else 0.0, low), complex(right, low))
    size = dimension(*ends, -BELOW, names.r0, ink.heights.number)
    strokes += body(size.strokes, "dimension", [drum.length])
    label = size.label._replace(of=(drum.length.slot,))
    wanted.append(Wanted("B", spot, ink.heights.point, 2.0, -1 + 0j, (mark.slot,), k))
    return Drawing(
        NAME, on.title, (*strokes, *more), (label,), shows=(made.view,), wanted=tuple(wanted)
    )


def _pieces(ink: CamInk, contour: Figure, length: float) -> Iterator[tuple[Mark, Complexes]]:
    """The curves and the straight pieces of a contour, each as points close together."""
    t = np.linspace(0.0, 1.0, FINE, endpoint=False)[:, None]
    for mark in contour.marks:
        if mark.kind is Curve:
            for run in bezier(ink.reading[mark]):
                p, q, r, s = run[:-1:3], run[1::3], run[2::3], run[3::3]
                u = 1.0 - t
                found: Complexes = u**3 * p + 3 * u * u * t * q + 3 * u * t * t * r + t**3 * s
                yield mark, np.append(found.T.ravel(), run[-1])
    for mark, start, end in _gaps(ink, contour, length):
        many = max(2, math.ceil(FINE * abs(end - start) / (length / FINE)))
        yield mark, np.asarray(np.linspace(start, end, many), dtype=np.complex128)


def _seen_from_side(places: Complexes, x: float, mean: float) -> Iterator[list[complex]]:
    """Yield the runs of a line that stand on the near half of the drum, ``x`` turned to the eye."""
    angle = (places.real - x) / mean
    angle -= math.tau * np.round(angle / math.tau)
    near = np.abs(angle) <= math.pi / 2
    run: list[complex] = []
    for k, ahead in enumerate(near):
        if ahead and run and abs(angle[k] - angle[k - 1]) < math.pi:
            run.append(complex(mean * math.sin(angle[k]), places[k].imag))
        elif ahead:
            run = [complex(mean * math.sin(angle[k]), places[k].imag)]
        if (not ahead or k == len(near) - 1) and len(run) > 1:
            yield run
        if not ahead:
            run = []
