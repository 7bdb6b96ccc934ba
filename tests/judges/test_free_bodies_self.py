"""The judge of all links at once: published figures, differences of places, power, the older judge."""

from __future__ import annotations

import cmath
import math
from typing import Any

import numpy as np
import pytest
from support import dynamics, oracle
from support.free_bodies import Judge
from support.free_forces import statics
from support.loaded import weighed
from support.mechanisms import Sampled, sample
from support.random_mechanisms import Random, drawn

WAYS = [("crank",), ("slider",), ("rod",), ("crank", "crank"), ("crank", "rod"), ("slider", "rod")]


def random_of(drives: tuple[str, ...], seed: int = 0) -> Random:
    return next(r for k in range(9) if (r := drawn(seed + 100 * k, drives, 3)))


def boom() -> dict[str, Any]:
    """A cylinder drives a lever."""
    return {
        "frame": {"O": [0, 0], "G": [0.4, 0]},
        "link": [
            {"number": 1, "points": {"O": [0, 0], "N": [0.5, 0], "C": [1.0, 0]}},
            {"number": 2, "points": {"G": [0, 0]}, "guides": {"z": {}}},
            {
                "number": 3,
                "points": {"N": [0, 0]},
                "slides": {"on": 2, "along": "z", "side": "+"},
            },
        ],
        "drive": {"link": 3, "speed": "0.05 m/s"},
    }


def test_a_boom_has_its_published_figures() -> None:
    turn = math.acos((0.25 + 0.16 - 0.36) / 0.4)
    n = cmath.rect(0.5, turn)
    along = cmath.phase(n - 0.4)
    state = Judge(boom()).solve([0.6], [(0j, turn), (0.4 + 0j, along), (n, along)])
    assert state.omega[1] == pytest.approx(0.151186, abs=1e-6)
    assert state.omega[2] == pytest.approx(0.094491, abs=1e-6)
    assert state.epsilon[1] == pytest.approx(0.00972, abs=1e-5)
    assert abs(state.point("C", 1)[1]) == pytest.approx(0.151186, abs=1e-6)


def test_a_slider_that_drives_has_its_published_figures() -> None:
    links = [
        {"number": 1, "points": {"B": [0, 0]}, "slides": {"on": "frame", "along": "x"}},
        {"number": 2, "points": {"A": [0, 0], "B": [0.3, 0]}},
        {"number": 3, "points": {"O": [0, 0], "A": [0.1, 0]}},
    ]
    scene = {"frame": {"O": [0, 0], "x": {}}, "link": links}
    a = cmath.rect(0.1, math.pi / 3)
    b = 0.05 + math.sqrt(0.09 - 0.0075)
    state = Judge(scene | {"drive": {"link": 1, "speed": "0.5 m/s"}}).solve(
        [b], [(b + 0j, 0.0), (a, cmath.phase(b - a)), (0j, math.pi / 3)]
    )
    assert state.omega[3] == pytest.approx(-4.917479, abs=1e-6)
    assert state.omega[2] == pytest.approx(0.856023, abs=1e-6)
    assert state.epsilon[3] == pytest.approx(-7.93943, abs=1e-5)


def test_two_cranks_have_their_published_figures() -> None:
    links = [
        {"number": 1, "points": {"O": [0, 0], "A": [0.1, 0]}},
        {"number": 2, "points": {"A": [0, 0], "B": [0.3, 0]}},
        {"number": 3, "points": {"C": [0, 0], "B": [0.3, 0]}},
        {"number": 4, "points": {"D": [0, 0], "C": [0.1, 0]}},
    ]
    drives = [{"link": 1, "speed": 5}, {"link": 4, "speed": 10, "turns": "clockwise"}]
    scene = {"frame": {"O": [0, 0], "D": [0.3, 0]}, "link": links, "drive": drives}
    turns = math.radians(60), math.radians(120)
    a, c = cmath.rect(0.1, turns[0]), 0.3 + cmath.rect(0.1, turns[1])
    b = (a + c) / 2 + 1j * math.sqrt(0.09 - abs(c - a) ** 2 / 4) * (c - a) / abs(c - a)
    poses = [(0j, turns[0]), (a, cmath.phase(b - a)), (c, cmath.phase(b - c)), (0.3 + 0j, turns[1])]
    state = Judge(scene).solve(turns, poses)
    assert state.point("B", 2)[1] == pytest.approx(-0.137047 + 0.145360j, abs=1e-6)
    assert state.omega[2] == pytest.approx(-1.046397, abs=1e-6)
    assert state.omega[3] == pytest.approx(3.546397, abs=1e-6)


@pytest.mark.parametrize("drives", WAYS)
def test_rates_are_differences_of_places(drives: tuple[str, ...]) -> None:
    """Places know the rates only as coordinates at three times, 0.1 ms of a radian apart."""
    found = random_of(drives)
    now, step = found.solved(0.0), 1e-4 / max(abs(d.rate) for d in found.judge.drives)
    step *= min(1.0, found.scale)
    around = []
    for t in (-step, step):
        at = [
            q + d.rate * t + d.gain * t * t / 2
            for q, d in zip(found.at, found.judge.drives, strict=True)
        ]
        around.append(found.judge.solve(at, now.poses))
    before, after = (np.array([*s.z, *s.t]) for s in around)
    middle = np.array([*now.z, *now.t])
    first, second = (after - before) / (2 * step), (after - 2 * middle + before) / step**2
    for due, rates in ((first, [*now.dz, *now.w]), (second, [*now.ddz, *now.e])):
        off = np.abs(due - np.array(rates)).max()
        assert off <= 1e-4 * np.abs(due).max(), drives


@pytest.mark.parametrize("drives", WAYS)
def test_all_that_acts_has_no_power(drives: tuple[str, ...]) -> None:
    for seed in range(2):
        found = random_of(drives, seed)
        state = found.solved(found.walked[0][0])
        due = statics(found.judge, state)
        assert abs(due.power) < 1e-14
        assert len(due.drives) == len(drives)


def scene_of(drawn: Sampled, loaded: dynamics.Loaded, balance: str) -> dict[str, Any]:
    """A mechanism of the older generator as tables."""

    def pair(z: complex) -> list[float]:
        return [z.real, z.imag]

    def guides(link: Any) -> dict[str, Any]:
        return {g.name: {"through": pair(g.through), "angle": g.angle} for g in link.guides}

    def table(link: Any) -> dict[str, Any]:
        slides = [
            {"on": s.on, "along": s.guide.name, "offset": s.offset, "angle": s.angle}
            for s in link.slides
        ]
        given = {"mass": link.mass, "J": link.inertia, "centre": link.centre}
        points = {x: pair(p) for x, p in link.points.items()}
        links = {"number": link.number, "points": points, "guides": guides(link), "slides": slides}
        return links | {key: value for key, value in given.items() if value is not None}

    mechanism = loaded.mechanism
    frame: dict[str, Any] = {x: pair(p) for x, p in mechanism.frame.points.items()}
    drive, sense = mechanism.drive, mechanism.drive.sense
    forces = [
        {
            "link": k,
            "point": x,
            "force": abs(f),
            "direction": math.degrees(math.atan2(f.imag, f.real)),
        }
        for k, x, f in loaded.forces
    ]
    return {
        "frame": frame | {"number": mechanism.frame.number} | guides(mechanism.frame),
        "link": [table(link) for link in mechanism.links],
        "drive": {
            "link": drive.link,
            "speed": abs(drive.speed),
            "acceleration": sense * drive.acceleration,
            "turns": "clockwise" if sense < 0 else "counterclockwise",
        },
        "effects": {"gravity": True, "inertia": True},
        "load": [*forces, *({"link": k, "moment": m} for k, m in loaded.moments)],
        "forces": {"balance": balance},
    }


def test_it_agrees_with_the_older_judge() -> None:
    compared = 0
    for k, drawn_ in enumerate(sample(25, seed=5)):
        loaded = weighed(drawn_, k)
        balance: Any = ("force", "moment")[k % 2]
        due = oracle.solve_fast(drawn_.mechanism, drawn_.phi, drawn_.poses)
        if due.condition > 1e4:
            continue
        judge = Judge(scene_of(drawn_, loaded, balance))
        near = [drawn_.poses[body.number] for body in judge.words.bodies[1:]]
        state = judge.solve([math.radians(drawn_.phi)], [(complex(x, y), t) for x, y, t in near])
        keys = [key for key in due.points if isinstance(key, tuple)]
        for part in range(3):
            largest = max(abs(due.points[key][part]) for key in keys)
            for key in keys:
                assert abs(due.points[key][part] - state.point(*key)[part]) < 1e-10 * largest
        forces = dynamics.statics(
            loaded.mechanism, due, loaded.forces, loaded.moments, gravity=True, inertia=True, balance=balance
        )  # fmt: skip
        found = statics(judge, state)
        arm = judge.size if balance == "moment" else 1.0
        assert abs(found.drives[0] - forces.balance) < 1e-9 * max(found.largest, 1e-9) * arm
        if all(len(on) < 3 for on in judge.words.standing.values()):
            for both, force in forces.reactions.items():
                assert abs(found.reactions[both] - force) < 1e-9 * found.largest
            compared += 1
    assert compared > 5
