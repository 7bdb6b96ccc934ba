"""Newton's and Euler's equations of all links at once, where `free_bodies` has found that they stand.

Unknown are two components of the force in every turning pair, normal force and couple in every sliding pair,
and what each drive needs: a moment or a force at the crank's pin (+90° from its arm), a force on the slider
along its guide, a force of the rod from its cylinder (outwards along the guide's sense). N, N·m; inside,
lengths in sizes.
"""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from support.free_bodies import PI, Drive, Judge, Spot, State, solved, unit
from support.scene_words import si

G = 9.81
Both = tuple[int, int]


class Wrench(NamedTuple):
    """A force at a place, and a couple, on a body by its place."""

    body: int
    force: Any
    place: Any
    couple: Any = 0.0


class Statics(NamedTuple):
    """What holds all links in equilibrium, SI.

    ``reactions``: of link i on link j by (i, j), N. ``drives``: what each drive needs, N or N·m. ``largest``:
    the largest force there is (moments divided by the size). ``power``: of all that acts, as a share of the
    powers that it is the sum of.
    """

    reactions: Mapping[Both, complex]
    drives: Sequence[float]
    largest: float
    power: float


class UnsettledError(ArithmeticError):
    """Friction and reactions that do not come to rest: the links lock, or come near to it."""


class Rough(NamedTuple):
    """How rough a pair is: its coefficient of friction, the radius of its pin (m)."""

    f: float
    radius: float = 0.0


def statics(
    judge: Judge, state: State, turned: float = 0.0, rough: Mapping[str, Rough] | None = None
) -> Statics:
    """The equilibrium of all links.

    ``turned``: how far the crank has, degrees, from the zero position; ``rough``: pairs with friction, by
    letter or guide: in a pin the couple f·r·|R|, on a slider's pin the force f·|N|, both against the motion.
    """
    numbers = [body.number for body in judge.words.bodies]
    pairs: list[tuple[Both, list[Wrench]]] = []
    for _, first, other in judge.pins:
        at = state.place(first)
        pairs += [
            ((first.body, other.body), _both(first.body, other.body, n, at)) for n in (1.0, 1j)
        ]
    for slide in judge.slides:
        across = 1j * state.units[slide.on] * unit(slide.along)
        at = state.place(Spot(slide.on, slide.through))
        pairs.append(((slide.on, slide.slider), _both(slide.on, slide.slider, across, at)))
        pairs.append(((slide.on, slide.slider), _both(slide.on, slide.slider, 0.0, at, 1.0)))
    driving = [_driving(judge, state, drive) for drive in judge.drives]
    acting = _acting(judge, state, turned)
    units = [*(wrenches for _, wrenches in pairs), *driving]
    matrix = np.array([_column(state, one) for one in units]).T
    found = solved(matrix, -_column(state, acting)[:, None])[:, 0]
    rubbing: list[Wrench] = []
    for _ in range(200 if rough else 0):
        rubbing, before = _rubbing(judge, state, found, rough or {}), found
        found = solved(matrix, -_column(state, [*acting, *rubbing])[:, None])[:, 0]
    if rough and np.abs(found - before).max() > 1e-10 * np.abs(found).max():
        raise UnsettledError
    acting += rubbing
    reactions: dict[Both, complex] = {}
    for ((i, j), wrenches), size in zip(pairs, found, strict=False):
        force = complex(wrenches[0].force * size)
        for both, one in (((i, j), force), ((j, i), -force)):
            key = numbers[both[0]], numbers[both[1]]
            reactions[key] = reactions.get(key, 0) + one
    needs = found[len(pairs) :]
    for wrenches, size in zip(driving, needs, strict=True):
        acting += [Wrench(w.body, w.force * size, w.place, w.couple * size) for w in wrenches]
    powers = [_power(state, wrench) for wrench in acting]
    moments = [d.kind == "turn" and judge.words.balance == "moment" for d in judge.drives]
    drives = [
        float(n) * (judge.size if moment else 1.0) for n, moment in zip(needs, moments, strict=True)
    ]
    largest = max([*map(abs, reactions.values()), *(abs(float(n)) for n in needs)])
    whole = float(sum(map(abs, powers))) or 1.0
    return Statics(reactions, drives, largest, float(sum(powers)) / whole)


def _rubbing(
    judge: Judge, state: State, found: Sequence[Any], rough: Mapping[str, Rough]
) -> list[Wrench]:
    """Friction in all rough pairs, of the reactions that were found."""
    wrenches: list[Wrench] = []
    for k, (letter, first, other) in enumerate(judge.pins):
        if pair := rough.get(letter):
            size = abs(found[2 * k] + 1j * found[2 * k + 1])
            sense = _sense(state.w[other.body] - state.w[first.body], max(map(abs, state.w)))
            couple = -sense * pair.f * pair.radius / judge.size * size
            wrenches += _both(first.body, other.body, 0.0, state.place(first), couple)
    for k, slide in enumerate(judge.slides, len(judge.pins)):
        if pair := rough.get(slide.name):
            along = state.units[slide.on] * unit(slide.along)
            at = state.place(slide.pin)
            slip = _speed(state, slide.slider, at) - _speed(state, slide.on, at)
            sense = _sense((along.conjugate() * slip).real, max(map(abs, [*state.dz, slip])))
            force = -sense * pair.f * abs(found[2 * k]) * along
            wrenches += _both(slide.on, slide.slider, force, at)
    return wrenches


def _sense(rate: Any, fastest: Any) -> float:
    return 0.0 if abs(rate) <= 1e-12 * fastest else math.copysign(1.0, float(rate))


def _both(i: int, j: int, force: Any, at: Any, couple: Any = 0.0) -> list[Wrench]:
    """A wrench of body i on body j, and what it gets back."""
    return [Wrench(j, force, at, couple), Wrench(i, -force, at, -couple)]


def _driving(judge: Judge, state: State, drive: Drive) -> list[Wrench]:
    """What a drive does, of size 1."""
    tip, root = state.place(drive.tip), state.place(drive.root)
    if drive.kind == "turn":
        arm = tip - root
        if judge.words.balance == "moment":
            return [Wrench(drive.tip.body, 0.0, tip, 1.0)]
        return [Wrench(drive.tip.body, 1j * arm / abs(arm), tip)]
    along = drive.sense * state.units[drive.line.body] * unit(drive.line.own)
    return _both(drive.line.body, drive.tip.body, along, tip)


def _acting(judge: Judge, state: State, turned: float) -> list[Wrench]:
    """Loads, springs, weights, inertia forces and couples."""
    found = [wrench for load in judge.words.loads for wrench in _load(judge, state, load, turned)]
    found += [w for spring in judge.words.springs for w in _sprung(judge, state, spring)]
    moving = range(1, len(state.z))
    return found + [wrench for k in moving for wrench in _massive(judge, state, k)]


def _load(judge: Judge, state: State, load: Mapping[str, Any], turned: float) -> list[Wrench]:
    """A force or a moment, and its opposite on the link that it comes from."""
    k, size = judge.index[load["link"]], _size(load, turned)
    if "point" in load:
        place = state.place(judge.spot(load["point"], load["link"]))
        found = [Wrench(k, size * _direction(judge, state, load), place)]
    else:
        against = load.get("direction") == "against rotation"
        moment = size / judge.size * (-np.sign(state.w[k]) if against else 1.0)
        found = [Wrench(k, 0.0, state.z[k], moment)]
    if "from" in load:
        _, force, place, couple = found[0]
        if "from_point" in load:
            place = state.place(judge.spot(load["from_point"], load["from"]))
        found.append(Wrench(judge.index[load["from"]], -force, place, -couple))
    return found


def _massive(judge: Judge, state: State, k: int) -> list[Wrench]:
    """The weight and the inertia of a body."""
    words, body, found = judge.words, judge.words.bodies[k], []
    if body.mass is not None and body.centre is not None:
        arm = state.arm(judge.spot(body.centre, body.number))
        fast = state.ddz[k] + (1j * state.e[k] - state.w[k] ** 2) * arm
        if words.gravity:
            found.append(Wrench(k, -1j * body.mass * G, state.z[k] + arm))
        if words.inertia:
            found.append(Wrench(k, -body.mass * fast * judge.size, state.z[k] + arm))
    if body.inertia is not None and words.inertia:
        found.append(Wrench(k, 0.0, state.z[k], -body.inertia * state.e[k] / judge.size))
    return found


def _sprung(judge: Judge, state: State, spring: Mapping[str, Any]) -> list[Wrench]:
    """What a spring or a damper pulls its ends together with: c(l − l_0) + F_0 + b·v."""
    first, other = (
        judge.spot(x, judge.words.bodies[judge.words.standing[x][0]].number)
        for x in spring["between"]
    )
    (r, v, _), (s, w, _) = (
        state.point(x, judge.words.bodies[spot.body].number)
        for x, spot in zip(spring["between"], (first, other), strict=True)
    )
    length = abs(s - r)
    along = (s - r) / length
    parting = ((w - v) * along.conjugate()).real
    pull = si(spring.get("force", 0.0)) + si(spring.get("damping", 0.0)) * parting
    if "rate" in spring:
        pull += si(spring["rate"]) * (length - si(spring["free"]))
    ends = ((first, 1.0), (other, -1.0))
    return [Wrench(spot.body, sign * pull * along, state.place(spot)) for spot, sign in ends]


def _size(load: Mapping[str, Any], turned: float) -> float:
    """The size of a load where the crank has turned so far from the zero position (degrees); N, N·m."""
    if "by_angle" in load:
        angles, sizes = zip(*((at, si(size)) for at, size in load["by_angle"]), strict=True)
        return float(np.interp(turned % 360.0, angles, sizes))
    return si(load["moment"] if "moment" in load else load["force"])


def _direction(judge: Judge, state: State, load: Mapping[str, Any]) -> Any:
    """The unit vector of a load: fixed in the sheet, of a line of links, or against its point's velocity."""
    told = load.get("direction", "against velocity")
    if told == "against velocity":
        _, v, _ = state.point(load["point"], load["link"])
        return -v / abs(v) if v else 0.0
    said = re.fullmatch(r"(along|square to|(\S+) deg to) (\S+)", str(told))
    if said is None:
        return cmath.rect(1.0, math.radians(si(told)))
    degrees = float(said[2]) if said[2] else 90.0 if said[1] == "square to" else 0.0
    return _line(judge, state, said[3]) * cmath.rect(1.0, math.radians(degrees))


def _line(judge: Judge, state: State, name: str) -> Any:
    """The direction of a guide of a link, or of one letter from another, as they stand."""
    for k, body in enumerate(judge.words.bodies):
        if name in body.guides:
            return state.units[k] * unit(np.longdouble(body.guides[name][1]) * PI / 180)
    letters = re.findall(r"[A-Z]\d*", name)
    first, other = (
        state.place(judge.spot(x, judge.words.bodies[judge.words.standing[x][0]].number))
        for x in letters
    )
    return (other - first) / abs(other - first)


def _column(state: State, wrenches: Sequence[Wrench]) -> Any:
    """Forces and moments about its origin on every moving body."""
    found = np.zeros((len(state.z), 3), np.longdouble)
    for body, force, place, couple in wrenches:
        force = np.clongdouble(force)
        turning = ((place - state.z[body]).conjugate() * force).imag + couple
        found[body] += (force.real, force.imag, turning)
    return found[1:].ravel()


def _speed(state: State, body: int, place: Any) -> Any:
    """The velocity of that point of a body which lies at a place."""
    return state.dz[body] + 1j * state.w[body] * (place - state.z[body])


def _power(state: State, wrench: Wrench) -> Any:
    speed = _speed(state, wrench.body, wrench.place)
    force = np.clongdouble(wrench.force)
    return (force.conjugate() * speed).real + wrench.couple * state.w[wrench.body]
