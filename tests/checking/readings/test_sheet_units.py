"""Lengths in other units of the paper are brought to mm, and how finely they were written with them."""

from __future__ import annotations

import pytest
from support.each import each

from graphic_tmm.checking.readings.read import read_readings


def rows(folder, text):
    file = folder / "readings.csv"
    file.write_text(text, "utf-8")
    return read_readings(file)


@each(
    "title, cell, due",
    [
        *[("mm", "6.85 cm", 68.5), ("mm", "6,85см", 68.5), ("mm", "2 in", 50.8), ("мм", "7", 7.0)],
        *[("mm", "2 inches.", 50.8), ("mm", "2,5 дюйма", 63.5), ("mm", "2″", 50.8)],
        *[("cm", "6.85", 68.5), ("см", "6,85", 68.5), ("in", "2", 50.8), ("дюймы", "2", 50.8)],
        *[("length, cm", "6.85", 68.5), ("Длина (см)", "6,85", 68.5), ("mm, cm", "1", 10.0)],
        *[("inches", "2", 50.8), ("cm", "68.5 mm", 68.5), ("in", "5 cm", 50.0)],
    ],
)
def test_lengths_in_other_units_of_the_paper(tmp_path, title, cell, due):
    text = f"plan;position;segment;{title}\nv;1;pb;{cell}\n"
    assert rows(tmp_path, text)[0].mm == pytest.approx(due, rel=1e-12)


def test_points_in_centimetres_and_how_finely_they_were_written(tmp_path):
    text = "plan;position;segment;x, cm;y (дюйм);mm\nv;1;b;1,25;2,0 мм;1.5 in\n"
    (one,) = rows(tmp_path, text)
    assert (one.x, one.y, one.mm) == pytest.approx((12.5, 2.0, 38.1))
    assert (one.last.x, one.last.y, one.last.mm) == pytest.approx((0.05, 0.05, 1.27))
