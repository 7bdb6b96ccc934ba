"""Honest students of one variant are not told to be alike, however they read; a copy among them is."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from support.handed_in import hand_in, variant_text
from support.students.records import Hand

from graphic_tmm.checking.check import Checker
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.classroom.marks.copies import alike
from graphic_tmm.classroom.marks.row import Row, known, row_of, text
from graphic_tmm.scene.read import read

HANDS = {
    "as taken for": Hand(),
    "ruler of 1 mm": Hand(ruler=1.0),
    "careful": Hand(swing=0.2, slip=0.25, pointing=0.2),
    "computer": Hand(swing=0.0, slip=0.01, pointing=0.01, ruler=0.1),
}


@pytest.fixture(scope="module")
def checker(tmp_path_factory: pytest.TempPathFactory) -> Checker:
    scene = tmp_path_factory.mktemp("variant") / "slider.toml"
    scene.write_text(variant_text(1, 8), "utf-8")
    return Checker(read(scene), trials=60)


@pytest.mark.turns(3)
@pytest.mark.slow
@pytest.mark.parametrize("mode", ["mm", "quantities", "points"])
@pytest.mark.parametrize("hand", HANDS)
def test_honest_students_are_not_alike(
    hand: str, mode: str, checker: Checker, tmp_path: Path, many: Callable[[int, int], int]
) -> None:
    file, count = tmp_path / "readings.csv", many(14, 7)
    rows: list[Row] = []
    for seed in range(count):
        file.write_text(
            hand_in(1, 400 + seed, positions=8, mode=mode, hand=HANDS[hand]).text, "utf-8"
        )
        rows.append(row_of(checker.made, checker.of(read_readings(file))))
    assert alike(rows) == ()
    if hand not in ("careful", "computer"):  # of a sure hand 30 equal readings are no wonder
        assert [(one.one, one.other) for one in alike([*rows, rows[3]])] == [(3, count)]
    assert known(text(rows[0])) == rows[0]
