"""A drawing in scale factors, moves and units of its own is judged as it was drawn."""

from __future__ import annotations

import math
from collections import Counter
from functools import cache

import numpy as np
import pytest
from support.another_hand import MACHINES as DRAWN
from support.gallery import CASES, SHEETS
from support.own_student.machines import MACHINES
from support.own_student.student import student
from support.own_told import kind_of, report_of, told, with_mistake

from graphic_tmm.checking.check import Checker
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.records import WRONG, Report, Taken
from graphic_tmm.scene.read import read

FOLDER = CASES / "check"


@cache
def checker(name: str = "sc") -> Checker:
    return Checker(read(FOLDER / f"{name}.toml"))


def report(case: str) -> Report:
    return checker().of(read_readings(FOLDER / f"{case}.csv")).report


@pytest.mark.parametrize(
    ("case", "by"), [("another_mu_mm_and_value", "rows"), ("another_mu_v", "rates")]
)
def test_a_scale_factor_that_rows_or_rates_say_is_used_and_said_first(case: str, by: str) -> None:
    one = report(case)
    (scale,) = one.scales
    assert (scale.plan, scale.mu, scale.due, scale.by) == ("velocities", 0.02, 0.025, by)
    assert one.wrong == 0
    assert "0.02" in one.head[0]


def test_what_only_lengths_say_is_asked() -> None:
    """All is twice as long: right in half the scale factor, nobody can tell."""
    one = report("another_mu_x2")
    assert {(s.plan, round(s.due / s.mu, 3), s.by) for s in one.scales} == {
        ("velocities", 2.0, "round"),
        ("accelerations", 2.0, "round"),
    }
    assert one.wrong == 0
    assert all("if you took" in says for says in one.head)


def rows_of(times: float, rates: float, plan: str = "velocities") -> list[Taken]:
    """Return exact lengths of a plan so many times as long, and rates so many times as large."""
    due = checker()._congruence.due
    found = []
    for (p, segment, place), cell in due.items():
        if p == plan and cell.mm is not None:
            found.append(Taken(p, place, segment, mm=times * abs(cell.mm), line=len(found) + 2))
        elif p == plan and cell.value is not None:
            value = rates * cell.value
            found.append(Taken(p, place, segment, value=value, unit=cell.unit, line=len(found) + 2))
    return found


def test_lengths_and_rates_that_differ_are_a_mistake_and_no_scale_factor() -> None:
    """pa is laid off 1.25 times too long, and ω calculated from that by the task's scale factor."""
    agreed = checker()._congruence.of(rows_of(1.25, 1.25))
    assert not agreed.times
    (scale,) = agreed.scales
    assert scale.by == ""
    assert scale.against == pytest.approx((1.25, 1.0), rel=1e-3)
    own = checker()._congruence.of(rows_of(1.25, 1.0))
    assert [one.by for one in own.scales] == ["rates"]


@pytest.mark.parametrize("times", [0.95, 0.96, 1.04])
def test_a_copy_has_no_scale_factor_of_its_own(times: float) -> None:
    plans = ("positions", "velocities", "accelerations")
    rows = [row for plan in plans for row in rows_of(times, 1.0, plan)]
    assert not checker()._congruence.of(rows).times


@pytest.mark.parametrize(("other", "own"), [(1.25, ["accelerations", "velocities"]), (1.0, [])])
def test_a_plan_a_little_larger_is_in_a_scale_factor_of_its_own_beside_another(
    other: float, own: list[str]
) -> None:
    """Of a plan 1.035 times as large each length fits both; all together do not. Alone it may be a copy."""
    only = [
        one
        for one in (*rows_of(1.035, 1.0), *rows_of(other, 1.0, "accelerations"))
        if one.mm is not None
    ]
    agreed = checker()._congruence.of(only)
    assert sorted({group.plan for group in agreed.times}) == own


@pytest.mark.parametrize(
    ("factor", "unit"), [(0.1, "cm"), (0.18, "cm"), (0.06, "cm"), (1.0 / 25.4, "inch")]
)
def test_centimetres_and_inches_are_told(factor: float, unit: str) -> None:
    agreed = checker()._congruence.of(rows_of(factor, 1.0))
    assert agreed.units == {"velocities": unit}


@pytest.mark.parametrize("factor", [0.26, 0.4])
def test_a_small_plan_is_in_no_other_unit(factor: float) -> None:
    assert not checker()._congruence.of(rows_of(factor, 1.0)).units


@pytest.mark.parametrize("usual", [1.0, 1.25])
def test_scale_factors_of_single_positions_are_told_by_their_rows(usual: float) -> None:
    rows = []
    for row in rows_of(1.0, 1.0):
        if row.mm is None:
            continue
        times = 0.5 if row.position == "3" else usual
        due = checker()._congruence.due[row.key]
        assert due.value is not None
        rows.append(row._replace(mm=times * row.mm, value=abs(due.value), unit=due.unit))
    checked = checker().of(rows).report
    (scale,) = checked.scales
    assert scale.mu == pytest.approx(0.025 / usual)
    assert dict(scale.places) == {"3": pytest.approx(0.05)}
    assert checked.wrong == 0


def test_an_honest_drawing_in_the_task_s_scale_factors_is_left_as_it_is() -> None:
    """Nothing is remade, nothing said."""
    drawn = DRAWN["sc"]
    assert drawn.mu["velocities"] == pytest.approx(0.025)
    agreed = checker()._congruence.of([*rows_of(1.0, 1.0), *rows_of(1.0, 1.0, "accelerations")])
    assert (agreed.times, agreed.places, agreed.scales, agreed.moves) == ({}, {}, (), {})


@pytest.mark.turns(2)
@pytest.mark.slow
@pytest.mark.parametrize("way", ["mm", "mm and rates", "mm and values", "points"])
def test_scale_factors_of_a_student_are_those_that_he_took(way: str) -> None:
    """Drawn without the package: what is told is his, within 2 % (lengths alone tell it to 1 %)."""
    told = 0
    for seed in range(7000, 7006):
        drawing = student(MACHINES["fb"], seed, way=way, mu_rows=False)
        found = report_of(drawing)
        assert isinstance(found, Report), found
        for scale in found.scales:
            if scale.by and scale.plan in drawing.ratios:
                ratio = scale.mu / scale.due
                assert abs(math.log(ratio / drawing.ratios[scale.plan])) < 0.02, (seed, scale)
                told += 1
    assert told >= 6


@pytest.mark.slow
@pytest.mark.parametrize("times", [0.8, 1.25])
@pytest.mark.parametrize("name", ["windrower", "shaper", "cam", "toggle-press", "lever", "engine"])
def test_whatever_is_drawn_may_be_drawn_larger(name: str, times: float) -> None:
    """Every length off by 0.7 mm, what is laid off first too: nothing is wrong but what is due to be 0."""
    check = Checker(read(SHEETS / name))
    rng, rows = np.random.default_rng(4), list[Taken]()
    for (plan, segment, place), cell in check._congruence.due.items():
        if cell.mm is not None and cell.value:
            mm = times * cell.mm + 0.7 * rng.standard_normal()
            mm = mm if plan == "diagrams" or cell.mm < 0 else abs(mm)
            rows.append(Taken(plan, place, segment, mm=round(mm, 1), line=len(rows) + 2))
    agreed = check._congruence.of(rows)
    counts = Counter(
        check._congruence.groups[row.key[:2]]
        for row in rows
        if abs(check._congruence.due[row.key].mm or 0.0) > 20.0
    )
    sure = [group for group, count in counts.items() if count > 8]
    assert sure
    for group in sure:
        assert agreed.times.get(group, 1.0) == pytest.approx(times, rel=0.03), group
    found, groups = check.verdicts(rows)[0], check._congruence.groups
    for group in sure:
        some = [one for one in found if groups.get(one.taken.key[:2]) == group]
        assert sum(one.verdict == WRONG for one in some) <= 0.2 * len(some), group


@pytest.mark.parametrize("name", ["pa the other way", "πa outwards, points"])
@pytest.mark.slow
def test_a_plan_against_the_others_is_a_mistake_in_points_that_are_turned(name: str) -> None:
    """All plans stand by 180° but the one whose first vector was reversed, which stands as due."""
    drawing = with_mistake(kind_of(name), 1, 83000)
    report = report_of(drawing)
    assert not isinstance(report, str)
    assert (drawing.manner.move, told(report, drawing).name) == ("turned by 180", True)


def test_rows_of_mm_and_value_tell_a_scale_factor_near_the_due_one() -> None:
    """0.983 times the task's: what is calculated with it is 1.7 % less."""
    rows = []
    for row in rows_of(1.0 / 0.983, 1.0):
        due = checker()._congruence.due[row.key]
        if row.mm and due.value and due.mm:
            mm = round(row.mm, 1)
            value = float(f"{mm * 0.983 * abs(due.value / due.mm):.4g}")
            rows += row._replace(mm=mm, value=value, unit=due.unit).parts()
    (one,) = checker()._congruence.of(rows).scales
    assert (one.by, one.mu / one.due) == ("rows", pytest.approx(0.983, abs=0.002))
