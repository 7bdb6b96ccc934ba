"""Shipped scenes that no single turning crank drives, in every position against the judge of all links."""

from __future__ import annotations

import cmath
import math
import tomllib
from functools import cache
from typing import Any

import numpy as np
import pytest
from support.free_bodies import Judge, State
from support.gallery import NAMES, SHEETS, drawn, one_crank, scene

from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN, KinematicPlans
from graphic_tmm.drawn import Drawn

OTHERS = [name for name in NAMES if not one_crank(name)]
RATIO = 1e-9


def _poses(work: Drawn, plans: KinematicPlans, place: int) -> list[tuple[complex, float]]:
    """Where the drawing puts every link: its origin (m, sheet's axes) and its angle."""
    mu, found = work.scales["positions"].value, []
    origin = plans.mechanism.frame.points[plans.structure.origin]
    for link in plans.mechanism.links:
        body = plans.positions.bodies[link.number]
        if body.drawn:
            line = work.reading[body.axis]
            turn = math.radians(-body.angle) + cmath.phase(np.ravel(line.along)[place])
            at = origin + mu * complex(np.ravel(line.at)[place])
        else:
            (slide,) = link.slides
            turn = math.radians(slide.guide.angle + slide.angle)
            letter = next(k for k, own in body.own.items() if own == body.at)
            at = origin + mu * complex(np.ravel(work.reading[body.marks[letter]])[place])
        found.append((at - body.at * cmath.rect(1.0, turn), turn))
    return found


@cache
def states(name: str) -> list[State]:
    work, told = drawn(name, exact=True), _tables(name)
    plans, judge = KINEMATICS_PLAN.on(work), Judge(told)
    turns = [drive.kind == "turn" for drive in judge.drives]
    found = []
    for place in range(len(work.names)):
        rows = (np.ravel(work.reading[mark]) for mark in plans.positions.row)
        at = [float(row[place % row.size]) for row in rows]
        at = [math.radians(x) if turn else x for x, turn in zip(at, turns, strict=True)]
        found.append(judge.solve(at, _poses(work, plans, place)))
    return found


def _tables(name: str) -> dict[str, Any]:
    """The scene, what stands with the speed that possible velocities have."""
    told = tomllib.loads((SHEETS / name / "scene.toml").read_text("utf-8"))
    told["drive"] = told["drive"] if isinstance(told["drive"], list) else [told["drive"]]
    for k, one in enumerate(told["drive"] if scene(name).mechanism.at_rest else ()):
        one["speed"] = 1.0 if k == 0 else 0.0
    return told


@pytest.mark.parametrize("name", OTHERS)
def test_every_point_moves_as_the_loops_of_all_links_do(name: str) -> None:
    work = drawn(name, exact=True)
    plans = KINEMATICS_PLAN.on(work)
    mu = work.scales["positions"].value
    origin = plans.mechanism.frame.points[plans.structure.origin]
    for place, state in enumerate(states(name)):
        due = {
            (letter, link.number): state.point(letter, link.number)
            for link in plans.mechanism.links
            for letter in link.points
        }
        for k, plan in enumerate((plans.positions, plans.velocities, plans.accelerations)):
            of = ("positions", "velocities", "accelerations")[k]
            if plan is None or (k and place not in work.row(of)):
                continue
            reading = work.reading if k == 0 else work.of(of)
            scale = mu if k == 0 else work.scales[of].value
            at = place if k == 0 else work.row(of).index(place)
            largest = max(abs(one[k]) for one in due.values())
            for (letter, number), one in due.items():
                mark = (
                    plans.positions.bodies[number].marks[letter]
                    if k == 0
                    else plan.images.by_letter[number][letter]
                )
                row = np.ravel(reading[mark])
                own = scale * complex(row[at % row.size]) + (origin if k == 0 else 0.0)
                assert abs(own - one[k]) <= RATIO * largest, (of, letter, place)


def test_there_are_such_scenes_of_every_sort() -> None:
    mechanisms = [scene(name).mechanism for name in OTHERS]
    assert any(one.further for one in mechanisms)
    assert any(one.at_rest for one in mechanisms)
    assert any(one.drive.slides for one in mechanisms)
