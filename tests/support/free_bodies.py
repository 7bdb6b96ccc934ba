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

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from support.scene_words import Words, si

PI = 4 * np.arctan(np.longdouble(1))
FULL = 2 * math.pi
Poses = Sequence[tuple[complex, float]]
"""Of the moving links in the scene's order: origin (m) and angle (rad)."""


class UnsolvedError(Exception):
    """The loops do not close, or are singular there."""


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
    z: Any
    t: Any
    dz: Any
    w: Any
    ddz: Any
    e: Any

    @cached_property
    def units(self) -> Any:
        """The direction of each body's own x axis."""
        return unit(self.t)

    def arm(self, spot: Spot) -> Any:
        """From the body's origin."""
        return spot.own * self.units[spot.body]

    def place(self, spot: Spot) -> Any:
        return self.z[spot.body] + self.arm(spot)

    @cached_property
    def jacobian(self) -> Any:
        return self.judge.rows.slopes(self)

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
    return np.cos(angle) + 1j * np.sin(angle)


def _dot(n: Any, d: Any) -> Any:
    return (n.conjugate() * d).real


def _cross(n: Any, d: Any) -> Any:
    return (n.conjugate() * d).imag


class Rows:
    """All equations, those of one kind at once: how far points lie from others along a direction, turns.

    ``far``: tips, roots, lines (a body and a direction, rad), and what is due. ``turns``: bodies, those from
    which they turn, and what is due. Each knows its number.
    """

    def __init__(
        self,
        far: Mapping[int, tuple[Spot, Spot, Spot, Any]],
        turns: Mapping[int, tuple[int, int | None, Any]],
        bodies: int,
    ) -> None:
        self.count, self.bodies = len(far) + len(turns), bodies
        self.far, self.turns = np.array([*far]), np.array([*turns])
        tips, roots, lines, due = zip(*far.values(), strict=True)
        self.tip, self.root, self.line = (
            np.array([spot.body for spot in some]) for some in (tips, roots, lines)
        )
        self.first, self.other = (np.array([s.own for s in some]) for some in (tips, roots))
        self.along = unit(np.array([spot.own for spot in lines], np.longdouble))
        self.due = np.zeros(self.count, np.longdouble)
        self.due[self.far] = due
        body, on, self.due[self.turns] = zip(*turns.values(), strict=True) if turns else ((),) * 3
        self.body = np.array(body, int)
        self.on = np.array([0 if k is None else k for k in on], int)
        self.held = np.array([k is not None for k in on], np.longdouble)

    def _lie(self, state: State) -> tuple[Any, Any, Any, Any]:
        """The directions, how far tips lie from roots, both from the origins of their bodies."""
        first, other = self.first * state.units[self.tip], self.other * state.units[self.root]
        n = state.units[self.line] * self.along
        return n, state.z[self.tip] + first - state.z[self.root] - other, first, other

    def values(self, state: State) -> Any:
        """By how much each is off where the bodies stand, coordinates of drives at 0."""
        found = -self.due
        n, d, _, _ = self._lie(state)
        found[self.far] += _dot(n, d)
        found[self.turns] += state.t[self.body] - self.held * state.t[self.on]
        return found

    def slopes(self, state: State) -> Any:
        """Their derivatives by x, y, θ of the moving bodies."""
        n, d, first, other = self._lie(state)
        found = np.zeros((self.count, self.bodies, 3), np.longdouble)
        for body, sign, turn in (
            (self.tip, 1, _dot(n, 1j * first)),
            (self.root, -1, -_dot(n, 1j * other)),
        ):
            found[self.far, body] += np.stack([sign * n.real, sign * n.imag, turn], axis=1)
        found[self.far, self.line, 2] += _cross(n, d)
        found[self.turns, self.body, 2] += 1
        found[self.turns, self.on, 2] -= self.held
        return found[:, 1:].reshape(self.count, -1)

    def quick(self, state: State) -> Any:
        """Their second derivatives where no link speeds up."""
        n, d, first, other = self._lie(state)
        wi, wk, w = (state.w[body] for body in (self.tip, self.root, self.line))
        rate = state.dz[self.tip] + 1j * wi * first - state.dz[self.root] - 1j * wk * other
        found = np.zeros(self.count, np.longdouble)
        found[self.far] = (
            _dot(n, wk**2 * other - wi**2 * first) + 2 * w * _cross(n, rate) - w**2 * _dot(n, d)
        )
        return found


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
        self.rows = self._rows()

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

    def _rows(self) -> Rows:
        """All equations, those of the drives last."""
        far: dict[int, tuple[Spot, Spot, Spot, Any]] = {}
        turns: dict[int, tuple[int, int | None, Any]] = {}
        for _, first, other in self.pins:
            for angle in (PI * 0, PI / 2):
                far[len(far)] = first, other, Spot(0, angle), 0
        for slide in self.slides:
            turns[len(far) + len(turns)] = slide.slider, slide.on, slide.turn
            across = Spot(slide.on, slide.along + PI / 2)
            origin, through = Spot(slide.slider, 0 * slide.through), Spot(slide.on, slide.through)
            far[len(far) + len(turns)] = origin, through, across, slide.offset
        for drive in self.drives:
            if drive.kind == "turn":
                own = drive.tip.own - drive.root.own
                due = -np.arctan2(own.imag, own.real)
                turns[len(far) + len(turns)] = drive.tip.body, None, due
            else:
                far[len(far) + len(turns)] = drive.tip, drive.root, drive.line, 0
        return Rows(far, turns, len(self.words.bodies))

    @cached_property
    def scaled(self) -> Any:
        """By how much coordinates of drives (m, rad) count in their equations."""
        return np.array([1.0 if d.kind == "turn" else d.sense / self.size for d in self.drives])

    def solve(self, at: Sequence[float], near: Poses, *, exact: bool = True) -> State:
        """The state at coordinates of the drives (m, rad), in the assembly that is nearest to poses."""
        real, plain = (np.longdouble, np.clongdouble) if exact else (float, complex)
        still = np.zeros(len(near) + 1, plain), np.zeros(len(near) + 1, real)
        z = np.array([0, *(plain(place / self.size) for place, _ in near)], plain)
        t = np.array([0, *(angle for _, angle in near)], real)
        longest, more = math.inf, 3 if exact else 0
        for _ in range(40):
            state = State(self, z, t, *still, *still)
            off = self.rows.values(state)
            off[-len(self.drives) :] -= self.scaled * np.array(at, np.longdouble)
            off[self.rows.turns] = _part(off[self.rows.turns])
            step = solved(state.jacobian, -off[:, None])
            longest = float(np.abs(step).max())
            if not longest < 10.0:
                break
            x, y, turn = step.reshape(-1, 3).T
            z, t = z.copy(), t.copy()
            z[1:] += x + 1j * y
            t[1:] += turn.astype(real)
            if longest < 1e-9:
                more -= 1
            if more < 0:
                return self._moving(State(self, z, t, *still, *still))
        raise UnsolvedError(f"the loops do not close at {at}")

    def _moving(self, state: State) -> State:
        """The same with velocities and accelerations."""
        right = np.zeros((len(state.jacobian), 1), np.longdouble)
        rates, gains = (
            self.scaled * rate
            for rate in ([d.rate for d in self.drives], [d.gain for d in self.drives])
        )
        right[-len(self.drives) :, 0] = rates
        dz, w = _parts(solved(state.jacobian, right))
        fast = State(self, state.z, state.t, dz, w, *(state.dz, state.w))
        right = -self.rows.quick(fast)[:, None]
        right[-len(self.drives) :, 0] += gains
        return State(self, state.z, state.t, dz, w, *_parts(solved(state.jacobian, right)))


def _part(turns: Any) -> Any:
    """Angles without whole turns."""
    return turns - 2 * PI * np.round(turns.astype(float) / FULL)


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


def _parts(found: Any) -> tuple[Any, Any]:
    x, y, turn = found.reshape(-1, 3).T
    return np.concatenate([[0], x + 1j * y]), np.concatenate([[0], turn])
