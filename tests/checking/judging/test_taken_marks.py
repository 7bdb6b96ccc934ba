"""What a reading can tell: the ruler, the digits written, how points were read; both figures of a row."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from support import gallery
from support.gallery import CASES
from support.trials import checks

from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking import check as check_module
from graphic_tmm.checking.cells import Cell, cells, points
from graphic_tmm.checking.check import check
from graphic_tmm.checking.judging.judge import judge
from graphic_tmm.checking.judging.scatter import Limits, limited
from graphic_tmm.checking.judging.taken_marks import POINTS, reader
from graphic_tmm.checking.judging.yardstick import Yardsticks
from graphic_tmm.checking.readings.figures import half_unit
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.records import DOUBTFUL, FINE, WRONG, Judged, Last, Report, Taken
from graphic_tmm.checking.report.html import html_report
from graphic_tmm.checking.report.json import json_report
from graphic_tmm.checking.report.markdown import markdown_report
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make

HEAD = "plan,position,segment,mm,value,unit,x,y\n"
TRIALS = 120
CLUMSY = 5.0


@cache
def scene(name: str) -> Scene:
    return read(CASES / "check" / f"{name}.toml")


@cache
def drawn(name: str) -> DrawnScene:
    return make(scene(name), exact=True)


def checked(name: str, rows: str, folder: Path, **how: object) -> Report:
    path = folder / "readings.csv"
    path.write_text(HEAD + rows, "utf-8")
    return check(scene(name), read_readings(path), trials=TRIALS, **how)  # type: ignore[arg-type]


def verdicts(report: Report) -> list[str]:
    return [one.verdict for one in report.readings]


@pytest.mark.parametrize(
    ("cell", "half"),
    [
        ("54.3", 0.05),
        ("31,40", 0.005),
        ("−7 мм", 0.5),
        ("1e3", 500.0),
        ("1.20e-2", 5e-5),
        (".5", 0.05),
        ("54.", 0.5),
        ("", 0.0),
    ],
)
def test_half_a_unit_of_the_last_digit(cell: str, half: float) -> None:
    assert half_unit(cell) == pytest.approx(half, rel=1e-12)


def test_a_row_keeps_the_digits_that_were_written(tmp_path: Path) -> None:
    path = tmp_path / "r.csv"
    path.write_text("plan;position;segment;mm;x;y\nv;1;pb;54,30;;\nv;1;b;;1,5;-2\n", "utf-8")
    first, second = read_readings(path)
    assert first.last == Last(mm=0.005)
    assert second.last == Last(x=0.05, y=0.05)


@pytest.mark.slow
def test_a_length_laid_off_is_judged_alike_in_tenths_and_in_halves() -> None:
    """pa is 96.0 mm, calculated and laid off; a ruler of 0.5 mm has no 96.6."""
    rows = [
        (f"{mm}", (Taken("velocities", "4", "pa", mm=mm, last=Last(mm=0.05)),))
        for mm in (96.6, 97.0, 101.1, 101.0)
    ]
    told = [verdicts(report) for report in checks(gallery.scene("lever"), rows)]
    assert told == [[FINE], [FINE], [WRONG], [WRONG]]


@pytest.mark.slow
def test_every_way_a_ruler_gives_a_calculated_length_is_fine() -> None:
    """pa is 54.348 mm: on a ruler of 0.1 mm it is 54.3 or 54.4, for the surest hand."""
    found = replace(scene("sc"), ruler=0.1, scales=replace(scene("sc").scales, mu_v=0.0368))
    due = {54.3: FINE, 54.4: FINE, 54.9: WRONG, 5.43: WRONG}
    last = {mm: Last(mm=0.005 if mm < 10 else 0.05) for mm in due}
    rows = [(f"{mm}", (Taken("velocities", "1", "pa", mm=mm, last=last[mm]),)) for mm in due]
    told = checks(found, rows, hand="cad", trials=20)
    assert [verdicts(report) for report in told] == [[one] for one in due.values()]


def test_what_is_given_is_judged_for_slips(tmp_path: Path) -> None:
    rows = "velocities,{},omega1,,{},{},,\n"
    fine = "".join(
        rows.format(*row) for row in ((0, "20", "1/s"), (1, "20.05", "1/s"), (2, "191 ", "rpm"))
    )
    assert verdicts(checked("sc", fine, tmp_path)) == [FINE] * 3
    wrong = "".join(
        rows.format(*row) for row in ((0, "2.0", "1/s"), (1, "21.0", "1/s"), (2, "20", "rpm"))
    )
    assert verdicts(checked("sc", wrong, tmp_path)) == [WRONG] * 3


@pytest.mark.slow
def test_both_figures_of_a_row_are_judged_and_agree(tmp_path: Path) -> None:
    """pb is 68.1 mm and 1.70 m/s in position 1; μ_v = 0.025 (m/s)/mm."""
    report = checked("sc", "velocities,1,pb,68.5,1.7125,m/s,,\n", tmp_path)
    assert [(one.unit, one.verdict) for one in report.readings] == [("mm", FINE), ("m/s", FINE)]
    tenfold = checked("sc", "velocities,1,pb,68.5,17.125,m/s,,\n", tmp_path)
    assert verdicts(tenfold) == [FINE, WRONG]
    # each alone would be fine, but the one does not follow from the other
    apart = checked("sc", "velocities,1,pb,68.5,1.665,m/s,,\n", tmp_path)
    assert verdicts(apart) == [FINE, DOUBTFUL]
    assert verdicts(checked("sc", "velocities,1,pb,,1.665,m/s,,\n", tmp_path)) == [FINE]


@pytest.mark.slow
def test_both_figures_agree_on_plans_that_no_step_measures_too(tmp_path: Path) -> None:
    """μ of the diagram of S is its own; 30 % more than the length says is no reading of it."""
    made = gallery.exact("windrower")
    key, cell = max(
        ((k, c) for k, c in cells(made).items() if k[:2] == ("diagrams", "S") and c.mm is not None),
        key=lambda one: abs(one[1].mm or 0.0),
    )
    assert cell.mm is not None
    assert cell.value is not None
    right = Taken(*key[:1], key[2], key[1], mm=round(cell.mm, 1), value=cell.value, unit=cell.unit)
    by = Yardsticks(made, HANDS["student"]._replace(trials=TRIALS), Limits()).of([right])
    slipped = right._replace(value=1.3 * cell.value)
    verdict = [[one.verdict for one in judge(made, [row], by)] for row in (right, slipped)]
    assert verdict == [[FINE, FINE], [FINE, WRONG]]


def test_a_quantity_follows_from_the_length_beside_it(tmp_path: Path) -> None:
    report = checked("sc", "velocities,1,pb,58.5,1.4625,m/s,,\n", tmp_path)
    assert verdicts(report) == [WRONG, FINE]
    assert report.readings[1].follows == report.readings[0].taken
    # a quantity that is right is not wrong for the length that was copied wrongly
    assert verdicts(checked("sc", "velocities,1,pb,58.5,1.70,m/s,,\n", tmp_path)) == [WRONG, FINE]


def test_a_rate_is_judged_by_what_was_read(tmp_path: Path) -> None:
    """ε₂ = t·μ_a/l: of the student's own t, 10 mm too short; and of another segment than t."""
    n2b = abs(cells(drawn("sc"))["accelerations", "n2b", "1"].mm or 0.0)
    right = (n2b - 12.0) * 0.5 / 0.35
    rows = "accelerations,1,n2b,{:.1f},,,,\naccelerations,1,epsilon2,,{:.4g},1/s^2,,\n"
    report = checked("sc", rows.format(n2b - 12.0, right), tmp_path)
    assert verdicts(report) == [WRONG, FINE]
    assert report.readings[1].follows == report.readings[0].taken
    other = checked("sc", rows.format(n2b, n2b * 1.06 * 0.5 / 0.35), tmp_path)
    assert verdicts(other) == [FINE, WRONG]


@pytest.mark.parametrize("language", ["en", "ru"])
def test_every_report_says_what_a_deviation_follows_from(language: str, tmp_path: Path) -> None:
    rows = "velocities,1,pb,58.5,1.4625,m/s,,\n"
    report = checked("sc", rows, tmp_path)._replace(language=language)
    words = {"en": ("follows from", "pb (line 2)"), "ru": ("следует из", "pb (№ 2)")}[language]
    for text in (markdown_report(report), html_report(report)):
        assert all(word in text.casefold() for word in words)
    assert '"follows_from": "pb", "follows_from_line": 2' in json_report(report)


@pytest.mark.slow
def test_percent_of_plan_is_the_same_for_mm_and_for_quantities(tmp_path: Path) -> None:
    """10 mm of 80 mm, the longest vector of the plan (pa), are 12.5 %."""
    due = abs(cells(drawn("sc"))["velocities", "pb", "1"].mm or 0.0)
    for row in (f"{due - 10:.9f},,", f",{(due - 10) * 0.025:.9f},m/s"):
        (one,) = checked("sc", f"velocities,1,pb,{row},,\n", tmp_path).readings
        assert one.percent == pytest.approx(12.5, abs=1e-6)
    (rate,) = checked("sc", "velocities,1,omega2,,3,1/s,,\n", tmp_path).readings
    assert np.isnan(rate.percent)
    (point,) = checked("sc", "positions,0,A,,,,40,0\n", tmp_path).readings
    assert point.percent == pytest.approx(100 * 10 / 225)  # B stands 225 mm from O


def test_an_absurd_figure_is_wrong_however_the_hand_scatters() -> None:
    """The hand is off by more than the figure itself: 1724, a limit of 2500. 19.5 is none of its drawings."""
    rng = np.random.default_rng(1)
    by = limited(np.sort(np.abs(500.0 * rng.standard_normal(400))), Limits())
    assert by.wrong > 1724.0
    assert by.verdict(1724.0 - 19.5, float(np.log(1724 / 19.5))) == DOUBTFUL
    times = by._replace(times=float(np.log(10.0)))
    assert times.verdict(1724.0 - 19.5, float(np.log(1724 / 19.5))) == WRONG
    assert times.verdict(1724.0 - 600.0, float(np.log(1724 / 600))) == DOUBTFUL


def test_a_flywheel_a_hundredth_of_what_is_due_is_wrong_by_a_clumsy_hand() -> None:
    """J is a difference of areas: a hand five times as clumsy is off by more than J itself."""
    made = gallery.exact("engine")
    due = cells(made)["results", "J_fly", ""]
    assert due.value is not None
    right = Taken("results", "", "J_fly", value=due.value, unit=due.unit)
    student = HANDS["student"]
    clumsy = student._replace(reading=CLUMSY * student.reading, swing=CLUMSY * student.swing)
    by = Yardsticks(made, clumsy._replace(trials=TRIALS), Limits()).of([right])
    assert by.spread[right.at].wrong > due.value
    rows = [right._replace(value=due.value * share) for share in (1.0, 1.0 / 88.0)]
    assert [one.verdict for one in judge(made, rows, by)] == [FINE, WRONG]


def test_points_are_read_as_finely_as_is_told() -> None:
    hand = HANDS["student"]
    slips = {how: reader(scene("sc"), hand, how).pointing for how in POINTS}
    assert slips == {"paper": hand.reading, "screen": 0.1, "photo": 0.5, "own sheet": 0.5}
    wide = reader(scene("sc"), hand, "photo")
    found = wide.pointed(np.zeros((4000, 1), dtype=complex), "a")
    assert np.std(found.real) == pytest.approx(0.5, rel=0.05)
    assert np.std(found.imag) == pytest.approx(0.5, rel=0.05)


def test_a_point_half_a_mm_off_is_fine_on_paper_and_not_on_a_screen(tmp_path: Path) -> None:
    row = "velocities,0,a,,,,0,81.5\n"
    assert verdicts(checked("sc", row, tmp_path, points="paper")) == [FINE]
    assert verdicts(checked("sc", row, tmp_path, points="screen")) == [WRONG]


def test_a_reading_of_a_figure_that_is_not_sure_is_said_not_judged(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    def unsure(made: DrawnScene) -> dict[tuple[str, str, str], Cell]:
        found = cells(made)
        del found["velocities", "ab", "2"]
        return found

    monkeypatch.setattr(check_module, "cells", unsure)
    rows = "velocities,1,pb,68,,,,\nvelocities,2,ab,3,,,,\n"
    report = checked("sc", rows, tmp_path)
    assert [one.taken.segment for one in report.readings] == ["pb"]
    note, _ = report.notes  # the other: what these two readings cannot show
    assert note.startswith("Line 3: ab (2) is not judged")
    assert note in markdown_report(report)


@pytest.mark.slow
def test_many_drawings_are_judged_by_one_yardstick_as_one_by_one(tmp_path: Path) -> None:
    rows = [
        (f"{k}", (Taken("velocities", "1", "pb", mm=mm, line=2),))
        for k, mm in enumerate((68.0, 58.0))
    ]
    together: list[tuple[Judged, ...]] = [
        r.readings for r in checks(scene("sc"), rows, trials=TRIALS)
    ]
    assert together == [check(scene("sc"), one, trials=TRIALS).readings for _, one in rows]


def own_sheet_rows(long: float) -> str:
    """Velocity plans of which pole, scale factor and points are off a little, pa by ``long`` mm in one."""
    random = np.random.default_rng(8)
    spots = {key: z for key, z in points(drawn("sc")).items() if key[0] == "velocities"}
    poles = {n: 0.3 * complex(*random.standard_normal(2)) for _, _, n in spots}
    rows = ""
    for (plan, letter, n), z in spots.items():
        slip = 0.1 * complex(*random.standard_normal(2))
        z *= 1.01 if letter != "a" or n != "3" else 1.01 + long / abs(z)
        z += slip + poles[n]
        rows += f"{plan},{n},{letter},,,,{z.real:.2f},{z.imag:.2f}\n"
    return rows


@pytest.mark.parametrize(("long", "wrong"), [(0.9, []), (5.0, ["3"])])
def test_what_is_common_to_a_clicked_plan_is_nobodys_mistake(
    long: float, wrong: list[str], tmp_path: Path
) -> None:
    scales = ["velocities=scene"]
    report = checked("sc", own_sheet_rows(long), tmp_path, points="own sheet", scales=scales)
    off = [one.taken.position for one in report.readings if one.verdict == WRONG]
    assert off == wrong
