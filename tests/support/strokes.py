"""Sizes of loads by the turn, the time, a travel or a swing: where each turns back is looked for all round.

Of a random mechanism, by the equations of all links at once. A travel goes from one of its two ends to the
other: where its coordinate is least and greatest as the crank goes round once from the zero position, or, of a
row that it goes through one way, where that begins and ends. Its sense is the sign of its velocity.
"""

from __future__ import annotations

import copy
import math
import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from support.free_bodies import PI, Judge, State, UnsolvedError, unit
from support.random_mechanisms import STEP, Random, ahead
from support.scene_words import si

WIDEST = 315.0
"""A protractor reads no wider swing, degrees."""
NEAR, SLOW = 1e-7, 1e-5
"""A share so near a jump may lie on either side; a coordinate so much slower than usual may go either way."""
VARYING = "of", "along", "start", "out", "back", "by_angle", "by_time"
STILL = 1e-9
"""What travels less than this share of the size, or of the widest swing, stands."""
Place = tuple[float, State]
Table = Sequence[tuple[float, float]]
WAYS = {"left": -1.0, "right": 1.0, "bottom": -1j, "top": 1j}
LEAST, FAR = 1e-4, 30.0
"""A step that shrinks below that (rad) ends at a dead place; what comes to so many sizes goes without end."""


class UnsureError(ArithmeticError):
    """The size is either of two: at a jump, or where what it goes by stands."""


class Coordinate(NamedTuple):
    """How far something has come and how fast it goes: m or degrees, their rates."""

    place: float
    rate: float


class Stroke(NamedTuple):
    """Where a stroke out begins, how far it goes, with its sign: m or degrees; its usual speed."""

    begin: float
    length: float
    usual: float


@dataclass(frozen=True)
class Row:
    """A row of a random mechanism: the way to its zero position; ``whole``: a turn from there on."""

    found: Random
    first: float
    whole: bool = False
    known: dict[tuple[Any, ...], Stroke | None] = field(default_factory=dict)

    @cached_property
    def states(self) -> list[Place]:
        """All along the places that were walked, as the first drive goes."""
        return self.found.walked[:: 1 if self.found.judge.drives[0].rate > 0 else -1]

    @property
    def time(self) -> float:
        """How long the first drive takes over the row, evenly: from the one end to the other, or a turn; s."""
        way = 2 * math.pi if self.whole else self.states[-1][0] - self.states[0][0]
        return abs(way / self.found.judge.drives[0].rate)

    @cached_property
    def round(self) -> tuple[list[Place], bool]:
        """As far as the crank comes round from the first position, and whether that is a whole turn."""
        found, there = self.found, self.states
        turn = math.copysign(2 * math.pi, found.judge.drives[0].rate)
        there = there + _walk(found, there[-1], there[0][0] + turn)
        whole = abs(there[-1][0] - there[0][0] - turn) < 1e-9
        if len(found.judge.drives) == 1 and not whole:
            there = _walk(found, there[0], self.states[-1][0] - turn)[::-1] + there
        if max(abs(z) for s in (there[0][1], there[-1][1]) for z in s.z) > FAR:
            raise UnsureError  # beyond a place without end it stands again
        return there, whole and len(found.judge.drives) == 1

    def stroke(self, load: Mapping[str, Any]) -> Stroke | None:
        """The stroke of a load; None where it has none."""
        key = load["of"], load.get("along"), load.get("start")
        if key not in self.known:
            self.known[key] = self._stroke(load)
        return self.known[key]

    def _stroke(self, load: Mapping[str, Any]) -> Stroke | None:
        of_turn, ends = False, None
        if isinstance(load["of"], int) and len(self._spots(load["of"])) < 2:
            return None
        if self.found.judge.drives[0].kind == "turn":
            ends = self._turning(load)
            of_turn = ends is not None
        if ends is None and not self.whole:
            row = [self.coordinate(load, state) for _, state in self.states]
            gains = [(b.place > a.place, b.rate > 0) for a, b in pairwise(row)]
            if len({*gains, (row[0].rate > 0,) * 2}) == 1:
                ends = row[0].place, row[-1].place
            elif len({gain for gain, _ in gains}) == 1:
                raise UnsureError  # it turns back beside its first place or its last
        if ends is None:
            return None
        low, high = sorted(ends)
        whole = WIDEST if isinstance(load["of"], int) else self.found.judge.size
        if high - low <= STILL * whole or (isinstance(load["of"], int) and high - low > whole):
            return None
        begin = ends[0]
        if "start" in load:
            begin = high if self._at_high(load) else low
        elif of_turn:
            begin = self._first_end(load, low, high)
        states = self.round[0] if self.found.judge.drives[0].kind == "turn" else self.states
        usual = float(np.median([abs(self.coordinate(load, s).rate) for _, s in states]))
        return Stroke(begin, (high - begin) or (low - begin), usual)

    def _at_high(self, load: Mapping[str, Any]) -> bool:
        """Whether a stroke begins where its coordinate is greatest."""
        if isinstance(load["of"], int):
            return bool(load["start"] == "counterclockwise")
        return (complex(WAYS[load["start"]]) * self.way(load).conjugate()).real > 0

    def coordinate(self, load: Mapping[str, Any], state: State) -> Coordinate:
        """How far that by which a load is told has come."""
        if isinstance(load["of"], int):
            k = self.found.judge.index[load["of"]]
            return Coordinate(math.degrees(state.t[k]), math.degrees(state.w[k]))
        r, v, _ = state.point(load["of"], self._number(load["of"]))
        way = complex(self.way(load)).conjugate()
        return Coordinate((r * way).real, (v * way).real)

    def _spots(self, number: int) -> set[complex]:
        """The places of the letters of a link, m."""
        judge = self.found.judge
        return set(judge.words.bodies[judge.index[number]].points.values())

    def _number(self, letter: str) -> int:
        words = self.found.judge.words
        return words.bodies[words.standing[letter][0]].number

    def way(self, load: Mapping[str, Any]) -> complex:
        """The direction in which a travel counts."""
        if "along" in load:
            return complex(unit(np.longdouble(si(load["along"])) * PI / 180))
        slides = (s for s in self.found.judge.slides if s.on == 0)
        words = self.found.judge.words
        along = next(s.along for s in slides if load["of"] in words.bodies[s.slider].points)
        return complex(unit(along))

    def _first_end(self, load: Mapping[str, Any], low: float, high: float) -> float:
        """Where a stroke begins that says nothing: behind, clockwise; of a slider away from the crank.

        Off the crank is where its rod does not come from, if it has one.
        """
        if isinstance(load["of"], int) or "along" in load:
            return low
        judge = self.found.judge
        bodies = judge.words.bodies
        owners = (bodies[k] for k in judge.words.standing[load["of"]])
        sides = [s.get("side") for body in owners for s in body.slides if s["on"] == "frame"]
        if side := next(filter(None, sides), ""):
            return high if side == "+" else low
        way = self.way(load)
        state = self.states[0][1]
        r, _, _ = state.point(load["of"], self._number(load["of"]))
        pivot = complex(state.place(judge.drives[0].root)) * judge.size
        foot = (r * way.conjugate()).real
        far = {x: abs(r + (x - foot) * way - pivot) for x in (low, high)}
        return max(far, key=far.__getitem__)

    def _turning(self, load: Mapping[str, Any]) -> tuple[float, float] | None:
        """The least and the greatest place of a turn, if it turns back at both."""
        states, closed = self.round
        row = [(way, state, self.coordinate(load, state)) for way, state in states]
        if closed and isinstance(load["of"], int) and abs(row[-1][2].place - row[0][2].place) > 1.0:
            return None  # it turns through
        inner = [
            self._refined(load, one, other)
            for one, other in pairwise(row)
            if (one[2].rate > 0) != (other[2].rate > 0)
        ]
        if not inner:
            return None
        edges = [] if closed else [row[0][2].place, row[-1][2].place]
        low, high = min(inner), max(inner)
        if any(0 < max(low - x, x - high) < 0.05 * (high - low) for x in edges):
            raise UnsureError  # beside a dead place it goes as far again
        return None if any(x < low or x > high for x in edges) else (low, high)

    def _refined(self, load: Mapping[str, Any], one: Any, other: Any) -> float:
        """The place where a coordinate turns back between two states."""
        (a, near, p), (b, _, q) = one, other
        found = p.place
        for k in range(60):
            way = (a + b) / 2 if k % 3 == 2 else a - p.rate * (b - a) / (q.rate - p.rate)
            near = self.found.judge.solve(self.found.coordinates(way), near.poses)
            c = self.coordinate(load, near)
            found = c.place
            if abs(c.rate) < 1e-12 * max(abs(p.rate), abs(q.rate)) or abs(b - a) < 1e-13:
                break
            if (c.rate > 0) == (p.rate > 0):
                a, p = way, c
            else:
                b, q = way, c
        return found


def _walk(found: Random, begin: Place, end: float) -> list[Place]:
    """Places behind one up to a way, so far as each leads to the next: they stop before a dead place."""
    rows: list[Place] = []
    (way, state), step = begin, math.copysign(STEP["turn"], end - begin[0])
    while abs(end - way) > 1e-12:
        step = math.copysign(min(abs(step), abs(end - way)), step)
        try:
            poses = ahead(state, step)
            near = found.judge.solve(found.coordinates(way + step), poses, exact=False)
            leads = near.hand == state.hand and _leap(near, state) < 0.5
        except UnsolvedError:
            leads = False
        if leads:
            way, state = way + step, near
            rows.append((way, state))
            step = math.copysign(min(2 * abs(step), STEP["turn"]), step)
        elif abs(step) < LEAST:
            break
        else:
            step /= 2
    return rows


def _leap(one: State, other: State) -> float:
    """How far links turn between two states, rad."""
    return max(abs(float(a - b)) for a, b in zip(one.t, other.t, strict=True))


def by_stroke(load: Mapping[str, Any], stroke: Stroke, at: Coordinate) -> float:
    """The size of a load where what it goes by stands, N or N*m; nothing acts outside of its table."""
    if abs(at.rate) < SLOW * stroke.usual:
        raise UnsureError
    share = (at.place - stroke.begin) / stroke.length
    return by_share(_points(load.get("out" if at.rate * stroke.length > 0 else "back", ())), share)


def by_share(points: Table, share: float) -> float:
    """The size at a share of a way, straight between two points of a table, none outside of it."""
    places = [x for x, _ in points]
    jumps = [a for a, b in pairwise(places) if a == b]
    jumps += [x for x in (places[0], places[-1]) if 0 < x < 1] if places else []
    if any(abs(share - x) < NEAR for x in jumps):
        raise UnsureError
    for (a, p), (b, q) in pairwise(points):
        if a < b and a - NEAR <= share <= b + NEAR:
            return p + (q - p) * (share - a) / (b - a)
    return 0.0


def by_turn(points: Table, cycle: float, at: float) -> float:
    """The size of a load so far in a cycle; behind its last point it goes straight to the first of the next."""
    at %= cycle
    (first, begins), (last, ends) = points[0], points[-1]
    row = [(last - cycle, ends), *points, (first + cycle, begins)]
    if any(abs(at - x) < NEAR * cycle for (x, _), (y, _) in pairwise(row) if x == y):
        raise UnsureError
    (a, p), (b, q) = next(two for two in pairwise(row) if two[0][0] <= at <= two[1][0] > two[0][0])
    return p + (q - p) * (at - a) / (b - a)


def _points(table: Sequence[tuple[Any, Any]]) -> Table:
    """A table of places and sizes in SI and degrees, in order of the places."""
    return sorted(((si(x), si(size)) for x, size in table), key=lambda point: point[0])


def sized(row: Row, judge: Judge, way: float, state: State) -> Judge:
    """A judge whose loads have the sizes of a place."""
    judge = copy.copy(judge)
    loads = [_constant(row, load, way, state) for load in judge.words.loads]
    judge.words = copy.copy(judge.words)
    judge.words.loads = loads
    return judge


def _constant(row: Row, load: Mapping[str, Any], way: float, state: State) -> Mapping[str, Any]:
    """A load as one of constant size."""
    rate = abs(row.found.judge.drives[0].rate)
    passed = (way - row.first) * math.copysign(1.0, row.found.judge.drives[0].rate)
    if "of" in load:
        stroke = row.stroke(load)
        assert stroke is not None
        size = by_stroke(load, stroke, row.coordinate(load, state))
    elif "by_angle" in load:
        points = _points(load["by_angle"])
        turns = 2.0 if points[-1][0] > 360.0 else 1.0
        size = by_turn(points, 360.0 * turns, math.degrees(passed))
    elif "by_time" in load:
        points, time = _points(load["by_time"]), row.time
        if row.whole:
            size = by_turn(points, time * (2 if points[-1][0] > 1.5 * time else 1), passed / rate)
        else:
            size = by_share([(t / time, size) for t, size in points], passed / rate / time)
    else:
        return load
    kept = {key: told for key, told in load.items() if key not in VARYING}
    return kept | {"force" if "point" in load else "moment": size}


def varying(pick: random.Random, row: Row, kinds: Sequence[str] = ()) -> list[dict[str, Any]]:
    """Loads whose sizes vary with anything there is, or of some ``kinds``; seldom with what has no stroke."""
    loads: list[dict[str, Any]] = []
    for _ in range(pick.choice((1, 1, 2))):
        for _ in range(6):
            load = _load(pick, row, kinds)
            if "of" not in load or row.stroke(load) is not None:
                break
        loads.append(load)
    return loads


def _load(pick: random.Random, row: Row, kinds: Sequence[str]) -> dict[str, Any]:
    """A force or a moment on a link."""
    found = row.found
    body = pick.choice(found.judge.words.bodies[1:])
    moving = [x for x in body.points if 0 not in found.judge.words.standing[x]]
    load: dict[str, Any] = {"link": body.number}
    if not moving or pick.random() < 0.4:
        return load | _varies(pick, row, kinds, "N*m", 100.0 * found.scale)
    load["point"] = pick.choice(moving)
    if pick.random() < 0.7:
        load["direction"] = f"{pick.uniform(-180, 180)!r} deg"
    return load | _varies(pick, row, kinds, "N", 500.0)


def _varies(
    pick: random.Random, row: Row, kinds: Sequence[str], unit: str, most: float
) -> dict[str, Any]:
    """What a size goes by, and its table."""
    judge = row.found.judge
    lead = judge.drives[0]
    known = ["slider", "point", "point", "link", "link"]
    if lead.kind == "turn":
        known += ["turn"]
    if not lead.gain:
        known += ["time"]
    kind = pick.choice(kinds or known)
    if kind == "turn":
        cycle = pick.choice((360.0, 360.0, 720.0)) if row.whole else 360.0
        return {"by_angle": [[x * cycle, size] for x, size in _table(pick, unit, most)]}
    if kind == "time":
        time = row.time * (pick.choice((1, 2)) if row.whole else 1)
        return {"by_time": [[f"{x * time!r} s", size] for x, size in _table(pick, unit, most)]}
    tables = {way: [[*one] for one in _table(pick, unit, most)] for way in ("out", "back")}
    if pick.random() < 0.3:
        del tables[pick.choice(("out", "back"))]
    bodies = judge.words.bodies
    sliders = sorted({s.slider for s in judge.slides if s.on == 0})
    pins = [x for k in sliders for x in bodies[k].points if len(judge.words.standing[x]) > 1]
    if kind == "link":
        load: dict[str, Any] = {"of": pick.choice(bodies[1:]).number}
        ends = ["clockwise", "counterclockwise"]
    elif kind == "slider" and pins:
        load, ends = {"of": pick.choice(pins)}, []
    else:
        letters = [x for b in bodies[1:] for x in b.points if 0 not in judge.words.standing[x]]
        load = {"of": pick.choice(letters), "along": f"{pick.uniform(-180, 180)!r} deg"}
        ends = []
    ends = ends or _level_ends(row, load)
    if pick.random() < 0.5:
        load["start"] = pick.choice(ends)
    return load | tables


def _level_ends(row: Row, load: Mapping[str, Any]) -> list[str]:
    """The names of both ends of a line."""
    way = row.way(load)
    return ["left", "right"] if abs(way.real) > abs(way.imag) else ["bottom", "top"]


def _table(pick: random.Random, unit: str, most: float) -> list[tuple[float, str]]:
    """Shares and sizes: straight lines, steps and jumps, all along or a part."""
    places = sorted(pick.uniform(0.02, 0.98) for _ in range(pick.randint(1, 3)))
    if pick.random() < 0.5:
        k = pick.randrange(len(places))
        places.insert(k, places[k])
    low, high = (0.0, 1.0) if pick.random() < 0.7 else (0.01, 0.99)
    sizes = [pick.uniform(-1, 1) * most for _ in range(len(places) + 2)]
    return [(x, f"{y!r} {unit}") for x, y in zip([low, *places, high], sizes, strict=True)]
