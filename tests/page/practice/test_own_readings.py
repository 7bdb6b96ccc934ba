"""Points read off a drawing: a check of the file that the page saves tells the verdicts that the page told."""

from __future__ import annotations

import json
import random
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from support.benches import Packed, packed
from support.command import invoke
from support.gallery import SHEETS
from support.scripts import run

from graphic_tmm.board.values import Point
from graphic_tmm.page.practice.words import practice_words

SCENES = ("crank-rocker", "toggle-press")
READ = """
import "./practice/written.js";
import { csvOf } from "./practice/record.js";
import { PlanReadings, ORIGIN } from "./own/readings.js";
const rows = [];
const all = [];
const told = asked.drawings.map(({ task, spots }) => {
  const readings = new PlanReadings(asked.practice, asked.practice.tasks[task]);
  const order = readings.points.map((one) => one.slot);
  for (const one of readings.points) {
    const spot = spots[String(one.slot)];
    if (spot !== undefined) readings.take(one.slot, spot);
  }
  rows.push(...readings.written(asked.words["decimal sign"]));
  all.push(readings);
  return { order, letters: readings.points.map((one) => one.name), next: readings.next ?? null };
});
all.forEach((readings, k) => {
  told[k].judged = [...readings.judged(all)].map(([slot, one]) => [slot, one.verdict, one.error]);
});
tell({ told, csv: csvOf(rows, asked.words["csv head"], asked.words["csv separator"]) });
"""


def drawn(scene: Packed, chance: random.Random, *, apart: bool) -> list[dict[str, Any]]:
    """Drawings of tasks by somebody: small slips, some large ones, the origin anywhere on the sheet.

    ``apart``: each in a position of its own; else several plans in one.
    """
    data, row = scene.data, scene.packing.row
    at = [one["at"] for one in data["tasks"]]
    if apart:
        tasks = [chance.choice([k for k, one in enumerate(at) if one == here]) for here in set(at)]
    else:
        here = max(set(at), key=at.count)
        tasks = [k for k, one in enumerate(at) if one == here]
    found = []
    for task in tasks[:6]:
        told = data["tasks"][task]
        origin = chance.uniform(100, 700), chance.uniform(100, 500)
        spots: dict[str, list[float]] = {"-1": list(origin)}
        for mark in (one.it for one in scene.packing.steps):
            if mark.slot not in told["steps"] or mark.kind is not Point:
                continue
            if mark not in scene.packing.named:
                continue
            numbers = row.numbers(mark)
            x, y = numbers[told["at"] if len(numbers) > 1 else 0]
            slip = chance.choice([0.1, 0.3, 0.5, 5.0, 15.0])
            away = chance.gauss(0, slip), chance.gauss(0, slip)
            spots[str(mark.slot)] = [origin[0] + x + away[0], origin[1] + y + away[1]]
        found.append({"task": task, "spots": spots})
    return found


def verdicts(scene: Packed, drawings: list[dict[str, Any]], file: Path) -> list[tuple[str, str]]:
    """Return what the page told of each point, and what a check of its file tells."""
    asked = {
        "practice": scene.data,
        "drawings": drawings,
        "words": practice_words(scene.made.scene.language),
    }
    answer = run(READ, asked, written=scene.program)
    file.write_text(answer["csv"], encoding="utf-8", newline="")
    options = ("-f", "json", "--points", "photo")
    done = invoke("check", str(SHEETS / scene.name / "scene.toml"), str(file), *options)
    assert done.exit_code in (0, 1), done.output
    rows = json.loads(done.stdout)["readings"]
    due = {(one["plan"], one["position"], one["segment"]): one["verdict"] for one in rows}
    steps = {one["it"]: one["read"] for one in scene.data["steps"] if "read" in one}
    found = []
    for drawing, told in zip(drawings, answer["told"], strict=True):
        position = scene.data["names"][scene.data["tasks"][drawing["task"]]["at"]]
        assert told["order"][0] == -1
        assert told["next"] is None
        assert len(told["judged"]) == len(told["order"]) - 1 > 0
        for slot, verdict, _ in told["judged"]:
            read = steps[slot]
            found.append((verdict, due.pop((read["name"], position, read["key"]))))
    assert due == {}
    return found


@pytest.mark.slow
def test_a_check_of_the_file_tells_what_the_page_told(tmp_path: Path) -> None:
    counted: Counter[str] = Counter()
    for name in SCENES:
        scene = packed(name)
        assert scene is not None
        drawings = drawn(scene, random.Random(name), apart=True)
        for told, due in verdicts(scene, drawings, tmp_path / f"{name}.csv"):
            assert told == due
            counted[told] += 1
    assert len(counted) == 3
    assert min(counted.values()) > 5


@pytest.mark.slow
def test_plans_of_one_position_are_judged_together(
    tmp_path: Path, many: Callable[[int, int], int]
) -> None:
    scene = packed("windrower")
    assert scene is not None
    found = []
    for seed in range(many(3, 1)):
        drawings = drawn(scene, random.Random(seed), apart=False)
        found += verdicts(scene, drawings, tmp_path / "readings.csv")
    assert [one for one in found if one[0] != one[1]] == []
