"""The scheme of a cam of arcs for its task: its contour with the radii given, the follower in its lowest place.

The nose is downward, as in `geometry`; a cam that turns counter-clockwise is the mirror image.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import NamedTuple

from graphic_tmm.board.scales import LENGTHS, standard_length
from graphic_tmm.chapters.arc_cam.geometry import centre_of, normals
from graphic_tmm.chapters.arc_cam.ink import DOT, PIN, from_to, rod
from graphic_tmm.chapters.arc_cam.task import ASKED, FLAT, ArcTask, Flank
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, circle, line
from graphic_tmm.paper.figure import added
from graphic_tmm.paper.formats import HEIGHTS
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.symbols.kinematic import arrowhead, fixed_pivot, round_arrow
from graphic_tmm.readers.task_sheet import Scheme
from graphic_tmm.scene.records import Scene
from graphic_tmm.scene.values import CLOCKWISE

SIZE = HEIGHTS["A4"].point
CROSS, TURN, ASIDE = 4.0, 7.0, 5.0
"""How far centre lines go on; radius of the arrow of turning; how far a dimension stands off, mm."""
TITLE = said("Scheme of the cam mechanism", context="task")
LOWEST = said("the follower in its lowest position", context="task")


class Part(NamedTuple):
    """Strokes of what kind, and the letters that they bear."""

    kind: str
    strokes: tuple[Ink, ...]
    wanted: tuple[Wanted, ...] = ()


class _Placed(NamedTuple):
    """A cam as it is shown: ``sense``: 1 if it turns clockwise, −1 for the mirror image."""

    order: ArcTask
    mu: float
    sense: int

    def length(self, real: float) -> float:
        """Return a length (m) in mm."""
        return real / self.mu

    def spot(self, real: complex) -> complex:
        """Return a place (m) in mm."""
        x, y = self.length(real.real), self.length(real.imag)
        return complex(self.sense * x, y)


def scheme(scene: Scene, room: complex) -> Scheme | None:
    """Return the cam and its follower within a width and a height (complex, mm); None if there is none."""
    order = ASKED.of(scene)
    if order is None:
        return None
    sense = 1 if order.turns == CLOCKWISE else -1
    high = order.base + order.distance + order.nose + 2.0 * order.roller
    least = standard_length(max(high / room.imag, 1e-9), 1.0)
    for mu in (one for one in (*LENGTHS, 10.0 * least) if one >= least):
        view = _drawing(_Placed(order, mu, sense))
        left, low, right, top = bounds(view)
        if right - left <= room.real and top - low <= room.imag:
            break
    _ = speaking(scene.language)
    return Scheme(view._replace(title=_(TITLE)), mu, (_(LOWEST),))


def _drawing(cam: _Placed) -> Drawing:
    parts = [*_contour(cam), *_sizes(cam), *_follower(cam)]
    strokes = tuple(stroke for part in parts for stroke in added(part.strokes, part.kind))
    wanted = tuple(one for part in parts for one in part.wanted)
    return finished(Drawing("scheme", "", strokes, wanted=wanted))


def _touches(order: ArcTask) -> tuple[complex, complex, complex, complex]:
    """Return where the arcs meet, m: base and rise, rise and nose, nose and return, return and base."""
    nose = -1j * order.distance
    low, high = normals(order, order.rise, 1)
    back, down = normals(order, order.fall, -1)[::-1]
    return (
        order.base * low,
        nose + order.nose * high,
        nose + order.nose * back,
        order.base * down,
    )


def _contour(cam: _Placed) -> Iterator[Part]:
    """Yield the contour, its base circle in full, centre lines, the shaft, the sense of turning."""
    order = cam.order
    nose, base = cam.spot(-1j * order.distance), cam.length(order.base)
    if order.eccentric:
        yield Part("contour", (circle("main", nose, cam.length(order.nose)),))
    else:
        spots = [cam.spot(one) for one in _touches(order)]
        strokes = [
            *from_to("main", 0j, spots[3], spots[0], cam.sense),
            *_flank(cam, order.rise, 1, spots[0], spots[1]),
            *from_to("main", nose, spots[1], spots[2], cam.sense),
            *_flank(cam, order.fall, -1, spots[2], spots[3]),
        ]
        yield Part("contour", tuple(strokes))
        yield Part("circle", (circle("thin", 0j, base),))
    low = nose.imag - cam.length(order.nose) - CROSS
    lines = (
        line("centre", complex(-base - CROSS), complex(base + CROSS)),
        line("centre", complex(0.0, low), complex(0.0, base + CROSS)),
        line("centre", nose - base / 3.0, nose + base / 3.0),
    )
    yield Part("axis", lines)
    free = complex(cam.sense)
    names = (
        Wanted("O", 0j, SIZE, 2.5, free - 1j),
        Wanted("C", nose, SIZE, 1.0, free - 1j),
    )
    yield Part("pivot", (circle("joint", 0j, 2.0), circle("main", nose, DOT, filled=True)), names)
    turn = -cam.sense
    arrow = round_arrow(0j, TURN, 90.0 - turn * 200.0, turn * 110.0)
    at = TURN * cmath.rect(1.0, math.radians(90.0 - turn * 145.0))
    yield Part("sense", arrow, (Wanted("ω_{1}", at, SIZE, 1.5),))


def _flank(cam: _Placed, flank: Flank, side: int, start: complex, end: complex) -> list[Ink]:
    at, _ = centre_of(cam.order, flank, side)
    if at is None:
        return [line("main", start, end)]
    return from_to("main", cam.spot(at), start, end, -cam.sense if flank.hollow else cam.sense)


def _sizes(cam: _Placed) -> Iterator[Part]:
    """Yield what is given: radii as arrows to their arcs, the distance of the nose's centre."""
    order, base = cam.order, cam.length(cam.order.base)
    nose, radius = cam.spot(-1j * order.distance), cam.length(order.nose)
    if order.eccentric:
        way = cmath.rect(1.0, math.radians(-90.0 + cam.sense * 55.0))
        yield _radius("R", nose, nose + radius * way, 0j)
        yield from _distance(cam, nose, radius, "e_{C}")
        return
    yield _radius("r_{1}", 0j, base * cmath.rect(1.0, math.radians(90.0 + cam.sense * 55.0)), 0j)
    if radius > 1.0:
        way = cmath.rect(1.0, math.radians(-90.0 + cam.sense * 35.0))
        yield _radius("r_{2}", nose, nose + radius * way, nose + (radius + 9.0) * way)
    touches = [cam.spot(one) for one in _touches(order)]
    letters = ("r_{3}", "r_{3}" if order.rise == order.fall else "r_{4}")
    flanks = ((order.rise, 1, touches[:2]), (order.fall, -1, touches[2:]))
    for letter, (flank, side, ends) in zip(letters, flanks, strict=True):
        at, _ = centre_of(order, flank, side)
        if at is None or (side < 0 and letters[0] == letters[1]):
            continue
        centre = cam.spot(at)
        way = (ends[0] + ends[1]) / 2 - centre
        tip = centre + abs(ends[0] - centre) * way / abs(way)
        out = way / abs(way) * (-1.0 if flank.hollow else 1.0)
        yield _radius(letter, tip, tip, tip + 11.0 * out)
    yield from _distance(cam, nose, base, "d")


def _distance(cam: _Placed, nose: complex, base: float, letter: str) -> Iterator[Part]:
    """Yield the dimension of how far a centre stands below the cam's, beside a circle of a radius."""
    x = -cam.sense * (base + ASIDE)
    ends = [complex(x, 0.0), complex(x, nose.imag)]
    lines = [
        line("thin", complex(-cam.sense * (base + CROSS)), complex(x - cam.sense * 2.0)),
        line("thin", nose - cam.sense * base / 3.0, complex(x - cam.sense * 2.0, nose.imag)),
        line("thin", *ends),
        *arrowhead(ends[0], 1j, pen="thin", length=3.0),
        *arrowhead(ends[1], -1j, pen="thin", length=3.0),
    ]
    told = Wanted(letter, (ends[0] + ends[1]) / 2, SIZE, 0.8, complex(-cam.sense))
    yield Part("dimension", tuple(lines), (told,))


def _radius(letter: str, start: complex, tip: complex, outside: complex) -> Part:
    """Return a radius: an arrow from its centre, or from outside to an arc whose centre is far or near."""
    begin = outside or start
    way = (tip - begin) / abs(tip - begin)
    strokes = (line("thin", begin, tip), *arrowhead(tip, way, pen="thin", length=3.0))
    at = begin if outside else begin + 0.6 * (tip - begin)
    return Part(
        "dimension", strokes, (Wanted(letter, at, SIZE, 0.8, way * -1.0 if outside else way * 1j),)
    )


def _follower(cam: _Placed) -> Iterator[Part]:
    """Yield the follower in its lowest position, with what is given of it."""
    order, reach = cam.order, cam.order.base + cam.order.roller
    roller = cam.length(order.roller)
    if order.rocks:
        yield from _rocker(cam, reach, roller)
        return
    at = cam.spot(complex(-order.offset, math.sqrt(reach**2 - order.offset**2)))
    if order.follower == FLAT:
        wide = cam.length(order.base)
        yield Part("face", (line("main", at - wide, at + wide),))
    pointed = roller == 0.0 and order.follower != FLAT
    yield Part("follower", tuple(rod(at, roller, pointed=pointed)))
    yield from _roller(cam, at, roller)
    if order.offset:
        away = 0.5 * cam.length(order.base) * 1j
        ends = (away, complex(at.real, away.imag))
        strokes = (line("thin", *ends), line("thin", at, ends[1]))
        told = Wanted("e", (ends[0] + ends[1]) / 2, SIZE, 0.8, 1j)
        yield Part("dimension", strokes, (told,))


def _roller(cam: _Placed, at: complex, radius: float) -> Iterator[Part]:
    if radius > 0.0:
        way = cmath.rect(1.0, math.radians(90.0 - cam.sense * 60.0))
        yield Part("roller", (circle("main", at, radius), circle("joint", at, PIN)))
        yield _radius("r", at, at + radius * way, at + (radius + 9.0) * way)


def _rocker(cam: _Placed, reach: float, roller: float) -> Iterator[Part]:
    """Yield the lever on its pivot above the cam."""
    order = cam.order
    assert order.centres is not None
    pivot = cam.spot(1j * order.centres)
    if order.lever is None:
        yield from _tilted(cam, reach, order.centres)
        return
    cosine = (order.centres**2 + reach**2 - order.lever**2) / (2.0 * order.centres * reach)
    between = math.acos(min(1.0, max(-1.0, cosine))) * (1.0 if order.same_sense else -1.0)
    at = cam.spot(reach * cmath.rect(1.0, math.pi / 2.0 + between))
    told = Wanted("l", (pivot + at) / 2, SIZE, 1.0)
    yield Part("lever", (line("main", pivot, at), *fixed_pivot(pivot)), (told,))
    yield from _roller(cam, at, roller)
    own = (Wanted("a", 0.75 * pivot, SIZE, 0.8, complex(-(at - pivot).real)),)
    yield Part("dimension", (line("thin", 0j, pivot),), own)


def _tilted(cam: _Placed, reach: float, centres: float) -> Iterator[Part]:
    """Yield a lever with a flat face; ``reach``: how far its line passes the cam's centre by."""
    order, side = cam.order, -1.0 if cam.order.same_sense else 1.0
    normal = cmath.rect(1.0, math.asin(reach / centres))
    normal = complex(side * normal.real, normal.imag)
    contact = order.base * normal
    foot = cam.spot(1j * centres - order.roller * normal)
    pivot, touch = cam.spot(1j * centres), cam.spot(contact)
    strokes = [line("main", foot, touch + (touch - foot) * 0.3), *fixed_pivot(pivot)]
    if order.roller:
        strokes.append(line("main", pivot, foot))
    yield Part("lever", tuple(strokes))
    aside = complex(-cam.sense * side)
    told = [Wanted("a", 0.75 * pivot, SIZE, 0.8, aside)]
    if order.roller:
        told.append(Wanted("l_{f}", (pivot + foot) / 2, SIZE, 0.8, 1j))
    yield Part("dimension", (line("thin", 0j, pivot),), tuple(told))
