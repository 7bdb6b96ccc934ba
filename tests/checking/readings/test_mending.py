"""Readings typed by people are judged as those by the names of the scene; what was mended is told."""

from __future__ import annotations

import random

import pytest
from support import gallery
from support.misspelt import misspelt

from graphic_tmm.checking.cells import cells, points
from graphic_tmm.checking.check import known_readings
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.records import Taken
from graphic_tmm.errors import SceneError

HEAD = "plan;position;segment;mm;value;unit;x;y\n"


def read(folder, text, encoding="utf-8"):
    file = folder / "readings.csv"
    file.write_bytes(text.encode(encoding, "replace"))
    return read_readings(file)


def keys(rows):
    return [(*one.key, one.mm, one.value, one.x, one.y) for one in rows]


@pytest.fixture(scope="module")
def made():
    return gallery.made("crank-rocker")


def typed(folder, made, rows, encoding="utf-8"):
    """Return what becomes of rows of a file, "plan;position;segment;mm;value;unit;x;y", and the notes."""
    return known_readings(
        made, read(folder, HEAD + "".join(f"{row}\n" for row in rows), encoding), "r.csv"
    )


def test_misspelt_readings_are_those_of_the_scene(made):
    source, due, given = random.Random(3), [], []
    for (plan, segment, position), cell in cells(made).items():
        if source.random() < 0.5:
            due.append(
                Taken(
                    plan,
                    position,
                    segment,
                    cell.mm,
                    cell.value if cell.mm is None else None,
                    cell.unit,
                )
            )
    for (plan, letter, position), spot in points(made).items():
        if source.random() < 0.3:
            due.append(Taken(plan, position, letter, x=spot.real, y=spot.imag))
    due = [one._replace(line=k) for k, one in enumerate(due, 2)]
    for one in due:
        name = one.segment if one.pointed else misspelt(source, one.segment)[0]
        place = source.choice(("{}", "0{}", " {}", "№{}")).format(one.position)
        given.append(one._replace(segment=name, position=place))
    assert len(due) > 60
    assert given != due
    rows, notes = known_readings(made, given, "r.csv")
    assert keys(rows) == keys(due)
    assert 0 < len(notes) < len(due)


def test_a_letter_of_another_alphabet_is_told(tmp_path, made):
    rows, notes = typed(tmp_path, made, ["velocities;1;рb;10;;;;", "velocities;2;рb;10;;;;"])
    assert [one.key for one in rows] == [("velocities", "pb", "1"), ("velocities", "pb", "2")]
    (note,) = notes
    assert note.startswith('"рb" was read as pb: it has Cyrillic letters')
    assert note.endswith("(Velocity plan; line 2, 3)")


def test_nothing_is_told_of_another_sign_for_the_same_letter(tmp_path, made):
    rows = ["velocities;1;ω3;;2;1/s;;", "Velocity plan;01;p b;10;;;;", "ускорения;2.0;pia;10;;;;"]
    found, notes = typed(tmp_path, made, rows)
    assert [one.segment for one in found] == ["omega3", "pb", "πa"]
    assert [one.position for one in found] == ["1", "1", "2"]
    assert not notes


def test_what_windows_1251_has_lost_is_found_again_where_one_thing_fits(tmp_path, made):
    rows = ["accelerations;2;πa;10;;;;", "velocities;1;ω3;;2;1/s;;"]
    found, notes = typed(tmp_path, made, rows, "cp1251")
    assert [one.segment for one in found] == ["πa", "omega3"]
    assert len(notes) == 2
    assert all("letters were lost" in note for note in notes)


def test_what_may_mean_two_things_is_refused_with_both(tmp_path):
    made = gallery.made("planetary")
    with pytest.raises(SceneError) as caught:
        typed(tmp_path, made, ["planet;;z1;10;;;;"])
    (fault,) = caught.value.faults
    assert fault.line == 2
    assert '"planet" may mean planetary or planetary-' in fault.message


def test_one_reading_under_two_names_stands_there_twice(tmp_path, made):
    with pytest.raises(SceneError, match="stands in line 2 already"):
        typed(tmp_path, made, ["velocities;1;pb;10;;;;", "скорости;01;PB;11;;;;"])


@pytest.mark.parametrize(
    ("row", "says"),
    [
        ("rates;1;pb;10;;;;", 'there is no plan "rates"'),
        ("velocities;1;bd;10;;;;", 'plan velocities has no segment "bd"'),
        ("скорости;1;bd;10;;;;", 'plan velocities has no segment "bd"'),
        ("velocities;12;PB;10;;;;", 'pb has no figure at position "12"'),
        ("velocities;1;π;;;;10;0", 'plan velocities has no segment "π"'),
    ],
)
def test_what_means_nothing_is_refused_as_before(tmp_path, made, row, says):
    with pytest.raises(SceneError, match=says):
        typed(tmp_path, made, [row])


@pytest.mark.parametrize(
    ("plan", "pole"),
    [
        *[("velocities", "p"), ("velocities", "P"), ("velocities", "р"), ("accelerations", "π")],
        *[("accelerations", "pi"), ("accelerations", "p"), ("positions", "O"), ("positions", "О")],
    ],
)
def test_a_row_for_the_pole_is_no_reading(tmp_path, made, plan, pole):
    letter = "B" if plan == "positions" else "b"
    rows = [f"{plan};2;{pole};;;;0;0,5", f"{plan};2;{letter};;;;12;-3"]
    found, notes = typed(tmp_path, made, rows)
    assert keys(found) == [(plan, letter, "2", None, None, 12.0, -3.0)]
    assert not [note for note in notes if "counted" in note]


def test_of_many_poles_that_stand_elsewhere_there_is_one_note(tmp_path, made):
    rows = [f"velocities;{k};p;;;;{100 * k};50" for k in range(1, 7)]
    found, notes = typed(tmp_path, made, [*rows, "velocities;2;b;;;;203;54"])
    assert [(one.x, one.y) for one in found] == [(3, 4)]
    assert list(notes) == [
        "Velocity plan: 6 poles p do not stand at 0 (lines 2, 3, 4, 5, …); the points of each plan are counted "
        "from its own"
    ]


def test_points_are_counted_from_a_pole_that_stands_elsewhere(tmp_path, made):
    rows = ["velocities;1;p;;;;100;50", "velocities;1;b;;;;112,5;47", "velocities;2;b;;;;3;4"]
    found, notes = typed(
        tmp_path, made, [*rows, "accelerations;2;b;;;;7;8", "velocities;1;pb;9;;;;"]
    )
    assert [(one.x, one.y) for one in found] == [(12.5, -3), (3, 4), (7, 8), (None, None)]
    (note,) = notes
    assert note.startswith("line 2: the pole p stands at x = 100, y = 50")
    assert note.endswith("counted from there (Velocity plan, position 1)")
    every, _ = typed(tmp_path, made, ["positions;;O;;;;100;50", "positions;2;B;;;;103;54"])
    assert [(one.x, one.y) for one in every] == [(3, 4)]


def test_a_pole_that_no_plan_has_or_a_length_of_it_is_refused(tmp_path, made):
    assert typed(tmp_path, made, ["velocities;1;p;0;;;;"]) == ((), ())
    with pytest.raises(SceneError, match='no segment "p"'):
        typed(tmp_path, made, ["velocities;1;p;5;;;;"])


def test_notes_are_said_in_the_language_of_the_scene(tmp_path):
    _, notes = typed(tmp_path, gallery.made("engine"), ["скорости;1;рb;10;;;;", "v;1;p;;;;1;1"][:1])
    assert notes == (
        "«рb» прочитано как pb: в нём русские буквы вместо похожих латинских (План скоростей; строки: 2)",
    )
