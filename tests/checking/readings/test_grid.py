"""Workbooks give the readings that their sheets show; what cannot be read is told; nothing is lost silently."""

from __future__ import annotations

import io
import random
import sys
import zipfile

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.examples import most
from support.workbooks import Formula, Shown, workbook, zipped

from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.readings.writing import file_of
from graphic_tmm.checking.records import Last, Taken
from graphic_tmm.errors import SceneError, SheetError

pytest.importorskip("openpyxl")

HEAD = ["plan", "position", "segment", "mm", "value", "unit", "x", "y"]
RUSSIAN = ["план", "положение", "отрезок", "мм", "величина", "единица", "x", "y"]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("workbooks")


def read(folder, data):
    file = folder / "readings.xlsx"
    file.write_bytes(data)
    return read_readings(file)


def rows_of(folder, *rows, head=HEAD, **options):
    return read(folder, workbook({"Лист1": [head, *rows]}, **options))


def refused(folder, data):
    with pytest.raises(SceneError) as caught:
        read(folder, data)
    return caught.value


@pytest.mark.parametrize("head", [HEAD, RUSSIAN])
@pytest.mark.parametrize("shared", [True, False])
def test_cells_as_a_spreadsheet_saves_them(folder, head, shared):
    found = rows_of(
        folder,
        ["velocities", 1, "pb", 17.5],
        ["скорости", 2.0, "πa", "17,5 мм", "0,25", "рад/с"],
        [None, None, None],
        ["v", "6*", "b", None, None, None, -1e-3, 12],
        head=head,
        shared=shared,
    )
    assert [one._replace(last=Last()) for one in found] == [
        Taken("velocities", "1", "pb", mm=17.5, line=2),
        Taken("скорости", "2", "πa", 17.5, 0.25, "рад/с", line=3),
        Taken("v", "6*", "b", x=-0.001, y=12.0, line=5),
    ]


def test_noughts_that_are_shown_were_written(folder):
    one, two = rows_of(folder, ["v", "1", "pb", Shown(17.0, "0.00")], ["v", "2", "pb", 17.25])
    assert (one.mm, one.last.mm, two.last.mm) == (17.0, 0.005, 0.005)
    (share,) = rows_of(folder, ["r", "", "share", None, Shown(0.125, "0%"), "%"])
    assert (share.value, share.unit) == (12.5, "%")


def test_a_formula_has_the_result_that_was_saved(folder):
    (one,) = rows_of(folder, ["v", Formula("1+1", "2"), "pb", Formula("D9*2", "17.5")])
    assert (one.position, one.mm) == ("2", 17.5)


@pytest.mark.parametrize(
    ("cell", "says"),
    [
        (Formula("1+1"), "a formula without a result"),
        (Shown(44927, "date"), "is a date"),
        ("1,5,2", "one piece"),
        ("#DIV/0!", "not a number"),
        ("abc", "not a number"),
    ],
)
def test_a_cell_that_is_no_figure_is_told_by_its_row(folder, cell, says):
    error = refused(
        folder, workbook({"s": [["# note"], HEAD, ["v", "1", "pb", 1], [], ["v", "2", "pb", cell]]})
    )
    (fault,) = error.faults
    assert (fault.key, fault.line) == ("mm", 5)
    assert says in fault.message


def test_titles_need_not_stand_in_the_first_row_nor_on_the_first_sheet(folder):
    sheets = {
        "about": [["Student: N."], ["velocities", "are", "in", "mm"]],
        "отсчёты": [["Вариант 7"], [], RUSSIAN, ["v", 1, "pb", 17.5]],
    }
    (one,) = read(folder, workbook(sheets))
    assert (one.mm, one.line) == (17.5, 4)


def test_a_sheet_with_titles_only_is_passed_by_but_two_with_readings_are_refused(folder):
    rows = [HEAD, ["v", 1, "pb", 17.5]]
    assert len(read(folder, workbook({"a": [HEAD, ["v", 1, "pb"]], "b": rows}))) == 1
    assert "several sheets hold readings (a, b)" in str(
        refused(folder, workbook({"a": rows, "b": rows}))
    )


def test_rows_that_a_dimension_does_not_tell_are_read(folder):
    assert len(rows_of(folder, ["v", 1, "pb", 1], ["v", 2, "pb", 2], dimension="A1:B1")) == 2


def test_titles_that_are_missing_are_told(folder):
    error = refused(folder, workbook({"s": [["plan", "mm"], ["v", 1]]}))
    assert {fault.key for fault in error.faults} == {"position", "segment"}
    assert "empty" in str(refused(folder, workbook({"s": [[]]})))


@given(
    rows=st.lists(
        st.tuples(
            st.sampled_from(["velocities", "ускорения"]),
            st.sampled_from(["1", "6*", ""]),
            st.text("abπω3_=#'′", min_size=1, max_size=5).filter(lambda name: name.strip() == name),
            st.none() | st.floats(-1e6, 1e6).map(lambda x: float(f"{x:.12g}")),
            st.none() | st.floats(-1e6, 1e6).map(lambda x: float(f"{x:.12g}")),
        ),
        max_size=5,
        unique_by=lambda row: row[:3],
    ),
    language=st.sampled_from(["en", "ru"]),
)
@settings(max_examples=most(30), deadline=None)
@pytest.mark.slow
def test_what_is_written_is_read_back(folder, rows, language):
    taken = [
        Taken(plan, position, segment, mm, value, "m/s" if value is not None else "")
        for plan, position, segment, mm, value in rows
    ]
    data = file_of("out.xlsx", taken, language=language, told=["first", "=second"])
    back = read(folder, data) if taken else ()
    kept = [one for one in taken if one.mm is not None or one.value is not None]
    assert [one._replace(line=0, last=Last()) for one in back] == kept


def test_the_same_rows_are_the_same_bytes_whenever_they_are_written(monkeypatch):
    import datetime

    import openpyxl.writer.excel as writer

    class Later(datetime.datetime):
        @classmethod
        def now(cls, tz=None):
            return cls(2031, 1, 1, tzinfo=tz)

    first = file_of("a.xlsx", [Taken("v", "1", "pb", mm=1.0)], language="ru", told=["a"])
    monkeypatch.setattr(writer.datetime, "datetime", Later)
    assert file_of("a.xlsx", [Taken("v", "1", "pb", mm=1.0)], language="ru", told=["a"]) == first


@pytest.mark.parametrize("place", range(0, 100, 7))
def test_a_damaged_workbook_is_readings_or_a_message(folder, place):
    data = bytearray(workbook({"s": [HEAD, ["v", 1, "pb", 17.5], ["v", 2, "pb", 7]]}))
    at = 4 + place * (len(data) - 4) // 100
    for damaged in (data[:at], data[:at] + b"\xff\0<" + data[at + 3 :]):
        faults = ("none",)
        try:
            read(folder, bytes(damaged))
        except SceneError as error:
            faults = error.faults
        assert faults


@pytest.mark.parametrize(
    "files",
    [
        {"a.txt": "hello"},
        {"mimetype": "application/vnd.oasis.opendocument.spreadsheet", "content.xml": "<a/>"},
        {"xl/workbook.xml": "<workbook/>", "[Content_Types].xml": "<Types/>"},
    ],
)
def test_an_archive_that_is_no_workbook(folder, files):
    assert "no xlsx workbook" in str(refused(folder, zipped(files)))


def test_a_workbook_that_unpacks_to_too_much_is_not_unpacked(folder):
    big = zipped({"xl/worksheets/sheet1.xml": b"\0" * 70_000_000})
    assert len(big) < 100_000
    assert "too large" in str(refused(folder, big))


def test_a_row_beyond_all_rows_ends_the_reading(folder):
    data = workbook({"s": [HEAD, ["v", 1, "pb", 17.5]]})
    far = {}
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        for name in archive.namelist():
            far[name] = archive.read(name).replace(b'<row r="2">', b'<row r="99999999999">')
    assert "no xlsx workbook" in str(refused(folder, zipped(far)))


def test_old_workbooks_and_a_missing_library_are_told(folder, monkeypatch):
    assert "an old workbook" in str(
        refused(folder, b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + bytes(600))
    )
    monkeypatch.setitem(sys.modules, "openpyxl", None)
    assert "graphic-tmm[xlsx]" in str(refused(folder, workbook({"s": [HEAD]})))
    with pytest.raises(SheetError, match="graphic-tmm\\[xlsx\\]"):
        file_of("a.xlsx", [], language="en")


def test_a_workbook_and_a_text_of_the_same_cells_are_the_same_readings(folder):
    source = random.Random(11)
    rows = []
    for k in range(200):
        mm, x = round(source.uniform(-200, 200), 1), round(source.uniform(-99, 99), 2)
        figures = source.choice(([mm], [mm, x, "m/s"], [None, None, None, x, mm]))
        rows.append(
            [source.choice(["velocities", "силы"]), k, source.choice(["πa", "P_ур"]), *figures]
        )
    text = "\n".join(";".join("" if c is None else str(c) for c in row) for row in [HEAD, *rows])
    file = folder / "same.csv"
    file.write_text(text, "utf-8")
    assert read(folder, workbook({"s": [HEAD, *rows]})) == read_readings(file)


def test_a_damaged_workbook_is_not_called_a_text(tmp_path):
    file = tmp_path / "Ivanov 04.XLSX"
    file.write_bytes(bytes(range(256)) * 12)
    with pytest.raises(SceneError, match="no xlsx workbook, or a damaged one"):
        read_readings(file)
