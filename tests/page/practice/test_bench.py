"""The page's benches: what Python draws, they draw; each task can be worked in any order."""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Any

import pytest
from support import drives
from support.benches import Packed, numbers, packed, practised, worked

import graphic_tmm as tmm
from graphic_tmm.checking.records import VERDICTS, WRONG
from graphic_tmm.page.practice.pack import Packing
from graphic_tmm.page.practice.tasks import sheet_row

NEAR = 1e-9
"""So near are two ways to calculate, as a share of what is calculated; mm where it is less than that."""
LARGE = 3.0
"""What is less wrong, mm or the unit of a rate, may be the hand's: lengths of some tenths, ten times over."""


@pytest.fixture(scope="module", params=["windrower", pytest.param("", marks=pytest.mark.slow)])
def answers(
    tmp_path_factory: pytest.TempPathFactory, request: pytest.FixtureRequest
) -> list[tuple[Packed, dict[str, Any]]]:
    """Scenes of the package, and what the page's benches have of them: one every day, some, all if measured."""
    every = request.config.getoption("--measured")
    scenes = [packed(request.param)] if request.param else practised(every=every)
    return list(
        zip(scenes, worked(scenes, {}, tmp_path_factory.mktemp("benches"), work=True), strict=True)
    )


def test_every_step_comes_to_what_python_has(answers: list[tuple[Packed, dict[str, Any]]]) -> None:
    compared = 0
    for scene, answer in answers:
        row = scene.packing.row
        for one in answer["worked"]:
            task, exact = one["task"], one["exact"]
            for step in scene.packing.steps:
                due = numbers(row.reading[step.it], task["at"])
                found = exact[str(step.it.slot)]
                if not row.there(step.it, task["at"]):
                    continue
                compared += 1
                size = max(1.0, *map(abs, due))
                apart = [abs(a - b) for a, b in zip(due, found, strict=True)]
                assert max(apart) < NEAR * size, (scene.name, step.it, task["at"], due, found)
    assert compared > 1_000 * len(answers)


def test_every_task_is_worked_in_two_orders(answers: list[tuple[Packed, dict[str, Any]]]) -> None:
    faults = [
        (scene.name, one["task"]["plan"], one["task"]["at"], order["faults"])
        for scene, answer in answers
        for one in answer["worked"]
        for order in one["solved"]
        if order["faults"]
    ]
    assert faults == []
    orders = [one["solved"] for _, answer in answers for one in answer["worked"]]
    assert sum(first["order"] != last["order"] for first, last in orders) > len(orders) / 2


def test_no_wrong_answer_is_fine(answers: list[tuple[Packed, dict[str, Any]]]) -> None:
    told: Counter[tuple[str, str]] = Counter()
    for scene, answer in answers:
        for one in answer["worked"]:
            for slot, kind, verdict, apart in one["failed"]:
                # what is nothing stays nothing, ten times over; two meetings may be one
                if apart > LARGE:
                    told[kind, verdict] += 1
                    assert kind == "5 mm" or verdict == WRONG, (scene.name, slot, kind, apart)
    shifted = [told["5 mm", verdict] for verdict in VERDICTS]
    # a ray that swings by 0.6° may be off so far at half a metre, as two lines that are almost one may meet; a
    # point of a similar figure may be found by such rays
    assert shifted[0] < 0.015 * sum(shifted), shifted
    assert shifted[2] > 0.8 * sum(shifted), shifted
    assert min(told["ten times", WRONG], told["other meeting", WRONG]) > 5


MATCHES = """
const found = [];
const task = data.tasks.find(({ plan, at }) => data.plans[plan] === "velocities" && at === 1);
const bench = new Bench(data, task);
const named = (name) => bench.task.steps.find((slot) => data.marks[slot].n === name);
const steps = bench.log.steps;
const [square, product, board] = [steps.get(named("(pa)")), steps.get(named("v_A")), steps.get(named("pa"))];
const told = (match) => (match.slot === undefined ? match.why : data.marks[match.slot].n);
found.push(told(bench.match("square", square.uses)), told(bench.match("square", [...square.uses].reverse())));
found.push(told(bench.match("parallel", square.uses)));
found.push(told(bench.match("square", [named("a"), square.uses[1]])));
found.push(told(bench.match(board.op, [named("v_A")])));
bench.take(product.it, bench.due(product.it));
found.push(told(bench.match(board.op, [named("v_A")])), told(bench.match(product.op, product.uses)));
bench.take(square.it);
found.push(told(bench.match("square", square.uses)));
found.push(bench.drop(product.it).map((slot) => data.marks[slot].n).join());
answers.push(found);
"""


def test_an_instrument_applied_to_marks_is_known_as_a_step(tmp_path: Path) -> None:
    found = worked([packed("windrower")], {}, tmp_path, more=MATCHES)  # type: ignore[list-item]
    assert found[0] == [
        *("(pa)", "(pa)", "no such step", "no such step", "not yet"),
        *("pa", "done", "done", "v_A"),
    ]


SAME_BY_ANOTHER_WAY = """
const task = data.tasks.find(({ plan, at }) => data.plans[plan] === "positions" && at === 1);
const bench = new Bench(data, task);
const named = (name) => bench.task.steps.find((one) => data.marks[one].n === name);
for (const one of bench.task.steps) if (one < named("(CD)")) bench.take(one, bench.due(one));
const { uses } = bench.log.steps.get(named("(CD)"));
answers.push([bench.match("join", [...uses].reverse()), bench.match("rocker_line", uses), named("(CD)")]);
"""


def test_what_comes_to_the_same_is_the_same_step(tmp_path: Path) -> None:
    (turned, another, slot), _ = worked(
        [packed("windrower")],  # type: ignore[list-item]
        {},
        tmp_path,
        more=SAME_BY_ANOTHER_WAY,
    )
    assert turned == another == {"slot": slot}


@pytest.mark.parametrize("text", [drives.BOOM, drives.SLIDER, drives.LEVER])
def test_plans_of_any_drive_are_drawn_and_judged_as_in_python(text: str, tmp_path: Path) -> None:
    """A rod's Coriolis acceleration and what else is calculated before it is laid off is rightly drawn, too."""
    made = tmm.draw(drives.scene(text), exact=True)._work.drawn_scene
    row = sheet_row(made)
    assert row is not None
    packing = Packing(made, row, ())
    one = Packed("driven", made, packing, packing.data(()), packing.program())
    (answer,) = worked([one], {}, tmp_path, work=True)
    assert len(answer["worked"]) == 18
    for each in answer["worked"]:
        at = each["task"]["at"]
        assert not any(order["faults"] for order in each["solved"])
        for step in packing.steps:
            if row.there(step.it, at):
                due, found = numbers(row.reading[step.it], at), each["exact"][str(step.it.slot)]
                assert found == pytest.approx(due, rel=NEAR, abs=NEAR)
