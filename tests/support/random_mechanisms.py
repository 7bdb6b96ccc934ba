"""Random mechanisms of any drives, as tables of a scene: drives, and groups of all kinds that hang on them.

Each is drawn outward from one place in which it stands: pins and directions of guides first, from them what a
scene says of links, offsets, sides. From there the judge walks both ways for as long as all equations keep
their distance from a dead place: so the row of positions is known, and where it ends. Lengths are near 1 and
scaled at the end.
"""

from __future__ import annotations

import cmath
import math
import random
from collections.abc import Sequence
from functools import cache
from typing import Any, NamedTuple

from support.free_bodies import Drive, Judge, Poses, State, UnsolvedError
from support.random_plane import Body, Plane

KINDS = ("RRR", "RRP", "RPR", "PRP", "RPP")
DRIVES = ("crank", "slider", "rod")
EASY = 300.0
"""Condition up to which a place is compared to all digits."""
STEP = {"turn": math.radians(6), "slide": 0.06, "rod": 0.06}
STEPS = 30
"""At most so many to either side: half a turn and more than a length."""


class Random(NamedTuple):
    """A random mechanism: its scene without a row, and where it stands.

    ``at``: the coordinates of all drives where it was drawn (rad, m). ``walked``: by the way of the first
    drive from there, places in order; ``ends``: whether the walk stopped before a dead place, below and
    above. ``ratios``: of the rates of each drive to the first's. ``scale``: m.
    """

    scene: dict[str, Any]
    judge: Judge
    kinds: tuple[str, ...]
    at: tuple[float, ...]
    walked: list[tuple[float, State]]
    ends: tuple[bool, bool]
    ratios: tuple[float, ...]
    scale: float

    def coordinates(self, way: float) -> list[float]:
        """Of all drives, that far of the first from where it was drawn."""
        return [q + ratio * way for q, ratio in zip(self.at, self.ratios, strict=True)]

    def row(self, low: float, high: float, positions: int) -> dict[str, Any]:
        """The scene with a row over some way of the first drive, in the sense in which that goes."""
        first, last = (low, high) if self.judge.drives[0].rate > 0 else (high, low)
        written = [dict(told) for told in self.judge.words.drives]
        for drive, told, q in zip(self.judge.drives, written, self.coordinates(first), strict=True):
            if told is not written[0]:
                told["at"] = _written(drive, q)
        lead = self.judge.drives[0]
        written[0] |= {
            "from": _written(lead, self.at[0] + first),
            "to": _written(lead, self.at[0] + last),
            "positions": positions,
        }
        return {**self.scene, "drive": written if len(written) > 1 else written[0]}

    def dead(self, sense: int) -> float | None:
        """The way to the dead place below or above, to 1e-9 of a step; None if the walk has not come near it.

        Two assemblies meet there, so behind it there is neither.
        """
        end = 0 if sense < 0 else -1
        way, state = self.walked[end]
        if not self.ends[end]:
            return None
        begin, step = state, abs(self.walked[1][0] - self.walked[0][0])
        least, far = step * 1e-9, step * 12
        for _ in range(150):
            if step < least:
                break
            try:
                poses = ahead(state, sense * step)
                near = self.judge.solve(self.coordinates(way + sense * step), poses, exact=False)
            except UnsolvedError:
                step /= 2
                continue
            moved = max(abs(a[0] - b[0]) for a, b in zip(near.poses, state.poses, strict=True))
            if near.hand != begin.hand or moved > 20 * self.scale:
                step /= 2
                continue
            way, state = way + sense * step, near
            if abs(way - self.walked[end][0]) > far:
                return None
        wide = max(abs(z) for z, _ in state.poses) > 30 * self.scale
        return None if wide or step >= least or state.condition < 1e4 else way

    def solved(self, way: float) -> State:
        """The exact state at a way, in the assembly that was walked to."""
        _, near = min(self.walked, key=lambda told: abs(told[0] - way))
        return self.judge.solve(self.coordinates(way), near.poses)


def _written(drive: Drive, coordinate: float) -> str:
    """A coordinate as a scene says it."""
    if drive.kind == "turn":
        return f"{math.degrees(coordinate)!r} deg"
    return f"{coordinate * 1e3!r} mm"


def _table(plane: Plane, body: Body) -> dict[str, Any]:
    """A link as its table says."""
    pick, number = plane.pick, body.number
    told: dict[str, Any] = {"number": number}
    told["points"] = {x: plane.own(body, plane.places[x]) for x in body.letters}
    centre = plane.places[body.letters[0]] if body.letters else body.z
    plane.places[f"S{number}"] = centre + 0.5 * plane.apart()
    told["points"][f"S{number}"] = plane.own(body, plane.places[f"S{number}"])
    if body.guides:
        told["guides"] = plane.guides(body)
    if body.slides:
        told["slides"] = body.slides if len(body.slides) > 1 else body.slides[0]
    if body.side:
        told["side"] = body.side
    if pick.random() < 0.8:
        mass = pick.uniform(0.5, 10.0)
        at_pin = body.letters and pick.random() < 0.2
        told |= {"mass": mass, "centre": pick.choice(body.letters) if at_pin else f"S{number}"}
        if pick.random() < 0.7:
            told["J"] = mass * (0.3 * plane.scale) ** 2
    return told


def _turning(plane: Plane) -> set[int]:
    """The links that can turn: not those that guides tie to the frame."""
    still = {0}
    for _ in plane.bodies:
        for body in plane.bodies:
            on = {0 if told["on"] == "frame" else told["on"] for told in body.slides}
            if body.number in still:
                still |= on
            elif on & still:
                still.add(body.number)
    return {body.number for body in plane.bodies} - still


def _direction(plane: Plane, body: Body) -> dict[str, str]:
    """A direction of any kind; none: against velocity."""
    pick = plane.pick
    kind = pick.choice(("fixed", "fixed", "along", "square to", "deg to", "against"))
    if kind == "against":
        return {}
    if kind == "fixed" or len(plane.places) < 2:
        return {"direction": f"{pick.uniform(-180.0, 180.0)!r} deg"}
    guides = [name for body in plane.bodies for name in body.guides]
    if not guides or pick.random() < 0.5:
        ends = sorted(pick.sample([*plane.places], 2))
        line = "".join(ends)
        if abs(plane.places[ends[0]] - plane.places[ends[1]]) < 0.3:
            return {}
    else:
        line = pick.choice(guides)
    by = f"{pick.uniform(-180.0, 180.0)!r} deg to" if kind == "deg to" else kind
    return {"direction": f"{by} {line}"}


def _loads(plane: Plane, drives: Sequence[str]) -> list[dict[str, Any]]:
    """Forces of all directions, and moments, on some links, some from another link."""
    pick, turning = plane.pick, _turning(plane)
    found: list[dict[str, Any]] = []
    for body in plane.bodies[1:]:
        own = f"S{body.number}"
        if pick.random() < 0.5:
            moving = [x for x in body.letters if x not in plane.frame.letters]
            load = {"link": body.number, "point": pick.choice([*moving, own])}
            load |= _amount(plane, drives, "force", "N", 500.0) | _direction(plane, body)
            found.append(load | _opposite(plane, body, load))
        if pick.random() < 0.25:
            load = {"link": body.number}
            load |= _amount(plane, drives, "moment", "N*m", plane.scale * 100.0)
            against = pick.random() < 0.5 and body.number in turning
            load |= {"direction": "against rotation"} if against else {}
            found.append(load | _opposite(plane, body, load))
    return found


def _amount(
    plane: Plane, drives: Sequence[str], name: str, unit: str, most: float
) -> dict[str, Any]:
    """A size, or sizes by the turn of the crank."""
    pick = plane.pick
    if tuple(drives) == ("crank",) and name == "force" and pick.random() < 0.2:
        angles = [0.0, *sorted(pick.uniform(1.0, 359.0) for _ in range(3)), 360.0]
        return {"by_angle": [[at, f"{pick.uniform(5.0, most)!r} {unit}"] for at in angles]}
    return {name: f"{pick.uniform(0.05, 1.0) * most!r} {unit}"}


def _opposite(plane: Plane, body: Body, load: dict[str, Any]) -> dict[str, Any]:
    """The link that a load comes from, and where the opposite acts on it; or nothing."""
    pick = plane.pick
    against = "against" in load.get("direction", "against" if "point" in load else "")
    if against or len(plane.bodies) < 3 or pick.random() < 0.7:
        return {}
    other = pick.choice([b for b in plane.bodies[1:] if b is not body])
    found: dict[str, Any] = {"from": other.number}
    if "point" in load and pick.random() < 0.5:
        found |= {
            "from_point": f"S{other.number}",
            "direction": f"along {load['point']}S{other.number}",
        }
    return found


def _springs(plane: Plane) -> list[dict[str, Any]]:
    """Springs and dampers between mass centres, or from one to the frame."""
    pick, found = plane.pick, []
    for body in plane.bodies[1:]:
        if pick.random() > 0.15:
            continue
        first = f"S{body.number}"
        others = [f"S{b.number}" for b in plane.bodies[1:]] + plane.frame.letters
        other = pick.choice([x for x in others if x != first] or [first])
        if other == first or abs(plane.places[first] - plane.places[other]) < 0.3:
            continue
        spring: dict[str, Any] = {"between": [first, other]}
        if pick.random() < 0.7:
            spring |= {"rate": pick.uniform(50.0, 500.0) / plane.scale}
            spring |= {"free": pick.uniform(0.2, 1.5) * plane.scale, "force": pick.uniform(-50, 50)}
        else:
            spring |= {"damping": pick.uniform(1.0, 50.0) / plane.scale}
        found.append(spring)
    return found


def _drive(plane: Plane, body: Body, kind: str, *, first: bool) -> dict[str, Any]:
    """What a drive says of its motion."""
    pick = plane.pick
    if kind == "crank":
        speed = pick.choice((f"{pick.uniform(0.5, 30)!r} rad/s", f"{pick.uniform(10, 300)!r} rpm"))
        told: dict[str, Any] = {"link": body.number, "speed": speed}
        if pick.random() < 0.6:
            told["acceleration"] = f"{pick.uniform(-90, 90)!r} rad/s2"
        if pick.random() < 0.5:
            told["turns"] = "clockwise"
        return told
    told = {"link": body.number, "speed": f"{plane.scale * pick.uniform(0.1, 2.0)!r} m/s"}
    if pick.random() < 0.6:
        told["acceleration"] = f"{plane.scale * pick.uniform(-2, 2)!r} m/s2"
    if first and pick.random() < 0.3:
        told |= {"from": "1 m", "to": "0 m"}  # which way it goes; where from and to, a row says
    return told


@cache
def drawn(
    seed: int, drives: tuple[str, ...], groups: int, kinds: tuple[str, ...] = KINDS
) -> Random | None:
    """A random mechanism; None if it has next to no row before it comes to a dead place.

    It is shared, for its walk takes long: change nothing of it.
    """
    pick = random.Random(f"{seed} {drives} {groups}")
    plane = Plane(pick, pick.choice((0.02, 0.1, 0.1, 1.0, 5.0)))
    driving = []
    for kind in drives:
        getattr(plane, kind)()
        driving.append(plane.bodies[-2 if kind == "rod" else -1])
    plane.free = list(plane.driven)
    chosen = tuple(pick.choice(kinds) for _ in range(groups))
    for kind in chosen:
        plane.group(kind)
    links = [_table(plane, body) for body in plane.bodies[1:]]
    pick.shuffle(links)
    frame = {x: plane.own(plane.frame, plane.places[x]) for x in plane.frame.letters}
    told = [
        _drive(plane, body, kind, first=body is driving[0])
        for body, kind in zip(driving, drives, strict=True)
    ]
    balance = pick.choice(("force", "moment")) if set(drives) == {"crank"} else "force"
    scene: dict[str, Any] = {
        "title": "Random",
        "language": "en",
        "frame": frame | plane.guides(plane.frame),
        "link": links,
        "drive": told if len(told) > 1 else told[0],
        "effects": {"gravity": pick.random() < 0.6, "inertia": pick.random() < 0.7},
        "load": _loads(plane, drives),
        "spring": _springs(plane),
        "forces": {"positions": "all", "balance": balance},
    }
    scene = {key: value for key, value in scene.items() if value != []}
    judge = Judge(scene)
    by_number = {body.number: body for body in plane.bodies}
    poses = [
        (by_number[link["number"]].z * plane.scale, by_number[link["number"]].theta)
        for link in links
    ]
    start = State(judge, [0j, *(z / judge.size for z, _ in poses)], [0.0, *(t for _, t in poses)],
                  *([0j] * len(poses) for _ in range(4)))  # fmt: skip
    at = tuple(_coordinate(start, drive) for drive in judge.drives)
    rates = [drive.rate for drive in judge.drives]
    ratios = tuple(rate / rates[0] for rate in rates)
    walked, ends = _walk(judge, poses, at, ratios, plane.scale)
    found = Random(scene, judge, chosen, at, walked, ends, ratios, plane.scale)
    return found if len(walked) >= 5 else None


def _coordinate(state: State, drive: Drive) -> float:
    """The coordinate of a drive as things stand, rad or m."""
    way = complex(state.place(drive.tip) - state.place(drive.root))
    if drive.kind == "turn":
        return cmath.phase(way)
    along = cmath.rect(1.0, float(state.t[drive.line.body]) + float(drive.line.own))
    return drive.sense * (way * along.conjugate()).real * state.judge.size


def _walk(
    judge: Judge, poses: Poses, at: Sequence[float], ratios: Sequence[float], scale: float
) -> tuple[list[tuple[float, State]], tuple[bool, bool]]:
    """Places on both sides of that in which it was drawn, each near the one before."""
    here = judge.solve(at, poses, exact=False)
    step = STEP[judge.drives[0].kind] * (1.0 if judge.drives[0].kind == "turn" else scale)
    step /= max(1.0, *(abs(r) * _alike(judge, k, scale) for k, r in enumerate(ratios)))
    sides: list[list[tuple[float, State]]] = []
    ends = []
    for sense in (-1, 1):
        state, row, dead = here, [], False
        for k in range(1, STEPS + 1):
            way = sense * k * step
            q = [x + ratio * way for x, ratio in zip(at, ratios, strict=True)]
            try:
                near = judge.solve(q, ahead(state, sense * step), exact=False)
            except UnsolvedError:
                dead = True
                break
            short = [
                d.kind == "rod" and x < 0.1 * scale for d, x in zip(judge.drives, q, strict=True)
            ]
            if near.condition > EASY or near.hand != here.hand or any(short):
                dead = not any(short)
                break
            state = near
            row.append((way, near))
        sides.append(row)
        ends.append(dead)
    return [*sides[0][::-1], (0.0, here), *sides[1]], (ends[0], ends[1])


def _alike(judge: Judge, k: int, scale: float) -> float:
    """So that a step of another kind of drive is as small as one of the first."""
    one, other = (judge.drives[i].kind == "turn" for i in (0, k))
    return 1.0 if one == other else (1.0 / scale if one else scale)


def ahead(state: State, way: float) -> Poses:
    """Poses a small way of the first drive on, along the velocities."""
    rate = state.judge.drives[0].rate
    return [
        (z + complex(dz) * state.judge.size * way / rate, t + float(w) * way / rate)
        for (z, t), dz, w in zip(state.poses, state.dz[1:], state.w[1:], strict=True)
    ]
