"""The coordinate of the drive in tables for machines: an angle where it turns, a length where it slides."""

from __future__ import annotations

import json

import numpy as np
import pytest
from support.command import rows
from support.drives import BOOM, LEVER, SLIDER, scene

import graphic_tmm as tmm
from graphic_tmm.board.values import Reals
from graphic_tmm.mechanism.records import Sweep
from graphic_tmm.readers.columns import Column
from graphic_tmm.readers.table import table
from graphic_tmm.readers.writing import as_csv


@pytest.mark.parametrize(
    ("text", "name", "ends"), [(BOOM, "l_GN", (0.6, 0.85)), (SLIDER, "s", (0.25, 0.35))]
)
def test_a_length_is_no_angle(text: str, name: str, ends: tuple[float, float]) -> None:
    made = tmm.draw(scene(text))._work.drawn_scene
    told = json.loads(str(table(made, "json")))["positions"]
    assert all(set(one) == {"number", "parameter"} for one in told)
    assert {(one["parameter"]["name"], one["parameter"]["unit"]) for one in told} == {(name, "m")}
    due = np.linspace(*ends, 6)
    assert [one["parameter"]["value"] for one in told] == pytest.approx(due, abs=1e-12)
    written = rows(str(table(made, "csv")))
    assert "angle_deg" not in written[0]
    assert sorted({float(row["length_m"]) for row in written}) == pytest.approx(due, abs=1e-12)


def test_a_lever_that_turns_in_part_has_angles() -> None:
    made = tmm.draw(scene(LEVER))._work.drawn_scene
    told = json.loads(str(table(made, "json")))["positions"]
    assert [one["angle_deg"] for one in told] == pytest.approx([20, 31, 42, 53, 64, 75])
    assert "length_m" not in rows(str(table(made, "csv")))[0]


def test_angles_of_a_part_stand_beside_the_lengths_of_the_drive() -> None:
    figures: Reals = np.array([[1.0, 2.0]])
    usual = Column("velocities", "pb", "pb", "m/s", figures, figures)
    own = Column("cam", "S", "S", "m", figures, figures, (("0", 0.0), ("1", 30.0)))
    sweep = Sweep("s", "m", 0.0, 1.0, closed=False)
    text = as_csv((("0", 0.25), ("1", 0.5)), [usual, own], sweep=sweep)
    told = [(row["angle_deg"], row["length_m"]) for row in rows(text)]
    assert told == [("", "0.25"), ("", "0.5"), ("0", ""), ("30", "")]
