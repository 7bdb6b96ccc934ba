"""A log is run once by a hand: scale factors are found without running it, readers share what was found."""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Any

import pytest
from support import asked
from support.command import invoke
from support.gallery import SHEETS
from support.mechanisms import sample
from support.once import ANEW
from support.scenes import written

from graphic_tmm.board.execute import Program
from graphic_tmm.mechanism.records import Row
from graphic_tmm.scene import read as reading
from graphic_tmm.scene.records import Scene, SheetOrder
from graphic_tmm.studio import make, sheets

WHOLE = 0.5
"""A run of more than this share of the longest run is one of the whole log: what recording tries (an extreme
position, whether the mechanism assembles) and a few lengths of a part are no drawing."""


class Runs:
    """The runs of programs while a test lasts: by how many steps, how many positions, and by whose hand."""

    def __init__(self) -> None:
        self.seen: list[tuple[int, int, Any]] = []

    def whole(self) -> Counter[tuple[int, int, Any]]:
        """Runs of whole logs."""
        most = max((steps for steps, _, _ in self.seen), default=0)
        return Counter(run for run in self.seen if run[0] > WHOLE * most)


@pytest.fixture
def runs(monkeypatch: pytest.MonkeyPatch) -> Runs:
    counted, run = Runs(), Program.run

    def counting(self: Program, given: Any, **options: Any) -> Any:
        found = run(self, given, **options)
        steps = sum(len(pointwise) + len(across) for pointwise, across in self.strata)
        counted.seen.append((steps, found.positions, options.get("hand")))
        return found

    monkeypatch.setattr(Program, "run", counting)
    monkeypatch.setattr(reading, "read", ANEW)  # what an earlier test found of a scene is not there
    return counted


def once(runs: Runs) -> None:
    """Every whole log was run once by each hand, and was run at all."""
    counts = runs.whole()
    assert counts
    assert set(counts.values()) == {1}, counts


COMMANDS = (("draw",), ("table",), ("table", "--exact"), ("steps",))


@pytest.mark.parametrize(
    ("name", "command"),
    [
        ("scotch-yoke", ("draw",)),
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
    out = ["-o", str(tmp_path)] if command == ("draw",) else []
    assert invoke(command[0], SHEETS / name, *command[1:], *out).exit_code == 0
    once(runs)


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(p.parent.name for p in SHEETS.glob("*/scene.toml")))
def test_every_scene_is_drawn_by_one_run_of_its_log(name: str, runs: Runs, tmp_path: Path) -> None:
    """A part is run with the exact hand in each size that is tried: wheels to another μ are drawn anew."""
    mechanism = ANEW(SHEETS / name).mechanism is not None
    runs.seen.clear()
    assert invoke("draw", SHEETS / name, "-o", tmp_path).exit_code == 0
    counts = runs.whole()
    if mechanism:
        assert set(counts.values()) == {1}, counts
    assert all(count == 1 for (*_, hand), count in counts.items() if hand.ruler is not None)


@pytest.mark.slow
def test_random_mechanisms_are_drawn_by_one_run_of_their_log(runs: Runs) -> None:
    places = ("positions", "velocities", "accelerations", "results")
    for k, one in enumerate(sample(4, 21)):
        runs.seen.clear()
        row = Row(8, zero=one.phi, accelerations=("0", "2"))
        scene = Scene(f"{k}", "T", "en", one.mechanism, row, sheets=(SheetOrder("A1", places),))
        sheets(scene)
        once(runs)


@pytest.mark.parametrize(
    ("kind", "count"), [("slider", 4), pytest.param("six", 8, marks=pytest.mark.slow)]
)
def test_all_that_a_mechanism_can_be_asked_for_takes_one_run(
    kind: str, count: int, runs: Runs, tmp_path: Path
) -> None:
    orders = [("A1", ("positions", "velocities", "forces", "lever")), ("A1", ("flywheel",))]
    make(ANEW(written(tmp_path, asked.mechanism(kind, count, orders))))
    once(runs)
