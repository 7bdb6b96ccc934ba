"""The kinematic scheme of a planetary train along its axis (ГОСТ 2.770): wheels to scale."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.record import Figure, Mark
from graphic_tmm.chapters.trains.ink_pairs import (
    BEARING,
    GAP,
    HOLLOW,
    RACK,
    STUB,
    WIDTH,
    Side,
    SideRows,
    bearing,
    draw_outside,
    racks_of,
    wheels_of,
)
from graphic_tmm.chapters.trains.motion import Motion
from graphic_tmm.chapters.trains.pictures import VIEW, Disc
from graphic_tmm.chapters.trains.plan import Planetary, reach_of
from graphic_tmm.chapters.trains.task import Mesh, Scheme
from graphic_tmm.paper.drawing import Stroke, line
from graphic_tmm.paper.formats import Heights
from graphic_tmm.paper.seen import Seen
from graphic_tmm.paper.symbols.kinematic import (
    CENTRE_BEYOND,
    RIM,
    Strokes,
    gear_side,
    guide,
    hatching,
)

SHAFT = 26.0
"""How far a shaft reaches from its wheel, or from the arm of the carrier, mm."""
DISC = 7.0
"""From a turning ring to the disc that carries it, mm."""
GROUND = 4.0
"""How far the ground of a fixed ring goes on at its sides, mm."""
SHORT = 9.0
"""Length of the hollow hub of a wheel with external teeth, mm."""
HUB = 14.0
"""Length of the hollow shaft of a wheel, mm."""


class Scheme2KH(NamedTuple):
    """What is drawn: the scheme, its wheels, the satellite's axis and the main axis at the arm.

    ``outside``: the wheels before and behind the train; ``motion``: which members move.
    """

    scheme: Scheme
    wheels: dict[str, Side]
    arm: tuple[complex, complex]
    outside: tuple[SideRows, ...]
    motion: Motion

    @property
    def last(self) -> Side | None:
        """The second central wheel; None of two wheels on an arm."""
        others = self.scheme.meshes[1:]
        return self.wheels[others[-1].wheel] if others else None

    @property
    def idle(self) -> bool:
        """Whether the carrier runs idle on the shaft of wheel 1: all three central wheels have shafts."""
        return "H" not in self.scheme.members

    @property
    def right(self) -> float:
        """Where the shaft of the carrier ends, or that of the last wheel where the carrier runs idle."""
        for view in self.outside:
            if view.member == "H" or (self.idle and view.member != "1"):
                return view.first.centre.real + WIDTH / 2 + STUB
        if self.last is None:
            return self.arm[1].real + WIDTH / 2 + SHAFT
        long = self.turns_outside or self.carried
        beyond = self.hub[1] if long else self.last.centre.real + WIDTH / 2
        if self.idle and self.motion.fixed != self.motion.last:
            beyond += DISC
        return max(beyond, self.arm[1].real + WIDTH / 2) + SHAFT

    @property
    def turns_outside(self) -> bool:
        """Whether the last wheel is a ring that turns, on a hollow shaft around that of the carrier."""
        ring = self.last is not None and self.scheme.second < 0
        return ring and not self.idle and self.motion.fixed != self.motion.last

    @property
    def carried(self) -> list[Side]:
        """The wheel outside the train that the hollow shaft of the last wheel carries, if there is one."""
        last = "" if self.idle else self.motion.last
        return [view.first for view in self.outside if view.member == last]

    @property
    def hub(self) -> tuple[float, float]:
        """From where to where the hollow shaft of a last wheel that turns reaches."""
        assert self.last is not None
        start = max(self.last.centre.real + WIDTH / 2, self.arm[1].real + STUB) + DISC
        return start, max([start, *(wheel.centre.real + WIDTH / 2 for wheel in self.carried)]) + HUB

    @property
    def before(self) -> float:
        """How far left of wheel 1 its shaft begins: behind its disc, if it is a ring, or what is on it."""
        if self.idle:
            return self.wheels["1"].centre.real - self.arm[1].real + BEARING / 2 + self.hub_before
        return DISC if self.scheme.first < 0 else 0.0

    @property
    def hub_before(self) -> float:
        """How far left of the arm of an idle carrier the hollow shaft of a ring 3 that turns reaches."""
        return 0.0 if self.motion.fixed == "3" else DISC + HUB

    @property
    def left(self) -> float:
        """Where the shaft of wheel 1 begins."""
        for view in self.outside:
            if view.member == "1":
                return view.first.centre.real - WIDTH / 2 - STUB
        return self.wheels["1"].centre.real - WIDTH / 2 - self.before - SHAFT

    @property
    def bearing_middle(self) -> float:
        """The middle of the bearing of wheel 1."""
        beside = any(view.member == "1" for view in self.outside)
        return self.left + SHAFT / 2 + (WIDTH / 2 if beside else 0.0)


def draw_scheme(made: Scheme2KH) -> Iterator[tuple[str, Strokes]]:
    """Yield the bodies of the scheme: the name of a wheel or of the carrier, and its strokes."""
    yield "1", _first(made, made.wheels["1"])
    rims = {name: made.wheels[name] for name in made.scheme.rims}
    for name, rim in rims.items():
        yield name, gear_side(rim.centre, rim.radius, WIDTH)
    for mesh in made.scheme.meshes[1:]:
        yield mesh.wheel, tuple(_other(made, mesh))
    yield "H", tuple(_carrier(made, list(rims.values())))
    joined = made.motion.closing is not None
    yield from draw_outside(made.outside, joined=joined, hollow=made.carried)


def spots(made: Scheme2KH) -> dict[str, tuple[complex, complex]]:
    """Return where the numbers of the wheels and the letter of the carrier stand: a point, a direction."""
    first, half = made.wheels["1"], WIDTH / 2
    beside = half + (DISC if made.scheme.first < 0 else 0.0)
    found = {"1": (first.centre - beside - 0.55j * first.radius, -1 + 0j)}
    for rim, way in zip(made.scheme.rims, (-1, 1), strict=False):
        wheel, outward = made.wheels[rim], made.scheme.mesh(rim).sense
        found[rim] = (wheel.centre + way * half + 0.5j * outward * wheel.radius, way + 0j)
    for name, _, sense, _ in made.scheme.meshes[1:]:
        wheel = made.wheels[name]
        depth = 0.5 * RIM if sense < 0 else -0.3 * wheel.radius
        found[name] = (wheel.centre + half - 1j * (wheel.radius + depth), 1 + 0j)
    for name, wheel in wheels_of(made.outside).items():
        found[name] = (wheel.centre + half + 0.5j * (wheel.far - wheel.centre).imag, 1 + 0j)
    for name, (_, at) in racks_of(made.outside).items():
        found[name] = (at + half - 0.5j * RACK, 1 + 0j)
    axis, foot = made.arm
    found["H"] = (foot + 0.4 * (axis - foot), 1 + 0j)
    return found


def _first(made: Scheme2KH, wheel: Side) -> Strokes:
    """Wheel 1 on its shaft; a ring by the disc beside it."""
    end = complex(made.left, 0.0)
    stand = bearing(complex(made.bearing_middle, 0.0))
    if made.motion.fixed == "1":
        stand = built_in(end, -1)
    if made.scheme.first > 0:
        own = gear_side(wheel.centre, wheel.radius, WIDTH)
        return (*own, line("main", end, wheel.centre + WIDTH / 2 + STUB), *stand)
    return (*_ring_on_shaft(wheel, made.left, -1), *stand)


def _other(made: Scheme2KH, mesh: Mesh) -> Iterator[Stroke]:
    """Another central wheel: on the ground, in its bearings or on its shaft."""
    wheel, stands = made.wheels[mesh.wheel], made.motion.fixed == mesh.wheel
    if made.turns_outside:
        yield from _ring_on_hub(wheel, *made.hub)
    elif stands or not made.idle:
        end = made.hub[1] if made.carried else wheel.centre.real + WIDTH / 2 + SHORT
        yield from _last(wheel, mesh.sense, end, stands=stands)
    elif wheel == made.last:
        yield from _ring_on_shaft(wheel, made.right, 1)
        middle = wheel.centre.real + WIDTH / 2 + DISC + SHAFT / 2
        yield from bearing(complex(middle, 0.0))
    else:
        start = made.arm[1].real - BEARING / 2 - DISC
        yield from _ring_on_hub(wheel, start, start - HUB)


def _ring_on_shaft(wheel: Side, end: float, way: int) -> Iterator[Stroke]:
    """A ring with its disc beside it, to the right (1) or to the left (−1), and its shaft."""
    side = wheel.centre.real + way * WIDTH / 2
    disc, top = side + way * DISC, wheel.radius + RIM / 2
    yield from (*_rim(wheel, 1), *_rim(wheel, -1))
    yield line("main", complex(end), complex(disc))
    corners = ((side, top), (disc, top), (disc, -top), (side, -top))
    yield line("main", *(complex(*corner) for corner in corners))


def _rim(wheel: Side, sense: int) -> Strokes:
    """The rim of a ring above (1) or below (−1) the axis."""
    x, half = wheel.centre.real, WIDTH / 2
    low, high = sense * wheel.radius, sense * (wheel.radius + RIM)
    corners = ((x - half, low), (x + half, low), (x + half, high), (x - half, high))
    return (line("main", *(complex(*corner) for corner in corners), closed=True),)


def _ring_on_hub(wheel: Side, start: float, end: float) -> Iterator[Stroke]:
    """A ring that turns, its disc behind the arm, its hollow shaft around another, from start to end."""
    way = 1 if end > start else -1
    for sense in (1, -1):
        yield from _rim(wheel, sense)
        rim = complex(wheel.centre.real + way * WIDTH / 2, sense * (wheel.radius + RIM / 2))
        low = 1j * sense * HOLLOW
        yield line("main", rim, complex(start, rim.imag), start + low, end + low)
        beside = end - way * HUB / 4 + low + 1j * sense * GAP
        ends = sorted((beside - way * BEARING, beside), key=lambda z: z.real)
        yield from guide(*ends, sides=(sense,))


def built_in(at: complex, way: int) -> Strokes:
    """The end of a shaft that is built into the frame, the hatching to the right (1) or to the left (−1)."""
    ends = at + 1j * way * GROUND, at - 1j * way * GROUND
    return (line("main", *ends), *hatching(*ends, 1))


def _last(wheel: Side, sense_of_mesh: int, end: float, *, stands: bool) -> list[Stroke]:
    """A ring with its ground, or a wheel on its hollow hub, on the ground or in a bearing."""
    half, x, strokes = WIDTH / 2, wheel.centre.real, list[Stroke]()
    for sense in (1, -1):
        if sense_of_mesh < 0:
            strokes += _rim(wheel, sense)
            y = sense * (wheel.radius + RIM)
            ends = complex(x - half - GROUND, y), complex(x + half + GROUND, y)
            strokes += guide(*ends, sides=(sense,))
            continue
        bore = min(HOLLOW, wheel.radius / 2)
        low, high = sense * bore, sense * wheel.radius
        strokes.append(
            line(
                "main",
                complex(end, low), complex(x - half, low), complex(x - half, high), complex(x + half, high),
                complex(x + half, low),
            )
        )  # fmt: skip
        if stands:
            strokes += guide(complex(end, low), complex(end, low + sense * 10.0), sides=(-sense,))
            continue
        foot, top = (complex(end - x, low + sense * GAP) for x in (BEARING + 1.0, 1.0))
        strokes += guide(foot, top, sides=(sense,))
    return strokes


def _carrier(made: Scheme2KH, rims: list[Side]) -> list[Stroke]:
    """The satellite's axle in the bearing of the arm, the arm, the shaft of the carrier."""
    axis, foot = made.arm
    begin = min(axis.real - BEARING / 2, *(rim.centre.real - WIDTH / 2 for rim in rims)) - STUB
    end = max(axis.real + BEARING / 2, *(rim.centre.real + WIDTH / 2 for rim in rims)) + STUB
    strokes = [line("main", complex(begin, axis.imag), complex(end, axis.imag))]
    for gap in (GAP, -GAP):
        middle = axis + 1j * gap
        strokes.append(line("main", middle - BEARING / 2, middle + BEARING / 2))
    if made.idle:
        sleeve = (
            line("main", *(foot + 1j * gap + x for x in (-BEARING / 2, BEARING / 2)))
            for gap in (GAP, -GAP)
        )
        return [*strokes, line("main", foot + 1j * GAP, axis - 1j * GAP), *sleeve]
    right = complex(made.right, 0)
    strokes += [line("main", foot, axis - 1j * GAP), line("main", foot, right)]
    if made.motion.fixed == "H":
        return [*strokes, *built_in(right, 1)]
    behind = foot.real if made.last is None else made.last.centre.real
    beside = max(behind, foot.real) + WIDTH / 2 + 2 * SHAFT / 3
    if made.turns_outside or made.carried:
        beside = made.hub[1] + SHAFT / 2
    return [*strokes, *bearing(complex(beside, 0.0))]


OVER = 6.0
"""How far a line goes on behind its last point, mm."""
LEAST = 0.5
"""Shorter vectors are points, mm."""
ASIDE = 2.2
"""From a heavy line to the box of a letter left of it, which leans over, mm."""


class TrainInk:
    """The places of a train's marks, mm.

    ``points``: A, B, C of the circles; ``zeros``: O, A, B, C beside them; ``tips``: ends of
    velocities; ``trial``: those of a trial; all by their letters.
    """

    def __init__(self, seen: Seen, made: Planetary, heights: Heights) -> None:
        self.seen, self.made, self.heights = seen, made, heights
        self.fixed, self.rims = made.motion.fixed, made.train.scheme.rims
        self.central = tuple(mesh.wheel for mesh in made.train.scheme.meshes)
        axis, foot = (self.fixed_place(mark) for mark in made.axial.arm)
        self.scheme = Scheme2KH(
            made.train.scheme,
            self.sides(made.axial.discs),
            (axis, foot),
            tuple(
                SideRows(view.member, tuple(map(self.sides, view.discs)))
                for view in made.pairs.outside
            ),
            made.motion,
        )
        self.centre = self.fixed_place(made.end.origin)
        self.points = {at: self.fixed_place(mark) for at, mark in made.end.points.items()}
        self.zeros = {at: self.fixed_place(mark) for at, mark in made.picture.zeros.items()}
        self.tips = {at: self.fixed_place(mark) for at, mark in made.picture.ends.items()}
        trial = made.picture.trial
        ends = trial.ends if trial is not None else {}
        self.trial = {at: self.fixed_place(mark) for at, mark in ends.items()}
        self.pole, self.foot = self.fixed_place(made.rates.pole), self.fixed_place(made.rates.foot)
        self.ends = {body: self.fixed_place(mark) for body, mark in made.rates.ends.items()}
        self.axes = [seen.point(made.end.satellites, k) for k in seen.positions]
        self.reach = self._reach()

    def fixed_place(self, mark: Mark) -> complex:
        """The place of a point that does not vary."""
        return self.seen.point(mark, 0)

    def sides(self, discs: Mapping[str, Disc]) -> dict[str, Side]:
        """The wheels from their sides."""
        return {
            name: Side(*(self.fixed_place(mark) for mark in disc)) for name, disc in discs.items()
        }

    def figures(self, kind: str) -> list[Figure]:
        """The bodies of a kind, as the plan tells them."""
        told = self.seen.construction.figures
        return [figure for figure in told if figure.view == VIEW and figure.kind == kind]

    def radius(self, wheel: str) -> float:
        """The pitch radius of a wheel; of the axes of the satellites for "H"."""
        return float(np.ravel(self.seen.reading[self.made.end.lengths[wheel]])[0])

    def ring(self, wheel: str) -> bool:
        """Whether a wheel is a ring."""
        return any(figure.name == wheel for figure in self.figures("ring"))

    def _reach(self) -> float:
        """The radius that the view along the axis takes."""
        rings = [self.radius(w) + RIM for w in self.central if self.ring(w)]
        radii = {name: self.radius(name) for name in self.made.end.lengths}
        return max(reach_of(self.made.train.scheme, radii), *rings, 0.0)

    @property
    def beyond(self) -> float:
        """How far the centre lines of the circles go."""
        return self.reach + CENTRE_BEYOND
