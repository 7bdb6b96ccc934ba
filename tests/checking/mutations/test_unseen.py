"""What readings cannot show is said: a plan is told of if no drawing of it would have changed any reading."""

from __future__ import annotations

import pytest
from support.gallery import CASES, LARGEST, SHEETS
from support.trials import FRESH, readings

from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking.cells import cells
from graphic_tmm.checking.check import Checker, check
from graphic_tmm.checking.mutations.mistakes import Offered
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.records import DOUBTFUL
from graphic_tmm.scene.read import read
from graphic_tmm.studio import drawings


def note(*plans: str) -> str:
    """Return what is noted if only readings of some plans are given."""
    rows = read_readings(CASES / "check" / "honest_six_mm.csv")
    some = [one for one in rows if one.plan in plans]
    notes = check(read(CASES / "check" / "six.toml"), some, trials=50).notes
    return " ".join(one for one in notes if one.startswith("these readings do not show"))


def test_a_plan_without_readings_is_told() -> None:
    told = note("velocities")
    assert "Acceleration plan" in told
    assert "Velocity plan" not in told
    assert "Plan of positions" not in told, "velocities follow from positions"


def test_nothing_is_said_if_every_plan_shows() -> None:
    assert note("positions", "velocities", "accelerations") == ""


def test_accelerations_show_velocities_too() -> None:
    assert note("accelerations") == ""


@pytest.mark.slow
def test_a_table_shows_the_plans_that_it_was_found_from() -> None:
    """A figure of a table has no step of its own: a mistake in a view is made, and the figure moves or not."""
    checker = Checker(read(SHEETS / LARGEST), trials=20)
    due = cells(checker.made)
    forces = [one for one in readings(due, due) if one.plan == "results" and one.value]
    told = [one for one in checker.of(forces).report.notes if "не видно" in one]
    assert told == ["по этим отсчётам не видно, что сделано на: План ускорений"]


def test_an_honest_drawing_executes_no_mutation(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of readings that a hand took some are doubtful by chance: no mistake is looked for."""
    checker = Checker(read(SHEETS / "crank-rocker"), trials=100)
    due = cells(checker.made)
    hand = HANDS["student"]._replace(trials=6, seed=FRESH)
    monkeypatch.setattr(Offered, "run", None)
    reports = [checker.of(readings(cells(one), due)).report for one in drawings(checker.made, hand)]
    assert sum(row.verdict == DOUBTFUL for one in reports for row in one.readings) > 2
    assert not any(one.mistakes for one in reports)
