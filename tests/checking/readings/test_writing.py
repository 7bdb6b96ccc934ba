"""A template asks for all that a scene lets one measure, once, and comes back as readings when filled in."""

from __future__ import annotations

import csv
import io

import numpy as np
import pytest
from support import gallery
from support.boards import parts
from support.columns import along
from support.gallery import NAMES

from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.readings.writing import result_columns, template, write_readings
from graphic_tmm.checking.records import Last, Taken
from graphic_tmm.readers.columns import Column, empty
from graphic_tmm.readers.table import columns_of, results_of, table

COLUMNS = (
    Column("velocities", "pb", "pb", "m/s", along(0.0, 1.0, None), along(0.0, 0.25, None)),
    Column("velocities", "omega2", "ω_2", "1/s", empty(3), along(3.0, None, None)),
    *result_columns(
        {
            "J_fly": (np.array([1.77]), "kg·m²"),
            "contact_ratio": (np.array([1.16]), ""),
            "y": (np.array([np.nan]), ""),
        }
    ),
)
NAMES_3 = ("1", "2", "6*")
DUE = """\
plan,position,segment,mm,value,unit,x,y
velocities,1,pb,,,m/s,,
velocities,2,pb,,,m/s,,
velocities,1,omega2,,,1/s,,
results,,J_fly,,,kg·m²,,
results,,contact_ratio,,,1,,
velocities,1,b,,,,,
velocities,2,b,,,,,
cam,1,K,,,,,
cam,2,K,,,,,
cam,6*,K,,,,,
"""


def saved(folder, text):
    file = folder / "template.csv"
    file.write_text(text, "utf-8")
    return file


def test_a_row_for_every_segment_and_position_that_there_is():
    assert template(COLUMNS, NAMES_3, [("velocities", "b"), ("cam", "K")]) == DUE


def test_in_russian_for_a_spreadsheet_set_to_russian():
    text = template(COLUMNS[:1], NAMES_3, language="ru")
    assert text == (
        "\ufeffплан;положение;отрезок;мм;величина;единица;x;y\n"
        "velocities;1;pb;;;m/s;;\nvelocities;2;pb;;;m/s;;\n"
    )


def test_points_of_a_scene_without_positions():
    assert template((), (), [("gear", "P")]).splitlines()[1:] == ["gear,,P,,,,,"]


@pytest.mark.parametrize("language", ["en", "ru"])
def test_a_template_not_filled_in_has_no_readings(tmp_path, language):
    text = template(COLUMNS, NAMES_3, [("velocities", "b")], language=language)
    assert read_readings(saved(tmp_path, text)) == ()


def test_writing_quotes_what_would_be_taken_for_something_else():
    rows = [Taken('a "b"', "1,5", "#c;", mm=-0.5), Taken("results", "", "z", value=3.0)]
    assert write_readings(rows).splitlines()[1:] == [
        '"a ""b""","1,5","#c;",-0.5,,,,',
        "results,,z,,3.0,1,,",
    ]
    assert '"a ""b""";1,5;"#c;";-0,5;;;;' in write_readings(rows, language="ru")


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_the_template_of_a_scene_filled_in_comes_back_whole(tmp_path, name):
    """Filled in with the program's own figures, row by row by the csv module, every figure comes back, once."""
    made = gallery.made(name)
    work = made.mechanism
    columns = columns_of(work) if work is not None else []
    results = {k: v for part in parts(made) for k, v in results_of(part).items()}
    columns = [*columns, *result_columns(results)]
    names = work.project.names if work is not None else ()
    due = {
        (c.plan, "" if c.plan == "results" else names[k], c.segment): (mm, value, c.unit)
        for c in columns
        for k, (mm, value) in enumerate(zip(*c.first_figures, strict=True))
        if (mm, value) != (None, None)
    }
    asked = list(csv.DictReader(io.StringIO(template(columns, names))))
    assert [(row["plan"], row["position"], row["segment"]) for row in asked] == list(due)
    for row in asked:
        mm, value, _ = due[row["plan"], row["position"], row["segment"]]
        row |= {"mm": "" if mm is None else repr(mm), "value": "" if value is None else repr(value)}
    out = io.StringIO()
    writer = csv.DictWriter(out, asked[0] if asked else ["plan", "position", "segment", "mm"])
    writer.writeheader()
    writer.writerows(asked)
    back = read_readings(saved(tmp_path, out.getvalue()))
    assert {one[:3]: (one.mm, one.value, one.unit) for one in back} == due
    assert len(back) == len(due)


def test_the_table_of_a_scene_is_a_file_of_readings(tmp_path):
    made = gallery.made("engine")
    text = table(made, "csv")
    assert isinstance(text, str)
    back = read_readings(saved(tmp_path, text))
    assert len(back) == len(text.splitlines()) - 1
    assert Taken("velocities", "3", "pb", 65.3, 16.32, "m/s") in [
        one._replace(line=0, last=Last()) for one in back
    ]
