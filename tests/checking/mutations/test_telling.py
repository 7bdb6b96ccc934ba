"""What is said of a diagnosis: what a mistake explains, what stands beside it, factors that readings have."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from support.gallery import CASES
from support.own_student.machines import MACHINES
from support.own_student.student import due_factors, student
from support.own_told import kind_of, report_of, with_mistake

from graphic_tmm.checking.check import check
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.records import UNKNOWN
from graphic_tmm.scene.read import read


@pytest.mark.slow
def test_a_slip_beside_a_mistake_is_not_explained_by_it_nor_the_only_thing_off() -> None:
    """n from the wrong end, and pb written without its decimal point in position 3 (line 25)."""
    rows = [
        one._replace(mm=455.0)
        if (one.plan, one.segment, one.position) == ("velocities", "pb", "3")
        else one
        for one in read_readings(CASES / "check" / "normal_from_the_wrong_end_sc.csv")
    ]
    report = check(read(CASES / "check" / "sc.toml"), rows)
    normal, slip = report.mistakes
    (line,) = (one.taken.line for one in report.readings if one.found == 455.0)
    assert line not in normal.lines
    wrong = {one.taken.line for one in report.readings if one.verdict == "wrong"}
    assert wrong == {*normal.lines, line}
    assert slip.lines == (line,)
    assert slip.says == "by itself pb at position 3 is off: its decimal point has perhaps slipped"


@pytest.mark.slow
def test_a_factor_is_told_as_the_readings_have_it() -> None:
    """All rates of a plan 130 times too large are not 100 times so."""
    rows = [
        one._replace(value=130.0 * one.value)
        if one.plan == "accelerations" and one.value is not None
        else one
        for one in read_readings(CASES / "check" / "honest_six_mm.csv")
    ]
    (first, *_) = check(read(CASES / "check" / "six.toml"), rows).mistakes
    told = re.search(r"are about (\d+) times as large", first.says)
    assert told
    assert abs(int(told[1]) / 130.0 - 1.0) < 0.1


def test_a_vector_drawn_the_other_way_is_told_once() -> None:
    """Not its length, its line and its end as three mistakes of which nobody could tell which."""
    rows = read_readings(CASES / "check" / "normal_from_the_wrong_end_sc.csv")
    (normal,) = check(read(CASES / "check" / "sc.toml"), rows).mistakes
    assert normal.like == ()
    assert normal.says.endswith("the normal component an2 points away from the centre of rotation")
    assert normal.view == "accelerations"


@pytest.mark.slow
def test_wrong_figures_of_tables_lead_to_a_finding(tmp_path: Path) -> None:
    """Forces, which are no step of a log that can be read, off in a way that no mistake makes."""
    machine = MACHINES["frc"]
    (file := tmp_path / "forces.csv").write_text(
        student(machine, 1, mu=due_factors(machine)).csv, encoding="utf-8"
    )
    times = np.random.default_rng(5).uniform(1.5, 3.5, 200).tolist()
    rows = [
        one._replace(mm=times[k] * one.mm, value=None)
        if one.mm is not None and one.plan == "forces"
        else one
        for k, one in enumerate(read_readings(file))
    ]
    report = check(read(machine.scene).spoken_in("en"), rows)
    assert report.wrong
    last = report.mistakes[-1]
    assert (last.kind, last.plan) == (UNKNOWN, "forces")
    assert re.match(
        r"no known mistake explains what is wrong: begin with R\w+ at position \d", last.says
    )


@pytest.mark.slow
def test_a_force_that_was_found_about_another_point_is_no_slip() -> None:
    """Perhaps it is that: the scale factor of the forces is the student's own."""
    report = report_of(with_mistake(kind_of("moments about A"), 0))
    assert not isinstance(report, str)
    (first, *_) = report.mistakes
    assert (first.kind, first.plan) == ("mistake", "forces")
    assert first.chance < 0.8
    assert "A was taken instead of B" in first.says


@pytest.mark.slow
def test_a_result_that_no_other_reading_confirms_is_no_sure_slip() -> None:
    """It may be what it was found from: here it is."""
    report = report_of(with_mistake(kind_of("balancing force by the diameter, header"), 0))
    assert not isinstance(report, str)
    (first, *_) = report.mistakes
    assert first.kind == "slip"
    assert first.chance < 0.8
    assert first.says.endswith("or what it is found from: no other reading tells which")


@pytest.mark.slow
def test_a_reading_among_fine_ones_of_its_segment_is_a_sure_slip() -> None:
    """An ordinate of S, the signs of a being as they should."""
    rows = [
        one._replace(mm=-one.mm) if one.segment == "a" and one.mm is not None else one
        for one in read_readings(CASES / "check" / "reversed_acceleration_diagram_frc.csv")
    ]
    rows = [
        one._replace(mm=-50.0) if (one.segment, one.position) == ("S", "5") else one for one in rows
    ]
    (first,) = check(read(CASES / "check" / "frc.toml"), rows).mistakes
    assert (first.kind, first.segment, first.chance) == ("slip", "S", 1.0)


@pytest.mark.slow
def test_what_nobody_knows_is_begun_where_the_drawing_goes_wrong_first() -> None:
    """ab, by a factor that changes with the position, and pb much more so: pb comes later."""
    rng = np.random.default_rng(3)
    rows = [
        one._replace(mm=one.mm * by * rng.uniform(0.8, 1.25))
        if one.plan == "velocities" and one.mm and (by := {"ab": 1.5, "pb": 3.0}.get(one.segment))
        else one
        for one in read_readings(CASES / "check" / "normal_from_the_wrong_end_sc.csv")
    ]
    report = check(read(CASES / "check" / "sc.toml"), rows)
    (unknown,) = [one for one in report.mistakes if one.kind == UNKNOWN]
    assert unknown.says.endswith(": ab")


@pytest.mark.parametrize(
    ("kind", "turn", "once"),
    [
        ("s2 from b", 0, "exchanged in the similarity"),
        ("the plan of the position before", 1, "crank"),
    ],
)
def test_what_means_the_same_is_told_once(kind: str, turn: int, once: str) -> None:
    report = report_of(with_mistake(kind_of(kind), turn, 33000))
    assert not isinstance(report, str)
    (first, *_) = report.mistakes
    says = (first.says, *first.like)
    assert [once in one or "circle" in one for one in says].count(True) == 1


@pytest.mark.slow
def test_a_mistake_of_signs_explains_readings_that_bear_the_other_sign() -> None:
    """Their magnitudes are right: V and a of a diagram that is upside down."""
    report = report_of(with_mistake(kind_of("S, V, a upside down"), 0, 70000))
    assert not isinstance(report, str)
    (first, *_) = report.mistakes
    wrong = {one.taken.line for one in report.readings if one.verdict == "wrong"}
    assert len(wrong) > 10
    assert set(first.lines) == wrong
