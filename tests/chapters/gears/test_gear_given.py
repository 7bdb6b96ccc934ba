"""What is given of a pair of gears, as the sheet of the task has it."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.gallery import scene
from support.scenes import calling

from graphic_tmm.readers.task_sheet import Given, given_rows, given_table
from graphic_tmm.scene.read import read


def test_teeth_module_shifts_and_rack() -> None:
    rows = given_rows(scene("gear-pair"), "gears")
    assert rows[:2] == (Given("z_1", 15), Given("z_2", 25))
    assert {row.symbol: row.value for row in rows[2:]} == {
        **{"m": pytest.approx(8.0), "x_1": 0.83, "x_2": 0.445},
        **{"α": 20.0, "h_a^*": 1.0, "c^*": 0.25},
    }
    view = given_table(scene("gear-pair"), board="gears")
    assert view.title == "Исходные данные: зубчатая пара"
    texts = {label.text for label in view.labels}
    assert {"Исходные данные:", "зубчатая пара", "0,445", "h_a^*"} <= texts


def test_an_equalising_shift_that_is_given_is_told_too(tmp_path: Path) -> None:
    section = '[gears]\nz1 = 15\nz2 = 25\nm = "8 mm"\ndelta_y = 0.19\n'
    path = calling(tmp_path, section, sheet="", head='title = "T"\n')
    assert Given("Δy", 0.19) in given_rows(read(path), "gears")
