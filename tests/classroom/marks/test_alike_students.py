"""Honest students of one variant are not told to be alike, however they read; a copy among them is."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.handed_in import hand_in, variant_text
from support.students.records import Hand

from graphic_tmm.checking.check import Checker
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.classroom.marks.alike import alike
from graphic_tmm.classroom.marks.made import row_of
from graphic_tmm.classroom.marks.row import Row, known, text
from graphic_tmm.scene.read import read

HANDS = {
    "as taken for": Hand(),
    "ruler of 1 mm": Hand(ruler=1.0),
    "careful": Hand(swing=0.2, slip=0.25, pointing=0.2),
    "computer": Hand(swing=0.0, slip=0.01, pointing=0.01, ruler=0.1),
}


@pytest.mark.slow
@pytest.mark.parametrize("mode", ["mm", "quantities", "points"])
@pytest.mark.parametrize("hand", HANDS)
def test_honest_students_are_not_alike(hand: str, mode: str, tmp_path: Path) -> None:
    scene, file = tmp_path / "slider.toml", tmp_path / "readings.csv"
    scene.write_text(variant_text(1, 8), "utf-8")
    checker = Checker(read(scene), trials=60)
    rows: list[Row] = []
    for seed in range(14):
        file.write_text(
            hand_in(1, 400 + seed, positions=8, mode=mode, hand=HANDS[hand]).text, "utf-8"
        )
        rows.append(row_of(checker.made, checker.of(read_readings(file))))
    assert alike(rows) == ()
    if hand not in ("careful", "computer"):  # of a sure hand 30 equal readings are no wonder
        assert [(one.one, one.other) for one in alike([*rows, rows[3]])] == [(3, 14)]
    assert known(text(rows[0])) == rows[0]
