"""The step that leaves a figure of a table, known again by its name and what it is due."""

from __future__ import annotations

import pytest
from support.gallery import exact
from support.lessons_told import by, sums

from graphic_tmm.checking.cells import cells
from graphic_tmm.checking.lessons.lessons import Teacher
from graphic_tmm.checking.lessons.steps import Steps, step_of_figure
from graphic_tmm.checking.records import WRONG, Judged, Lesson, Taken


def lesson(scene: str, plan: str, segment: str, position: str = "") -> Lesson:
    made = exact(scene)
    value = cells(made)[plan, segment, position].value
    assert value is not None
    taken = Taken(plan, position, segment, value=1.5 * value)
    wrong = Judged(taken, 1.5 * value, value, 0.5 * value, 1.0, 0.0, WRONG)
    (found,) = Teacher(made).lessons((wrong,), (), by(made))
    return found


@pytest.mark.parametrize(
    ("name", "due"),
    # by the formulas of the tooth: m = 8 mm, h* = 1, c* = 0.25; Δy = 0.1896 of the published pair
    [("h", 0.008 * (2.25 - 0.1896)), ("h_w", 0.008 * (2 - 0.1896))],
)
def test_a_gears_result_is_told_by_its_formula(name: str, due: float) -> None:
    found = lesson("gear-pair", "results", name)
    reckoned, told = sums(found.calculation.replace("h_a^*", ""))
    assert reckoned == pytest.approx(due, rel=1e-3)
    assert told == pytest.approx(due, rel=1e-3)
    assert (found.segment, found.letter, found.position) == (name, name, "")


@pytest.mark.slow
def test_a_weight_is_mass_times_g() -> None:
    found = lesson("windrower", "forces", "G3", "8")
    reckoned, told = sums(found.calculation)
    assert (reckoned, told) == pytest.approx((25 * 9.81, 25 * 9.81), rel=1e-3)
    assert (found.view, found.position) == ("loads", "8")


@pytest.mark.slow
@pytest.mark.parametrize("scene", ["gear-pair", "windrower", "planetary", "cam"])
def test_the_step_leaves_what_is_due(scene: str) -> None:
    """Of no figure of any table another step is told than one that comes to just that figure."""
    made = exact(scene)
    steps, found = Steps(made), 0
    for (plan, segment, position), cell in cells(made).items():
        told = step_of_figure(steps, Taken(plan, position, segment, value=cell.value))
        if told is None or not told.step.op.formula or told.step.it.kind.__name__ != "Number":
            continue
        taken = Taken(plan, position, segment, value=1.0)
        wrong = Judged(taken, 1.0, 1.0, 1.0, 1.0, 0.0, WRONG)
        (one,) = Teacher(made).lessons((wrong,), (), by(made))[:1]
        assert cell.value is not None
        if one.calculation and one.segment == segment and found < 40:
            text = one.calculation.rpartition(" = ")[2]
            assert sums(f"0 = {text}")[1] == pytest.approx(abs(cell.value), rel=6e-4) or (
                sums(f"0 = {text}")[1] == pytest.approx(-abs(cell.value), rel=6e-4)
            )
            found += 1
    assert found >= 2


def test_equal_figures_of_other_names_are_not_told() -> None:
    """The contact ratio is calculated and drawn: neither is called so in the log."""
    steps = Steps(exact("gear-pair"))
    assert step_of_figure(steps, Taken("results", "", "contact_ratio", value=1.0)) is None
    assert step_of_figure(steps, Taken("results", "", "nothing", value=1.0)) is None
    assert step_of_figure(steps, Taken("velocities", "1", "a", x=1.0, y=1.0)) is None
