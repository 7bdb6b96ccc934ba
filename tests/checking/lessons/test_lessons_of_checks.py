"""Lessons: the sentence and reason of the log, the formula with what was read; small plans, by the loop."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cache

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.examples import most
from support.gallery import exact
from support.lessons_told import (
    MU_A,
    MU_L,
    MU_V,
    ROD,
    by,
    lessons,
    plan_of_velocities,
    points_of_positions,
    row,
    slider_crank,
    sums,
)

from graphic_tmm.checking.lessons.lessons import PICTURED, Teacher
from graphic_tmm.checking.records import UNKNOWN, WRONG, Judged, Likely, PlanPicture, Taken
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.readers.protocol import plan_protocols

NORMAL = "5 an2"
DUE = 11.91


def normal(position: str = "5", mm: float = 44.3) -> Judged:
    return row("accelerations", position, "an2", DUE, NORMAL, mm=mm)


@settings(max_examples=most(30))
@given(st.floats(20.0, 120.0), st.sampled_from(["1", "3", "5"]))
def test_the_formula_has_the_students_own_number(ab: float, position: str) -> None:
    ab = round(ab, 1)
    read = row("velocities", position, "ab", 57.76, mm=ab, line=9)
    (lesson,) = lessons(read, normal(position))
    due = (ab * MU_V) ** 2 / (ROD / MU_L * MU_L) / MU_A
    reckoned, told = sums(lesson.calculation)
    assert lesson.own
    assert told == pytest.approx(due, rel=5e-4)  # four digits are told
    assert reckoned == pytest.approx(due, rel=2e-3)
    assert re.search(rf"[(−]{re.escape(f'{ab:g}')}\)?·0\.025\)²", lesson.calculation)


@pytest.mark.parametrize("position", ["1", "3", "5"])
def test_without_a_reading_the_formula_has_the_exact_number(position: str) -> None:
    (lesson,) = lessons(normal(position))
    due = (abs(plan_of_velocities(int(position))["ab"]) * MU_V) ** 2 / ROD / MU_A
    assert not lesson.own
    assert sums(lesson.calculation)[1] == pytest.approx(due, rel=5e-4)
    other = row("velocities", "1" if position != "1" else "3", "ab", 57.76, mm=50.0, line=9)
    assert lessons(other, normal(position)) == (
        lesson,
    )  # what was read elsewhere is not his number


def test_what_is_measured_is_told_with_the_steps_that_drew_it() -> None:
    (lesson,) = lessons(row("velocities", "1", "pb", 68.2, "10 pb", mm=30.0))
    assert lesson.drawn == (
        "5. Through a draw (ab) square to (AB).",
        "6. Through p draw (pb) parallel to (x).",
        "7. Where (pb) and (ab) meet, mark b.",
    )
    assert lessons(normal())[0].drawn == ()  # it is calculated


@pytest.mark.slow
@pytest.mark.parametrize("name", ["windrower", "engine"])
def test_lessons_speak_as_the_protocol_does(name: str) -> None:
    """Every step of the plans of velocities and accelerations, blamed in turn."""
    made = exact(name)
    work, language = made.mechanism, made.scene.language
    assert work is not None
    teacher = Teacher(made)
    seen = 0
    for plan in ("velocities", "accelerations"):
        position = work.names[work.row(plan)[0]]
        for one in plan_protocols(made, (plan,), position, language):
            sentences = {f"{line.number}. {line.text}" for line in one.lines}
            for line in one.lines:
                if line.step is None or not line.number:
                    continue
                label = f"{line.number} {line.step.it.name}"
                taken = Taken(plan, position, "none", mm=1.0)
                blamed = Judged(taken, 1.0, 2.0, -1.0, 1.0, 0.0, WRONG, step=label)
                (lesson,) = teacher.lessons((blamed,), (), by(made))
                assert (lesson.says, lesson.why) == (line.text, line.why)
                assert lesson.step == label
                assert set(lesson.drawn) <= sentences
                if lesson.calculation:
                    assert lesson.calculation == line.calculation
                    seen += 1
    assert seen > 8


@cache
def of_windrower() -> Teacher:
    return Teacher(exact("windrower"))


def numbers(made: DrawnScene, plan: str) -> list[tuple[str, str]]:
    """Return the segments of a plan that can be read and are calculated, with the labels of their steps."""
    work = made.mechanism
    assert work is not None
    steps = [step for step in work.construction.steps if step.it.view == plan]
    return [
        (step.it.letter.translate({ord(c): None for c in "_{}"}), f"{k} {step.it.name}")
        for k, step in enumerate(steps, 1)
        if step.op.formula and step.it.kind.__name__ == "Length"
    ]


@settings(max_examples=most(20))
@given(st.data())
def test_the_printed_numbers_come_to_the_printed_result(data: st.DataObject) -> None:
    """Whatever was read of the six-bar's plan of velocities."""
    made = exact("windrower")
    work = made.mechanism
    assert work is not None
    position = work.names[work.row("accelerations")[0]]
    read: Sequence[Judged] = [
        row("velocities", position, segment, 50.0, mm=round(data.draw(st.floats(5.0, 90.0)), 1))
        for segment in ("aa3", "pa3", "cd", "pa")
    ]
    read = (
        *read,
        row("positions", position, "BA", 100.0, mm=round(data.draw(st.floats(70, 140)), 1)),
    )
    known = [
        (s, label) for s, label in numbers(made, "accelerations") if s in ("ak2", "πn3", "cn4")
    ]
    assert len(known) >= 2
    segment, label = data.draw(st.sampled_from(known))
    blamed = row("accelerations", position, segment, 10.0, label, mm=30.0)
    (lesson,) = of_windrower().lessons((*read, blamed), (), by(made))
    assert lesson.own
    reckoned, printed = sums(lesson.calculation)
    # every number of at most six is printed to four digits, and the last of all too
    assert reckoned == pytest.approx(printed, rel=4e-3)


def test_numbers_are_the_readers_own_only_if_he_gave_all_of_them() -> None:
    """ak2 hangs on BA, which is measured on the plan of positions: without it the due numbers are told."""
    made = exact("windrower")
    work = made.mechanism
    assert work is not None
    position = work.names[work.row("accelerations")[0]]
    label = dict(numbers(made, "accelerations"))["ak2"]
    blamed = row("accelerations", position, "ak2", 10.0, label, mm=30.0)
    speeds = [row("velocities", position, one, 50.0, mm=33.3) for one in ("pa3", "aa3")]
    due = of_windrower().lessons((blamed,), (), by(made))
    assert not due[0].own
    assert of_windrower().lessons((*speeds, blamed), (), by(made)) == due
    read = row("positions", position, "BA", 100.0, mm=99.9)
    (own,) = of_windrower().lessons((*speeds, read, blamed), (), by(made))
    assert own.own
    assert "33,3" in own.calculation


def test_a_square_has_no_sign_that_nobody_read() -> None:
    """ab is due with a minus, as the rod turns, and was read without one."""
    (lesson,) = lessons(row("velocities", "5", "ab", 57.76, mm=57.5, line=9), normal("5"))
    assert lesson.own
    assert "(57.5·0.025)²" in lesson.calculation
    assert "−" not in lesson.calculation


def test_lessons_stand_in_the_order_of_the_log_and_show_what_is_off_the_most() -> None:
    late = row("accelerations", "1", "πb", 57.07, "13 πb", mm=87.0, line=5)
    rows = (late, normal("1", 40.0), normal("3", 48.0), normal("5", 44.0))
    found = lessons(*rows)
    assert [one.step for one in found] == [NORMAL, "13 πb"]
    assert found[0].shown == rows[2]
    assert found[0].position == "3"


def likely(plan: str, step: str = "", segment: str = "", position: str = "") -> Likely:
    told = Likely("", "it was", (2,), 1, 0.0, kind=UNKNOWN)
    return told._replace(plan=plan, step=step, segment=segment, position=position)


@pytest.mark.parametrize("step", ["an2", NORMAL, ""])
def test_a_finding_has_a_lesson_on_its_step_though_no_reading_blames_it(step: str) -> None:
    finding = likely("accelerations", step, "an2", "3")
    fine = row("accelerations", "3", "an2", DUE, mm=12.0)
    (lesson,) = lessons(fine, findings=(finding,))
    assert (lesson.step, lesson.names, lesson.shown, lesson.position) == (NORMAL, (0,), fine, "3")
    (blamed,) = lessons(normal(), findings=(finding,))
    assert (blamed.names, blamed.position) == ((0,), "5")


def test_a_finding_may_show_in_a_later_plan_than_it_was_made_in() -> None:
    """The rod's line was drawn wrongly; the first reading that shows it is of the plan of velocities."""
    (lesson,) = lessons(findings=(likely("velocities", "(AB)", "ab"),))
    assert (lesson.view, lesson.letter, lesson.names) == ("positions", "(AB)", (0,))
    assert lesson.picture is None  # the rod's line is not ink of the plan
    off = row("velocities", "3", "ab", 57.76, "8 ab", mm=30.0)
    made = [
        one for one in lessons(off, findings=(likely("velocities", "(AB)", "ab"),)) if one.names
    ]
    assert [(one.shows, one.shown, one.position) for one in made] == [(off, None, "3")]
    # a stands in both plans: it is the one of the plan that is named, else the last before the reading
    (here,) = lessons(findings=(likely("accelerations", "a", "b"),))
    assert here.view == "accelerations"
    (before,) = lessons(findings=(likely("accelerations", "(ab)", "an2"),))
    assert before.view == "velocities"


@pytest.mark.parametrize("plan", ["", "accelerations", "none", "results"])
def test_a_finding_of_no_step_has_no_lesson(plan: str) -> None:
    assert lessons(findings=(likely(plan), likely(plan, "zz", "q"))) == ()


def test_a_step_that_nobody_knows_has_no_lesson() -> None:
    assert lessons(row("accelerations", "3", "an2", DUE, "99 x", mm=3.0)) == ()
    other = row("nowhere", "3", "an2", DUE, NORMAL, mm=3.0)
    assert [one.plan for one in lessons(other)] == ["nowhere"]


def test_only_some_lessons_have_a_picture() -> None:
    made = exact("windrower")
    teacher, work = Teacher(made), made.mechanism
    assert work is not None
    position = work.names[work.row("accelerations")[0]]
    rows = [
        row(plan, position, segment, 10.0, label, mm=30.0)
        for plan in ("positions", "velocities", "accelerations")
        for segment, label in numbers(made, plan)
    ]
    found = teacher.lessons(rows, (), by(made))
    assert len(found) == len(rows) > PICTURED
    assert sum(one.picture is not None for one in found) <= PICTURED
    assert any(one.picture is not None for one in found)


def test_nothing_wrong_is_no_lesson() -> None:
    assert lessons(row("velocities", "1", "ab", 57.76, mm=57.5)) == ()
    assert slider_crank().mechanism is not None


def test_a_step_that_nothing_was_read_of_is_shown_in_some_position() -> None:
    (lesson,) = lessons(findings=(likely("velocities", "b"),))
    assert lesson.picture is not None
    assert lesson.picture.found == ()
    assert lesson.picture.due == pytest.approx((plan_of_velocities(0)["pb"],), abs=1e-9)
    assert lesson.position == "0"  # as its caption says
    (rate,) = lessons(findings=(likely("velocities", "ω_2"),))
    assert (rate.picture, rate.position) == (None, "")


def picture(*args: object, **more: object) -> PlanPicture | None:
    (lesson,) = lessons(row(*args, **more))  # type: ignore[arg-type]
    return lesson.picture


@pytest.mark.parametrize("position", [1, 3, 5, 7])
@pytest.mark.parametrize(("segment", "step"), [("pb", "10 pb"), ("ab", "8 ab"), ("pa", "2 pa")])
def test_a_length_is_laid_along_its_due_vector(position: int, segment: str, step: str) -> None:
    due = plan_of_velocities(position)[segment]
    found = picture("velocities", str(position), segment, abs(due), step, mm=33.0)
    assert found is not None
    start, end = found.due
    assert end - start == pytest.approx(due, abs=1e-9)
    begin, other = found.found
    assert begin == start
    assert other - begin == pytest.approx(33.0 * due / abs(due), abs=1e-9)
    named = plan_of_velocities(position)
    assert start == pytest.approx(named["pa"] if segment == "ab" else 0.0, abs=1e-9)


@pytest.mark.parametrize("position", [0, 2, 5])
def test_a_point_stands_where_it_was_read(position: int) -> None:
    due = points_of_positions(position)["B"]
    read = due + 3.0 - 20.0j
    found = picture("positions", str(position), "B", abs(due), "7 B", at=read)
    assert found is not None
    assert found.found == (read,)
    assert found.due == pytest.approx((due,), abs=1e-9)


def test_a_length_of_nothing_and_a_rate_have_no_picture() -> None:
    assert picture("velocities", "0", "pb", 0.0, "10 pb", mm=9.0) is None  # b stands in the pole
    assert picture("velocities", "1", "omega2", 4.1, "9 ω_2", mm=9.0) is None


def test_every_letter_has_the_point_that_it_names() -> None:
    due = points_of_positions(3)
    found = picture("positions", "3", "B", abs(due["B"]), "7 B", at=due["B"] + 9.0)
    assert found is not None
    named = dict(zip((one.text for one in found.drawing.labels), found.named, strict=True))
    assert named["A"] == pytest.approx(due["A"], abs=1e-9)
    assert named["B"] == pytest.approx(due["B"], abs=1e-9)


def test_of_readings_that_are_off_alike_the_largest_due_is_shown() -> None:
    """What should be nothing shows less of a calculation."""
    rows = (
        row("velocities", "2", "ab", 0.0, "8 ab", mm=20.0),
        row("velocities", "3", "ab", 57.8, "8 ab", mm=38.8, line=3),
        row("velocities", "5", "ab", 57.8, "8 ab", mm=48.8, line=4),
    )
    (lesson,) = lessons(*rows)
    assert lesson.position == "3"
    assert lesson.shown == rows[1]
