"""An independent judge of motion and forces, of any drives: the equations of all links at once.

It reads the tables of a scene and imports nothing of the package. Unknown are the places and angles of all
moving links; the equations: letters that links share coincide, a slider keeps its angle and its offset to the
guide, each drive's coordinate is the given: the angle of a crank (from its fixed letter to its pin), the way
of a slider along the frame's guide, the length of a rod from its cylinder's pin to its own along the guide.
Velocities and accelerations come from the Jacobian and the exact terms of second order, forces from Newton's
and Euler's equations of all links. Residuals have 18 digits (``numpy.longdouble``), so results have all of
float64. Inside, lengths are divided by the size; outside all is SI, angles in rad.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from support.scene_words import Words, si

PI = 4 * np.arctan(np.longdouble(1))
FULL = 2 * math.pi
Slopes = dict[int, tuple[Any, Any, Any]]
"""Of an equation: its derivatives by x, y, θ of the bodies by their place."""
Poses = Sequence[tuple[complex, float]]
"""Of the moving links in the scene's order: origin (m) and angle (rad)."""


class UnsolvedError(Exception):
    """The loops do not close, or are singular there."""


class Row(NamedTuple):
    """An equation: its value, its slopes, its second derivative where no link speeds up."""

    value: Any
    slopes: Slopes
    quick: Any


class Spot(NamedTuple):
    """A point of a body, in the body's own axes, sizes."""

    body: int
    own: Any


class Drive(NamedTuple):
    """A pair whose coordinate is given; its rate and second rate (SI, signed).

    ``kind``: "turn", "slide" or "rod". ``tip``: the crank's pin, the driven point; ``root``: the crank's pivot,
    the guide's point, the cylinder's pin. ``line``: the body and the direction of the guide (rad); ``sense``:
    +1 where the tip lies along it.
    """

    kind: str
    tip: Spot
    root: Spot
    line: Spot
    sense: int
    rate: float
    gain: float


class Slide(NamedTuple):
    """A sliding pair: slider, owner, the guide's point, direction and turn of the slider (rad), its offset.

    ``name``: the guide's; ``pin``: the slider's point that is joined to another body.
    """

    name: str
    pin: Spot
    slider: int
    on: int
    through: Any
    along: Any
    turn: Any
    offset: Any


@dataclass(frozen=True)
class State:
    """Bodies where they stand, the frame first: origins, angles, their two derivatives; sizes, rad, s."""

    judge: Judge
    z: Sequence[Any]
    t: Sequence[Any]
    dz: Sequence[Any]
    w: Sequence[Any]
    ddz: Sequence[Any]
    e: Sequence[Any]

    @cached_property
    def units(self) -> list[Any]:
        """The direction of each body's own x axis."""
        return [unit(t) for t in self.t]

    def arm(self, spot: Spot) -> Any:
        """From the body's origin."""
        return spot.own * self.units[spot.body]

    def place(self, spot: Spot) -> Any:
        return self.z[spot.body] + self.arm(spot)

    @cached_property
    def jacobian(self) -> Any:
        return _matrix(self.judge.rows(self, [0.0] * len(self.judge.drives)), len(self.z))

    @cached_property
    def condition(self) -> float:
        """Condition number of the equations: large near a dead place."""
        return float(np.linalg.cond(self.jacobian.astype(float)))

    @cached_property
    def hand(self) -> float:
        """The sign of the determinant: it keeps while no group passes a dead place."""
        return float(np.linalg.slogdet(self.jacobian.astype(float))[0])

    @property
    def poses(self) -> Poses:
        size = self.judge.size
        return [(complex(z) * size, float(t)) for z, t in zip(self.z[1:], self.t[1:], strict=True)]

    def point(self, letter: str, number: int) -> tuple[complex, complex, complex]:
        """r, v, a (m, s) of that point of a link which lies at a letter."""
        k = self.judge.index[number]
        arm = self.place(self.judge.spot(letter, number)) - self.z[k]
        parts = (
            self.z[k] + arm,
            self.dz[k] + 1j * self.w[k] * arm,
            self.ddz[k] + (1j * self.e[k] - self.w[k] ** 2) * arm,
        )
        r, v, a = (complex(part) * self.judge.size for part in parts)
        return r, v, a

    @property
    def omega(self) -> dict[int, float]:
        return {number: float(self.w[k]) for number, k in self.judge.index.items()}

    @property
    def epsilon(self) -> dict[int, float]:
        return {number: float(self.e[k]) for number, k in self.judge.index.items()}


def unit(angle: Any) -> Any:
    """e^{iθ} in the digits of θ."""
    if isinstance(angle, np.longdouble):
        return np.cos(angle) + 1j * np.sin(angle)
    return cmath.rect(1.0, angle)


def _dot(n: Any, d: Any) -> Any:
    return (n.conjugate() * d).real


def _cross(n: Any, d: Any) -> Any:
    return (n.conjugate() * d).imag


class Judge:
    """The equations of a scene's mechanism."""

    def __init__(self, scene: Mapping[str, Any]) -> None:
        words = Words(scene)
        self.words = words
        self.index = {body.number: k for k, body in enumerate(words.bodies)}
        own = [list(body.points.values()) for body in words.bodies]
        reach = max(abs(a - b) for points in own for a in points for b in points)
        self.size = math.ldexp(1.0, math.frexp(reach)[1])
        self.pins = [
            (letter, self._spot(first, letter), self._spot(other, letter))
            for letter, (first, *rest) in words.standing.items()
            for other in rest
        ]
        self.slides = [
            self._slide(k, told) for k, b in enumerate(words.bodies) for told in b.slides
        ]
        self.drives = [self._drive(told) for told in words.drives]
        unknown = 3 * (len(words.bodies) - 1)
        if 2 * (len(self.pins) + len(self.slides)) + len(self.drives) != unknown:
            raise UnsolvedError("there are not as many equations as unknowns")

    def _spot(self, body: int, letter: str) -> Spot:
        return self._at(body, self.words.bodies[body].points[letter])

    def _at(self, body: int, own: complex) -> Spot:
        return Spot(body, np.clongdouble(own) / self.size)

    def spot(self, letter: str, number: int) -> Spot:
        """A letter of a link; one of others, as any of these has it."""
        k = self.index[number]
        on = self.words.standing[letter]
        return self._spot(k if k in on else on[0], letter)

    def _slide(self, slider: int, told: Mapping[str, Any]) -> Slide:
        on = 0 if told["on"] == "frame" else self.index[told["on"]]
        through, degrees = self.words.guide(on, told["along"])
        along = np.longdouble(degrees) * PI / 180
        turn = along + np.longdouble(si(told.get("angle", 0.0))) * PI / 180
        offset = np.longdouble(si(told.get("offset", 0.0))) / self.size
        letters = [*self.words.bodies[slider].points]
        pin = next((x for x in letters if self.words.standing[x] != [slider]), None)
        held = self._at(slider, 0j) if pin is None else self._spot(slider, pin)
        return Slide(
            told["along"],
            held,
            slider,
            on,
            np.clongdouble(through) / self.size,
            along,
            turn,
            offset,
        )

    def _drive(self, told: Mapping[str, Any]) -> Drive:
        words, k = self.words, self.index[told["link"]]
        back = "from" in told and si(told["to"]) < si(told["from"])
        sense = -1 if back or told.get("turns") == "clockwise" else 1
        rate = sense * si(told["speed"])
        gain = sense * si(told.get("acceleration", 0.0))
        if not words.bodies[k].slides:
            pivot = next(x for x in words.bodies[k].points if 0 in words.standing[x])
            others = [x for x in words.bodies[k].points if x != pivot]
            pin = next((x for x in others if len(words.standing[x]) > 1), others[0])
            return Drive(
                "turn", self._spot(k, pin), self._spot(k, pivot), Spot(k, PI * 0), 1, rate, gain
            )
        slide = next(s for s in self.slides if s.slider == k)
        line = Spot(slide.on, slide.along)
        letters = [*words.bodies[k].points]
        tip = next((x for x in letters if words.standing[x] != [k]), letters[0])
        if slide.on == 0:
            return Drive("slide", self._spot(k, tip), Spot(0, slide.through), line, 1, rate, gain)
        root = next(
            x for x in words.bodies[slide.on].points if set(words.standing[x]) - {slide.on, k}
        )
        side = -1 if words.bodies[k].slides[0].get("side") == "-" else 1
        return Drive("rod", self._spot(k, tip), self._spot(slide.on, root), line, side, rate, gain)

    def rows(self, state: State, at: Sequence[Any]) -> list[Row]:
        """All equations where the bodies stand, of the coordinates of the drives (m, rad)."""
        found = []
        for _, first, other in self.pins:
            found += [_projected(state, first, other, Spot(0, a)) for a in (PI * 0, PI / 2)]
        for slide in self.slides:
            turn = state.t[slide.slider] - state.t[slide.on] - slide.turn
            found.append(Row(_part(turn), {slide.slider: (0, 0, 1), slide.on: (0, 0, -1)}, 0))
            across = Spot(slide.on, slide.along + PI / 2)
            origin, through = Spot(slide.slider, 0 * slide.through), Spot(slide.on, slide.through)
            row = _projected(state, origin, through, across)
            found.append(row._replace(value=row.value - slide.offset))
        for drive, coordinate in zip(self.drives, at, strict=True):
            if drive.kind == "turn":
                own = drive.tip.own - drive.root.own
                turn = state.t[drive.tip.body] + np.arctan2(own.imag, own.real) - coordinate
                found.append(Row(_part(turn), {drive.tip.body: (0, 0, 1)}, 0))
            else:
                row = _projected(state, drive.tip, drive.root, drive.line)
                way = drive.sense * coordinate / self.size
                found.append(row._replace(value=row.value - way))
        return found

    def solve(self, at: Sequence[float], near: Poses, *, exact: bool = True) -> State:
        """The state at coordinates of the drives (m, rad), in the assembly that is nearest to poses."""
        real, plain = (np.longdouble, np.clongdouble) if exact else (float, complex)
        still = [plain(0)] * (len(near) + 1), [real(0)] * (len(near) + 1)
        z = [plain(0), *(plain(place / self.size) for place, _ in near)]
        t = [real(0), *(real(angle) for _, angle in near)]
        longest, more = math.inf, 3 if exact else 0
        for _ in range(40):
            state = State(self, z, t, *still, *still)
            rows = self.rows(state, at)
            step = solved(_matrix(rows, len(z)), -np.array([row.value for row in rows])[:, None])
            longest = float(np.abs(step).max())
            if not longest < 10.0:
                break
            x, y, turn = step.reshape(-1, 3).T
            z = [z[0], *(a + plain(b) + 1j * plain(c) for a, b, c in zip(z[1:], x, y, strict=True))]
            t = [t[0], *(a + real(b) for a, b in zip(t[1:], turn, strict=True))]
            if longest < 1e-9:
                more -= 1
            if more < 0:
                return self._moving(State(self, z, t, *still, *still))
        raise UnsolvedError(f"the loops do not close at {at}")

    def _moving(self, state: State) -> State:
        """The same with velocities and accelerations."""
        right = np.zeros((len(state.jacobian), 1), np.longdouble)
        scaled = [
            np.array([1.0 if d.kind == "turn" else d.sense / self.size for d in self.drives]) * rate
            for rate in ([d.rate for d in self.drives], [d.gain for d in self.drives])
        ]
        right[-len(self.drives) :, 0] = scaled[0]
        dz, w = _parts(solved(state.jacobian, right))
        fast = State(self, state.z, state.t, dz, w, *(state.dz, state.w))
        rows = self.rows(fast, [0.0] * len(self.drives))
        right = -np.array([row.quick for row in rows], np.longdouble)[:, None]
        right[-len(self.drives) :, 0] += scaled[1]
        return State(self, state.z, state.t, dz, w, *_parts(solved(state.jacobian, right)))


def _part(turn: Any) -> Any:
    """An angle without whole turns."""
    return turn - 2 * PI * round(float(turn) / FULL)


def _projected(state: State, tip: Spot, root: Spot, line: Spot) -> Row:
    """How far a point lies from another along a direction of a body."""
    n = state.units[line.body] * unit(line.own)
    d = state.place(tip) - state.place(root)
    first, other, w = state.arm(tip), state.arm(root), state.w[line.body]
    slopes: Slopes = {}
    for body, turn, x, y in (
        (tip.body, _dot(n, 1j * first), n.real, n.imag),
        (root.body, -_dot(n, 1j * other), -n.real, -n.imag),
        (line.body, _cross(n, d), 0, 0),
    ):
        there = slopes.get(body, (0, 0, 0))
        slopes[body] = (there[0] + x, there[1] + y, there[2] + turn)
    wi, wk = state.w[tip.body], state.w[root.body]
    rate = state.dz[tip.body] + 1j * wi * first - state.dz[root.body] - 1j * wk * other
    quick = _dot(n, wk**2 * other - wi**2 * first) + 2 * w * _cross(n, rate) - w**2 * _dot(n, d)
    return Row(_dot(n, d), slopes, quick)


def _matrix(rows: Sequence[Row], bodies: int) -> Any:
    found = np.zeros((len(rows), bodies, 3), np.longdouble)
    for row, there in zip(rows, found, strict=True):
        for body, slope in row.slopes.items():
            there[body] += slope
    return found[:, 1:].reshape(len(rows), -1)


def solved(matrix: Any, right: Any) -> Any:
    """The solution of linear equations, refined by residuals of 18 digits."""
    rough = matrix.astype(float)
    found = np.zeros(right.shape, np.longdouble)
    try:
        for _ in range(3):
            found = found + np.linalg.solve(rough, (right - matrix @ found).astype(float))
    except np.linalg.LinAlgError as error:
        raise UnsolvedError("the place is singular") from error
    return found


def _parts(found: Any) -> tuple[list[Any], list[Any]]:
    x, y, turn = found.reshape(-1, 3).T
    return [np.clongdouble(0), *(x + 1j * y)], [np.longdouble(0), *turn]
