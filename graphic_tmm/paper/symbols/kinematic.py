"""Symbols of kinematic diagrams, of gears and cams too (ГОСТ 2.770), y upward; hatching (ГОСТ 2.306).

The standard shows the shapes; its sizes are left to the draughtsman and stand here as constants.
Every function returns a tuple of strokes in sheet coordinates. Points and directions are complex,
angles are in degrees, counter-clockwise. A slider ("body") hides the guide under it, and a rod
(pen "rod") runs over the slider to the pin ("joint"), which hides them all. Strokes of a sign that is always
the same know it (`Symbol`), so that a CAD program gets it as a block; a pin is a sign of its own.

Seen from the end a gear is its pitch circle, a ring with internal teeth has the circle of its rim about it;
seen from the side a gear is a rectangle with the shaft through it. A break is a wavy line (ГОСТ 2.303).
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence

import numpy as np
import shapely

from graphic_tmm.paper.arithmetic import arcsine, counted, polar, signed, smaller
from graphic_tmm.paper.drawing import Bezier, Stroke, Symbol, arc, circle, line

HATCH = 2.5
"""Pitch of section hatching, mm."""
_LINE = 1
"""The kind of a shape that is a line, as shapely counts them."""
MOST = 1000
"""Lines at the most: more than the largest sheet takes at the usual pitch."""


def hatched(
    area: shapely.Polygon, *, pitch: float = HATCH, rising: bool = True
) -> tuple[Stroke, ...]:
    """Return the hatching of a section: thin lines at 45°.

    An area that no sheet holds is hatched more coarsely: it is refused only later, and not to be waited for.
    """
    left, low, right, high = area.bounds
    span = right - left + high - low
    pitch = max(pitch, span / MOST)
    slope = 1 if rising else -1
    count = math.ceil(span * math.sqrt(0.5) / pitch) + 1
    middle = complex((left + right) / 2, (low + high) / 2)
    along = cmath.rect(1.0, slope * math.pi / 4)
    feet = middle + np.arange(-count, count + 1) * pitch * 1j * along
    ends = np.stack([feet - span * along, feet + span * along], axis=1)
    lines = shapely.linestrings(np.stack([ends.real, ends.imag], axis=2))
    parts = shapely.get_parts(shapely.intersection(lines, area))
    there = (shapely.get_type_id(parts) == _LINE) & (shapely.length(parts) > 0.2)
    return tuple(line("thin", *(complex(x, y) for x, y in part.coords)) for part in parts[there])


JOINT_RADIUS = 1.5
"""Of the circle of a turning pair, mm. ГОСТ 2.770 gives shapes, not sizes: this and those below were chosen by
eye."""
FOOT_HEIGHT, FOOT_WIDTH, GROUND_LENGTH = 7.0, 8.0, 12.0
"""A pivot on the frame: height and width of its legs, length of its base line, mm."""
HATCH_PITCH, HATCH_DEPTH = 1.5, 2.0
"""Hatching of the frame: way between strokes along the line, their depth, mm."""
MOST_HATCHES = 2000
"""Strokes along one line at the most: at the pitch above, 3 m."""
PLATE_PITCH = 2.0
"""Pitch of the hatching of a plate, mm."""
SLIDER_LENGTH, SLIDER_WIDTH = 12.0, 6.0
"""A slider on a guide of the frame, mm."""
STONE_LENGTH, STONE_WIDTH = 10.0, 5.0
"""A stone on a rocker, mm: smaller than a slider, so that it shows on the link."""
TUBE_WIDTH, PISTON_LENGTH, PISTON_WIDTH = 8.0, 4.0, 6.4
"""A cylinder: the width of its tube, length and width of its piston, mm."""
PORT = 3.0
"""Side of the triangle that marks oil (filled) or gas (open), mm; ГОСТ 2.782."""
CORNER, ROOF = 4.0, 3.2
"""Legs of the triangle that joins two bars firmly, its height over a straight bar, mm."""
ARROW_LENGTH, ARROW_WIDTH = 4.5, 1.2
"""An arrowhead, its length and width, mm."""
POLE_RADIUS = 0.7
"""The dot of a pole, mm."""

Strokes = tuple[Stroke, ...]


def turning_pair(at: complex) -> Strokes:
    """Return a turning pair: a circle of 1.5 mm radius with the paper inside."""
    return _sign("pair", at, 0.0, (circle("joint", at, JOINT_RADIUS),))


def _sign(kind: str, at: complex, turn: float, strokes: Strokes) -> Strokes:
    return tuple(stroke._replace(symbol=Symbol(kind, at, turn)) for stroke in strokes)


def fixed_pivot(at: complex, angle: float = 0.0) -> Strokes:
    """Return a pivot on the frame: pin, legs, base line, hatching; ``angle`` turns its foot."""
    turn = polar(1.0, angle)
    feet = [at + turn * complex(x, -FOOT_HEIGHT) for x in (-FOOT_WIDTH / 2, FOOT_WIDTH / 2)]
    ends = [at + turn * complex(x, -FOOT_HEIGHT) for x in (-GROUND_LENGTH / 2, GROUND_LENGTH / 2)]
    legs = line("main", feet[0], at, feet[1])
    foot = (legs, *guide(ends[0], ends[1], sides=(-1,)))
    return (*_sign("support", at, angle, foot), *turning_pair(at))


def hatching(start: complex, end: complex, side: int) -> Strokes:
    """Return strokes at 45° along a line: ``side`` +1 to the left of start -> end, -1 right.

    The strokes stay between the ends; they are 1.5 mm apart along the line, or farther along one that no
    sheet holds: it is refused only later, and not to be waited for.
    """
    length = abs(end - start)
    if length <= HATCH_DEPTH:
        return ()
    along = (end - start) / length
    slant = HATCH_DEPTH * along * complex(-1, side)
    pitch = max(HATCH_PITCH, length / MOST_HATCHES)
    count = math.floor((length - HATCH_DEPTH) / pitch + 1e-9)
    first = (length - HATCH_DEPTH - count * pitch) / 2 + HATCH_DEPTH
    roots = (start + along * (first + k * pitch) for k in counted(count + 1))
    return tuple(line("thin", root, root + slant) for root in roots)


def guide(start: complex, end: complex, *, sides: Sequence[int] = (-1,)) -> Strokes:
    """Return a fixed guide: a main line hatched on ``sides`` (+1 left of it, -1 right)."""
    hatched = (stroke for side in sides for stroke in hatching(start, end, side))
    return (line("main", start, end), *hatched)


def channel(at: complex, angle: float, length: float, *, width: float = SLIDER_WIDTH) -> Strokes:
    """Return two guides ``width`` mm apart, hatched outside: a slider runs between them."""
    turn = polar(1.0, angle)
    half, gap = turn * length / 2, 1j * turn * width / 2
    upper = guide(at - half + gap, at + half + gap, sides=(1,))
    return upper + guide(at - half - gap, at + half - gap, sides=(-1,))


def slider(
    at: complex,
    angle: float = 0.0,
    *,
    length: float = SLIDER_LENGTH,
    width: float = SLIDER_WIDTH,
    pin: bool = True,
    kind: str = "slider",
) -> Strokes:
    """Return a slider: a rectangle turned by ``angle``; ``pin`` adds a turning pair; ``kind`` of its sign."""
    turn = polar(0.5, angle)
    corners = ((-length, -width), (length, -width), (length, width), (-length, width))
    box = line("body", *(at + turn * complex(x, y) for x, y in corners), closed=True)
    sign = _sign(kind, at, angle, (box,))
    return (*sign, *turning_pair(at)) if pin else sign


def stone(at: complex, angle: float = 0.0, *, pin: bool = True) -> Strokes:
    """Return the stone on a rocker: a smaller rectangle than the slider on a fixed guide."""
    return slider(at, angle, length=STONE_LENGTH, width=STONE_WIDTH, pin=pin, kind="stone")


def tube(start: complex, end: complex) -> Strokes:
    """Return the tube of a cylinder between the middles of its ends; it hides what lies under it."""
    half = 1j * (end - start) / abs(end - start) * TUBE_WIDTH / 2
    return (line("body", start + half, end + half, end - half, start - half, closed=True),)


def piston(at: complex, angle: float = 0.0) -> Strokes:
    """Return a piston about the middle of it, in a tube along ``angle``."""
    return slider(at, angle, length=PISTON_LENGTH, width=PISTON_WIDTH, pin=False, kind="piston")


def port(at: complex, way: complex, *, filled: bool) -> Strokes:
    """Return the sign of what is in a cylinder, at its wall: ``way`` (of length 1) leads in; filled: oil."""
    base, half = at - PORT * way, 0.5j * PORT * way
    pen = "main" if filled else "body"
    return (line(pen, at, base + half, base - half, closed=True, filled=filled),)


def rigid_joint(at: complex, first: complex, second: complex, *, times: float = 1.0) -> Strokes:
    """Return the filled corner that joins two rods rigidly, given their directions from ``at``.

    ``times``: how much larger than the usual: one at a pair has to show behind its circle.

    Where the rods are in one line (a pin in the middle of a rod) the corner lies on the left of
    ``first``.
    """
    u, v, reach = first / abs(first), second / abs(second), CORNER * times
    sine = (u.conjugate() * v).imag
    if abs(sine) < 0.1:
        points = (at - reach * u, at + reach * u, at + ROOF * times * 1j * u)
    else:
        points = (at, at + reach * u, at + reach * v)
        points = points if sine > 0 else (points[0], points[2], points[1])
    return (line("main", *points, closed=True, filled=True),)


def plate(*corners: complex) -> Strokes:
    """Return a link of three pairs or more: a main outline, thin hatching at 45° inside."""
    area = shapely.Polygon([(z.real, z.imag) for z in corners])
    return (line("main", *corners, closed=True), *hatched(area, pitch=PLATE_PITCH))


def arrowhead(
    tip: complex,
    direction: complex,
    *,
    pen: str = "main",
    length: float = ARROW_LENGTH,
    width: float = ARROW_WIDTH,
) -> Strokes:
    """Return a filled arrowhead with its point at ``tip``, pointing along ``direction`` (not 0)."""
    u = direction / abs(direction)
    base = tip - length * u
    wing = 1j * u * width / 2
    return (line(pen, tip, base + wing, base - wing, closed=True, filled=True),)


def round_arrow(
    centre: complex, radius: float, start: float, sweep: float, *, pen: str = "thin"
) -> Strokes:
    """Return the arrow of an angular velocity: an arc over ``sweep`` degrees, headed at its end.

    The head is a chord of the arc, so that it follows the turn; it is shortened to half of a short
    arc.
    """
    sense = signed(1.0, sweep)
    head = smaller(2 * arcsine(smaller(1.0, ARROW_LENGTH / (2 * radius))), abs(sweep) / 2)
    tip = centre + polar(radius, start + sweep)
    base = centre + polar(radius, start + sweep - sense * head)
    bow = arc(pen, centre, radius, start, sweep - sense * head)
    return (bow, *arrowhead(tip, tip - base, pen=pen, length=abs(tip - base)))


def pole(at: complex) -> Strokes:
    """Return the mark of a pole: a filled dot."""
    return (circle("main", at, POLE_RADIUS, filled=True),)


RIM = 4.0
"""From the pitch circle of a ring to the circle of its rim, mm."""
CENTRE_BEYOND = 4.0
"""How far the centre lines of a gear go on behind its circle, mm."""
FIX = 2.0
"""Half the cross that fixes a gear to its shaft, mm."""
GROUND_PITCH, MOST_GROUND = 2.5, 600
"""Way along a rim between the strokes of its ground, mm; their number at the most."""
WAVE, HEIGHT = 12.0, 1.5
"""Length and height of a wave of the line of a break, mm."""


def gear(at: complex, radius: float, *, internal: bool = False) -> Strokes:
    """Return a gear from its end: pitch circle, centre lines, turning pair; a ring has a rim outside."""
    reach = radius + (RIM if internal else 0.0) + CENTRE_BEYOND
    axes = tuple(line("centre", at - reach * way, at + reach * way) for way in (1, 1j))
    rim = (circle("main", at, radius + RIM),) if internal else ()
    return (*axes, circle("main", at, radius), *rim, *(() if internal else turning_pair(at)))


def ring_ground(at: complex, radius: float) -> Strokes:
    """Return the ground of a fixed ring: strokes at 45° outside its rim, all around and evenly."""
    count = min(max(8, round(2 * math.pi * radius / GROUND_PITCH)), MOST_GROUND)
    ways = (cmath.rect(1.0, math.radians(360.0 * (k + 0.5) / count)) for k in range(count))
    slant = HATCH_DEPTH * (1 + 1j)
    return tuple(line("thin", at + radius * way, at + (radius + slant) * way) for way in ways)


def gear_side(at: complex, radius: float, width: float, *, fixed: bool = True) -> Strokes:
    """Return a gear from its side, the shaft level: its outline; a cross fixes it to the shaft."""
    half = width / 2
    corners = (
        complex(-half, -radius),
        complex(half, -radius),
        complex(half, radius),
        complex(-half, radius),
    )
    box = line("main", *(at + z for z in corners), closed=True)
    if not fixed:
        return (box,)
    ends = (complex(FIX, FIX), complex(FIX, -FIX))
    return (box, *(line("main", at - z, at + z) for z in ends))


def cam(at: complex, profile: Sequence[complex]) -> Strokes:
    """Return a cam: its closed profile (points about its centre), its turning pair."""
    return (line("main", *(at + z for z in profile), closed=True), *turning_pair(at))


def wavy(start: complex, end: complex) -> Bezier:
    """Return the wavy line of a break from ``start`` to ``end``: whole waves, thin."""
    span = end - start
    count = 2 * max(1, round(abs(span) / WAVE))
    step, side = span / count, 1j * span / abs(span) * HEIGHT
    controls = [start]
    for k in range(count):
        foot, lift = start + k * step, side * (1 if k % 2 == 0 else -1)
        controls += [foot + step / 3 + lift, foot + 2 * step / 3 + lift, foot + step]
    return Bezier("thin", tuple(controls))
