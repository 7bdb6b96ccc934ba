"""Every task of every scene as a student works it: right in two orders, wrong in every way, saved."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from support import gallery
from support.benches import Packed, by_node, packed, practised

from graphic_tmm.checking.check import check
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.page.practice.words import practice_words

PROGRAM = Path(__file__).parents[2] / "support" / "practising.mjs"
CHECKED = {"crank-rocker": "en", "windrower": "ru", "engine": "en"}
"""Scenes of which drawings are checked from their files, and the languages of these."""


@pytest.fixture(scope="module")
def worked(
    tmp_path_factory: pytest.TempPathFactory, request: pytest.FixtureRequest
) -> list[tuple[Packed, list[dict[str, Any]]]]:
    """Scenes of which each group, load and diagram is worked; with ``--measured`` all of them."""
    scenes = practised(every=request.config.getoption("--measured"))
    asked = [{"words": practice_words("en")} for _ in scenes]
    folder = tmp_path_factory.mktemp("students")
    answers = by_node(PROGRAM.read_text("utf-8"), scenes, asked, folder)
    return list(zip(scenes, answers, strict=True))


@pytest.mark.slow
def test_every_task_is_done_at_once_by_its_own_due_answers_in_two_orders(worked: Any) -> None:
    tasks = 0
    for scene, answers in worked:
        for task, answer in zip(scene.data["tasks"], answers, strict=True):
            tasks += 1
            for how in ("first", "last"):
                one, here = answer[how], (scene.name, task["plan"], task["at"], how)
                assert one["faults"] == [], here
                assert one["ready"], here
                assert one["score"]["once"] == one["score"]["count"] == len(task["steps"]), here
                assert sorted(one["order"]) == sorted(task["steps"]), here
    assert tasks > 20 * len(worked)


@pytest.mark.slow
def test_what_is_wrong_is_refused(worked: Any) -> None:
    """Ten times a length, a point 5 mm off, the other meeting; by another instrument nothing wrong is drawn."""
    told: Counter[str] = Counter()
    for scene, answers in worked:
        for task, answer in zip(scene.data["tasks"], answers, strict=True):
            for kind, slot, how, more in answer["wrong"]:
                told[kind] += 1
                here = (scene.name, task["plan"], task["at"], slot, kind, how)
                if kind == "instrument":
                    done = more in task["steps"] and more != slot
                    assert done or how not in ("asked", "drawn"), here
                else:
                    assert how, here
    assert min(told[kind] for kind in ("times ten", "5 mm off", "other meeting")) > 50
    assert told["other side"] > 20
    assert told["instrument"] > 5_000


@pytest.mark.turns(1)
@pytest.mark.slow
@pytest.mark.parametrize("name", CHECKED)
def test_the_readings_that_are_saved_are_judged_alike_by_a_check(
    name: str, tmp_path: Path, many: Callable[[int, int], int]
) -> None:
    scene = packed(name)
    assert scene is not None
    seeds = 4 if name == "crank-rocker" else many(4, 1)  # its plans are small
    chance = random.Random(name)
    drawn = [(chance.randrange(len(scene.data["tasks"])), k) for k in range(1, seeds + 1)]
    asked = [{"words": practice_words(CHECKED[name]), "drawn": drawn}]
    (answers,) = by_node(PROGRAM.read_text("utf-8"), [scene], asked, tmp_path)
    verdicts: Counter[str] = Counter()
    for k, answer in enumerate(answers):
        file = tmp_path / f"{k}.csv"
        file.write_text(answer["csv"], encoding="utf-8")
        report = check(gallery.scene(name), read_readings(file), points="screen")
        found = {(*one.taken.key[:2], one.taken.key[2]): one.verdict for one in report.readings}
        due = {(plan, segment, at): verdict for plan, at, segment, verdict in answer["verdicts"]}
        assert found == due
        verdicts.update(found.values())
    assert len(verdicts) >= (3 if seeds > 1 else 2), verdicts
