"""Scale factors and turns as people state them."""

from __future__ import annotations

from typing import Any

import pytest
from support.gallery import CASES, SHEETS
from support.own_told import checker

from graphic_tmm.checking.check import Checker
from graphic_tmm.checking.congruence.moves import Move
from graphic_tmm.checking.congruence.stated import is_scale_row, stated_by, stated_in, turns_by
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.records import Taken
from graphic_tmm.errors import SceneError
from graphic_tmm.scene.read import read


@pytest.fixture
def symbols() -> Any:
    return checker("frc")._congruence.remaking.symbols


@pytest.mark.parametrize(
    ("plan", "segment", "value", "unit", "mu"),
    [
        ("velocities", "μ", 0.02, "(m/s)/mm", 0.02),
        ("скорости", "масштаб", 0.02, "м/с/мм", 0.02),
        ("velocities", "mu_v", 0.02, "", 0.02),
        ("План скоростей", "μv", 20.0, "(mm/s)/mm", 0.02),
        ("positions", "µ_l", 2.0, "mm/mm", 0.002),
        ("diagrams", "μ_V", 0.05, "", 0.05),
    ],
)
def test_a_row_states_a_scale_factor(
    plan: str, segment: str, value: float, unit: str, mu: float, symbols: Any
) -> None:
    row = Taken(plan, "", segment, value=value, unit=unit)
    assert is_scale_row(row)
    (stated,), faults = stated_in([row], symbols)
    assert not faults
    assert stated.mu == pytest.approx(mu)


@pytest.mark.parametrize(
    ("plan", "segment", "value", "unit", "says"),
    [
        ("diagrams", "μ", 0.05, "", "which scale factor"),
        ("velocities", "μ_v", 0.02, "kg/mm", "does not fit"),
        ("velocities", "μ_v", -0.02, "", "more than 0"),
        ("gears", "μ", 0.02, "", "no scale factor"),
    ],
)
def test_what_is_not_understood_is_refused(
    plan: str, segment: str, value: float, unit: str, says: str, symbols: Any
) -> None:
    stated, faults = stated_in([Taken(plan, "", segment, value=value, unit=unit)], symbols)
    assert not stated
    assert says in str(faults[0].message)


def test_options_state_scale_factors_and_turns(symbols: Any) -> None:
    (one,) = stated_by(["velocities=0,02"], symbols, "x")
    assert (one.group.plan, one.mu) == ("velocities", 0.02)
    assert turns_by(["velocities=90"], ("velocities",), "x") == {"velocities": Move(1)}
    for wrong in ("velocities", "velocities=0", "velocities=-1", "gears=1", "diagrams=2"):
        with pytest.raises(SceneError):
            stated_by([wrong], symbols, "x")
    for wrong in ("velocities=45", "velocities", "gears=90"):
        with pytest.raises(SceneError):
            turns_by([wrong], ("velocities",), "x")


@pytest.mark.slow
def test_a_prescribed_scale_factor_forbids_another() -> None:
    """The lengths are then wrong, and it is said by what the figures were calculated."""
    scene = read(CASES / "check" / "sc.toml")
    readings = read_readings(CASES / "check" / "another_mu_v.csv")
    report = Checker(scene, scales=("velocities=scene",)).of(readings).report
    assert report.wrong > 10
    assert "0.02" in report.head[0]


def test_a_row_left_as_the_template_has_it_is_no_statement() -> None:
    """His rates and lengths say another one; a row that was changed is believed."""
    readings = [*read_readings(CASES / "check" / "another_mu_v.csv")]
    left = Taken("velocities", "", "μ_v", value=0.025, unit="(m/s)/mm", line=99)
    assert checker("sc").of([*readings, left]).report.wrong == 0
    changed = checker("sc").of([*readings, left._replace(value=0.02)]).report
    assert changed.wrong == 0
    assert [(one.by, one.mu) for one in changed.scales] == [("stated", 0.02)]


def test_one_letter_is_of_all_polygons_of_forces(symbols: Any) -> None:
    """Who states μ_F states it for the polygon of link 1, too."""
    own = checker("frc")._congruence
    (mu,) = (one for one in own.stated_rows() if one.plan == "forces")
    stated, _ = stated_in([mu._replace(value=2.0)], symbols)
    agreed = own.of([], stated)
    assert [(one.of, times) for one, times in agreed.times.items()] == [(("forces", "N"), 2.0)] * 2


def test_the_scene_s_own_scale_factor_of_forces_is_of_the_polygons_that_it_is_due_to() -> None:
    """The windrower's polygon of link 1 is due in another μ_F; a row that was left so says nothing of it."""
    own = Checker(read(SHEETS / "windrower"))._congruence
    (mu,) = (one for one in own.stated_rows() if one.plan == "forces")
    stated, _ = stated_in([mu], own.remaking.symbols)
    assert not own.of([], stated).times
    changed, _ = stated_in([mu._replace(value=50.0)], own.remaking.symbols)
    times = own.of([], changed).times
    assert {(group.mu, times[group]) for group in times} == {(25.0, 0.5), (75.0, 1.5)}


def test_who_draws_all_polygons_in_the_scene_s_scale_factor_of_one_has_stated_it() -> None:
    """By a reaction of another polygon: due in 75 N/mm, it is as long as in the stated 25."""
    own = Checker(read(SHEETS / "windrower"))._congruence
    (mu,) = (one for one in own.stated_rows() if one.plan == "forces")
    stated, _ = stated_in([mu], own.remaking.symbols)
    mm = own.due["forces", "R63", "8"].mm
    assert mm is not None
    for longer, times in ((3.0, {75.0: 3.0}), (1.0, {}), (2.0, {})):
        read_so = Taken("forces", "8", "R63", mm=round(longer * mm, 1), line=9)
        agreed = own.of([read_so], stated)
        assert {group.mu: one for group, one in agreed.times.items()} == times, longer
