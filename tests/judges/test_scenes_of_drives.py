"""Shipped scenes that no single turning crank drives, in every position against the judge of all links."""

from __future__ import annotations

import cmath
import math
import re
import tomllib
from collections.abc import Iterator
from functools import cache
from typing import Any

import numpy as np
import pytest
from support.free_bodies import Judge, State
from support.free_forces import G, statics
from support.gallery import NAMES, SHEETS, drawn, one_crank, scene
from support.scene_words import si

import graphic_tmm
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
            turn = math.radians(-body.angle) + cmath.phase(_at(line.along, place))
            at = origin + mu * _at(line.at, place)
        elif not link.slides:
            first, last = list(body.own)[:2]
            spots = [_at(work.reading[body.marks[letter]], place) for letter in (first, last)]
            turn = cmath.phase((spots[1] - spots[0]) / (body.own[last] - body.own[first]))
            spot = spots[0] - body.own[first] * cmath.rect(1.0 / mu, turn)
            found.append((origin + mu * spot, turn))
            continue
        else:
            (slide,) = link.slides
            turn = math.radians(slide.guide.angle + slide.angle)
            letter = next(k for k, own in body.own.items() if own == body.at)
            at = origin + mu * _at(work.reading[body.marks[letter]], place)
        found.append((at - body.at * cmath.rect(1.0, turn), turn))
    return found


def _at(values: Any, place: int) -> complex:
    row = np.ravel(values)
    return complex(row[place % row.size])


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
    """The scene, its named lengths in their places; what stands with the speed of possible velocities."""
    text = (SHEETS / name / "scene.toml").read_text("utf-8")
    lengths: dict[str, str] = tomllib.loads(text).get("lengths", {})
    for letter, length in lengths.items():
        text = re.sub(rf'([\[,] ?)"{letter}"(?= ?[],])', rf'\1"{length}"', text)
    told = tomllib.loads(text)
    told["drive"] = told["drive"] if isinstance(told["drive"], list) else [told["drive"]]
    for k, one in enumerate(told["drive"] if scene(name).mechanism.at_rest else ()):
        one["speed"] = 1.0 if k == 0 else 0.0
    return told


@pytest.mark.every
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


@pytest.mark.every
@pytest.mark.parametrize("name", [name for name in OTHERS if "forces" in scene(name).told])
def test_every_row_of_the_table_of_forces_is_what_its_name_and_unit_say(name: str) -> None:
    table, told = graphic_tmm.draw(name, exact=True).table("forces"), _tables(name)
    (place,) = (k for k, v in enumerate(next(iter(table.values())).value[0]) if np.isfinite(v))
    if unknown := told["forces"].get("unknown"):
        sought = {**unknown, "force": table["P_tool"].value[0, place]}
        told["load"] = [*told["load"], sought]
        assert table["P_tool"].unit == "N"
    judge, state = Judge(told), states(name)[place]
    due, moment = statics(judge, state), judge.words.balance == "moment"
    rows = dict(_loads(judge, state))
    rows |= {f"R{i}{j}": ("N", abs(one)) for (i, j), one in due.reactions.items()}
    letter, unit = ("M", "N·m") if moment else ("P", "N")
    first, *further = due.drives
    rows |= {f"{letter}_bal_{way}": (unit, first) for way in ("forces", "lever", "left")}
    links = [drive["link"] for drive in judge.words.drives[1:]]
    for link, one in zip(links, further, strict=True):
        rows |= {f"P_bal_{link}{method}": ("N", one) for method in ("", "_lever")}
        rows[f"P_bal_{link}_difference"] = ("%", 0.0)
    rows[f"{letter}_bal_difference"] = ("%", 0.0)
    for column in table.keys() - {"P_tool", "advantage"}:
        unit, size = rows[column]
        assert table[column].unit == unit, column
        found = table[column].value[0, place]
        assert found == pytest.approx(size, rel=1e-9, abs=1e-8 * due.largest), column


def _loads(judge: Judge, state: State) -> Iterator[tuple[str, tuple[str, float]]]:
    """What acts on the links, by the names of the table: units and sizes."""
    for load in judge.words.loads:
        yield f"F{load['link']}", ("N", abs(si(load["force"])))
    for body in judge.words.bodies[1:]:
        k = body.number
        if body.mass is not None and body.centre is not None:
            yield f"G{k}", ("N", G * body.mass)
            yield f"Pi{k}", ("N", body.mass * abs(state.point(body.centre, k)[2]))
        if body.inertia is not None:
            yield f"Mi{k}", ("N·m", -body.inertia * state.epsilon[k])


def test_there_are_such_scenes_of_every_sort() -> None:
    mechanisms = [scene(name).mechanism for name in OTHERS]
    assert any(one.further for one in mechanisms)
    assert any(one.at_rest for one in mechanisms)
    assert any(one.drive.slides for one in mechanisms)
