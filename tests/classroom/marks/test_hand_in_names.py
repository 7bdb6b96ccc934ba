"""Which hand-in a name tells: variant, student, sheet; what names none or two."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from support.each import each

from graphic_tmm.classroom.batch.record import is_safe
from graphic_tmm.classroom.marks.names import HandIn, hand_ins
from graphic_tmm.errors import SheetError

THIRTY = [f"{k:02d}" for k in range(1, 31)]


def handed(folder: Path, *names: str, variants: list[str] | None = THIRTY) -> tuple[HandIn, ...]:
    """Return the hand-ins of a folder that holds empty files of these names; none is skipped."""
    put(folder, *names)
    found, skipped = hand_ins(folder, variants)
    assert skipped == ()
    return found


def put(folder: Path, *names: str) -> None:
    for name in names:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text("", "utf-8")


NAMES = {
    "07.csv": ("07", ""), "Иванов-07.csv": ("07", "Иванов"), "07 Иванов.xlsx": ("07", "Иванов"),
    "7.csv": ("07", ""), "ivanov_07.csv": ("07", "ivanov"),
    "Group 2015 Petrov (12).csv": ("12", "Group 2015 Petrov"),
    "Sidorov_B 30.CSV": ("30", "Sidorov B"),
}  # fmt: skip


@each("name", NAMES)
def test_a_name_tells_variant_and_student(tmp_path: Path, name: str) -> None:
    (one,) = handed(tmp_path, name)
    assert (one.variant, one.student) == NAMES[name]


@each(
    "name", ["nobody.csv", "07_12.csv", "31.csv", "a7.csv", "7b.csv", "12-1.csv", "Ivanov 3/04.csv"]
)
def test_a_name_of_none_or_of_two_is_skipped(tmp_path: Path, name: str) -> None:
    put(tmp_path, name)
    found, skipped = hand_ins(tmp_path, THIRTY)
    assert found == ()
    assert [one.name for one in skipped] == [name]


def test_photographs_of_several_sheets_are_one_hand_in(tmp_path: Path) -> None:
    (one,) = handed(tmp_path, "ivanov_07_1.jpg", "ivanov_07_2.jpg", "ivanov_07.csv")
    assert [path.name for path in one.tables] == ["ivanov_07.csv"]
    assert [(path.name, sheet) for path, sheet in one.photographs] == [
        ("ivanov_07_1.jpg", 1),
        ("ivanov_07_2.jpg", 2),
    ]


def test_a_folder_is_a_hand_in(tmp_path: Path) -> None:
    (one,) = handed(tmp_path, "Петров 10/readings.csv", "Петров 10/sheet1.jpg", "Петров 10/2.png")
    assert (one.name, one.variant, one.student) == ("Петров 10", "10", "Петров")
    assert [sheet for _, sheet in one.photographs] == [2, 1]


def test_a_folder_without_a_variant_has_that_of_its_files(tmp_path: Path) -> None:
    (one,) = handed(tmp_path, "Иванов Иван_123456_file_/11.csv")
    assert (one.variant, one.student) == ("11", "Иванов Иван 123456 file")


def test_a_folder_with_files_of_two_variants_is_skipped(tmp_path: Path) -> None:
    put(tmp_path, "Иванов/11.csv", "Иванов/12.csv")
    found, skipped = hand_ins(tmp_path, THIRTY)
    assert found == ()
    assert [one.name for one in skipped] == ["Иванов"]


def test_variants_with_signs_in_their_names(tmp_path: Path) -> None:
    found = handed(tmp_path, "7-a Orlov.csv", "7 Popov.csv", variants=["7", "7-a"])
    assert {(one.variant, one.student) for one in found} == {("7-a", "Orlov"), ("7", "Popov")}


def test_without_variants_every_file_is_a_hand_in(tmp_path: Path) -> None:
    found = handed(tmp_path, "07_12.csv", "anybody.csv", "b/x.csv", "b/y.csv", variants=None)
    assert [one.name for one in found] == ["07_12", "anybody", "b"]


def test_what_systems_leave_behind_is_not_looked_at(tmp_path: Path) -> None:
    assert (
        handed(tmp_path, ".DS_Store", "Thumbs.db", "~$07.xlsx", "__MACOSX/07.csv", ".x/07.csv")
        == ()
    )


def test_what_is_neither_readings_nor_photograph_is_told(tmp_path: Path) -> None:
    put(tmp_path, "07.pdf", "08.docx")
    assert [one.name for one in hand_ins(tmp_path, THIRTY)[1]] == ["07.pdf", "08.docx"]


HOSTILE = [
    "<script>alert(1)<_script> 01.csv", "=HYPERLINK(\"x\") 02.csv", "a\x1b[31m 03.csv", "tab\tnew\nline 04.csv",
    "й" * 100 + " 05.csv", "CON 06.csv", "... 07.csv", "a\u202eb 08.csv", "x 09 .csv", "A 10.csv", "a 10.csv",
    ": 11.csv", "* 12.csv",
]  # fmt: skip


def test_files_are_called_so_that_every_disk_takes_it(tmp_path: Path) -> None:
    found = handed(tmp_path, *HOSTILE)
    names = [one.file for one in found]
    assert len(found) == len(HOSTILE) - 2  # "A 10" and "a 10" are one student's; one is hidden
    assert all(is_safe(f"reports/{name}.html") for name in names)
    assert len({name.casefold() for name in names}) == len(names)


def test_the_order_is_fixed(tmp_path: Path) -> None:
    (tmp_path / "a").mkdir()
    (tmp_path / "b").mkdir()
    names = [f"{name} {k:02d}.csv" for k, name in enumerate("gcaebd", 1)]
    one = handed(tmp_path / "a", *names)
    other = handed(tmp_path / "b", *reversed(names))
    assert [x.name for x in one] == [x.name for x in other] == sorted(n[:-4] for n in names)


def test_no_folder_is_told(tmp_path: Path) -> None:
    with pytest.raises(SheetError, match="no folder"):
        hand_ins(tmp_path / "none", THIRTY)


@pytest.mark.skipif(os.name != "posix", reason="links need rights elsewhere")
def test_no_link_is_followed_out_of_the_folder_or_in_it(tmp_path: Path) -> None:
    """A file, a folder, a link that leads nowhere, one to another's hand-in: each is skipped by name."""
    secret, handed_in = tmp_path / "secret", tmp_path / "class"
    put(secret, "05.csv")
    put(handed_in, "07.csv")
    links = {
        "01.csv": secret / "05.csv", "02 Ivanov": secret, "03.csv": tmp_path / "nothing",
        "04.csv": handed_in / "07.csv", "in/06.csv": secret / "05.csv",
    }  # fmt: skip
    (handed_in / "in").mkdir()
    for name, target in links.items():
        (handed_in / name).symlink_to(target)
    for variants in (THIRTY, None):
        found, skipped = hand_ins(handed_in, variants)
        assert [one.name for one in found] == ["07"]
        assert sorted(one.name for one in skipped) == sorted(links)
        assert all("link" in one.why for one in skipped)
    aside = tmp_path / "aside"  # the folder itself may be reached by one: the teacher has named it
    aside.symlink_to(handed_in)
    assert len(hand_ins(aside, THIRTY)[0]) == 1


def test_a_number_and_the_same_with_zeros_before_it_are_two_variants_where_both_are_there(
    tmp_path: Path,
) -> None:
    put(tmp_path, "1.csv", "01.csv", "Ivanov-1.xlsx", "Petrov 01.xlsx")
    found, skipped = hand_ins(tmp_path, ["01", "1"])
    assert skipped == ()
    own = {one.name: one.variant for one in found}
    assert own == {"1": "1", "01": "01", "Ivanov-1": "1", "Petrov 01": "01"}
