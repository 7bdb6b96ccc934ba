"""A train of bevel wheels in ink: its scheme from the side (ГОСТ 2.770), velocities above, vectors ω beside."""

from __future__ import annotations

import math
from collections.abc import Iterator

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.trains.bevel import RELATIVE, BevelView
from graphic_tmm.chapters.trains.ink import (
    BELOW,
    COLUMN,
    VIEWS,
    Captions,
    block_of_lines,
    in_lines,
    with_steps,
)
from graphic_tmm.chapters.trains.ink_pairs import BEARING, GAP, HOLLOW, STUB, WIDTH, Side, bearing
from graphic_tmm.chapters.trains.ink_rates import (
    DOT,
    draw_pole,
    is_read,
    line_between,
    vector,
    with_segment,
)
from graphic_tmm.chapters.trains.ink_scheme import (
    ASIDE,
    LEAST,
    OVER,
    SHAFT,
    SHORT,
    Scheme2KH,
    TrainInk,
    built_in,
)
from graphic_tmm.chapters.trains.plan import Planetary
from graphic_tmm.paper.drawing import Drawing, Ink, Label, Stroke, Wanted, circle, line
from graphic_tmm.paper.figure import body, figure, showing
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.mark_rules import leaving
from graphic_tmm.paper.seen import Rule, Subject
from graphic_tmm.paper.shapes import box
from graphic_tmm.paper.symbols.kinematic import FIX, Strokes, guide

FACE = 0.3
"""A wheel is no wider, of the length of its cone: half of it to either side of the mean radius."""
LOCK = 3.5
"""Half the length of the collars that keep a satellite on its axle, mm."""
OFF = 5.0
"""From the picture of velocities up to its caption, mm."""


def draw_bevel_scheme(made: Scheme2KH, opposite: bool) -> Iterator[tuple[str, Strokes]]:
    """Yield the bodies by their names; O is in 0. ``opposite``: a satellite stands opposite the one drawn."""
    first, last = (
        made.wheels[mesh.wheel] for mesh in (made.scheme.meshes[0], made.scheme.meshes[-1])
    )
    left, right = ends_of(made)
    end = max(_faces(last)) + SHORT
    yield "1", _first(first, left, stands=made.motion.fixed == "1")
    for rim in made.scheme.rims:
        one = _cone(made.wheels[rim])
        yield rim, (*one, *(map(_mirrored, one) if opposite else ()))
    yield made.motion.last, tuple(_last(last, end, stands=made.motion.fixed == made.motion.last))
    sleeves = [part for rim in made.scheme.rims for part in _along(made.wheels[rim])]
    way = made.arm[0] / abs(made.arm[0])
    low, high = min(sleeves) * way, max(sleeves) * way
    axle: list[Stroke] = []
    for gap in (GAP * 1j * way, -GAP * 1j * way):
        axle.append(line("main", low + gap, high + gap))
    for at in (low - way, high + way):
        axle.append(line("main", at + LOCK * 1j * way, at - LOCK * 1j * way))
    axle.append(line("main", 0j, high + way * (1.0 + STUB)))
    if opposite:
        axle += map(_mirrored, axle[:])
    axle.append(line("main", 0j, complex(right)))
    if made.motion.fixed == "H":
        axle += built_in(complex(right), 1)
    else:
        axle += bearing(complex((end + right) / 2))
    yield "H", tuple(axle)


def ends_of(made: Scheme2KH) -> tuple[float, float]:
    """Return where the shafts of wheel 1 and of the carrier end."""
    first, last = (
        made.wheels[mesh.wheel] for mesh in (made.scheme.meshes[0], made.scheme.meshes[-1])
    )
    return min(_faces(first)) - SHAFT, max(_faces(last)) + SHORT + SHAFT


def spots_of_bevel(made: Scheme2KH) -> dict[str, tuple[complex, complex]]:
    """Return where numbers of wheels and the letter of the carrier stand: a point, a direction."""
    found = {}
    for wheel, way in (("1", -1), (made.motion.last, 1)):
        side = made.wheels[wheel]
        x = max(_faces(side), key=lambda one: way * one)
        found[wheel] = (complex(x, -0.6 * side.radius), complex(way))
    out = made.arm[0] / abs(made.arm[0])
    last = max(made.scheme.rims, key=lambda rim: abs(made.wheels[rim].centre))
    for rim in made.scheme.rims:
        side, way = made.wheels[rim], 1 if rim == last else -1
        share = 1.0 + way * _share(side)
        found[rim] = (share * (0.5 * side.far + 0.5 * side.centre), way * out)
    found["H"] = (0.35 * made.arm[0], 1 + 0j)
    return found


def _share(side: Side) -> float:
    """Half the width of a wheel over the length of its cone."""
    return min(WIDTH / 2 / abs(side.near), FACE)


def _faces(side: Side) -> tuple[float, float]:
    """Where both faces of a central wheel stand along the main axis."""
    share = _share(side)
    return side.near.real * (1.0 + share), side.near.real * (1.0 - share)


def _along(side: Side) -> tuple[float, float]:
    """Where both faces of a satellite's rim stand along its axis, from O."""
    share = _share(side)
    return abs(side.centre) * (1.0 + share), abs(side.centre) * (1.0 - share)


def _cone(side: Side) -> Strokes:
    """A wheel from its side, all its lines toward O."""
    out, within = 1.0 + _share(side), 1.0 - _share(side)
    corners = (out * side.near, out * side.far, within * side.far, within * side.near)
    return (line("main", *corners, closed=True),)


def _mirrored(stroke: Stroke) -> Stroke:
    """Return a stroke on the other side of the main axis."""
    return stroke._replace(path=tuple((x, -y, -bulge) for x, y, bulge in stroke.path))


def _first(side: Side, left: float, *, stands: bool) -> Strokes:
    """Wheel 1 on its shaft, which goes left."""
    middle = side.centre
    cross = (line("main", middle - z, middle + z) for z in (FIX * (1 + 1j), FIX * (1 - 1j)))
    shaft = line("main", complex(left), complex(max(_faces(side)) + STUB))
    stand = built_in(complex(left), -1) if stands else bearing(complex(left + SHAFT / 2))
    return (*_cone(side), *cross, shaft, *stand)


def _last(side: Side, end: float, *, stands: bool) -> Iterator[Stroke]:
    """The last wheel on a hollow hub, through which the shaft of the carrier goes."""
    out, within = 1.0 + _share(side), 1.0 - _share(side)
    for sense, rim in ((1, side.near), (-1, side.far)):
        low = 1j * sense * min(HOLLOW, side.radius / 2)
        near, far = rim.real * within + low, rim.real * out + low
        yield line("main", end + low, far, out * rim, within * rim, near)
        if stands:
            yield from guide(end + low, end + low + 10j * sense, sides=(-sense,))
        else:
            middle = end - SHORT / 2 + low + 1j * sense * GAP
            yield from guide(middle - BEARING / 2, middle + BEARING / 2, sides=(sense,))


def draw_bevel_ink(on: Subject, made: Planetary, captions: Captions) -> Drawing:
    """Return the train from its side, the picture of velocities above it, the triangle of ω to its right."""
    ink = TrainInk(on.seen(VIEWS, range(1)), made, on.heights)
    traces = figure(ink.seen, showing(_rules(ink)))
    strokes = (*traces.staying, *_bodies(ink), *draw_pole(ink))
    labels = with_steps(ink, _captions(ink, captions))
    return traces.drawing(on, strokes, _letters(ink), labels, [(0, "1")])


def _bodies(ink: TrainInk) -> Iterator[Ink]:
    marks = {one.name: one.marks for kind in ("disc", "arm") for one in ink.figures(kind)}
    rims = [mark for rim in ink.rims for mark in marks[rim]]
    for name, strokes in draw_bevel_scheme(ink.scheme, _opposite(ink)):
        on = (*rims, *marks[name]) if name == "H" else marks[name]
        yield from body(strokes, "carrier" if name == "H" else "wheel", on)


def _opposite(ink: TrainInk) -> bool:
    return ink.made.train.satellites % 2 == 0


def _rules(ink: TrainInk) -> dict[Mark, Rule]:
    """What stays: axes, lines of contact, levels, velocities, the vectors of ω."""
    view, picture = ink.made.end, ink.made.picture
    assert isinstance(view, BevelView)
    left, right = ends_of(ink.scheme)
    axis = ink.scheme.arm[0]
    out = max(part for rim in ink.rims for part in _along(ink.scheme.wheels[rim])) + 2 * OVER
    top = axis / abs(axis) * out
    bent = [top.conjugate(), 0j, top] if abs(top.real) > LEAST else [top.conjugate(), top]
    ways = bent if _opposite(ink) else [0j, top]
    rules = {
        view.main: line_between("centre", complex(left - OVER), complex(right + OVER)),
        view.up: leaving(line("centre", *ways)),
    }
    for mark, at in zip(view.lines.values(), "AC", strict=True):
        rules[mark] = line_between("thin", 0j, ink.points[at])
    for at, level in view.levels.items():
        rules[level] = line_between("thin", ink.points[at], ink.zeros[at])
    zero = ink.seen.by_mark[picture.zeros["A"]].uses[0]
    across = ink.zeros["C"] - ink.zeros["A"]
    beyond = OVER * across / abs(across)
    rules[zero] = line_between("thin", ink.zeros["A"] - beyond, ink.zeros["C"] + beyond)
    for at, end in picture.ends.items():
        own = picture.readings[at], picture.speeds[at]
        mark = own[0] if is_read(ink, own[0]) else end
        rules[mark] = vector(ink, ink.zeros[at], ink.tips[at], *own)
    one, other = (ink.tips.get(at, ink.zeros[at]) for at in "AC")
    rules[picture.lines[ink.rims[0]]] = line_between("main", one, other)
    return rules | _vectors(ink, view)


def _vectors(ink: TrainInk, view: BevelView) -> dict[Mark, Rule]:
    rates, pole = ink.made.rates, ink.pole
    hub, tip = ink.ends.get("H", pole), ink.ends["2"]
    xs = [pole.real, *(end.real for name, end in ink.ends.items() if name != "2")]
    lines = [
        step
        for step in ink.seen.steps
        if step.op.name == "parallel" and step.it.view == rates.pole.view
    ]
    base, about, *rays = (step.it for step in lines)
    y = pole.imag
    rules = {
        base: line_between("thin", complex(min(xs) - OVER, y), complex(max(xs) + OVER, y)),
        about: line_between("thin", hub, tip),
    }
    for mark, wheel in zip(rays, view.lines, strict=True):
        rules[mark] = line_between("medium", ink.ends.get(wheel, pole), tip)
    for name, end in rates.ends.items():
        own = rates.segments[name], rates.values[name]
        if name in ("H", "2"):
            rules[end if name == "H" else own[0]] = vector(ink, pole, ink.ends[name], *own)
            continue
        dot = circle("main", ink.ends[name], DOT, filled=True)
        rules[end] = leaving(with_segment(ink, dot, *own))
    own = rates.segments[RELATIVE], rates.values[RELATIVE]
    return rules | {own[0]: vector(ink, hub, tip, *own)}


def _letters(ink: TrainInk) -> list[Wanted]:
    """Numbers of the wheels, letters of the points, of the ends of velocities and of vectors."""
    made, small = ink.made, ink.heights.point
    marks = {one.name: one.marks for kind in ("disc", "arm") for one in ink.figures(kind)}
    wanted = [
        Wanted(name, at, small, ASIDE, way, tuple(mark.slot for mark in marks[name]))
        for name, (at, way) in spots_of_bevel(ink.scheme).items()
    ]
    wanted.append(Wanted("O", ink.centre, small, 1.5, 1 - 1j, (made.end.origin.slot,)))
    ways = {"A": -1 + 0.5j, "B": 1 - 1j, "C": 1 + 0.5j}
    for name, mark in made.end.points.items():
        wanted.append(Wanted(name, ink.points[name], small, 1.5, ways[name], (mark.slot,)))
        zero = made.picture.zeros[name]
        wanted.append(Wanted(name, ink.zeros[name], small, 0.8, ways[name], (zero.slot,)))
    for name, at in ink.tips.items():
        if abs(at - ink.zeros[name]) >= LEAST:
            of = (made.picture.ends[name].slot,)
            wanted.append(Wanted(name.lower(), at, small, 0.8, at - ink.zeros[name], of))
    named = [Named(ink.pole, "P", (made.rates.pole.slot,))]
    named += [Named(ink.ends[key], key, (mark.slot,)) for key, mark in made.rates.ends.items()]
    return [*wanted, *lettered(shared(named), small, 0.8, away_from=None)]


def _captions(ink: TrainInk, captions: Captions) -> list[list[Label]]:
    """The captions: below the scheme, above the picture of velocities, below the triangle."""
    left, right = ends_of(ink.scheme)
    high = max(z.imag for z in (*ink.zeros.values(), *ink.tips.values())) + OFF
    ends = [ink.pole, *ink.ends.values()]
    xs = [z.real for z in ends]
    low = min(z.imag for side in ink.scheme.wheels.values() for z in (side.near, side.far))
    if _opposite(ink):
        low = min(low, *(-abs(part) for rim in ink.rims for part in _along(ink.scheme.wheels[rim])))
    wide = max(max(xs) - min(xs), COLUMN * ink.heights.point)
    beside = (min(xs) + max(xs)) / 2
    rooms = (
        (captions.views, (left + right) / 2, low - 2 * OVER - BELOW[0], math.inf),
        (captions.velocities, ink.zeros["B"].real, high, right - left),
        (captions.rates, beside, min(z.imag for z in ends) - BELOW[2], wide),
    )
    blocks = []
    for k, (lines, middle, y, most) in enumerate(rooms):
        sizes = (ink.heights.title, *[ink.heights.point] * len(lines))
        parts = [
            (part, size)
            for text, size in zip(lines, sizes, strict=False)
            for part in in_lines(text, size, most)
        ]
        block = block_of_lines(parts, middle, y)
        if k == 1 and block:
            up = y - min(box(one).bounds[1] for one in block)
            block = [one._replace(at=one.at + 1j * up) for one in block]
        blocks.append(block)
    return blocks
