"""Tables of variants: as people and spreadsheets write them, every fault at once, and back as they were."""

from __future__ import annotations

import random
import string
import tempfile
from contextlib import suppress
from pathlib import Path

import openpyxl
import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.each import each

from graphic_tmm.classroom.variants.table import read_variants, write_variants
from graphic_tmm.classroom.variants.variant import Value, Variant
from graphic_tmm.errors import SceneError

DUE = (
    Variant("1", (Value("OA", "110", "mm"), Value("drive.speed", "60", "rpm")), 2),
    Variant("Иванов_А", (Value("OA", "12.5", "mm"), Value("links.5.mass", "50 kg", "")), 3),
)


def written(tmp_path: Path, data: str | bytes, name: str = "v.csv") -> Path:
    file = tmp_path / name
    file.write_bytes(data.encode() if isinstance(data, str) else data)
    return file


@each(
    "text",
    [
        'variant,"OA, mm",drive.speed [rpm],links.5.mass\n1,110,60,\nИванов_А,12.5,,50 kg\n',
        "вариант;OA, mm;drive.speed, rpm;links.5.mass\n1;110;60;\nИванов_А;12,5;;50 kg\n",
        "№\tOA (mm)\tdrive.speed (rpm)\tlinks.5.mass\n1\t110\t60\nИванов_А\t12.5\t\t50 kg\n",
        " student ;OA [mm];drive.speed, rpm;links.5.mass;;\n1;110 ; 60;;;\nИванов_А;12.5;;50  kg\n;;;\n",
    ],
)
@each("encoding", ["utf-8", "utf-8-sig", "utf-16", "cp1251"])
def test_a_table_is_read_however_it_is_saved(text: str, encoding: str, tmp_path: Path) -> None:
    assert read_variants(written(tmp_path, text.encode(encoding))) == DUE


def test_a_workbook_is_read_with_its_numbers(tmp_path: Path) -> None:
    book = openpyxl.Workbook()
    for row in (
        ("variant", "OA (mm)", "drive.speed, rpm", "links.5.mass"),
        (1, 110, 60, None),
        ("Иванов_А", 12.5, None, "50 kg"),
    ):
        book.active.append(row)
    book.save(tmp_path / "v.xlsx")
    assert read_variants(tmp_path / "v.xlsx") == DUE


FAULTS = {
    "": ["first row holds titles"],
    "variant,OA\n": ["no variant below"],
    "variant\n1\n": ["first row has 1 titles"],
    "variant,OA,OA\n1,2,3\n": ["1: OA: this column stands twice"],
    "variant,,OA\n1,2,3\n": ["a column without a title"],
    "variant,OA (miles)\n1,2\n": ['the unit "miles" is not known'],
    "variant,OA, mm\n1,2\n": ['"mm" is a unit'],
    "variant,OA\n,5\n7,6\nA b,7\n7,1\nx,1,2\n": [
        ":2: the variant has no name",
        ':4: "A b" is no name',
        ':5: "7" is called as the variant of line 3',
        ":6: the row has 3 cells",
    ],
    "variant,OA\nab,1\nAB,2\n": [':3: "AB" is called as the variant of line 2'],
    "variant,OA\n../x,1\n": ["is no name of a variant"],
    "variant,OA\n1,5\u200b\n": ["U+200B"],
    'variant,OA\n1,"5\n': ["cannot be split into cells"],
}


@each("text, says", FAULTS.items())
def test_all_faults_are_told_with_their_lines(text: str, says: list[str], tmp_path: Path) -> None:
    with pytest.raises(SceneError) as told:
        read_variants(written(tmp_path, text))
    assert len(told.value.faults) == len(says)
    for one, line in zip(says, str(told.value).splitlines(), strict=True):
        assert one in line


def test_too_many_variants_are_refused(tmp_path: Path) -> None:
    rows = "".join(f"v{k},1\n" for k in range(100_001))
    with pytest.raises(SceneError, match="at most 100000"):
        read_variants(written(tmp_path, "variant,OA\n" + rows))


NAMES = st.from_regex(r"[A-Za-zА-я0-9_][A-Za-z0-9_.-]{0,20}", fullmatch=True)
TYPED = st.one_of(
    st.integers(-(10**6), 10**6).map(str),
    st.decimals(-1000, 1000, places=2).map(lambda d: f"{d:f}"),
    st.sampled_from(
        ["0.4 BC", "60 kg", "=1+2", "[2, 5]", '"', "a;b", "x,y", "# no", "1,5 см", "+1"]
    ),
)


@given(
    st.lists(
        st.tuples(NAMES, st.tuples(TYPED, TYPED, TYPED)),
        min_size=1,
        max_size=5,
        unique_by=lambda one: one[0].casefold(),
    ),
    st.sampled_from(["en", "ru"]),
)
def test_what_is_written_is_read_back(
    found: list[tuple[str, tuple[str, str, str]]], language: str
) -> None:
    keys = (("OA", "mm"), ("drive.speed", "об/мин"), ("link 5, mass", ""))
    due = tuple(
        Variant(name, tuple(Value(k, v, u) for (k, u), v in zip(keys, values, strict=True)))
        for name, values in found
    )
    with tempfile.TemporaryDirectory() as folder:
        for name in ("v.csv", "v.xlsx"):
            file = written(Path(folder), write_variants(due, name, language=language), name)
            assert tuple(one._replace(line=0) for one in read_variants(file)) == due, name


def test_a_formula_is_text_in_a_workbook(tmp_path: Path) -> None:
    one = Variant("1", (Value("title", "=1+2"), Value("OA", "5")))
    file = written(tmp_path, write_variants([one], "v.xlsx"), "v.xlsx")
    cells = list(openpyxl.load_workbook(file).active[2])
    assert [cell.data_type for cell in cells] == ["s", "s", "n"]
    assert cells[1].value == "=1+2"


def test_whatever_stands_in_a_file_is_told_or_read(tmp_path: Path) -> None:
    random_, good = random.Random(5), b"variant;OA, mm;drive.speed\n1;110;60\n2;120;70\n"
    signs = string.printable.encode() + bytes(range(256))
    for _ in range(400):
        data = bytearray(good)
        for _ in range(random_.randrange(1, 8)):
            at = random_.randrange(len(data))
            data[at : at + random_.randrange(3)] = bytes(random_.choices(signs, k=2))
        with suppress(SceneError):
            assert read_variants(written(tmp_path, bytes(data)))
