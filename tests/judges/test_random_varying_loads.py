"""Loads by turn, time, travel and swing on random mechanisms of any drives, against the judge."""

from __future__ import annotations

import copy
import math
import random
from collections.abc import Sequence

import pytest
from judges.test_random_drives import POSITIONS, WAYS
from support.against_judge import LIMITS, PLANS, errors, ways
from support.free_bodies import Judge, State
from support.random_mechanisms import Random, drawn
from support.strokes import Row, UnsureError, sized, varying

from graphic_tmm.errors import StructureError

KINDS = {"whole turn": ("crank",), "two cranks all round": ("crank", "crank"), **WAYS}
ROUND = "whole turn", "two cranks all round"
"""Of the kinds, those whose cranks are seen to go round."""
TURN = 61
"""So many places are walked where nothing stops a crank."""
NO_STROKE = "does not turn back at both ends|shows no swing|a protractor reads 315° at most"


def loaded(kind: str, seed: int, by: Sequence[str] = ()) -> tuple[Random, Row]:
    """A mechanism with loads that vary, and its row; one that goes evenly where they vary ``by`` time."""
    groups = 1 + seed % 3
    found = _mechanism(kind, seed, groups, even="time" in by)
    if kind == "whole turn":
        scene = copy.deepcopy(found.scene)
        scene["drive"]["zero"] = math.degrees(found.at[0])
        row = Row(found, 0.0, whole=True)
    else:
        scene = found.row(found.walked[0][0], found.walked[-1][0], POSITIONS)
        row = Row(found, found.walked[0 if found.judge.drives[0].rate > 0 else -1][0])
    loads = varying(random.Random(f"{kind} {seed} loads"), row, by)
    scene["load"] = [*scene.get("load", ()), *loads]
    return found._replace(scene=scene, judge=Judge(scene)), row


def _mechanism(kind: str, seed: int, groups: int, *, even: bool) -> Random:
    for k in range(50):
        found = drawn(seed + 1000 * k, KINDS[kind], groups)
        if found is None or (even and found.judge.drives[0].gain):
            continue
        if kind not in ROUND or len(found.walked) == TURN:
            return found
    raise AssertionError(kind)


def judged(kind: str, seeds: range, by: Sequence[str] = ()) -> int:
    """Compare some mechanisms; return how many were."""
    compared = 0
    for seed in seeds:
        try:
            found, row = loaded(kind, seed, by)
            going = [load for load in found.scene["load"] if "of" in load]
            none = [load for load in going if row.stroke(load) is None]
        except UnsureError:
            continue
        at = [] if none else [way for way in ways(found, 3) if _sure(found, row, way)]
        if none:
            with pytest.raises(StructureError, match=NO_STROKE):
                errors(found, found.scene, ways(found, 2))
        elif at:
            off = _errors(found, row, at)
            assert all(off[name] <= LIMITS[name] for name in off), (kind, seed, off)
            compared += 1
    return compared


def _errors(found: Random, row: Row, at: list[float]) -> dict[str, float]:
    def judge(way: float, state: State) -> Judge:
        return sized(row, found.judge, way, state)

    off = errors(found, found.scene, at, PLANS, row.first, judge)
    return {name: value for name, value in off.items() if name != "power"}  # the judge's own


def _sure(found: Random, row: Row, way: float) -> bool:
    try:
        sized(row, found.judge, way, found.solved(way))
    except UnsureError:
        return False
    return True


@pytest.mark.parametrize("kind", ROUND)
def test_loads_that_vary(kind: str) -> None:
    assert judged(kind, range(2)) >= 1


@pytest.mark.parametrize("kind", KINDS)
def test_loads_by_time(kind: str) -> None:
    assert judged(kind, range(20, 23), ["time"]) >= 1


@pytest.mark.turns(len(KINDS))
@pytest.mark.slow
@pytest.mark.parametrize("block", range(4))
@pytest.mark.parametrize("kind", KINDS)
def test_loads_that_vary_oftener(kind: str, block: int) -> None:
    count = 2 if WAYS.get(kind, ("crank",)).count("crank") else 6
    assert judged(kind, range(10 + count * block, 10 + count * (block + 1))) >= 1
