"""Readings as people have them: whatever their table looks like it is understood, or refused; never misread."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest
from click.testing import CliRunner
from support.gallery import CASES
from support.later_ways_of_writing import LAST
from support.ways_of_writing import FIRST, HEAD, REFUSED, V, W, book, rows, sv

from graphic_tmm.checking.cells import points
from graphic_tmm.checking.check import known_readings
from graphic_tmm.checking.readings.letters import letters_of
from graphic_tmm.checking.readings.read import FileReadings, readings_of
from graphic_tmm.commands.check import check
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.errors import SceneError
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

SIX = CASES / "check" / "six.toml"
NOT_YET = {
    "crosstab values in unit column",
    "two tables side by side",
    "φ, град col",
    "ω3 in mm with unit",
    "v in mm with m/s",
    "План скоростей (1)",
    "W_D old letter",
    "a^отн_A3A",
}
"""They could be understood, and are refused."""


@cache
def six() -> DrawnScene:
    return make(read(SIX), exact=True)


def understood(way: W) -> tuple[dict[tuple[str, str, str], tuple[str, float]], tuple[str, ...]]:
    """Return what was understood of a way of writing, nothing where it was refused; notes."""
    suffix = "xlsx" if way.file.startswith(b"PK") else "csv"
    try:
        taken = readings_of(Path(f"r.{suffix}"), way.file)
        letters = {**taken.letters, **letters_of([way.letters])[0]}
        named, notes = known_readings(six(), FileReadings.of(taken, taken.notes, letters), "r")
    except SceneError:
        return {}, ()
    found = {}
    for one in named:
        figure = one.mm if one.mm is not None else one.value
        assert figure is not None
        found[one.key] = "v" if one.mm is None else "mm", round(figure, 3)
    return found, notes


@pytest.mark.turns(60)
@pytest.mark.parametrize("way", [*FIRST, *LAST], ids=lambda way: way.name)
def test_a_way_of_writing_is_understood_or_refused(way: W) -> None:
    due = REFUSED if way.name in NOT_YET else way.due
    assert understood(way)[0] == due


def said_of(*text: str) -> str:
    return "\n".join(understood(W("", sv(*text), {}))[1])


def test_what_was_not_written_is_said() -> None:
    """A column left out, cells filled, a position by its angle or in Roman figures, letters, a plan."""
    left_out = said_of("план;положение;отрезок;мм;итого", "скорости;1;pd;25,1;3")
    assert 'the column "итого" means nothing here' in left_out
    empty = said_of("план;положение;отрезок;мм;итого", "скорости;1;pd;25,1;")
    assert "итого" not in empty
    assert "line 3" in said_of(HEAD, "скорости;1;pa;82,5", ";;pd;25,1")
    assert "by its angle" in said_of(HEAD, "скорости;φ=45;pd;25,1")
    assert '"III" was read as 3' in said_of(HEAD, "скорости;III;pd;30")
    assert "by the letters" in said_of("буквы;E=D", HEAD, "скорости;1;pe;25,1")
    assert "no plan is named" in said_of("отрезок;1;3", "pd;25,1;30")
    assert "is no length" in said_of("скорости;1;3", "ω3;4,9;-4")


def test_a_quantity_without_a_unit_may_be_either() -> None:
    with pytest.raises(SceneError, match="may be mm or a quantity"):
        readings_of(Path("r.csv"), sv("скорости;1;3", "V_D;1,004;1,2"))


def test_a_name_that_several_plans_have_is_refused() -> None:
    """a is a point of both plans."""
    rows_ = sv("положение;отрезок;x;y", "1;a;3;4")
    with pytest.raises(SceneError, match="velocities or accelerations"):
        known_readings(six(), readings_of(Path("r.csv"), rows_), "r")


def test_letters_of_the_scene_that_were_exchanged() -> None:
    exchanged = sv("буквы;C=D;D=C", HEAD, "скорости;1;pc;25,1", "скорости;1;pd;24,8")
    found = understood(W("", exchanged, {}))[0]
    assert found == {(V, "pd", "1"): ("mm", 25.1), (V, "pc", "1"): ("mm", 24.8)}


def test_lines_of_several_sheets_are_counted_on() -> None:
    some = [["отрезок", 1, 3], ["pd", 25.1, 30]]
    more = [["отрезок", 1, 3], ["πd", 14.9, 13]]
    taken = readings_of(Path("r.xlsx"), book(("Скорости", some, []), ("Ускорения", more, [])))
    assert [one.line for one in taken] == [2, 2, 4, 4]


def run(folder: Path, data: bytes, *options: str) -> tuple[int, str]:
    file = folder / "r.csv"
    file.write_bytes(data)
    done = CliRunner().invoke(check, [str(SIX), str(file), "--trials", "50", *options])
    return done.exit_code, f"{done.output}{done.exception}"


def test_no_reading_at_all_is_refused_with_what_was_left_out(tmp_path: Path) -> None:
    status, text = run(tmp_path, sv(f"{HEAD};итого", "скорости;1;pd;;3"))
    assert status != 0
    assert "no row holds a figure" in text
    assert "итого" in text
    assert run(tmp_path, rows("скорости;1;pd;25,1"))[0] == 0


def test_the_option_of_letters(tmp_path: Path) -> None:
    data = rows("скорости;1;pe;25,1")
    assert run(tmp_path, data)[0] != 0
    assert run(tmp_path, data, "--letters", "E=D")[0] == 0
    assert "no pair of letters" in run(tmp_path, data, "--letters", "E")[1]


def test_a_scale_factor_below_a_position_is_of_all_of_them() -> None:
    data = rows("скорости;1;pa;82,5", ";;pd;25,1", ";;μ;0,04")
    assert [one.position for one in readings_of(Path("r.csv"), data)] == ["1", "1", ""]


def test_a_letter_is_proposed_by_its_place_and_taken_only_when_it_is_given() -> None:
    """a of velocities stands at position 1 where the student has e; c and d are too near each other to tell."""
    due, other = points(six())[V, "a", "1"], points(six())[V, "d", "1"]
    text = f"{due.real + 0.6:.1f};{due.imag - 0.4:.1f}"
    head = "план;положение;отрезок;x;y"
    with pytest.raises(SceneError, match="letters;E=A"):
        known_readings(six(), readings_of(Path("r.csv"), sv(head, f"{V};1;e;{text}")), "r")
    with pytest.raises(SceneError) as far:
        known_readings(
            six(),
            readings_of(Path("r.csv"), sv(head, f"{V};1;e;{other.real:.1f};{other.imag:.1f}")),
            "r",
        )
    assert "letters" not in str(far.value)
    taken = readings_of(Path("r.csv"), sv("буквы;E=A", head, f"{V};1;e;{text}"))
    assert [one.key for one in known_readings(six(), taken, "r")[0]] == [(V, "a", "1")]
