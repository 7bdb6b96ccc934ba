"""Three mechanisms of one group with closed positions at any number of digits, and frames to put them in.

The closed positions go to the oracle, which derives velocities and accelerations from them: near a change
point Newton's method could walk over to the other assembly.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from typing import Any, NamedTuple

import mpmath as mp  # type: ignore[import-untyped]

from graphic_tmm.chapters.kinematics.sides import side_values
from graphic_tmm.mechanism.records import Drive, Guide, Link, Mechanism, Side, Slide
from support import linkages, oracle
from support.loaded import Loaded

DRIVE = (2.0, 3.0)
four_bar = partial(linkages.four_bar, drive=DRIVE)
slider_crank = partial(linkages.slider_crank, drive=DRIVE)
coulisse = partial(linkages.coulisse, drive=DRIVE)


class Frame(NamedTuple):
    """Where a mechanism is put: ``scale`` times as large, mirrored about the x axis, turned, shifted."""

    scale: float = 1.0
    turn: float = 0.0
    mirrored: bool = False
    shift: complex = 0j

    def angle(self, degrees: float) -> float:
        """The crank's angle in this frame."""
        return (-degrees if self.mirrored else degrees) + self.turn


FRAMES = (
    Frame(),
    Frame(mirrored=True),
    Frame(turn=90.0, mirrored=True),
    Frame(1e-6, 37.0),
    Frame(1e6, 211.5, True),
    Frame(1e-3, -90.0, False, 3 + 2j),
    Frame(1.0, 123.456, True, -7 + 30j),
)


def put(mechanism: Mechanism, frame: Frame) -> Mechanism:
    """Return the mechanism in a frame; of its own axes only those that are mirrored change."""

    def own(z: complex) -> complex:
        return (z.conjugate() if frame.mirrored else z) * frame.scale

    sense = -1 if frame.mirrored else 1
    guides: dict[str, Guide] = {}

    def guide(of: Guide, fixed: bool) -> Guide:
        if of.name not in guides:
            place, turn = own(of.through), frame.turn if fixed else 0.0
            if fixed:
                place = _on_sheet(frame, place)
            guides[of.name] = Guide(of.name, place, sense * of.angle + turn)
        return guides[of.name]

    fixed = Link(
        mechanism.frame.number,
        {k: _on_sheet(frame, own(z)) for k, z in mechanism.frame.points.items()},
        tuple(guide(g, True) for g in mechanism.frame.guides),
    )
    links = []
    for link in mechanism.links:
        slides = tuple(
            replace(
                s,
                guide=guide(s.guide, s.on == fixed.number),
                offset=sense * s.offset * frame.scale,
                angle=sense * s.angle,
                side=_side(s.side, frame),
            )
            for s in link.slides
        )
        links.append(
            replace(
                link,
                points={k: own(z) for k, z in link.points.items()},
                guides=tuple(guide(g, False) for g in link.guides),
                slides=slides,
                side=_side(link.side, frame),
            )
        )
    drive = replace(
        mechanism.drive,
        speed=sense * mechanism.drive.speed,
        acceleration=sense * mechanism.drive.acceleration,
    )
    return Mechanism(fixed, tuple(links), drive)


def _on_sheet(frame: Frame, z: complex) -> complex:
    quarter, rest = divmod(frame.turn, 90.0)
    turned = z * 1j ** int(quarter % 4)
    return (turned * cmath.rect(1.0, math.radians(rest)) if rest else turned) + frame.shift


def _side(side: Side | None, frame: Frame) -> Side | None:
    """The sign just behind the angle 0° of the new frame, and where it flips there."""
    if side is None:
        return None
    flips, sign = side.flips_at, side.sign
    if flips:
        sense = -1 if frame.mirrored else 1
        flips = tuple(sorted(frame.angle(a) % 360.0 for a in flips))
        first = min(a for a in (*flips, 360.0) if a > 0)
        sign = int(float(side_values(side, sense * (first / 2 - frame.turn))))  # type: ignore[arg-type]
    left = -1 if frame.mirrored and side.left_of else 1
    return Side(sign * left, side.left_of, flips)


def closed(mechanism: Mechanism, phi: Any, side: int) -> dict[int, tuple[Any, Any]] | None:
    """Return origin and direction (complex) of every moving link, in the set precision; None if it locks."""
    links, frame = mechanism.by_number, mechanism.frame

    def digits(z: complex) -> Any:
        return mp.mpc(z.real, z.imag)

    o, r = digits(frame.points["O"]), mp.mpf(abs(links[1].points["A"]))
    along = mp.expj(phi)
    a = o + r * along
    found = {1: (o, along)}
    if "B" in links[2].points and "C" in frame.points:
        c, base = digits(frame.points["C"]), None
        p, q = mp.mpf(links[2].points["B"].real), mp.mpf(links[3].points["B"].real)
        base, d = c - a, abs(c - a)
        x = (d * d + p * p - q * q) / (2 * d) if d else mp.inf
        if abs(x) > p:
            return None
        b = a + mp.mpc(x, side * mp.sqrt((p - x) * (p + x))) * base / d
        return found | {2: (a, (b - a) / abs(b - a)), 3: (c, (b - c) / abs(b - c))}
    if "B" in links[2].points:
        (slide,) = links[3].slides
        u, g = mp.expj(mp.mpf(slide.guide.angle) * mp.pi / 180), digits(slide.guide.through)
        p, z = mp.mpf(links[2].points["B"].real), (a - g) * mp.conj(u)
        if abs(z.imag) > p:
            return None
        b = g + (z.real + side * mp.sqrt((p - z.imag) * (p + z.imag))) * u
        return found | {2: (a, (b - a) / abs(b - a)), 3: (b, u)}
    (slide,) = links[2].slides
    c, h = digits(frame.points["C"]), mp.mpf(slide.guide.through.imag)
    d = abs(a - c)
    if d < abs(h) or d == 0:
        return None
    u = (a - c) / mp.mpc(side * mp.sqrt((d - h) * (d + h)), h)
    return found | {2: (a, u / abs(u)), 3: (c, u / abs(u))}


def side_at(mechanism: Mechanism, degrees: float) -> int:
    """Return the side of the one group at a crank angle (degrees)."""
    sides: Mapping[int, Side | None] = {n: link.side for n, link in mechanism.by_number.items()}
    kept = [s for s in sides.values() if s] or [
        slide.side for link in mechanism.links for slide in link.slides if slide.side
    ]
    return int(float(side_values(kept[0], degrees)))  # type: ignore[arg-type]


def chain(groups: int) -> Mechanism:
    """A crank and rockers in a row, the last of eight groups a slider: each hangs on the one before."""
    pivots = {"O": 0j} | {f"C{k}": complex(3.0 * k, -0.1 * k) for k in range(1, groups)}
    guide = Guide("x", complex(0, 1.9), 0.0)
    links = [Link(1, {"O": 0j, "A": 1 + 0j})]
    before = "A"
    for k in range(1, groups):
        pin, first = f"B{k}", 2 * k
        coupler = 2.9 + 0.03 * k
        links += [
            Link(first, {before: 0j, pin: complex(coupler, 0)}, side=Side(1, (before, f"C{k}"))),
            Link(first + 1, {f"C{k}": 0j, pin: complex(2.0 + 0.05 * (k % 2), 0)}),
        ]
        before = pin
    last = 2 * groups
    links += [
        Link(last, {before: 0j, "D": 4 + 0j}),
        Link(last + 1, {"D": 0j}, slides=(Slide(0, guide, side=Side(1)),)),
    ]
    return Mechanism(Link(0, pivots, (guide,)), tuple(links), Drive(1, 2.0, 3.0))


def weighed(mechanism: Mechanism) -> Loaded:
    """Masses on every link, at a letter of its own; a force on the last one."""
    size = oracle.system_of(mechanism).size
    links = tuple(
        replace(link, mass=2.0 + k, inertia=0.01 * (k + 1) * size**2, centre=list(link.points)[-1])
        for k, link in enumerate(mechanism.links)
    )
    last = links[-1]
    letter = next(iter(last.points)) if last.slides else list(last.points)[-1]
    return Loaded(replace(mechanism, links=links), [(last.number, letter, 40.0 + 30.0j)], [])
