"""The limits of the centre for a flat face on a lever, in ink: ends E of the arms, what binds, radii."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Complexes
from graphic_tmm.chapters.cam.centre import VIEW
from graphic_tmm.chapters.cam.flat_rocker import FaceLever, FaceRegion
from graphic_tmm.chapters.cam.ink_centre import AROUND, CentreNames, part_of_circle
from graphic_tmm.chapters.cam.ink_rules import OVER, POINT, CamInk, dots, numbered
from graphic_tmm.chapters.cam.plan import Cam
from graphic_tmm.paper.drawing import Drawing, Ink, Label, Wanted, circle, line
from graphic_tmm.paper.figure import body, figure, showing
from graphic_tmm.paper.mark_rules import curve, leaving, straight
from graphic_tmm.paper.seen import Rule, Subject, finite
from graphic_tmm.paper.symbols.dimensions import dimension
from graphic_tmm.paper.symbols.kinematic import fixed_pivot

BEYOND = 8.0
"""How far lines go on behind what stands on them, mm."""


def draw_face_ink(on: Subject, cam: Cam, names: CentreNames) -> Drawing:
    """Return the ends E of the arms with the limits on the circle of the centres, both radii."""
    region, lever = cam.centre, cam.path
    assert isinstance(region, FaceRegion)
    assert isinstance(lever, FaceLever)
    ink = _Limits(CamInk(on, cam, VIEW), region, lever)
    traces = figure(ink.on, showing(_rules(ink)))
    sizes = list(_dimensions(ink, names))
    strokes = [*traces.staying, *_bodies(ink)]
    strokes += [stroke for found, _ in sizes for stroke in found]
    labels = [label for _, label in sizes]
    return traces.drawing(on, strokes, _letters(ink, names), labels, enumerate(names.positions))


class _Limits:
    """The places of the figure, mm; ``begin``: along the lowest lever, ``down``: from there to the cam."""

    def __init__(self, on: CamInk, region: FaceRegion, lever: FaceLever) -> None:
        self.on, self.region, self.lever = on, region, lever
        self.begin = complex(lever.sense)
        self.radius = on.fixed_number(lever.centres)
        self.face = -1j * (on.fixed_number(lever.face) if lever.face is not None else 0.0)
        self.centre, self.least = on.fixed_place(region.centre), on.fixed_place(region.least_centre)
        self.ends = [on.all(mark) for mark in region.ends]
        found = [(-1.0, 0, 0)]
        for n, row in enumerate(self.ends):
            turns = np.nan_to_num(-lever.sense * np.angle(row / self.begin), nan=-1.0)
            found.append((float(turns.max()), n, int(turns.argmax())))
        self.turn, self.stretch, self.position = max(found)

    @property
    def binding(self) -> complex:
        """Where on the circle the limit ends that binds; NaN if a dwell does."""
        return complex(self.ends[self.stretch][self.position]) if self.turn > 0.0 else np.nan + 0j


def _rules(ink: _Limits) -> dict[Mark, Rule]:
    """What stays of the steps: the lowest lever, curves of E, part of the circle, the line of centres."""
    region, far = ink.region, ink.radius * ink.begin
    spots = [far, ink.binding, ink.least, ink.centre]
    rules: dict[Mark, Rule] = {
        region.begin: straight("main", 0j, far + BEYOND * ink.begin),
        region.circle: leaving(*part_of_circle(far, ink.radius, spots, AROUND)),
        ink.lever.line: straight("thin", 0j, ink.centre),
        **dict.fromkeys(region.curves, curve()),
    }
    for rows, below in ((region.points, False), (region.ends, True)):
        for mark, (_, first, last) in zip(rows, ink.on.cam.diagrams.stretches, strict=True):
            rules[mark] = partial(dots, first, last, below=below)
    return rules


def _bodies(ink: _Limits) -> Iterator[Ink]:
    """The limit that binds with the tangent that it is square to, the face, the centres, the pivot."""
    region, end = ink.region, ink.binding
    if finite(end):
        n, k = ink.stretch, ink.position
        spot, way = complex(ink.on.all(region.points[n])[k]), end / abs(end)
        touch = way * (spot * way.conjugate()).real
        strokes = [line("main", 0j, end + BEYOND * way), line("thin", spot, touch)]
        of = [region.points[n], region.limits[n], region.ends[n]]
        yield from body(strokes, "dimension", of, k)
    if ink.face and ink.lever.face is not None:
        low = line("main", ink.face, ink.face + (ink.radius + BEYOND) * ink.begin)
        yield from body([low], "face", [ink.lever.face])
    for mark, spot in ((region.least_centre, ink.least), (region.centre, ink.centre)):
        if finite(spot):
            chosen = mark == region.centre
            dot = circle("joint", spot, 1.2) if chosen else circle("main", spot, 0.7, filled=True)
            yield from body([dot], "pivot", [mark])
    yield from body(fixed_pivot(0j), "pivot", [region.begin])


def _dimensions(ink: _Limits, names: CentreNames) -> Iterator[tuple[tuple[Ink, ...], Label]]:
    """The dimensions of both radii: from the centres up to the lowest face, beyond the circle."""
    rows = (
        (ink.region.centre, ink.centre, names.r0, OVER + BEYOND),
        (ink.region.least_centre, ink.least, names.least, 2.6 * OVER + BEYOND),
    )
    for mark, spot, text, aside in rows:
        if finite(spot) and abs(spot.imag - ink.face.imag) > POINT:
            high = complex(spot.real, ink.face.imag)
            out = ink.radius + aside - abs(spot.real)
            size = dimension(spot, high, -out * ink.begin.real, text, ink.on.heights.number)
            strokes = tuple(body(size.strokes, "dimension", [mark]))
            yield strokes, size.label._replace(of=(mark.slot,))


def _letters(ink: _Limits, names: CentreNames) -> Iterator[Wanted]:
    """The letters of pivot and centres, the numbers of the positions."""
    region, point, small = ink.region, ink.on.heights.point, ink.on.heights.number
    yield Wanted("O_{1}", 0j, point, 2.0, 1j - ink.begin, (region.begin.slot,))
    for mark, spot, letter, size in (
        (region.least_centre, ink.least, "O_{min}", small),
        (region.centre, ink.centre, "O", point),
    ):
        if finite(spot):
            yield Wanted(letter, spot, size, 1.6, -1j - 0.4 * ink.begin, (mark.slot,))
    for mark, (_, first, last) in zip(region.points, ink.on.cam.diagrams.stretches, strict=True):
        row = np.arange(len(ink.on.positions))
        own: Complexes = np.where((row >= first) & (row <= last), ink.on.all(mark), np.nan)
        yield from numbered(ink.on, names.positions, mark, own, own + 0.5j * ink.radius)
