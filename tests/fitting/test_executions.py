"""A log is run once by a hand: scale factors are found without running it, readers share what was found."""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from support import asked
from support.command import invoke
from support.gallery import EVERYDAY, SHEETS
from support.mechanisms import sample
from support.once import ANEW
from support.scenes import written

from graphic_tmm.board.execute import Program
from graphic_tmm.board.hand import EXACT
from graphic_tmm.chapters.kinematics.task import POSITIONS
from graphic_tmm.mechanism.records import Row
from graphic_tmm.scene import read as reading
from graphic_tmm.scene.records import Scene, SheetOrder
from graphic_tmm.studio import make, sheets

WHOLE = 0.5
"""A run of more than this share of the longest run is one of the whole log: what recording tries (an extreme
position, whether the mechanism assembles) and a few lengths of a part are no drawing."""


class Run(NamedTuple):
    """A run of a program: by how many steps, how many positions, whose hand; whether it is the mechanism's."""

    steps: int
    positions: int
    hand: Any
    own: bool


class Runs:
    """The runs of programs while a test lasts."""

    def __init__(self) -> None:
        self.seen: list[Run] = []

    def whole(self, own: bool = True) -> Counter[Run]:
        """Runs of whole logs, the mechanism's ``own`` or those of parts on boards of their own."""
        there = [run for run in self.seen if run.own == own]
        most = max((run.steps for run in there), default=0)
        return Counter(run for run in there if run.steps > WHOLE * most)


@pytest.fixture
def runs(monkeypatch: pytest.MonkeyPatch) -> Runs:
    counted, run = Runs(), Program.run

    def counting(self: Program, given: Any, **options: Any) -> Any:
        found = run(self, given, **options)
        steps = sum(len(pointwise) + len(across) for pointwise, across in self.strata)
        own = any(mark.view == POSITIONS for mark in self.given)
        counted.seen.append(Run(steps, found.positions, options.get("hand"), own))
        return found

    monkeypatch.setattr(Program, "run", counting)
    monkeypatch.setattr(reading, "read", ANEW)  # what an earlier test found of a scene is not there
    return counted


def once(runs: Runs) -> None:
    """Every whole log was run once by each hand, and was run at all.

    By the exact hand once more where results of curves are held against those of a finer row, and for each size
    in which views are measured: three times on an A4 that does not hold them in natural size.
    """
    counts = runs.whole()
    assert counts
    exact = {run: count for run, count in counts.items() if run.hand == EXACT}
    assert set(exact.values()) <= {1, 2, 3, 4, 5}, exact
    assert {count for run, count in counts.items() if run not in exact} <= {1}, counts


def readings_of(name: str, folder: Path) -> Path:
    """Write down what a drawing without errors gives of the plans of velocities."""
    table = json.loads(invoke("table", SHEETS / name, "--exact", "--format", "json").stdout)
    names = [one["number"] for one in table["positions"]]
    rows = [
        f"velocities,{number},{one['segment']},{length}"
        for one in table["columns"]
        if one["plan"] == "velocities"
        for number, length in zip(names, one["mm"], strict=True)
        if length is not None and one["segment"].isalpha()
    ]
    path = folder / "readings.csv"
    path.write_text("\n".join(["plan,position,segment,mm", *rows]), encoding="utf-8")
    return path


COMMANDS = (("draw",), ("table",), ("table", "--exact"), ("steps",), ("check",))


@pytest.mark.turns(2)
@pytest.mark.parametrize(
    ("name", "command"),
    [
        ("oscillating-cylinder", ("draw",)),
        ("crank-rocker", ("table", "--exact")),
        *(
            pytest.param(name, command, marks=pytest.mark.slow)
            for name in ("windrower", "slider-diagrams")
            for command in COMMANDS
        ),
    ],
)
def test_a_command_runs_the_log_once(
    name: str, command: tuple[str, ...], runs: Runs, tmp_path: Path
) -> None:
    more = ["-o", str(tmp_path)] if command == ("draw",) else []
    if command == ("check",):
        more = [str(readings_of(name, tmp_path))]
        runs.seen.clear()
    assert invoke(command[0], SHEETS / name, *command[1:], *more).exit_code == 0
    once(runs)


@pytest.mark.turns(3, "one run")
@pytest.mark.slow
@pytest.mark.parametrize("name", [*EVERYDAY, "windrower", "project"])
def test_every_chapter_is_drawn_by_one_run_of_its_log(
    name: str, runs: Runs, tmp_path: Path
) -> None:
    """A part is run with the exact hand in each size that is tried: wheels to another μ are drawn anew."""
    mechanism = ANEW(SHEETS / name).mechanism is not None
    runs.seen.clear()
    assert invoke("draw", SHEETS / name, "-o", tmp_path).exit_code == 0
    if mechanism:
        once(runs)
    parts = runs.whole(own=False)
    assert all(count == 1 for run, count in parts.items() if run.hand.ruler is not None), parts


@pytest.mark.turns(3, "one run")
@pytest.mark.slow
def test_random_mechanisms_are_drawn_by_one_run_of_their_log(runs: Runs) -> None:
    places = ("positions", "velocities", "accelerations", "results")
    for k, one in enumerate(sample(2, 21)):
        runs.seen.clear()
        row = Row(8, zero=one.phi, accelerations=("0", "2"))
        scene = Scene(f"{k}", "T", "en", one.mechanism, row, sheets=(SheetOrder("A1", places),))
        sheets(scene)
        once(runs)


@pytest.mark.turns(3, "one run")
@pytest.mark.slow
@pytest.mark.parametrize(
    ("kind", "places"),
    [("slider", ("positions", "velocities", "forces", "lever")), ("six", ("forces", "lever"))],
)
def test_all_that_a_mechanism_can_be_asked_for_takes_one_run(
    kind: str, places: tuple[str, ...], runs: Runs, tmp_path: Path
) -> None:
    make(ANEW(written(tmp_path, asked.mechanism(kind, 4, [("A1", places), ("A1", ("flywheel",))]))))
    once(runs)
