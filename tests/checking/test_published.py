"""The documents' published readings: their errata are found by the program; the reports stand in the scenes."""

from __future__ import annotations

from functools import cache

import pytest
from support.gallery import SHEETS

from graphic_tmm.checking.check import check
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.records import FINE, Report
from graphic_tmm.checking.report.markdown import markdown_report
from graphic_tmm.scene.read import read

pytestmark = pytest.mark.every

NAMES = ("engine", "windrower-published", "gear-pair", "planetary", "slider-diagrams", "locomobile")


@cache
def report(name: str) -> Report:
    return check(read(SHEETS / name), read_readings(SHEETS / name / "published.csv"))


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_the_committed_report_is_what_the_program_says(
    name: str, request: pytest.FixtureRequest
) -> None:
    path, text = SHEETS / name / "published.md", markdown_report(report(name))
    if request.config.getoption("--redraw"):
        path.write_text(text, "utf-8")
    assert path.read_text("utf-8") == text


@pytest.mark.slow
@pytest.mark.parametrize("name", ["engine", "slider-diagrams", "locomobile"])
def test_honest_tables_are_fine(name: str) -> None:
    assert {one.verdict for one in report(name).readings} == {FINE}


def not_fine(name: str) -> set[str]:
    return {one.taken.segment for one in report(name).readings if one.verdict != FINE}


@pytest.mark.slow
def test_the_gear_documents_errata() -> None:
    assert not_fine("gear-pair") == {"h", "h_w", "contact_ratio_drawn", "contact_ratio"}


def test_the_planetary_documents_errata() -> None:
    assert not_fine("planetary") == {"planetary_satellites", "planetary_ratio"}


@pytest.mark.slow
def test_the_windrowers_table_belongs_to_other_data() -> None:
    wrong = [one for one in report("windrower-published").readings if one.verdict != FINE]
    assert len(wrong) > 20
    assert any(one.taken.segment == "pc" for one in wrong)


@pytest.mark.slow
def test_the_engines_deviations_by_hand() -> None:
    due = {"pb": 42.53, "ps2": 48.37, "ab": 53.45}
    taken = {"pb": 44, "ps2": 49, "ab": 52}
    for one in report("engine").readings:
        if one.taken.position == "2":
            segment = one.taken.segment
            assert one.deviation == pytest.approx(taken[segment] - due[segment], abs=0.005)
    seventeen = [o for o in report("engine").readings if o.found == 17.0]
    assert len(seventeen) == 2
    assert all(o.verdict == FINE and o.due == pytest.approx(17.47, abs=0.005) for o in seventeen)
    assert sum(one.taken.plan == "velocities" for one in report("engine").readings) == 36
