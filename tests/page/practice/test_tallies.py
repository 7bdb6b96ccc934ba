"""What a student's steps are worth, and how near a mark has to be: asked of the page's own task."""

from __future__ import annotations

from typing import Any

import pytest
from support.benches import by_node, packed

PROGRAM = """
import { readFileSync, writeFileSync } from "node:fs";
const [, , asked, answered] = process.argv;
const { Session } = await import("./practice/session.js");
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
writeFileSync(answered, JSON.stringify(answers));
"""


@pytest.fixture(scope="module")
def told(tmp_path_factory: pytest.TempPathFactory) -> list[dict[str, Any]]:
    scene = packed("crank-rocker")
    assert scene is not None
    found: list[dict[str, Any]] = by_node(PROGRAM, [scene], [{}], tmp_path_factory.mktemp("tally"))
    return found


def test_what_is_wrong_and_stands_is_counted_so_until_it_is_done_right(told: Any) -> None:
    far, _, near = told
    assert (far["mark"], far["wrong"]) == ("wrong", 1)
    assert (near["mark"], near["wrong"]) == ("helped", 0)


def test_a_mark_beside_its_crossing_is_missed(told: Any) -> None:
    """With a loupe and steps of 0.1 mm a millimetre is plenty."""
    assert [one["missed"] for one in told] == [True, True, False]
