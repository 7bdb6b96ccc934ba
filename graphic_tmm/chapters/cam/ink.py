"""The profile of a cam in ink: both profiles, the follower in its place and in its inverted places."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.record import Figure, Mark
from graphic_tmm.board.values import Arc, Complexes, Curve
from graphic_tmm.chapters.cam.centre import Path
from graphic_tmm.chapters.cam.flat_rocker import FaceLever
from graphic_tmm.chapters.cam.ink_rules import (
    CamInk,
    between,
    directions,
    draw_phases,
    numbered,
    phase_letters,
    whole,
)
from graphic_tmm.chapters.cam.plan import Cam
from graphic_tmm.chapters.cam.profile import OUTER, THEORETICAL, VIEW, WORKING
from graphic_tmm.chapters.cam.rocker import Lever
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, arc, circle, line
from graphic_tmm.paper.figure import added, body, figure, showing
from graphic_tmm.paper.mark_rules import curve
from graphic_tmm.paper.seen import Rule, Subject, finite
from graphic_tmm.paper.symbols.kinematic import arrowhead, channel, fixed_pivot, round_arrow

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
PENS = {THEORETICAL: "medium", WORKING: "main", OUTER: "main"}
"""By contour."""
DWELL = 1e-6
"""What is shorter is no dwell, degrees."""


def inverted(ink: CamInk) -> Iterator[Ink]:
    """Rollers and pivots in their inverted places, the circles on which pivots and guides stand."""
    for roller in ink.figures("roller"):
        centre, radius = roller.marks
        for k, at in enumerate(ink.all(centre)):
            if np.isfinite(at):
                made = circle("thin", complex(at), ink.fixed_number(radius))
                yield from body([made], "roller", roller.marks, k)
    swinging = ink.figures("lever") + ink.figures("face lever")
    for lever in swinging:
        pivots = lever.marks[0]
        for k, at in enumerate(ink.all(pivots)):
            if np.isfinite(at):
                yield from body([circle("thin", complex(at), PIVOT)], "pivot", [pivots], k)
    for stand in swinging + ink.figures("guide"):
        mark = stand.marks[0]
        reach = abs(complex(ink.all(mark)[0]))
        if len(stand.marks) > 1 and math.isfinite(reach):
            yield from body([circle("thin", 0j, reach)], "circle", [mark])


def dwells(ink: CamInk, contour: Figure) -> Iterator[Ink]:
    """The arcs of a contour: each goes on from the end of the curve before it to the beginning of the next."""
    pen = PENS[contour.name]
    sense = -ink.cam.sense
    for n, mark in enumerate(contour.marks):
        if mark.kind is not Arc:
            continue
        before, after = contour.marks[n - 1], contour.marks[(n + 1) % len(contour.marks)]
        ends = ink.reading[before].knots[0, -1], ink.reading[after].knots[0, 0]
        start, end = (complex(z) for z in ends)
        radius = ink.arc(mark, 0)[1]
        if not finite(start, end, radius):
            continue
        turn = (sense * math.degrees(cmath.phase(end / start))) % 360.0
        if DWELL < turn < 360.0 - DWELL:
            begin = math.degrees(cmath.phase(start))
            made = arc(pen, 0j, radius, begin, sense * turn)
            yield from body([made], "contour", [mark, before, after])


def first_place(ink: CamInk, spot: complex) -> complex:
    """Return where a point of the first position is as the turn begins: a dwell may go before it."""
    angle = ink.cam.diagrams.turn.angles[0]
    return spot * cmath.exp(1j * ink.cam.sense * math.radians(angle)) if angle else spot


def follower(ink: CamInk, points: Complexes) -> Iterator[Ink]:
    """The follower in its lowest place, in full: roller and rod in a guide, lever, or face."""
    start, made = first_place(ink, complex(points[0])), ink.cam.profile
    if not np.isfinite(start):
        return
    radius = 0.0
    for roller in ink.figures("roller"):
        radius = ink.fixed_number(roller.marks[1])
        strokes = (circle("main", start, radius), circle("joint", start, PIN))
        yield from body(strokes, "roller", roller.marks, 0)
    for lever in ink.figures("lever"):
        pivot = first_place(ink, complex(ink.all(lever.marks[0])[0]))
        strokes_ = (line("main", pivot, start), *fixed_pivot(pivot))
        yield from body(strokes_, "lever", lever.marks, 0)
        return
    for lever in ink.figures("face lever"):
        pivot, foot = (first_place(ink, complex(ink.all(m)[0])) for m in lever.marks[:2])
        yield from body(face_lever(ink, pivot, foot, start), "lever", lever.marks, 0)
        return
    for face in ink.figures("face"):
        feet = ink.all(face.marks[0])
        start = first_place(ink, complex(feet[0]))
        half = float(np.nanmax(np.abs(points - feet))) + 5.0
        yield from body([line("main", start - half, start + half)], "face", face.marks, 0)
    edge = made.roller is None and made.theoretical is not None
    points_of = [(made.theoretical or made.working).points]
    yield from body(rod(start, radius, edge=edge), "follower", points_of, 0)


def face_lever(ink: CamInk, pivot: complex, foot: complex, contact: complex) -> Iterator[Ink]:
    """Yield a lever with its flat face, as long as its contacts want it, on its pivot."""
    assert ink.cam.contact is not None
    mu = ink.fixed_number(ink.cam.profile.mu)
    far = ink.fixed_number(ink.cam.contact.extremes[0].value) / mu
    way = (contact - foot) / abs(contact - foot)
    if finite(pivot, way, far):
        yield line("main", pivot, foot, foot + (far + FACE) * way)
        yield from fixed_pivot(pivot)


def rod(at: complex, radius: float, *, edge: bool = False, length: float = ROD) -> list[Ink]:
    """Return the rod of a follower over its roller or face, or with its knife edge, upright in its guide."""
    top, half = at + 1j * (length + radius), 0.5 * WIDTH
    foot = (at, at + WIDTH * 1j + half) if edge else (at - half, at + half)
    left = (at + WIDTH * 1j - half,) if edge else ()
    outline = line("body", *foot, top + half, top - half, *left, closed=True)
    return [outline, *channel(top - 0.5j * GUIDE - 4j, 90.0, GUIDE, width=WIDTH)]


def shaft(centre: Mark, reach: float, sense: int) -> Iterator[Ink]:
    """Yield centre lines that reach so far (mm), the cam's shaft, the arrow of its turning."""
    if not math.isfinite(reach):
        return
    yield from added([line("centre", -reach * way, reach * way) for way in (1 + 0j, 1j)], "axis")
    yield from body([circle("joint", 0j, 2.0)], "pivot", [centre])
    bow = round_arrow(0j, TURN, 90.0 - sense * 200.0, sense * 110.0)
    yield from body(bow, "sense", [centre])


BEYOND = 4.0
"""How far a guide goes on behind its roller, to the number of its position, mm."""
FACE = 8.0
"""How far a face goes on behind the point where it touches the cam, mm."""
ROOMY = 40.0
"""The least lower dwell, degrees, beside which letters find room."""


class ProfileNames(NamedTuple):
    """What is lettered: positions, the radii r0 and of the roller with their values, the two profiles.

    ``offset``: e with its value; of a drum ``length``: 2πR with its value, ``pressure``: α with the largest.
    """

    positions: Sequence[str]
    r0: str
    roller: str
    theoretical: str
    working: str
    omega: str = "ω"
    offset: str = "e"
    length: str = "2πR"
    pressure: str = "α"


def draw_profile_ink(on: Subject, cam: Cam, names: ProfileNames) -> Drawing:
    """Return the profiles of a cam with the rollers (or faces) whose envelope the working one is."""
    ink = CamInk(on, cam, VIEW)
    made = cam.profile
    points = ink.all((made.theoretical or made.working).points)
    traces = figure(ink, showing(_rules(ink, points)))
    strokes = [*traces.staying, *inverted(ink)]
    for contour in ink.figures("contour"):
        strokes += dwells(ink, contour)
    reach = ink.arc((made.outer or made.working).upper, 0)[1] + CROSS
    strokes += [*follower(ink, points), *shaft(made.centre, reach, cam.sense)]
    wanted = [*_letters(ink, names, points), *_dwell_letters(ink, names, points)]
    wanted += phase_letters(ink)
    strokes += [*_radii(ink, points), *draw_phases(ink)]
    return traces.drawing(on, strokes, wanted, (), enumerate(names.positions))


def _rules(ink: CamInk, points: Complexes) -> dict[Mark, Rule]:
    """What stays of the steps: profiles, the base circle, guides or levers or faces."""
    made = ink.cam.profile
    rules: dict[Mark, Rule] = {(made.theoretical or made.working).lower: whole}
    for contour in ink.figures("contour"):
        curves = [mark for mark in contour.marks if mark.kind is Curve]
        rules |= dict.fromkeys(curves, curve(PENS[contour.name]))
    feet = ink.all(made.feet) if made.feet is not None else np.zeros_like(points)
    if isinstance(ink.cam.path, Lever):
        rules[made.guides] = between(feet, points)
    elif isinstance(ink.cam.path, FaceLever):
        feet = ink.all(ink.figures("face lever")[0].marks[1])
        rules[made.guides] = between(feet, points + FACE * directions(points - feet))
    elif isinstance(ink.cam.path, Path):
        reach = BEYOND + (ink.fixed_number(made.roller) if made.roller is not None else 0.0)
        rules[made.guides] = between(feet, points + reach * directions(points - feet))
    else:
        assert made.feet is not None
        rules[ink.used(made.feet)] = between(np.zeros_like(feet), feet)
        along = ink.reading[made.guides].along[0]
        half = np.abs(points - feet) + FACE
        rules[made.guides] = between(feet - half * along, feet + half * along)
    return rules


def _ends(ink: CamInk, points: Complexes) -> tuple[Complexes, Complexes]:
    """Where the numbers of the positions stand, and in which direction from there."""
    made = ink.cam.profile
    feet = ink.all(made.feet) if made.feet is not None else 0j * points
    if isinstance(ink.cam.path, Lever) or made.theoretical is None:
        return feet, directions(feet)
    ways = directions(points - feet)
    radius = ink.fixed_number(made.roller) if made.roller is not None else 0.0
    return points + (radius + BEYOND) * ways, ways


def _letters(ink: CamInk, names: ProfileNames, points: Complexes) -> Iterator[Wanted]:
    """The numbers of the positions, the letters of the centre and of the roller's radius."""
    cam, made = ink.cam, ink.cam.profile
    spots, ways = _ends(ink, points)
    aside = np.array(ways)
    free = complex(-cam.sense)  # beside the follower no positions stand on this side
    lever = isinstance(cam.path, Lever | FaceLever)
    if not lever and np.isfinite(points[0]) and cam.diagrams.turn.angles[0] == 0.0:
        spots = np.array(spots)
        spots[0] += (0.5 * WIDTH + 1.5) * free - 3.0j
        aside[0] = free
    yield Wanted("O", 0j, ink.heights.point, 2.5, free - 1j, (made.centre.slot,))
    low = TURN * cmath.rect(1.0, math.radians(-90 + cam.sense * 15))
    yield Wanted(names.omega, low, ink.heights.number, 1.0, -1j, (made.centre.slot,))
    mark = (made.theoretical or made.working).points
    yield from numbered(ink, names.positions, mark, spots, aside, radius=1.6 if lever else 0.6)
    if made.roller is not None and np.isfinite(points[0]):
        edge = _edge(ink, points)[1]
        way = edge - _edge(ink, points)[0]
        of = (mark.slot, made.roller.slot)
        at = edge + 5.0 * way / abs(way)
        yield Wanted(names.roller, at, ink.heights.number, 0.5, free, of, 0)
    if _offset(ink) is not None:
        assert made.feet is not None
        tip = _tip_of_offset(ink)
        at = tip + 5.0 * tip / abs(tip)
        yield Wanted(names.offset, at, ink.heights.number, 0.5, free, (made.feet.slot,))


def _edge(ink: CamInk, points: Complexes) -> tuple[complex, complex]:
    """Where the arrow of the roller's radius begins and ends."""
    assert ink.cam.profile.roller is not None
    start = first_place(ink, complex(points[0]))
    radius = ink.fixed_number(ink.cam.profile.roller)
    return start, start + radius * cmath.rect(1.0, math.radians(90.0 + ink.cam.sense * 55.0))


def _offset(ink: CamInk) -> float | None:
    """The radius of the circle that the guides touch, if there is one."""
    made, path = ink.cam.profile, ink.cam.path
    if not isinstance(path, Path) or path.offset is None or made.feet is None:
        return None
    reach = abs(complex(ink.all(made.feet)[0]))
    return reach if math.isfinite(reach) else None


def _tip_of_offset(ink: CamInk) -> complex:
    """Where the arrow of the offset ends on its circle: on the side of the lower dwell, above."""
    free = complex(-ink.cam.sense)
    return (_offset(ink) or 0.0) * (0.6 * free + 0.8j)


def _last(ink: CamInk, points: Complexes) -> complex | None:
    """Where the lower dwell begins, if it leaves room for letters."""
    turn = ink.cam.diagrams.turn
    last = complex(points[turn.lowest.last])
    roomy = turn.rest(turn.lowest) >= ROOMY and np.isfinite(last) and last != 0
    return last if roomy else None


def _share(ink: CamInk, last: complex, *shares: float) -> complex:
    """Return the direction of the share of the dwell that keeps farthest from the centre lines."""
    turn, sense = ink.cam.diagrams.turn, ink.cam.profile.working.sense
    dwell = turn.rest(turn.lowest)
    turns = [sense * math.radians(share * dwell) for share in shares]
    ways = [last / abs(last) * cmath.exp(1j * turn) for turn in turns]
    return max(ways, key=lambda way: round(abs((way * way).imag), 6))


def _dwell_letters(ink: CamInk, names: ProfileNames, points: Complexes) -> Iterator[Wanted]:
    """The names of the profiles and the radius r0, where the lower dwell leaves room for them."""
    last, made, small = _last(ink, points), ink.cam.profile, ink.heights.number
    if last is None:
        return
    radius, way = ink.arc(made.working.lower, 0)[1], _share(ink, last, 0.5, 0.55, 0.6)
    yield Wanted(names.working, radius * way, small, 0.5, -way, (made.working.lower.slot,))
    if made.theoretical is not None and made.roller is not None:
        lower = made.theoretical.lower
        radius, way = ink.arc(lower, 0)[1], _share(ink, last, 0.7, 0.75)
        yield Wanted(names.theoretical, radius * way, small, 1.5, way, (lower.slot,))
    tip = _r0(ink, last)
    of = ((made.theoretical or made.working).lower.slot,)
    yield Wanted(names.r0, 0.45 * tip, small, 0.5, 1j * tip, of)


def _r0(ink: CamInk, last: complex) -> complex:
    """Where the arrow of r0 ends: on the base circle."""
    made = ink.cam.profile
    radius = ink.arc((made.theoretical or made.working).lower, 0)[1]
    return radius * _share(ink, last, 0.15, 0.25, 0.35)


def _radii(ink: CamInk, points: Complexes) -> Iterator[Ink]:
    """The arrows of the radii of the roller and of the base circle."""
    made = ink.cam.profile
    if made.roller is not None and made.theoretical is not None and np.isfinite(points[0]):
        start, edge = _edge(ink, points)
        way = (edge - start) / abs(edge - start)
        strokes = [line("thin", start, edge + 5.0 * way), *arrowhead(edge, way, pen="thin")]
        yield from body(strokes, "dimension", [made.theoretical.points, made.roller], 0)
    if _offset(ink) is not None:
        assert made.feet is not None
        tip = _tip_of_offset(ink)
        way = tip / abs(tip)
        strokes = [line("thin", 0j, tip + 5.0 * way), *arrowhead(tip, way, pen="thin")]
        yield from body(strokes, "dimension", [made.feet])
    last = _last(ink, points)
    if last is not None:
        tip = _r0(ink, last)
        strokes = [line("thin", 0j, tip), *arrowhead(tip, tip, pen="thin")]
        yield from body(strokes, "dimension", [(made.theoretical or made.working).lower])
