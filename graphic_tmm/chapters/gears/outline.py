"""The outlines of drawn teeth, and what the operations of a gear pair leave on paper."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping
from itertools import pairwise

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.operations.curve import bezier
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.chapters.gears.rolling import along_arc, smooth_through
from graphic_tmm.chapters.gears.teeth import Flank, Tooth, Wheel
from graphic_tmm.paper.clipping import Controls, cut, nearest
from graphic_tmm.paper.drawing import Bezier, Ink, Stroke, arc, line
from graphic_tmm.paper.figure import body
from graphic_tmm.paper.mark_rules import curve
from graphic_tmm.paper.seen import Rule, Seen, finite


def stepped_off(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """The part of the arc along which dividers stepped off a length."""
    start, end = seen.point(step.uses[0], k), seen.point(step.it, k)
    centre, radius = seen.arc(step.uses[1], k)
    if finite(start, end) and abs(end - start) > 1e-9:
        sense = 1 if seen.number(step.uses[2], k) * step.choice["sense"] > 0.0 else -1
        turn = math.degrees(cmath.phase((end - centre) / (start - centre)))
        if turn * sense < 0.0:
            turn += 360.0 * sense
        yield arc("thin", centre, radius, math.degrees(cmath.phase(start - centre)), turn)


RULES: Mapping[str, Rule] = {along_arc.name: stepped_off, smooth_through.name: curve("thin")}
"""By operation."""


BAND, PITCH = 2.0, 1.6
"""Breadth of the hatched band along the working part of a flank, and the pitch of its strokes, mm."""
BESIDE = 0.3
"""How far the root goes on beside the outer teeth, of a pitch."""


def controls(reading: Reading, curve: Mark) -> Controls:
    """Return a curve as control points of cubic arcs; () if it cannot be drawn as one piece."""
    runs = bezier(reading[curve])
    return tuple(complex(z) for z in runs[0]) if len(runs) == 1 else ()


def spot(reading: Reading, mark: Mark) -> complex:
    """Return where a point stands."""
    return complex(reading[mark][0, 0])


def part(reading: Reading, curve: Mark, like: Mark, start: complex, end: complex) -> Controls:
    """Return the part of ``curve`` that corresponds to the part of ``like`` between two points of that."""
    model, own = controls(reading, like), controls(reading, curve)
    if not (model and own and cmath.isfinite(start) and cmath.isfinite(end)):
        return ()
    return cut(own, nearest(model, start), nearest(model, end))


def flank(reading: Reading, side: Flank) -> Controls:
    """Return a flank from where it begins to the tip."""
    start, tip = spot(reading, side.start), spot(reading, side.tip)
    return part(reading, side.flank, side.flank, start, tip)


def fillet(reading: Reading, side: Flank) -> Controls:
    """Return a fillet from the root to where the flank begins; () of a ring."""
    own = controls(reading, side.fillet) if side.fillet else ()
    start = spot(reading, side.start)
    if not (own and cmath.isfinite(start)):
        return ()
    return cut(own, float(len(own) // 3), nearest(own, start))


def outline(reading: Reading, wheel: Wheel) -> Iterator[Ink]:
    """Yield the outline of the three teeth of a wheel, with the root circle between and beside them."""
    centre = spot(reading, wheel.circles.centre)
    roots = _roots(reading, wheel)
    for tooth in wheel.teeth:
        yield from tooth_outline(reading, tooth, centre)
    spread = BESIDE * 2 * math.pi / float(reading[wheel.sizes.z][0, 0])
    spread = -spread if wheel.sizes.cut is None else spread
    if not all(roots):
        return
    spots = [piece[0] for piece in roots]
    arcs = [_between(spots[0], centre, spread), _between(spots[-1], centre, -spread)]
    for right, left in ((spots[1], spots[2]), (spots[3], spots[4])):
        arcs.append(_between(right, centre, cmath.phase((left - centre) / (right - centre))))
    sides = (side for tooth in wheel.teeth for side in (tooth.left, tooth.right))
    fillets = [side.fillet or side.flank for side in sides]
    yield from body(arcs, "tooth", [wheel.circles.root, *fillets])


def pitch_outline(reading: Reading, wheel: Wheel) -> Iterator[Ink]:
    """Yield the outline of one tooth with the root circle up to the next one: a wheel has it z times."""
    centre, roots = spot(reading, wheel.circles.centre), _roots(reading, wheel)
    yield from tooth_outline(reading, wheel.teeth[1], centre)
    if all(roots):
        right, left = roots[3][0], roots[4][0]
        yield _between(right, centre, cmath.phase((left - centre) / (right - centre)))


def _roots(reading: Reading, wheel: Wheel) -> list[Controls]:
    """Return where each side of the three teeth begins at the root; () where it cannot be drawn."""
    roots = []
    for tooth in wheel.teeth:
        for side in (tooth.left, tooth.right):
            own = flank if side.fillet is None else fillet
            roots.append(own(reading, side)[:1])
    return roots


def tooth_outline(reading: Reading, tooth: Tooth, centre: complex) -> Iterator[Ink]:
    """Yield the sides of a tooth and the arc of its tip, if it has one."""
    made: list[Ink] = []
    for side in (tooth.left, tooth.right):
        for piece in (fillet(reading, side), flank(reading, side)):
            if piece:
                made.append(Bezier("main", piece, side.flank.name))
    left, right = (spot(reading, side.tip) for side in (tooth.left, tooth.right))
    if cmath.isfinite(left) and cmath.isfinite(right) and abs(left - right) > 1e-9:
        made.append(_between(left, centre, cmath.phase((right - centre) / (left - centre))))
    yield from body(made, "tooth", tooth.marks)


def _between(start: complex, centre: complex, turn: float) -> Stroke:
    """Return the arc about a centre from a point over an angle (radians)."""
    reach = start - centre
    return arc("main", centre, abs(reach), math.degrees(cmath.phase(reach)), math.degrees(turn))


def hatched(spots: list[complex]) -> Iterator[Ink]:
    """Yield a hatched band to the left of a flank."""
    inner = [z + BAND * 1j * (w - z) / abs(w - z) for z, w in pairwise(spots) if w != z]
    if len(inner) < 2:
        return  # the flank works in one point only
    yield line("thin", *inner)
    gone = 0.0
    for k, (z, w) in enumerate(pairwise(spots)):
        gone += abs(w - z)
        if gone >= PITCH and k + 2 < len(inner):
            gone = 0.0
            yield line("thin", w, inner[min(k + 2, len(inner) - 1)])


def sector(reading: Reading, wheel: Wheel) -> tuple[float, float]:
    """Return from where to where (degrees, counter-clockwise) the teeth of a wheel and their root reach."""
    centre, pole = spot(reading, wheel.circles.centre), spot(reading, wheel.middle)
    z = float(reading[wheel.sizes.z][0, 0])
    middle = math.degrees(cmath.phase(pole - centre))
    half = 360.0 / z * (1.0 + 0.5 + BESIDE)
    return middle - half, middle + half
