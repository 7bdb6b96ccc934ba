"""Instantaneous centres of random mechanisms: both links have one velocity there, says who knows velocities."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
import pytest
from support.mechanisms import sample
from support.oracle import solve_fast
from support.oracle_gears import OracleError
from support.random_mechanisms import drawn

import graphic_tmm as tmm
from graphic_tmm.board.execute import execute
from graphic_tmm.chapters.centres.record import CENTRES_PLAN
from graphic_tmm.chapters.centres.task import ASKED, CentresTask
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.mechanism.records import Row
from graphic_tmm.project import Project, record
from graphic_tmm.scene.records import Scene, SheetOrder

CLOSE = 1e-9
"""Of the mechanism's size, or of how far a centre lies off it."""
EASY, FAR = 1e3, 1e3
"""Conditions of the mechanism up to which it is judged; centres no farther off than so many of its sizes."""
DRIVES = (
    ("crank",),
    ("slider",),
    ("rod",),
    ("crank", "crank"),
    ("crank", "rod"),
    ("slider", "rod"),
)


class Moving(NamedTuple):
    """The origins of links, their velocities (m, m/s), how fast they turn (1/s), by number; the size, m."""

    z: dict[int, complex]
    v: dict[int, complex]
    w: dict[int, float]
    size: float

    def apart(self, links: tuple[int, int], spot: complex) -> complex:
        """How much faster one link moves there than the other."""
        first, second = (self.v[k] + 1j * self.w[k] * (spot - self.z[k]) for k in links)
        return first - second


class Judged(NamedTuple):
    """How many centres were judged, how many have no place though they have one."""

    seen: int
    missing: int
    lost: int


def judged(project: Project, moving: Moving, place: int, origin: complex) -> Judged:
    """Hold the centres of a position against velocities."""
    made, log = CENTRES_PLAN.on(project), project.construction
    given = {**dict.fromkeys(log.given, 1.0), **project.given}
    reading = execute(log, given, [one.mark for one in made.centres])
    rates = max(abs(w) for w in moving.w.values())
    speeds = max([*map(abs, moving.v.values()), rates * moving.size])
    seen = missing = 0
    for one in made.centres:
        i, j = one.links
        turning = abs(moving.w[i] - moving.w[j])
        value: Any = reading[one.mark]
        if one.far:
            way = _at(value.along, place)
            off = moving.apart(one.links, moving.z[i])
            assert turning * moving.size <= CLOSE * speeds, one
            assert abs((off * way.conjugate()).real) <= CLOSE * speeds, one
            seen += 1
            continue
        spot = _at(value, place)
        if spot != spot or turning * moving.size < 1e-6 * speeds:
            missing += int(turning * moving.size >= 1e-6 * speeds)
            continue
        away = abs(spot)
        off = abs(moving.apart(one.links, spot + origin)) / turning
        if away <= FAR * moving.size:
            assert off <= CLOSE * max(moving.size, away) * max(1.0, away / moving.size), (
                one,
                off / moving.size,
            )
            seen += 1
    _velocities(project, moving, place, origin)
    return Judged(seen, missing, len(made.lost))


def _velocities(project: Project, moving: Moving, place: int, origin: complex) -> None:
    """Hold what is found by the centres against what is known."""
    made, log = CENTRES_PLAN.on(project), project.construction
    wanted = [one.omega for one in made.rotations if one.omega is not None]
    wanted += [one.value for one in made.speeds]
    points = {mark: of for of, mark in made.points.items()}
    given = {**dict.fromkeys(log.given, 1.0), **project.given}
    reading = execute(log, given, [*wanted, *points])
    rates = max(abs(w) for w in moving.w.values())
    for one in made.rotations:
        due = moving.w[one.link]
        if one.still:
            assert abs(due) <= CLOSE * rates
        elif one.omega is not None and not one.alike:
            value = _at(reading[one.omega], place).real
            if value == value:
                assert abs(value - due) <= 1e-7 * rates, (one, value, due)
    for speed in made.speeds:
        value = _at(reading[speed.value], place).real
        mark = next(k for k, of in points.items() if of.name == speed.letter)
        spot = _at(reading[mark], place) + origin
        due = abs(moving.v[speed.link] + 1j * moving.w[speed.link] * (spot - moving.z[speed.link]))
        if value == value:
            assert abs(value - due) <= 1e-7 * max(due, rates * moving.size), (speed, value, due)


def _at(value: Any, place: int) -> complex:
    return complex(value[0, place if value.shape[1] > 1 else 0])


def of_cranks(count: int, seed: int) -> Iterator[tuple[Project, Moving, complex]]:
    """Random mechanisms of a crank and one to three groups, in the position in which they were drawn."""
    for one in sample(count, seed):
        try:
            state = solve_fast(one.mechanism, one.phi, one.poses)
        except OracleError:
            continue
        if not state.condition <= EASY:
            continue
        row = Row(8, 0, one.phi, (), ())
        scene = Scene(
            "random", "random", "en", one.mechanism, row, sheets=(SheetOrder("A1", ("centres",)),)
        )
        project = record(ASKED.put(scene, CentresTask(("0",))))
        numbers = [*one.mechanism.by_number]
        q, dq = (np.asarray(part, dtype=float) for part in state.rates[:2])
        z = {n: complex(*q[k][:2]) * state.size for k, n in enumerate(numbers)}
        v = {n: complex(*dq[k][:2]) * state.size for k, n in enumerate(numbers)}
        w = {n: float(dq[k][2]) for k, n in enumerate(numbers)}
        yield project, Moving(z, v, w, state.size), _origin(project)


def _origin(project: Project) -> complex:
    made = KINEMATICS_PLAN.on(project)
    return made.mechanism.frame.points[made.structure.origin]


def of_drives(drives: tuple[str, ...], seeds: range) -> Iterator[tuple[Project, Moving, complex]]:
    """Random mechanisms of any drives, in the middle of their row."""
    for seed in seeds:
        found = drawn(seed, drives, 1 + seed % 3)
        if found is None:
            continue
        low, high = found.walked[0][0], found.walked[-1][0]
        told = found.row(low, high, 5)
        scene = {k: v for k, v in told.items() if k not in ("load", "spring", "forces", "effects")}
        scene |= {"centres": {"positions": [2]}, "sheet": [{"format": "A1", "place": ["centres"]}]}
        project = record(tmm.read(scene))
        state = found.solved((low + high) / 2)
        if not state.condition <= EASY:
            continue
        size, index = found.judge.size, found.judge.index
        z = {n: complex(state.z[k]) * size for n, k in index.items()}
        v = {n: complex(state.dz[k]) * size for n, k in index.items()}
        w = {n: float(state.w[k]) for n, k in index.items()}
        yield project, Moving(z, v, w, size), _origin(project)


@pytest.mark.turns(1)
@pytest.mark.parametrize("block", range(10))
def test_cranks_with_groups_of_every_kind(block: int) -> None:
    """One to three groups."""
    every = [judged(*one[:2], 0, one[2]) for one in of_cranks(30, block)]
    assert sum(one.seen for one in every) > 300
    assert sum(one.missing + one.lost for one in every) == 0


@pytest.mark.turns(2)
@pytest.mark.parametrize("block", range(5))
@pytest.mark.parametrize("drives", DRIVES, ids="+".join)
def test_any_drives(drives: tuple[str, ...], block: int) -> None:
    every = [
        judged(*one[:2], 2, one[2]) for one in of_drives(drives, range(10 * block, 10 * block + 10))
    ]
    assert sum(one.seen for one in every) > 50
    assert sum(one.missing for one in every) == 0
    assert sum(one.lost for one in every) <= 2
