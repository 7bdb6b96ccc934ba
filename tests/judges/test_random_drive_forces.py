"""Forces of random mechanisms of sliders, cylinders and several drives, against the judge."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from judges.test_random_drives import POSITIONS, WAYS, judged, random_of
from support.against_judge import clear
from support.free_bodies import Judge
from support.free_forces import Rough, UnsettledError, statics

import graphic_tmm


@pytest.mark.parametrize("kind", WAYS)
def test_forces(kind: str) -> None:
    judged(kind, 3, forces=True)


@pytest.mark.turns(7)
@pytest.mark.slow
@pytest.mark.parametrize("block", range(5))
@pytest.mark.parametrize("kind", WAYS)
def test_forces_oftener(kind: str, block: int) -> None:
    for seed in range(10 + 10 * block, 20 + 10 * block):
        judged(kind, seed, forces=True)


@pytest.mark.parametrize(
    "kind", ["rod", *(pytest.param(k, marks=pytest.mark.slow) for k in WAYS if k != "rod")]
)
def test_forces_along_a_row(kind: str) -> None:
    """The table of a sheet has at every place of its row what balances each drive there."""
    found, scene = random_of(kind, 4, forces=True)
    scene["drive"] = _all_accelerated(scene["drive"])
    forward = found.judge.drives[0].rate > 0
    ends = found.walked[0][0], found.walked[-1][0]
    first, last = ends if forward else ends[::-1]
    table = tabled(scene).table("forces")
    for k, way in enumerate(np.linspace(first, last, POSITIONS)):
        due = statics(found.judge, found.solved(way), math.degrees(abs(way - first)))
        moment = found.judge.words.balance == "moment"
        letter, arm = ("M", found.judge.size) if moment else ("P", 1.0)
        further = found.judge.words.drives[1:]
        names = {f"{letter}_bal_{name}": due.drives[0] for name in ("forces", "lever")}
        for d, p in zip(further, due.drives[1:], strict=True):
            names |= {f"{letter}_bal_{d['link']}{method}": p for method in ("", "_lever")}
        for name, balance in names.items():
            value = table[name].value[0, k]
            assert value == pytest.approx(balance, abs=1e-8 * due.largest * arm), (k, name)


def tabled(scene: dict[str, Any]) -> graphic_tmm.Drawn:
    """Draw a scene for its tables: on a sheet of positions alone no sizes of other plans are looked for."""
    sheet = [{"format": "A1", "place": ["positions"]}]
    return graphic_tmm.draw(graphic_tmm.read({**scene, "sheet": sheet}), exact=True)


@pytest.mark.turns(9)
@pytest.mark.parametrize(
    "kind", ["open crank", *(pytest.param(k, marks=pytest.mark.slow) for k in ("slider", "rod"))]
)
@pytest.mark.parametrize(
    "seed", [5, *(pytest.param(k, marks=pytest.mark.slow) for k in range(6, 26))]
)
def test_what_stands(kind: str, seed: int) -> None:
    """At speed zero only its own acceleration moves it: loads, weights, ε; nothing has a power."""
    found, scene = random_of(kind, seed, forces=True)
    scene["drive"] = {**scene["drive"], "speed": 0, "accelerations": "all"}
    turns = [load for load in scene.get("load", ()) if "against" not in load.get("direction", "")]
    scene["load"] = [x for x in turns if "direction" in x or "moment" in x]
    judge, gained = Judge(scene), scene["drive"].get("acceleration")
    table = tabled(scene).table("forces")
    forward = found.judge.drives[0].rate > 0
    ends = found.walked[0][0], found.walked[-1][0]
    first, last = ends if forward else ends[::-1]
    for k, way in enumerate(np.linspace(first, last, POSITIONS)):
        state = judge.solve(found.coordinates(way), found.solved(way).poses)
        assert gained or not any(state.epsilon.values())
        due = statics(judge, state, math.degrees(abs(way - first)))
        moment = judge.words.balance == "moment"
        letter, arm = ("M", judge.size) if moment else ("P", 1.0)
        for name in ("forces", "lever"):
            value = table[f"{letter}_bal_{name}"].value[0, k]
            assert value == pytest.approx(due.drives[0], abs=1e-8 * due.largest * arm), (k, name)


def _all_accelerated(drives: object) -> object:
    """The drives, the first with a plan of accelerations in every position."""
    if isinstance(drives, list):
        return [_all_accelerated(drives[0]), *drives[1:]]
    assert isinstance(drives, dict)
    return {**drives, "accelerations": "all"}


@pytest.mark.turns(6)
@pytest.mark.slow
@pytest.mark.parametrize("kind", ["slider", "rod", "open crank"])
@pytest.mark.parametrize("seed", range(7, 18))
def test_rates_of_each_position(kind: str, seed: int) -> None:
    """A drive of another speed and acceleration at every place: ω, ε, and what balances it."""
    found, scene = random_of(kind, seed, forces=True)
    rate, unit = abs(found.judge.drives[0].rate), "rad/s" if kind == "open crank" else "m/s"
    speeds = [f"{rate * (0.3 + 0.3 * k)!r} {unit}" for k in range(POSITIONS)]
    gains = [f"{0.1 * rate * (k - 2)!r} {unit}2" for k in range(POSITIONS)]
    motion = {"speed": speeds, "acceleration": gains, "accelerations": "all"}
    sheet = tabled({**scene, "drive": {**scene["drive"], **motion}})
    tables = {name: sheet.table(name) for name in ("velocities", "accelerations", "forces")}
    ends = found.walked[0][0], found.walked[-1][0]
    first, last = ends if found.judge.drives[0].rate > 0 else ends[::-1]
    for k, way in enumerate(np.linspace(first, last, POSITIONS)):
        there = {**scene["drive"], "speed": speeds[k], "acceleration": gains[k]}
        judge = Judge({**scene, "drive": there})
        state = judge.solve(found.coordinates(way), found.solved(way).poses)
        due = statics(judge, state, math.degrees(abs(way - first)))
        for table, letter, turns in (
            ("velocities", "omega", state.omega),
            ("accelerations", "epsilon", state.epsilon),
        ):
            largest = max(map(abs, turns.values()))
            for number, turn in turns.items():
                if (name := f"{letter}{number}") in tables[table]:
                    value = tables[table][name].value[0, k]
                    assert value == pytest.approx(turn, abs=1e-9 * largest), (k, name)
        if clear(found, state):
            moment = judge.words.balance == "moment"
            letter, arm = ("M", judge.size) if moment else ("P", 1.0)
            for name in ("forces", "lever"):
                value = tables["forces"][f"{letter}_bal_{name}"].value[0, k]
                assert value == pytest.approx(due.drives[0], abs=1e-8 * due.largest * arm), (
                    k,
                    name,
                )


ROUGH = 0.05
"""How rough every pair is; its pins have a fiftieth of the mechanism's size."""


@pytest.mark.turns(14)
@pytest.mark.parametrize(
    "kind", ["rod", *(pytest.param(k, marks=pytest.mark.slow) for k in WAYS if k != "rod")]
)
@pytest.mark.parametrize(
    "seed", [3, *(pytest.param(k, marks=pytest.mark.slow) for k in range(4, 12))]
)
def test_friction_of_any_drives(kind: str, seed: int) -> None:
    """Twelve passes come within what they leave open of the judge's two hundred; η is a ratio of powers."""
    found, scene = random_of(kind, seed, forces=True)
    judge = found.judge
    # at one place, to the scale of positions alone, η has no sure digit, and is left out
    whole = (kind, seed) == ("two cranks", 11)
    scene["effects"] = {**scene.get("effects", {}), "friction": True}
    scene["friction"] = {"f": ROUGH, "radius": f"{0.02 * judge.size!r} m", "passes": 12}
    links = [drive["link"] for drive in judge.words.drives]
    rough = {letter: Rough(ROUGH, 0.02 * judge.size) for letter, _, _ in judge.pins}
    rough |= {
        slide.name: Rough(ROUGH)
        for slide in judge.slides
        if slide.on == 0 or judge.words.bodies[slide.slider].number not in links
    }
    drawn = graphic_tmm.draw(graphic_tmm.read(scene), exact=True) if whole else tabled(scene)
    table = drawn.table("forces")
    ends = found.walked[0][0], found.walked[-1][0]
    first, last = ends if judge.drives[0].rate > 0 else ends[::-1]
    letter, arm = ("M", judge.size) if judge.words.balance == "moment" else ("P", 1.0)
    stems = [f"{letter}_bal_forces", *(f"{letter}_bal_{link}" for link in links[1:])]
    opens = [f"{letter}_bal_open", *(f"{stem}_open" for stem in stems[1:])]
    levers = [f"{letter}_bal_lever", *(f"{stem}_lever" for stem in stems[1:])]
    compared = 0
    for k, way in enumerate(np.linspace(first, last, POSITIONS)):
        state, turned = found.solved(way), math.degrees(abs(way - first))
        try:
            smooth, due = (statics(judge, state, turned, how) for how in (None, rough))
        except UnsettledError:
            continue
        values = [table[stem].value[0, k] for stem in stems]
        if not np.isfinite(values).all():
            continue  # passes that do not settle
        compared += 1
        for value, wanted, left, lever in zip(values, due.drives, opens, levers, strict=True):
            still = np.nan_to_num(table[left].value[0, k])  # none where only rounding is left of it
            near = 1.5 * still + 1e-9 * due.largest * arm
            assert value == pytest.approx(wanted, abs=near), (k, left)
            assert table[lever].value[0, k] == pytest.approx(value, abs=near), (k, lever)
        if letter == "M" or not any(drive.kind == "turn" for drive in judge.drives):
            rates = [drive.rate for drive in judge.drives]
            both = [float(np.dot(one.drives, rates)) for one in (smooth, due)]
            share = 100.0 * min(both, key=abs) / max(both, key=abs)
            told = table["efficiency"].value[0, k]
            assert np.isnan(told) == (share < 0.0 or abs(both[0]) > abs(both[1]) > 0.0 < both[0])
            assert np.isnan(told) or told == pytest.approx(share, abs=0.1)
    assert compared >= POSITIONS // 2
