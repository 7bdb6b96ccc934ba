"""A short template asks for what is measured in one position, explains itself, and comes back filled in."""

from __future__ import annotations

import re

import pytest
from support import gallery

from graphic_tmm.checking.cells import cells, points
from graphic_tmm.checking.check import check, known_readings
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.readings.writing import file_of
from graphic_tmm.checking.template import letters_sheet, short
from graphic_tmm.errors import SheetError
from graphic_tmm.paper.write.svg import svg

DRAWN = [name for name in gallery.EVERYDAY if name != "lettering"]


def filled(made, asked):
    """Return the rows with what a ruler of 0.5 mm and a pocket calculator say."""
    due, spots = cells(made), points(made)
    rows = []
    for row in asked.rows:
        if row.key in due and due[row.key].mm is not None:
            rows.append(row._replace(mm=round(2.0 * due[row.key].mm) / 2.0))
        elif row.key in due:
            rows.append(row._replace(value=float(f"{due[row.key].value:.4g}")))
        else:
            spot = spots[row.key]
            rows.append(row._replace(x=round(spot.real, 1), y=round(spot.imag, 1)))
    return rows


@pytest.mark.parametrize("name", ["windrower", "crank-rocker", "engine"])
def test_what_is_measured_is_asked_for_and_what_is_calculated_is_told(name):
    made = gallery.made(name)
    asked = short(made)
    assert 5 <= len(asked.rows) <= 20
    assert len({row.position for row in asked.rows}) == 1
    assert {"velocities", "accelerations"} <= {row.plan for row in asked.rows}
    segments = {row.segment for row in asked.rows}
    # what is calculated first is laid off: nobody measures it
    assert segments.isdisjoint({"pa", "πa", "ak2", "πn3", "cn4", "an2", "omega2", "sB"})
    told = "\n".join(asked.told)
    for calculated in ("pa", "πa", "omega2", "epsilon2"):
        assert re.search(rf"\b{calculated}\b", told)
    assert "velocities: p" in told
    assert name != "windrower" or {"k2a3", "n3a3"} <= segments
    assert "accelerations: π" in told


@pytest.mark.parametrize("name", ["windrower", "slider-diagrams"])
def test_a_scale_factor_that_is_told_makes_the_quantity_of_the_mm(name):
    made = gallery.made(name)
    due = cells(made)
    told = {}
    for line in short(made).told:
        found = re.search(r"\((\w+), положение .*1 мм изображает ([0-9,]+) ", line)
        if found:
            told[found[1]] = float(found[2].replace(",", "."))
    assert told
    for (plan, _, _), cell in due.items():
        if plan in told and cell.mm:
            assert cell.value == pytest.approx(told[plan] * cell.mm, rel=1e-6)


@pytest.mark.turns(5)
@pytest.mark.parametrize("name", DRAWN)
@pytest.mark.parametrize("form", ["csv", "xlsx"])
def test_a_template_filled_in_by_a_ruler_comes_back(tmp_path, name, form):
    if form == "xlsx":
        pytest.importorskip("openpyxl")
    made = gallery.made(name)
    asked = short(made)
    file = tmp_path / f"readings.{form}"
    for rows in (asked.rows, filled(made, asked)):
        text = file_of(file.name, rows, language=made.scene.language, told=asked.told)
        file.write_bytes(text.encode("utf-8") if isinstance(text, str) else text)
        back = read_readings(file)
        wanted = [one for one in rows if (one.mm, one.value, one.x) != (None, None, None)]
        assert [(one.key, one.mm, one.value, one.x, one.y) for one in back] == [
            (one.key, one.mm, one.value, one.x, one.y) for one in wanted
        ]
    assert back
    assert len(known_readings(made, back, "r")[0]) == len(back)


def test_a_template_filled_in_rightly_is_fine():
    made = gallery.made("crank-rocker")
    report = check(made.scene, filled(made, short(made)), trials=60)
    assert report.readings
    assert not report.wrong


def test_what_a_teacher_marks_is_asked_for():
    made = gallery.made("windrower")
    asked = short(made, ["ускорения:pia,n_ba3,D", "скорости", "силы:R12", "results:J_м"], "08")
    keys = [row.key for row in asked.rows]
    assert keys[:3] == [(("accelerations"), name, "8") for name in ("πa", "πn3", "d")]
    plan = {segment for p, segment, place in cells(made) if (p, place) == ("velocities", "8")}
    assert {segment for p, segment, _ in keys if p == "velocities"} == plan
    assert keys[-2:] == [("forces", "R12", "8"), ("results", "J_fly", "")]
    units = {row.segment: row.unit for row in asked.rows}
    assert (units["omega3"], units["J_fly"], units["πa"]) == ("1/s", "kg·m²", "")
    assert any("впишите величину" in line for line in asked.told)


@pytest.mark.parametrize(
    ("only", "position", "says"),
    [
        (["rates"], "", '--only: what is "rates"? There are velocities, accelerations'),
        (["velocities:xy"], "", '--only: what is "xy"? There are'),
        ([], "99", '--position: what is "99"? There are'),
        (["accelerations"], "1", "nothing that is asked for is drawn at position 1"),
    ],
)
def test_what_a_scene_does_not_have_is_refused(only, position, says):
    with pytest.raises(SheetError) as caught:
        short(gallery.made("crank-rocker"), only, position)
    assert says in str(caught.value)


@pytest.mark.parametrize("name", ["windrower", "crank-rocker", "slider-diagrams"])
def test_the_picture_shows_the_letters_but_not_the_plans_that_are_asked_for(name):
    made = gallery.made(name)
    asked = short(made)
    picture = letters_sheet(made, asked.places)
    assert picture is not None
    assert len(picture.drawings) == len(asked.places)
    text = svg(picture)
    letters = {letter for plan, letter, _ in points(made) if plan in asked.places}
    shown = " ".join(label.text for drawing in picture.drawings for label in drawing.labels)
    for letter in letters:
        assert re.search(rf"{letter[0]}_?{{?{letter[1:]}", shown), letter
    assert "<svg" in text[:100]
    for drawing, plan in zip(picture.drawings, asked.places, strict=True):
        there = {place for p, _, place in points(made) if p == plan}
        assert not drawing.title.endswith(f" {asked.places[plan]}") or len(there) == 1


def test_no_picture_where_no_plan_has_letters():
    made = gallery.made("cam")
    assert letters_sheet(made, short(made).places) is None
