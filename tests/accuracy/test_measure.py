"""Errors as one would count them, work as one counts on the fingers, seconds of the exact hand."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from support.tasks import by, drawing, measure, quantity, scales, scene

from graphic_tmm.accuracy.cost import count, varying
from graphic_tmm.accuracy.drawing import References, draw, tried
from graphic_tmm.accuracy.measure import Measure, off, work_of
from graphic_tmm.accuracy.timing import Calls, Seconds, Stopwatch
from graphic_tmm.board.execute import execute
from graphic_tmm.mechanism.records import Extreme
from graphic_tmm.readers.position_count import at_count


def test_nine_readings_of_ten_keep_within_the_error() -> None:
    due = np.array([[4.0, -8.0, 0.0, 2.0]])
    values = due + np.random.default_rng(1).normal(size=(50, 4))
    found = off(values, due, 8.0)
    apart = np.sort(np.abs(values - due).ravel()) / 8.0 * 100.0
    # of 200 readings the 180th and the 181st stand on either side of nine tenths
    assert apart[179] <= found.error <= apart[180]
    assert apart[99] <= found.median <= apart[100]
    assert found.failed == 0.0


def test_a_failed_reading_counts_as_far_off_and_leaks_into_nothing() -> None:
    due = np.array([[1.0, 1.0]])
    values = np.full((10, 2), 1.5)
    values[0, 0] = np.nan
    found = off(values, due, 1.0)
    assert (found.error, found.failed) == (50.0, 5.0)
    values[:2] = np.nan
    assert np.isnan(off(values, due, 1.0).error)
    assert off(values, due, 1.0).median == 50.0


def test_the_standard_error_is_that_of_repeated_drawings() -> None:
    """Measured on 400 sets of 100 drawings: the sets' own standard error agrees with how they scatter.

    That scatter is known to 1/√800 = 3.5 %; the standard error of a quantile by leaving out groups is of the
    right order only, a third too large or too small at most.
    """
    rng = np.random.default_rng(5)
    due = np.array([[1.0]])
    sets = [off(1.0 + 0.01 * rng.normal(size=(100, 1)), due, 1.0) for _ in range(400)]
    scatter = np.std([one.error for one in sets], ddof=1)
    assert np.sqrt(np.mean([one.spread**2 for one in sets])) == pytest.approx(scatter, rel=0.33)


def test_nothing_due_is_no_error() -> None:
    assert np.isnan(off(np.ones((1, 2)), np.zeros((1, 2)), 0.0).error)
    assert np.isnan(off(np.ones((1, 2)), np.full((1, 2), np.nan), 1.0).error)


class Still(Stopwatch):
    """Times nothing: every call is said to take as long as there were calls before it."""

    def keep(self, calls: Calls[Any]) -> None:
        self.calls = dict(calls)

    def kept(self) -> dict[Any, Seconds]:
        return {key: Seconds(k, k, k, k) for k, key in enumerate(self.calls)}


def test_runs_of_the_exact_hand_along_the_number_of_positions_are_timed_and_no_others() -> None:
    task = Measure(scales("slider-diagrams"), References(scene("slider-diagrams"), {}))
    exact, student = by("slider-diagrams", "exact"), by("slider-diagrams", "student")
    runs = task.runs(exact, "positions", "8")
    runs += task.runs(student, "positions", "8")
    runs += task.runs(exact, "size", "1")
    done = task.timed(runs, Still())
    timed = [run for run in done if run.seconds is not None]
    assert [(run.hand, run.axis) for run in timed] == [("exact", "positions")] * len(timed)
    assert len(timed) == len({run.quantity for run in runs})
    assert len({run.seconds for run in timed}) == len(timed)
    assert [run.errors for run in done] == [run.errors for run in runs]


@pytest.mark.turns(3, "measured")
@pytest.mark.slow
@pytest.mark.parametrize("n", [4, 8, 24])
def test_velocities_of_a_slider_are_what_one_counts_on_the_fingers(n: int) -> None:
    """Once: [OA], [AB], v_A and pa calculated 4, the guide's ray 5, the line of v_B 3.

    At each position: its angle 1; the crank's ray 5, A 3, the arc about A 4, AB 3; (pa) 3, a 3, (ab) 3; ab and
    pb read 3 each; where lines meet costs nothing.
    """
    changed = at_count(scene("slider-diagrams"), n)
    drawn = drawing("slider-diagrams", changed)
    assert work_of(drawn, quantity(drawn, "v").marks).simplicity == 12 + 31 * n


@pytest.mark.turns(3, "measured")
@pytest.mark.slow
def test_a_row_twice_as_long_is_twice_the_work_for_readings() -> None:
    drawn = drawing("windrower")
    finer = drawing("windrower", at_count(scene("windrower"), 24))
    one, two = (work_of(d, quantity(d, "v").marks).elements["M3"] for d in (drawn, finer))
    assert two == pytest.approx(2 * one, abs=5)


def test_minutes_are_those_of_the_table_that_is_told() -> None:
    drawn = drawing("slider-diagrams")
    v = quantity(drawn, "v")
    only = dict.fromkeys(work_of(drawn, v.marks).elements, 0.0)
    assert work_of(drawn, v.marks, {**only, "M3": 2.0}).minutes == 2.0 * 8 * 2


@pytest.mark.turns(3, "measured")
@pytest.mark.slow
def test_an_extreme_position_that_is_tried_costs_its_trials() -> None:
    """A trial takes all that leads to the velocity of E; the bracket of 16 parts is narrowed twice: 17 + 15."""
    own = scene("crank-rocker")
    changed = replace(own, row=replace(own.row, zero=Extreme("E", "top"), extra=()))
    drawn = drawing("crank-rocker", changed)
    ((mark, trial),) = tried(drawn).items()
    assert mark.letter == "φ_{0}"
    v = quantity(drawn, "v")
    whole = work_of(drawn, v.marks)
    alone = count(drawn.construction, varying(drawn.given), v.marks, positions=drawn.count)
    with_trials, plain = (work.operations["measure_along"] for work in (whole, alone))
    once = count(trial.log, [trial.angle], [trial.reading]).operations["measure_along"]
    assert with_trials - plain == (17 + 15) * once > 0
    assert (whole.untold, alone.untold) == ((), (mark,))
    assert not tried(drawing("windrower"))


@pytest.mark.turns(3, "measured")
@pytest.mark.every
@pytest.mark.parametrize(
    ("name", "found"),
    [
        ("engine", ["J_fly", "J_fly_energy_mass"]),
        ("slider-diagrams", ["v", "a"]),
        ("windrower", ["v", "a", "V_diagram", "a_diagram", "P_bal", "J_fly", "J_fly_energy_mass"]),
    ],
)
def test_a_larger_drawing_is_the_same_for_an_exact_hand(name: str, found: list[str]) -> None:
    own, larger = (draw(scene(name), scales(name), k)[0] for k in (1.0, 2.0))
    for told in found:
        one, two = (
            quantity(d, told).read(execute(d.construction, d.given, quantity(d, told).marks), 1)
            for d in (own, larger)
        )
        assert np.abs(one - two).max() < 1e-9 * np.abs(one).max()


@pytest.mark.turns(3, "measured")
@pytest.mark.slow
def test_a_ruler_on_a_drawing_twice_as_large_is_one_of_half_the_division() -> None:
    task = measure("windrower")
    own = by("windrower", "exact")
    fine = replace(own, who=own.who._replace(ruler=0.1))
    coarse = replace(own, who=own.who._replace(ruler=0.2), enlarged=2.0)
    for one, two in zip(task.runs(fine, "", ""), task.runs(coarse, "", ""), strict=True):
        assert one.error == pytest.approx(two.error, rel=1e-6)


@pytest.mark.turns(3, "measured")
@pytest.mark.slow
@pytest.mark.parametrize("name", ["windrower", "slider-diagrams"])
def test_farther_poles_are_the_same_for_an_exact_hand(name: str) -> None:
    task = measure(name)
    own = by(name, "exact")
    found = [
        task.runs(replace(own, pole=k), "", "", ["a_diagram"])[0].error for k in (0.5, 1.0, 2.0)
    ]
    assert found == pytest.approx([found[1]] * 3, rel=1e-9)


def test_a_farther_pole_helps_a_hand_that_slips() -> None:
    """Ordinates twice as tall are read with the same slip."""
    task = measure("slider-diagrams")
    near, far = (
        task.runs(replace(by("slider-diagrams", "student", 200), pole=k), "", "", ["a_diagram"])[0]
        for k in (0.25, 2.0)
    )
    assert far.error + 3 * far.errors.spread < near.error


@pytest.mark.turns(3, "measured")
@pytest.mark.slow
def test_the_largest_is_that_of_the_turn_whatever_positions_are_drawn() -> None:
    """The press works in the last third of its way; with 4 positions none of them meets the load."""
    task = measure("crank-press")
    few = at_count(scene("crank-press"), 4)
    assert few is not None
    found = {}
    for changed in (few, scene("crank-press")):
        drawn = drawing("crank-press", changed)
        p = quantity(drawn, "P_bal")
        due = task.references.of(p, drawn)
        assert due is not None
        found[drawn.count] = (np.abs(due).max(), task.references.largest(p, drawn))
    assert found[4][1] == found[12][1] >= found[12][0] > 20 * found[4][0]
