"""Gas on pistons of random mechanisms, in cylinders that stand and that swing, against the judge."""

from __future__ import annotations

import cmath
import copy
import math
import random
from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import pytest
from judges.test_random_varying_loads import TURN as ALL_ROUND
from support.against_judge import LIMITS, PLANS, errors
from support.free_bodies import Judge, State
from support.random_mechanisms import KINDS, Random, drawn
from support.strokes import NEAR, SLOW, Row, UnsureError, sized

TURN, COUNT = 360.0, 24
"""Degrees of a turn, and the positions of the row in it."""
HELD = {"swings": KINDS, "stands": ("RRP", "RRP", "PRP", "RPP")}
"""The groups that hang on the crank: more of those that slide on the frame, where one bears the gas."""
MOST = 8e5
"""The highest pressure, Pa."""
Parts = Sequence[tuple[float, float, float, float, float | None]]
"""From one share of the stroke to another, the pressures there (Pa); the exponent, None of a straight line."""


class Piston(NamedTuple):
    """A cylinder as the judge knows it.

    ``link``, ``point``: what the gas pushes; ``cylinder``: on which it pushes the other way, 0 the frame.
    ``at``: by a state the share of the stroke from the cover, its rate as a share of the usual, and the way
    (degrees) from the cover. ``begins``: degrees that the crank turns to the first stroke out. ``order``: the
    table of the scene; ``faces``: of both sides their sign, area (m²) and parts by turn and stroke.
    """

    link: int
    point: str
    cylinder: int
    at: Callable[[State], tuple[float, float, float]]
    begins: float
    order: dict[str, Any]
    faces: list[tuple[float, float, dict[tuple[int, str], Parts]]]

    def force(self, state: State, turned: float) -> float:
        """What the gas pushes with, from the cover, N; ``turned``: degrees from the zero position."""
        share, rate, _ = self.at(state)
        if abs(rate) < SLOW:
            raise UnsureError
        turns = self.order.get("strokes", 2) // 2
        passed = (turned - self.begins - self.order.get("phase", 0.0)) / TURN
        turn, way = math.floor(passed) % turns, "out" if rate > 0 else "back"
        return sum(
            sign * area * _pressure(told[turn, way], share) for sign, area, told in self.faces
        )


def _pressure(parts: Parts, share: float) -> float:
    """The pressure at a share of a stroke, Pa."""
    at = [x for a, b, *_ in parts for x in (a, b) if 0.0 < x < 1.0]
    if any(abs(share - x) < NEAR for x in at):
        raise UnsureError
    a, b, p, q, n = next(
        one for one in parts if min(one[:2]) - NEAR <= share <= max(one[:2]) + NEAR
    )
    return p + (q - p) * (share - a) / (b - a) if n is None else p * (a / share) ** n


def _faces(
    pick: random.Random, scale: float, *, four: bool
) -> tuple[dict[str, Any], list[tuple[float, float, dict[tuple[int, str], Parts]]]]:
    """The pressures of a cylinder: its keys, and both faces as the judge knows them."""
    bore, rod = 0.3 * scale * pick.uniform(0.5, 1.0), 0.0
    order: dict[str, Any] = {"bore": bore}
    faces = []
    for side, sign in (("cover", 1.0), ("shaft", -1.0))[: pick.choice((1, 2))]:
        if side == "shaft" and pick.random() < 0.5:
            rod = bore * pick.uniform(0.1, 0.6)
            order["rod"] = rod
        told: dict[tuple[int, str], Parts] = {}
        points: dict[str, Any] = {}
        for turn in range(2 if four else 1):
            for way in ("out", "back"):
                inner = sorted(pick.uniform(0.05, 0.95) for _ in range(pick.randint(0, 2)))
                shares = [0.0, *inner, 1.0][:: 1 if way == "out" else -1]
                row = [(x, pick.uniform(0.0, MOST)) for x in shares]
                points[way + "_2" * turn] = [[*one] for one in row]
                told[turn, way] = [(a, b, p, q, None) for (a, p), (b, q) in pairwise(row)]
        order[f"{side}_points"] = points
        area = math.pi / 4 * (bore**2 - (rod**2 if side == "shaft" else 0.0))
        faces.append((sign, area, told))
    if four:
        order |= {"strokes": 4} | ({"phase": 360.0} if pick.random() < 0.5 else {})
    return order, faces


def swinging(pick: random.Random, found: Random) -> tuple[Random, Piston]:
    """A random mechanism with a cylinder that swings about a pin of the frame, its rod on the crank."""
    judge, scene = found.judge, copy.deepcopy(found.scene)
    crank, words = judge.drives[0], judge.words
    state, pin = found.walked[0][1], "Y9"
    ahead = cmath.rect(pick.uniform(0.5, 1.5), pick.uniform(-math.pi, math.pi))
    bodies = words.bodies
    driven = next(one for one in scene["link"] if one["number"] == bodies[crank.tip.body].number)
    base, end = (complex(spot.own) * judge.size for spot in (crank.root, crank.tip))
    place = base + ahead * (end - base)
    driven["points"][pin] = [place.real, place.imag]
    origin = complex(state.place(crank.root)) * judge.size
    radius = abs(place - base)
    foot = origin + radius * cmath.rect(pick.uniform(1.3, 3.0), pick.uniform(-math.pi, math.pi))
    side, turn = pick.choice("+-"), pick.uniform(-math.pi, math.pi)
    rod, cylinder = (max(body.number for body in bodies) + k for k in (1, 2))
    scene["frame"]["Z9"] = [foot.real, foot.imag]

    def own(number: int) -> dict[str, Any]:
        mass = pick.uniform(0.5, 5.0)
        centre = [found.scale * pick.uniform(-1, 1), found.scale * pick.uniform(-1, 1)]
        return {"number": number, "mass": mass, "J": mass * (0.3 * found.scale) ** 2,
                "centre": f"S{number}", "points": {f"S{number}": centre}}  # fmt: skip

    first, second = own(rod), own(cylinder)
    first["points"][pin] = [0.0, 0.0]
    first["slides"] = {"on": cylinder, "along": "z9", "side": side}
    second["points"]["Z9"] = [0.0, 0.0]
    second["guides"] = {"z9": {"through": [0, 0], "angle": f"{math.degrees(turn)!r} deg"}}
    scene["link"] += [first, second]
    full = Judge(scene)
    walked = []
    for way, before in found.walked:
        tip = origin + ahead * (complex(before.place(crank.tip)) * judge.size - origin)
        along = cmath.phase(tip - foot) if side == "+" else cmath.phase(foot - tip)
        poses = [*before.poses, (tip, along), (foot, along - turn)]
        walked.append((way, full.solve(found.coordinates(way), poses)))

    def at(state: State) -> tuple[float, float, float]:
        tip, speed, _ = state.point(pin, rod)
        arm = tip - foot
        rate = (arm.conjugate() * speed).real / abs(arm) / abs(speed)
        share = (abs(arm) - abs(foot - origin) + radius) / (2 * radius)
        return share, rate, math.degrees(cmath.phase(arm))

    order, faces = _faces(pick, found.scale, four=pick.random() < 0.5)
    sense = math.copysign(1.0, crank.rate)
    shortest = math.degrees(cmath.phase((foot - origin) / ahead)) - math.degrees(found.at[0])
    begins = shortest * sense % TURN
    told = Piston(rod, pin, cylinder, at, begins, {"point": pin} | order, faces)
    return found._replace(scene=scene, judge=full, walked=walked), told


def standing(pick: random.Random, found: Random) -> tuple[Random, Piston] | None:
    """A random mechanism with gas on one of its sliders; None if none of them has a stroke."""
    judge, row = found.judge, Row(found, 0.0, whole=True)
    sliders = sorted({s.slider for s in judge.slides if s.on == 0})
    pins = [(k, x) for k in sliders for x in judge.words.bodies[k].points
            if len(judge.words.standing[x]) > 1]  # fmt: skip
    pick.shuffle(pins)
    for k, letter in pins:
        load = {"of": letter}
        stroke = row.stroke(load)
        if stroke is None:
            continue
        way = math.copysign(1.0, stroke.length) * row.way(load)

        def at(state: State, load: Any = load, stroke: Any = stroke, way: Any = way) -> Any:
            c = row.coordinate(load, state)
            share = (c.place - stroke.begin) / stroke.length
            rate = c.rate / math.copysign(stroke.usual, stroke.length)
            return share, rate, math.degrees(cmath.phase(way))

        order, faces = _faces(pick, found.scale, four=False)
        number = judge.words.bodies[k].number
        return found, Piston(number, letter, 0, at, 0.0, {"point": letter} | order, faces)
    return None


def loaded(kind: str, seed: int) -> tuple[Random, Row, Piston] | None:
    pick = _pick(kind, seed)
    found = next(
        one
        for k in range(50)
        if (one := drawn(seed + 1000 * k, ("crank",), 1 + seed % 3, HELD[kind]))
        and len(one.walked) == ALL_ROUND
    )
    made = swinging(pick, found) if kind == "swings" else standing(pick, found)
    if made is None:
        return None
    found, piston = made
    scene = copy.deepcopy(found.scene)
    scene["drive"]["positions"] = COUNT
    scene["drive"]["zero"] = math.degrees(found.at[0])
    scene["effects"] = scene.get("effects", {}) | {"gas": True}
    scene["indicator"] = piston.order
    found = found._replace(scene=scene)
    return found, Row(found, 0.0, whole=True), piston


def _pick(kind: str, seed: int) -> random.Random:
    return random.Random(f"{kind} {seed} gas")


def compared(kind: str, seeds: range) -> int:
    count = 0
    for seed in seeds:
        made = loaded(kind, seed)
        if made is None:
            continue
        found, row, piston = made
        # between its positions the pressure is read off the diagram as drawn
        steps = _pick(kind, seed).sample(range(-(COUNT // 2), COUNT // 2), 5)
        sense = math.copysign(2.0 * math.pi / COUNT, found.judge.drives[0].rate)
        at = [k * sense for k in steps if _sure(row, piston, k * sense, found.solved(k * sense))]

        def judge(way: float, state: State, row: Row = row, piston: Piston = piston) -> Judge:
            return _pushed(row, piston, way, state)

        off = errors(found, found.scene, at, PLANS, row.first, judge)
        del off["power"]
        assert all(off[name] <= LIMITS[name] for name in off), (kind, seed, off)
        count += bool(at)
    return count


def _pushed(row: Row, piston: Piston, way: float, state: State) -> Judge:
    """A judge with the force of the gas among its loads."""
    judge = sized(row, row.found.judge, way, state)
    sense = math.copysign(1.0, judge.drives[0].rate)
    turned = math.degrees(way) * sense
    force, way_out = piston.force(state, turned), f"{piston.at(state)[2]!r} deg"
    gas: dict[str, Any] = {"link": piston.link, "point": piston.point, "force": force,
                           "direction": way_out}  # fmt: skip
    if piston.cylinder:
        gas["from"] = piston.cylinder
    judge.words.loads = [*judge.words.loads, gas]
    return judge


def _sure(row: Row, piston: Piston, way: float, state: State) -> bool:
    try:
        _pushed(row, piston, way, state)
    except UnsureError:
        return False
    return True


@pytest.mark.parametrize("kind", ["swings", "stands"])
def test_gas(kind: str) -> None:
    assert compared(kind, range(5)) >= 2


@pytest.mark.turns(4)
@pytest.mark.slow
@pytest.mark.parametrize("block", range(4))
@pytest.mark.parametrize("kind", ["swings", "stands"])
def test_gas_oftener(kind: str, block: int) -> None:
    assert compared(kind, range(10 + 10 * block, 20 + 10 * block)) >= 3
