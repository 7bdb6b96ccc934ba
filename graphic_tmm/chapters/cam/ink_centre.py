"""Where the centre of a cam with a translating follower may stand, in ink: tangents, region, radii."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.chapters.cam.centre import VIEW, Centre
from graphic_tmm.chapters.cam.ink_letters import OVER, arrow_axis, numbered
from graphic_tmm.chapters.cam.ink_rules import CamInk, curve, picture, reached, straight
from graphic_tmm.chapters.cam.plan import Cam
from graphic_tmm.paper.drawing import Drawing, Ink, Label, Wanted, arc, circle, line
from graphic_tmm.paper.figure import added, body, figure, showing
from graphic_tmm.paper.lettering.heights import Heights
from graphic_tmm.paper.seen import Rule, finite
from graphic_tmm.paper.symbols.dimensions import dimension
from graphic_tmm.paper.symbols.kinematic import hatching

LEAST = 0.3
"""What is shorter has no dimension, mm."""
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
    construction: Construction,
    reading: Reading,
    cam: Cam,
    names: CentreNames,
    title: str,
    heights: Heights,
) -> Drawing:
    """Return the S–dS/dφ diagram of a translating roller with the region of allowed centres."""
    made = cam.centre
    assert isinstance(made, Centre)
    ink = _Region(CamInk(construction, reading, cam, VIEW, heights), made)
    traces = figure(ink.on.seen, showing(_rules(ink)))
    radii = list(_dimensions(ink, names))
    strokes = [*traces.staying, *added(_axes(ink), "axis"), *_bodies(ink)]
    strokes += [stroke for found, _ in radii for stroke in found]
    labels = [label for _, label in radii if label is not None]
    wanted = _letters(ink, names)
    return picture((VIEW, title), traces, strokes, wanted, names.positions, labels)


class _Region:
    """The places of the diagram, mm; ``out``: to which side dS/dφ of the rise is laid off."""

    def __init__(self, on: CamInk, made: Centre) -> None:
        self.on, self.made, self.out = on, made, complex(-on.cam.sense)
        self.points = on.all(made.points)
        side = (self.points * np.conj(self.out)).real
        self.near = float(np.nanmin(side, initial=0.0))
        self.far = float(np.nanmax(side, initial=0.0))
        self.top = float(np.nanmax(self.points.imag, initial=0.0))
        assert made.apex is not None
        self.apex = on.one(made.apex)
        self.centre, self.least = on.one(made.centre), on.one(made.least_centre)
        self.bottom = self._bottom()

    def _bottom(self) -> float:
        """How low the region is drawn."""
        if not finite(self.apex):
            return 0.0
        deepest = [z.imag - ABOVE for z in (self.least, self.centre) if finite(z)]
        return min([0.0, self.apex.imag - BELOW, *deepest])

    @property
    def foot(self) -> complex:
        """How far the line of the centres goes down."""
        if not finite(self.centre):
            return 1j * self.bottom
        return complex(self.centre.real, min(self.centre.imag, self.least.imag) - 3.0)


def _rules(ink: _Region) -> dict[Mark, Rule]:
    """What stays of the steps: the curve with what was laid off to it, the limits, the line of the centres."""
    made = ink.made
    rules: dict[Mark, Rule] = {made.points: reached, **dict.fromkeys(made.curves, curve())}
    for mark in made.limits:
        spot, way = ink.on.seen.line(mark, 0)
        if finite(spot, ink.apex):
            rules[mark] = straight("main", _down(ink, mark), spot + ABOVE * way)
    down = ink.on.used(made.ends[0])
    rules[down] = straight("centre", complex(ink.foot.real, 8.0), ink.foot)
    return rules


def _down(ink: _Region, limit: Mark) -> complex:
    """Where a limit of the region ends below."""
    spot, way = ink.on.seen.line(limit, 0)
    return spot + way * ((ink.bottom - spot.imag) / way.imag)


def _axes(ink: _Region) -> Iterator[Ink]:
    yield from arrow_axis(ink.out * (ink.near - OVER), ink.out * (ink.far + OVER))
    yield from arrow_axis(0j, complex(0, ink.top + OVER))


def _bodies(ink: _Region) -> Iterator[Ink]:
    """The hatching of the region, the allowed pressure angles, the chosen centre and the least one."""
    made, cam = ink.made, ink.on.cam
    assert made.apex is not None
    for mark, end, phase in zip(made.limits, made.ends, cam.diagrams.turn.phases, strict=True):
        spot, way = ink.on.seen.line(mark, 0)
        if finite(spot, ink.apex):
            side = -1 if phase.sign * cam.sense < 0 else 1
            strokes = hatching(_down(ink, mark), ink.apex, side)
            yield from body(strokes, "hatching", [mark, made.apex])
        at = ink.on.one(end)
        if finite(at, way):
            bow = arc("thin", at, ANGLE, 90.0, math.degrees(cmath.phase(way / 1j)))
            yield from body([bow], "dimension", [mark, end])
    if finite(ink.least):
        dot = circle("main", ink.least, 0.7, filled=True)
        yield from body([dot], "point", [made.least_centre])
    if finite(ink.centre):
        yield from body([circle("joint", ink.centre, 1.2)], "pivot", [made.centre])


def _dimensions(ink: _Region, names: CentreNames) -> Iterator[tuple[tuple[Ink, ...], Label | None]]:
    """The dimensions of both radii on either side, that of an offset; a radius that leans is a line."""
    made, small = ink.made, ink.on.heights.number
    rows = (
        (made.least_centre, ink.least, names.least, -ink.out, -ink.near),
        (made.centre, ink.centre, names.r0, ink.out, ink.far),
    )
    for mark, spot, text, way, room in rows:
        if not finite(spot):
            continue
        if abs(spot.real) <= LEAST:
            left = 1.0 if (-1j * spot * np.conj(way)).real > 0 else -1.0
            size = dimension(spot, 0j, left * (min(room, 40.0) + ASIDE), text, small)
            strokes, label = list[Ink](size.strokes), size.label
        elif mark == made.centre:
            low = complex(0, spot.imag)
            ends = (low, spot) if spot.real > 0 else (spot, low)
            size = dimension(*ends, -(ABOVE + ASIDE), names.offset, small)
            strokes = [line("thin", spot, 0j), line("thin", 0j, low), *size.strokes]
            label = size.label
        else:
            continue
        of = (mark, made.lowest)
        told = tuple(body(strokes, "dimension", of))
        yield told, label._replace(of=tuple(one.slot for one in of))


def _letters(ink: _Region, names: CentreNames) -> Iterator[Wanted]:
    """The letters of axes and points, the allowed angles, a radius that leans, the numbers of positions."""
    made, point, small = ink.made, ink.on.heights.point, ink.on.heights.number
    yield Wanted(names.up, complex(0, ink.top + OVER), point, 1.5, -ink.out)
    yield Wanted(names.out, ink.out * (ink.far + OVER), point, 1.5, -1j)
    yield Wanted("B_{0}", 0j, small, 1.0, -ink.out - 1j, (made.lowest.slot,))
    rows = (
        (made.least_centre, ink.least, "O_{min}", small, -ink.out),
        (made.centre, ink.centre, "O", point, ink.out),
    )
    for mark, spot, letter, size, way in rows:
        if finite(spot):
            yield Wanted(letter, spot, size, 1.4, way, (mark.slot,))
    if finite(ink.centre) and abs(ink.centre.real) > LEAST:
        yield Wanted(names.r0, 0.45 * ink.centre, small, 0.5, ink.out, (made.centre.slot,))
    for limit, mark, text in zip(made.limits, made.ends, names.limits, strict=True):
        spot, way = ink.on.one(mark), ink.on.seen.line(limit, 0)[1]
        if finite(spot, way):
            turn = math.radians(90.0) + cmath.phase(way / 1j) / 2
            middle = cmath.rect(ANGLE, turn)
            yield Wanted(text, spot + middle, small, 0.5, middle, (mark.slot, limit.slot))
    toward = ink.points - 0.5j * ink.top
    yield from numbered(ink.on, names.positions, made.points, ink.points, toward)
