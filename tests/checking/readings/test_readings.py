"""Readings come back from CSV as they were taken, however the file was saved; what cannot be read is told."""

from __future__ import annotations

import codecs
import csv
import io

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from support.each import each

from graphic_tmm.checking.readings.read import TOLD, read_readings
from graphic_tmm.checking.readings.writing import write_readings
from graphic_tmm.checking.records import Last, Taken
from graphic_tmm.errors import SceneError

HEADS = ("plan", "position", "segment", "mm", "value", "unit", "x", "y")
RUSSIAN = ("план", "положение", "отрезок", "мм", "величина", "единица", "x", "y")
ENCODINGS = {
    "UTF-8": lambda text: text.encode("utf-8"),
    "UTF-8 with BOM": lambda text: text.encode("utf-8-sig"),
    "UTF-16": lambda text: text.encode("utf-16"),
    "UTF-16, most significant first": lambda text: codecs.BOM_UTF16_BE + text.encode("utf-16-be"),
    "UTF-16 without BOM": lambda text: text.encode("utf-16-le"),
    "UTF-16 without BOM, most significant first": lambda text: text.encode("utf-16-be"),
    "UTF-32": lambda text: text.encode("utf-32"),
    "Windows-1251": lambda text: text.encode("cp1251"),
}
PAIR = [
    Taken("velocities", "1", "pb", mm=17.5, line=2),
    Taken("скорости", "6*", "ωб", value=-0.25, unit="рад/с", line=3),
]

# names in their normal form: no control characters, single spaces within
SIGNS = st.characters(
    blacklist_categories=("Cc", "Cs", "Zl", "Zp", "Zs"), blacklist_characters="\ufeff"
)
DITTO = {'"', "''", "〃", "//", "-//-", "—//—", '-"-', '—"—', "то же", "ditto", "so"}
WORDS = st.lists(st.text(SIGNS, min_size=1, max_size=6), min_size=1, max_size=3)
NAMES = WORDS.map(" ".join).filter(
    lambda name: name == " ".join(name.split()) and name not in DITTO
)
NUMBERS = st.floats(-1e12, 1e12)
UNITS = NAMES.filter(lambda unit: unit not in ("1", "-", "–", "—"))


@st.composite
def taken(draw):
    names = draw(NAMES), draw(st.just("") | NAMES), draw(NAMES)
    mm = draw(st.none() | NUMBERS)
    value = draw(st.none() | NUMBERS)
    unit = draw(st.just("") | UNITS)
    x, y = draw(st.just((None, None)) | st.tuples(NUMBERS, NUMBERS))
    if mm is None and value is None and x is None:
        mm = draw(NUMBERS)
    return Taken(*names, mm, value, unit, x, y)


READINGS = st.lists(taken(), max_size=6, unique_by=lambda one: one[:3])


def read_bytes(folder, data, name="readings.csv"):
    file = folder / name
    file.write_bytes(data)
    return without_digits(read_readings(file))


def without_digits(rows):
    """How finely figures were written is another test's."""
    return tuple(one._replace(last=Last()) for one in rows)


def read_text(folder, text):
    return read_bytes(folder, text.encode("utf-8"))


def refused(folder, text):
    with pytest.raises(SceneError) as caught:
        read_bytes(folder, text.encode("utf-8") if isinstance(text, str) else text)
    return caught.value


def without_lines(rows):
    return [one._replace(line=0) for one in rows]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("readings")


@given(rows=READINGS, language=st.sampled_from(["en", "ru"]))
def test_what_is_written_is_read_back_to_the_last_bit(folder, rows, language):
    back = read_text(folder, write_readings(rows, language=language))
    assert without_lines(back) == rows
    assert [one.line for one in back] == list(range(2, len(rows) + 2))


@given(
    rows=READINGS,
    order=st.permutations(range(10)),
    separator=st.sampled_from([",", ";", "\t"]),
    ends=st.sampled_from(["\n", "\r\n", "\r"]),
    quoting=st.sampled_from([csv.QUOTE_MINIMAL, csv.QUOTE_ALL]),
    encoding=st.sampled_from([name for name in ENCODINGS if name != "Windows-1251"]),
    heads=st.sampled_from([HEADS, RUSSIAN, tuple(head.upper() for head in RUSSIAN)]),
    point=st.sampled_from([".", ","]),
    noise=st.lists(st.sampled_from(["", "   ", '# note, "torn; \t', " #"]), max_size=3),
)
def test_every_way_of_saving_means_the_same(
    folder, rows, order, separator, ends, quoting, encoding, heads, point, noise
):
    """The csv module writes, in every dialect, columns shuffled, two that mean nothing among them."""

    def shuffled(cells):
        return [cells[k] for k in order]

    def typed(one):
        unit = one.unit if one.value is None else one.unit or "1"
        numbers = [
            "" if cell is None else repr(cell).replace(".", point)
            for cell in (one.mm, one.value, one.x, one.y)
        ]
        mm, value, x, y = numbers
        return [*one[:3], mm, value, unit, x, y, "angle, 17", "made by #1"]

    out = io.StringIO()
    writer = csv.writer(out, delimiter=separator, lineterminator=ends, quoting=quoting)
    writer.writerow(shuffled([*heads, "angle_deg", "примечание"]))
    for one in rows:
        out.write("".join(f"{line}{ends}" for line in noise))
        row = shuffled(typed(one))
        # the csv module does not quote a first cell that looks like a comment
        quoted = csv.QUOTE_ALL if row[0].startswith("#") else quoting
        csv.writer(out, delimiter=separator, lineterminator=ends, quoting=quoted).writerow(row)
    assume(heads is not HEADS or separator == ";" or point == "." or _shows_its_comma(rows))
    text = out.getvalue()
    assert without_lines(read_bytes(folder, ENCODINGS[encoding](text))) == rows


def _shows_its_comma(rows):
    """Whether "1,234" is a decimal for sure: in another cell there are not just three digits behind it."""
    cells = [
        repr(cell) for one in rows for cell in (one.mm, one.value, one.x, one.y) if cell is not None
    ]
    return any("." in cell and len(cell.partition(".")[2]) != 3 for cell in cells)


@given(
    plan=st.text("абвгдежзийклмнопрстуфхцчшщъыьэюяАБВЯ19", min_size=1, max_size=9),
    language=st.sampled_from(["en", "ru"]),
)
def test_russian_names_in_windows_1251(folder, plan, language):
    """No word of these letters is UTF-8: after its first bytes (C0 … FF) come others than 80 … BF."""
    rows = [Taken(plan, "1", "отрезок", mm=17.5)]
    text = write_readings(rows, language=language).removeprefix("\ufeff")
    assert without_lines(read_bytes(folder, text.encode("cp1251"))) == rows


@pytest.mark.parametrize("encoding", ENCODINGS)
def test_encodings_are_found_out(tmp_path, encoding):
    text = "план;положение;отрезок;мм;величина;единица\r\n"
    text += "velocities;1;pb;17,5;;\r\nскорости;6*;ωб;;-0,25;рад/с\r\n"
    text = text.replace("ω", "w") if encoding == "Windows-1251" else text
    due = [PAIR[0], PAIR[1]._replace(segment="wб" if encoding == "Windows-1251" else "ωб")]
    assert list(read_bytes(tmp_path, ENCODINGS[encoding](text))) == due


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16", "utf-32"])
def test_two_byte_order_marks_are_as_good_as_one(tmp_path, encoding):
    """As where a text that begins with the mark is saved with one."""
    text = write_readings(PAIR, language="ru")
    assert text[0] == "\ufeff"
    assert list(read_bytes(tmp_path, text.encode(encoding))) == PAIR


@each(
    "cell, due",
    [
        *[("17.5", 17.5), ("17,5", 17.5), ("12 mm", 12.0), ("12mm", 12.0), ("12,5 мм", 12.5)],
        *[("−3", -3.0), ("+3", 3.0), (".5", 0.5), ("5.", 5.0), ("1e2", 100.0), ("1,234 ", 1.234)],
        *[("1,234 mm", 1.234), ("1,5e1", 15.0), ("1000000000000", 1e12)],
        *[(" 17 ", 17.0), ("17\u00a0mm", 17.0), ("0", 0.0), ("1e-999", 0.0), ("12 MM", 12.0)],
    ],
)
def test_millimetres(tmp_path, cell, due):
    assert read_text(tmp_path, f"plan;position;segment;mm\nv;1;pb;{cell}\n")[0].mm == due


@each(
    "value, unit, due",
    [
        *[("16,3", "m/s", (16.3, "m/s")), ("87000 Pa", "", (87000.0, "Pa"))],
        *[("12", "1", (12.0, "")), ("12", "—", (12.0, "")), ("−5 °", "", (-5.0, "°"))],
        *[("3.5 %", "", (3.5, "%")), ("4 1/s", "", (4.0, "1/s")), ("4 кгс", "кгс", (4.0, "кгс"))],
        *[
            ("4 kg·m2", "kg*m^2", (4.0, "kg*m^2")),
            ("", "m/s", (None, "m/s")),
            ("", "1", (None, "")),
        ],
    ],
)
def test_values(tmp_path, value, unit, due):
    text = f"plan;position;segment;value;unit;mm\nv;1;pb;{value};{unit};1\n"
    assert read_text(tmp_path, text)[0][4:6] == due


def test_a_point_and_a_segment_of_one_name_are_two_readings(tmp_path):
    text = "plan,position,segment,mm,x,y\nv,1,b,,12.5,-3\nv,1,b,7,,\n"
    assert read_text(tmp_path, text) == (
        Taken("v", "1", "b", x=12.5, y=-3.0, line=2),
        Taken("v", "1", "b", mm=7.0, line=3),
    )


def test_rows_not_filled_in_are_left_out(tmp_path):
    text = (
        "plan,position,segment,mm,value,unit,x,y\nv,1,pb,,,m/s,,\nv,2,pb,7,,m/s,,\n,,,,,,,\nv,3\n"
    )
    assert read_text(tmp_path, text) == (Taken("v", "2", "pb", mm=7.0, unit="m/s", line=3),)


def test_what_spreadsheets_add_means_nothing(tmp_path):
    text = 'sep=;\n# one\n"# quoted; by a spreadsheet";;\nplan;position;segment;mm;;\nv;1;pb;7;;\n# end;;;\n'
    assert read_text(tmp_path, text) == (Taken("v", "1", "pb", mm=7.0, line=5),)


def test_titles_typed_with_look_alikes(tmp_path):
    text = "План;ПОЛОЖЕНИЕ; Отрезок;х, мм;у (мм)\nv;1;b;1,5;2\n"  # Cyrillic х and у
    assert read_text(tmp_path, text) == (Taken("v", "1", "b", x=1.5, y=2.0, line=2),)


def test_spaces_around_cells_mean_nothing(tmp_path):
    text = 'plan, position, "segment",mm\nv, "1", pb ,  "7,5"\n'
    assert read_text(tmp_path, text) == (Taken("v", "1", "pb", mm=7.5, line=2),)


def test_a_quoted_cell_may_run_over_lines(tmp_path):
    text = 'plan,note,position,segment,mm\nv,"two\n# lines, ""so""\n",1,pb,7\nv,,2,pb,8\n'
    assert [(one.line, one.mm) for one in read_text(tmp_path, text)] == [(2, 7.0), (5, 8.0)]


def test_a_comma_before_three_digits_is_a_decimal_sign_if_another_cell_shows_it(tmp_path):
    text = 'plan,position,segment,mm\nv,1,pb,"1,234"\nv,2,pb,"{}"\n'
    assert read_text(tmp_path, text.format("17,5"))[0].mm == 1.234
    assert "can be read in two ways" in str(refused(tmp_path, text.format("17")))


@pytest.mark.slow
def test_order_and_number_of_many_rows_are_kept(tmp_path):
    many = [f"velocities;{k};pb;{k % 997},25;{k};m/s;1,5;-2,5\n" for k in range(20_000)]
    text = "план;положение;отрезок;мм;величина;единица;x;y\n" + "".join(many)
    file = tmp_path / "many.csv"
    file.write_text(text, "utf-8")
    back = without_digits(read_readings(str(file)))
    assert [one.mm for one in back] == [k % 997 + 0.25 for k in range(20_000)]
    last = ("velocities", "19999", "pb", 19999 % 997 + 0.25, 19999.0, "m/s", 1.5, -2.5)
    assert back[-1] == Taken(*last, line=20_001)


HEAD = "plan,position,segment,mm,value,unit,x,y\n"
WRONG = {
    "nan": ("v,1,pb,nan,,,,", "mm", "not a number"),
    "inf": ("v,1,pb,-inf,,,,", "mm", "not a number"),
    "a word": ("v,1,pb,abc,,,,", "mm", "not a number"),
    "1e999": ("v,1,pb,1e999,,,,", "mm", "too large"),
    "a huge number": (f"v,1,pb,{'9' * 400},,,,", "mm", "too large"),
    "beyond all measure": ("v,1,pb,1e13,,,,", "mm", "too large"),
    "metres": ("v,1,pb,0.12 m,,,,", "mm", "write it in mm"),
    "two numbers": ("v,1,pb,12 13,,,,", "mm", "one piece"),
    "groups of thousands": ('v,1,pb,"1.234,5",,,,', "mm", "one piece"),
    "a fraction": ("v,1,pb,1/2,,,,", "mm", "one piece"),
    "no unit": ("v,1,pb,,12,,,", "value", "no unit"),
    "two units": ("v,1,pb,,12 N,kgf,,", "value", "keep one"),
    "a value that is none": ("v,1,pb,,abc,N,,", "value", "not a number"),
    "half a point": ("v,1,b,,,,3,", "y", "both x and y"),
    "the other half": ("v,1,b,,,,,3", "x", "both x and y"),
    "no segment": ("v,1,,12,,,,", "segment", "empty"),
    "a decimal comma among commas": ("v,1,pb,65,3,,,,,", "value", "no unit"),
    "a surplus cell": ("v,1,b,,,,12,5,3", "", "quote a number"),
    "another separator": ("v;1;pb;12", "", "single cell"),
    "a quote not closed": ('v,"1,pb,12', "", "quote"),
    "a quote within": ('v,"1"2,pb,12', "", "quote"),
}


@each("name", WRONG)
def test_a_fault_names_file_line_column_and_remedy(tmp_path, name):
    row, column, remedy = WRONG[name]
    error = refused(tmp_path, f"{HEAD}v,0,pb,1,,,,\n{row}\n")
    (fault,) = error.faults
    assert (fault.key, fault.line) == (column, 3)
    assert remedy in fault.message
    assert str(error).startswith(f"{tmp_path / 'readings.csv'}:3: {column}")


@pytest.mark.parametrize(
    ("second", "column"),
    [("v,1,pb,13,,,,", "mm"), ("v,1,pb,12,3,N,,", "mm"), ("v, 1 ,pb,12,,,,", "mm")],
)
def test_the_same_reading_twice(tmp_path, second, column):
    (fault,) = refused(tmp_path, f"{HEAD}v,1,pb,12,,,,\n\n{second}\n").faults
    assert (fault.key, fault.line) == (column, 4)
    assert "stands in line 2 already; keep one" in fault.message


def test_a_value_or_a_point_twice(tmp_path):
    faults = refused(
        tmp_path, f"{HEAD}r,,J,,1,kg,,\nr,,J,,2,g,,\nv,1,b,,,,1,2\nv,1,b,,,,1,3\n"
    ).faults
    assert [(fault.key, fault.line) for fault in faults] == [("value", 3), ("x", 5)]


@each(
    "head, keys, remedy",
    [
        ("position,segment,mm", ["plan"], "velocities"),
        ("plan,segment,mm", ["position"], "empty for results"),
        ("plan,position,segmnt,mm", ["segment"], 'did you mean it by "segmnt"?'),
        ("план,положение,отрзок,мм", ["segment"], 'did you mean it by "отрзок"?'),
        ("plan,position,segment,unit", ["mm"], "value and unit"),
        ("plan,position,segment,x", ["y"], "both x and y"),
        ("plan,position,segment,mm,мм", ["мм"], "twice"),
        ("v,1,pb,17.5", ["plan", "position", "segment", "mm"], "the first row names: v, 1, pb"),
        ('"plan,position', [""], "quote"),
        ("колонка|другая", ["plan", "position", "segment", "mm"], "колонка|другая"),
    ],
)
def test_titles_that_are_missing_or_stand_twice(tmp_path, head, keys, remedy):
    error = refused(tmp_path, f"\n# made by hand\n{head}\nv,1,pb,7\n")
    assert [fault.key for fault in error.faults] == keys
    assert {fault.line for fault in error.faults} == {3}
    assert remedy in str(error)


def test_all_faults_at_once_but_not_too_many(tmp_path):
    rows = "".join(f"v,{k},pb,x{k},,,,\n" for k in range(1000))
    faults = refused(tmp_path, HEAD + rows).faults
    assert len(faults) == TOLD + 1
    assert [fault.line for fault in faults[:TOLD]] == list(range(2, TOLD + 2))
    assert "980 more" in faults[-1].message
    exactly = refused(tmp_path, HEAD + "".join(f"v,{k},pb,x,,,,\n" for k in range(TOLD))).faults
    assert len(exactly) == TOLD


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (b"", "empty"),
        (b"\n# nothing\n", "empty"),
        (b"\xff\xd8\xff\xe0\x00\x10JFIF\x00\x01\x02", "not a text"),
        (b"\x89PNG\r\n\x1a\n\x00\x00\x00\rIHDR\x98\xff", "not a text"),
        (b"plan,mm\x98\xff\n", "not a text"),
        (b"plan,position,segment,mm\nv,1,p\x01b,3\n", "not a text"),
        (b"\xff\xfep", "not a text"),
        (b"PK\x03\x04\x14\x00", "save the sheet as CSV"),
    ],
)
def test_what_is_no_table(tmp_path, data, said):
    assert said in str(refused(tmp_path, data))


def test_a_message_stays_short_whatever_the_titles(tmp_path):
    for head in ("," * 100_000, "segmnt" * 20_000, "a," * 50_000 + "segmnt"):
        assert len(str(refused(tmp_path, f"{head}\n"))) < 2000


def test_no_such_file_and_a_folder(tmp_path):
    for path, said in ((tmp_path / "no.csv", "no such file"), (tmp_path, "a folder")):
        with pytest.raises(SceneError, match=said) as caught:
            read_readings(path)
        assert caught.value.path == str(path)
    with pytest.raises(SceneError, match="cannot be read"):
        read_readings("a\0b")


@given(data=st.binary(max_size=200))
def test_no_bytes_bring_anything_but_readings_or_a_message(folder, data):
    for head in (b"", HEAD.encode(), codecs.BOM_UTF16_LE + HEAD.encode("utf-16-le")):
        faults = ("none",)
        try:
            read_bytes(folder, head + data)
        except SceneError as error:
            faults = error.faults
        assert 0 < len(faults) <= TOLD + 1


@given(text=st.text(alphabet='v1,;\t"#\n\r mм.-e', max_size=60))
def test_no_text_loses_a_figure_silently(folder, text):
    """Every row that is read has a figure; where it cannot be read there is a fault."""
    try:
        back = read_text(folder, HEAD + text)
    except SceneError:
        return
    assert all(one.plan and one.segment for one in back)
    assert all({one.mm, one.value, one.x} != {None} for one in back)
