"""What a student's steps are worth, and how near a mark has to be: asked of the page's own task."""

from __future__ import annotations

from typing import Any

import pytest
from support.benches import by_node, packed

PROGRAM = """
import { readFileSync, writeFileSync } from "node:fs";
const [, , asked, answered] = process.argv;
const { Session } = await import("./practice/session.js");
const { instrumentOf } = await import("./practice/palette.js");
const [{ written, data }] = JSON.parse(readFileSync(asked, "utf8"));
await import(`./practice/${written}`);
const page = { title: "", practice: data, words: {}, views: [] };
const n = data.tasks.findIndex((one) => data.plans[one.plan] === "velocities");
const { task, bench, easel } = new Session(page, n);
const move = task.moves.find((one) => easel.kindOf(one.it) === "point");
for (const { it } of task.moves.slice(0, task.moves.indexOf(move))) task.take(it, null);
const due = bench.due(move.it);
const across = [-due.im / Math.hypot(due.re, due.im), due.re / Math.hypot(due.re, due.im)];
const answers = [];
for (const off of [5, 1.4, 0.3]) {
  task.asked = move;
  const found = { re: due.re + off * across[0], im: due.im + off * across[1] };
  const { missed } = task.tell(found, ["", ""], { x: 0.005, y: 0.005 });
  task.leave();
  const { once, wrong } = task.score.tally();
  answers.push({ missed, wrong, mark: task.score.marks.get(move.it), refused: task.refused !== null, once });
}
const fresh = new Session(page, n);
fresh.clear();
first_steps: for (const one of fresh.task.moves) {
  if (one.op !== "parallel" && one.op !== "perpendicular") fresh.task.take(one.it, null);
  const can = fresh.task.moves.filter((two) => !fresh.task.isDone(two.it) && fresh.bench.ready(two.it));
  for (const two of can.slice(1)) {
    const { name } = instrumentOf(two.op);
    if (name === instrumentOf(can[0].op).name) continue;
    fresh.task.choose(name);
    answers.push({ asked: name, helped: instrumentOf(fresh.task.own.get(fresh.task.help().slot).op).name });
    break first_steps;
  }
}
const { plainSlip } = await import("./practice/slips.js");
answers.push([[473, 47.3], [0.473, 47.3], [-47.3, 47.3], [51, 47.3], [473, 51]].map((two) => plainSlip(...two)));
writeFileSync(answered, JSON.stringify(answers));
"""


@pytest.fixture(scope="module")
def told(tmp_path_factory: pytest.TempPathFactory) -> list[dict[str, Any]]:
    scene = packed("crank-rocker")
    assert scene is not None
    found: list[dict[str, Any]] = by_node(PROGRAM, [scene], [{}], tmp_path_factory.mktemp("tally"))
    return found


def test_what_is_wrong_and_stands_is_counted_so_until_it_is_done_right(told: Any) -> None:
    far, _, near = told[:3]
    assert (far["mark"], far["wrong"]) == ("wrong", 1)
    assert (near["mark"], near["wrong"]) == ("helped", 0)


def test_a_mark_beside_its_crossing_is_missed(told: Any) -> None:
    """With a loupe and steps of 0.1 mm a millimetre is plenty."""
    assert [one["missed"] for one in told[:3]] == [True, True, False]


def test_help_is_for_the_instrument_that_was_chosen(told: Any) -> None:
    helped = told[3]
    assert helped["helped"] == helped["asked"]


def test_a_slipped_point_and_a_wrong_sign_are_told(told: Any) -> None:
    found = [one and (one["key"], one["times"]) for one in told[4]]
    assert found == [("times more", 10), ("times less", 100), ("other sense", 1), None, None]
