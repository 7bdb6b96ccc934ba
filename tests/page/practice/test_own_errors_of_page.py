"""Wrong drawings at random: the page tells the same own errors and verdicts as a check of the readings."""

from __future__ import annotations

import math
import random
import re
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from support.benches import Packed, packed, practised, worked
from support.centres_by_hand import FAR, SIX_BAR, Student, Way

from graphic_tmm.board.hand import HANDS
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Point
from graphic_tmm.checking.check import TRIALS, known_readings
from graphic_tmm.checking.judging.comparison import Comparison
from graphic_tmm.checking.judging.equivalents import crossings, ways_of
from graphic_tmm.checking.judging.judge import judge
from graphic_tmm.checking.judging.scatter import Limits
from graphic_tmm.checking.judging.yardstick import Yardstick, Yardsticks
from graphic_tmm.checking.records import DOUBTFUL, FINE, WRONG, Judged, Last, Taken
from graphic_tmm.page.practice.limits import MANNERS
from graphic_tmm.project import Project

DRAWINGS = 12
"""Of each scene."""
NEAR = 1e-9
TIED = 3e-5
"""Sizes are packed to so many digits, as a share: errors that are nearer, each by its size, are as large."""


class Case:
    """A drawing of one plan in one position: its readings as a check has them, as the page has them."""

    def __init__(
        self, scene: Packed, chance: random.Random, task: int | None = None, manner: str = ""
    ) -> None:
        self.scene = scene
        # of each scene one task a manner, again and again: a yardstick costs more than a drawing
        tasks = random.Random(scene.name).sample(range(len(scene.data["tasks"])), len(MANNERS))
        self.manner = manner or chance.choice(list(MANNERS))
        self.task = tasks[list(MANNERS).index(self.manner)] if task is None else task
        asked = scene.data["tasks"][self.task]
        self.at = asked["at"]
        self.position = scene.data["names"][self.at]
        packing = scene.packing
        steps = [step for step in packing.steps if step.it.slot in asked["steps"]]
        marks = [step.it for step in steps if step.it in packing.named]
        if self.manner == "points":
            marks = [mark for mark in marks if mark.kind is Point]
        clumsy = chance.choice([0.0, 0.3, 1.0, 5.0])
        self.taken = {mark: self.reading(mark, chance, clumsy) for mark in marks}

    def reading(self, mark: Mark, chance: random.Random, clumsy: float) -> Taken:
        _, plan, name, unit = self.scene.packing.named[mark]
        bare = Taken(plan, self.position, name, line=mark.slot)
        row = self.scene.packing.row.numbers(mark)
        due = row[self.at if len(row) > 1 else 0]
        slip = chance.choice([0.0, 0.1, 0.5, clumsy])
        if mark.kind is Point:
            x, y = (z + chance.gauss(0.0, slip) for z in due)
            return bare._replace(x=round(x, 2), y=round(y, 2), last=Last(x=0.005, y=0.005))
        wrong = chance.choice([1.0] * 12 + [10.0, 0.1, -1.0])
        if mark.kind is Length:
            digits = chance.choice([0, 1, 3])
            figure = round(wrong * (abs(due[0]) + chance.gauss(0.0, slip)), digits)
            return bare._replace(mm=figure, last=Last(mm=0.5 * 10.0**-digits))
        figure = wrong * due[0] * (1.0 + chance.gauss(0.0, slip / 50.0))
        figure = float(f"{figure:.4g}")
        half = 0.5 * 10.0 ** (math.floor(math.log10(abs(figure) or 1.0)) - 3)
        return bare._replace(value=figure, unit=unit, last=Last(value=half))

    def told(self) -> dict[str, Any]:
        rows = []
        for mark, taken in self.taken.items():
            figure = taken.mm if taken.mm is not None else taken.value
            found = [taken.x, taken.y] if taken.pointed else figure
            rows.append([mark.slot, found, taken.last._asdict()])
        return {"task": self.task, "manner": self.manner, "rows": rows}

    def compare(self, *others: Case) -> tuple[tuple[Judged, ...], Comparison]:
        made = self.scene.made
        taken = [one for case in (self, *others) for one in case.taken.values()]
        rows, _ = known_readings(made, taken, "readings")
        assert len(rows) == len(taken)
        by = _yardstick(self.scene, self.manner, rows)
        return judge(made, rows, by), Comparison(made, rows, by)


_KEPT: dict[Any, Yardstick] = {}


def _yardstick(scene: Packed, manner: str, rows: Any) -> Yardstick:
    key = (scene.name, manner, frozenset(row.at for row in rows))
    if key not in _KEPT:
        hand = HANDS["student"]._replace(trials=TRIALS, seed=scene.made.scene.seed)
        _KEPT[key] = Yardsticks(scene.made, hand, Limits(), MANNERS[manner]).of(rows)
    return _KEPT[key]


@pytest.fixture(scope="module")
def judgements(
    tmp_path_factory: pytest.TempPathFactory, request: pytest.FixtureRequest
) -> list[tuple[Case, list[dict[str, Any]]]]:
    chance = random.Random(18)
    scenes = practised(every=request.config.getoption("--measured"))
    cases = [Case(scenes[k % len(scenes)], chance) for k in range(DRAWINGS * len(scenes))]
    told = {one.name: [case.told() for case in cases if case.scene is one] for one in scenes}
    answers = worked(scenes, told, tmp_path_factory.mktemp("judged"))
    found = {one.name: iter(answer["judged"]) for one, answer in zip(scenes, answers, strict=True)}
    return [(case, next(found[case.scene.name])) for case in cases]


@pytest.mark.slow
def test_own_errors_and_verdicts_are_those_of_a_check(
    judgements: list[tuple[Case, list[dict[str, Any]]]],
) -> None:
    verdicts: Counter[str] = Counter()
    for case, told in judgements:
        due, comparison = case.compare()
        page = {one["slot"]: one for one in told}
        for one in due:
            mine = page[one.taken.line]
            here = (case.scene.name, case.manner, one, mine)
            _same_errors(comparison, one, mine, here)
            assert mine["verdict"] == one.verdict, here
            if one.own is not None:
                _same_worst(comparison, one, mine, here)
            if one.verdict != FINE:
                name = next(m for m in case.scene.packing.marks() if m.slot == mine["blamed"]).name
                assert one.step.split(" ", 1)[1] == name, here
            verdicts[one.verdict] += 1
    assert min(verdicts[one] for one in (FINE, DOUBTFUL, WRONG)) > len(judgements) / 4


def _same_worst(comparison: Comparison, one: Judged, mine: dict[str, Any], here: Any) -> None:
    """Compare the error that counts: of two that are as large for the hand it may be either."""
    errors = comparison.errors(one.taken)
    step = comparison.step(one.taken)
    assert one.own is not None
    assert step is not None
    limits = comparison.by.steps[step.it, comparison.place(one.taken)]
    sizes = limits.at(comparison.share if one.taken.pointed else 1.0)
    counts = next((k for k, (_, error, _) in enumerate(errors) if error == one.own), None)
    if counts is None:
        # by another construction it is milder
        assert ways_of(step, {}) or step.it in crossings(_project(comparison))
        assert abs(mine["error"] - one.own) <= NEAR * max(1.0, abs(one.own)), here
        return
    times = [abs(error) / size for (_, error, _), size in zip(errors, sizes, strict=True)]
    tied = [
        error
        for (_, error, _), much in zip(errors, times, strict=True)
        if abs(much - times[counts]) <= TIED * much
    ]
    apart = min(abs(mine["error"] - error) for error in (one.own, *tied))
    assert apart <= NEAR * max(1.0, abs(one.own)), here


def _project(comparison: Comparison) -> Project:
    assert comparison.made.mechanism is not None
    return comparison.made.mechanism.project


def _same_errors(comparison: Comparison, one: Judged, mine: dict[str, Any], here: Any) -> None:
    errors = comparison.errors(one.taken)
    assert not errors or len(errors) == len(mine["parts"]), here
    for (step, error, _), (slot, found) in zip(errors, mine["parts"], strict=False):
        assert step.it.slot == slot, here
        assert abs(error - found) <= NEAR * max(1.0, abs(error)), here


TOGETHER = 3
"""So many drawings of each scene have several plans."""


@pytest.mark.slow
def test_plans_of_one_drawing_are_judged_together(
    tmp_path: Path, many: Callable[[int, int], int]
) -> None:
    chance, some = random.Random(23), practised(every=bool(many(1, 0)))
    drawings = {one.name: [_plans(one, chance) for _ in range(TOGETHER)] for one in some}
    scenes = [one for one in some if min(map(len, drawings[one.name])) > 1]
    told = {
        one.name: [[case.told() for case in cases] for cases in drawings[one.name]]
        for one in scenes
    }
    answers = worked(scenes, {}, tmp_path, together=told)
    verdicts: Counter[str] = Counter()
    for one, answer in zip(scenes, answers, strict=True):
        for cases, judged in zip(drawings[one.name], answer["together"], strict=True):
            page = {row["slot"]: row for row in judged}
            due, comparison = cases[0].compare(*cases[1:])
            for row in due:
                mine = page[row.taken.line]
                here = (one.name, [case.task for case in cases], row, mine)
                _same_errors(comparison, row, mine, here)
                assert mine["verdict"] == row.verdict, here
                verdicts[row.verdict] += 1
    assert len(scenes) > many(12, 5)
    assert min(verdicts[verdict] for verdict in (FINE, DOUBTFUL, WRONG)) > len(scenes)


def _plans(scene: Packed, chance: random.Random) -> list[Case]:
    """Return plans of a scene in one position, two of them or all."""
    at = random.Random(scene.name).choice(scene.data["tasks"])["at"]
    tasks = [k for k, task in enumerate(scene.data["tasks"]) if task["at"] == at]
    tasks = chance.sample(tasks, chance.choice([2, len(tasks)])) if len(tasks) > 1 else tasks
    return [Case(scene, chance, task, "points") for task in sorted(tasks)]


BY_OTHER_LINES: dict[str, Way] = {
    "25": ("24", "45", "20", FAR),
    "15": ("12", "25", "10", FAR),
    "14": ("13", "34", "15", "45"),
    "35": ("15", "13", "34", "45"),
}
"""Centres of a six-bar by other lines than the log's, P_25 before P_15."""


@pytest.mark.parametrize("manner", MANNERS)
def test_centres_by_other_lines_are_judged_as_a_check_does(tmp_path: Path, manner: str) -> None:
    """Of eight drawings every second has a centre that is off by some mm."""
    scene = packed("centres-of-six-bar")
    assert scene is not None
    task = next(
        k
        for k, one in enumerate(scene.data["tasks"])
        if scene.data["plans"][one["plan"]] == "centres" and scene.data["names"][one["at"]] == "9"
    )
    cases = []
    for k in range(8):
        student = Student(70 + k)
        student.ways = {name: SIX_BAR[name] for name in ("20", "13", "40", "34")} | BY_OTHER_LINES
        case = Case(scene, random.Random(k), task, manner)
        spots = student.centres(9)
        if k % 2:
            spots["14" if k % 4 == 1 else "25"] += complex(0.0, k)
        for mark, taken in case.taken.items():
            number = re.sub(r"[^0-9]", "", mark.name)
            if taken.pointed and number in spots:
                x, y = round(spots[number].real, 2), round(spots[number].imag, 2)
                case.taken[mark] = taken._replace(x=x, y=y)
        cases.append(case)
    (answer,) = worked([scene], {scene.name: [case.told() for case in cases]}, tmp_path)
    verdicts: Counter[tuple[str, str]] = Counter()
    for case, told in zip(cases, answer["judged"], strict=True):
        page = {one["slot"]: one for one in told}
        for one in case.compare()[0]:
            if one.taken.pointed:
                assert page[one.taken.line]["verdict"] == one.verdict, (case.manner, one)
                verdicts[one.taken.segment, one.verdict] += 1
    assert verdicts["P_{35}", FINE] == len(cases)
    assert verdicts["P_{14}", WRONG] > 0
