"""What a mistake draws beside what is due, by the vector loop of a slider-crank."""

from __future__ import annotations

import cmath
import math
from functools import cache

import pytest
from support.gallery import CASES
from support.lessons_told import CRANK, MU_A, OMEGA, ROD, by
from support.own_told import kind_of, report_of, with_mistake

from graphic_tmm.checking.check import check
from graphic_tmm.checking.lessons.lessons import Teacher
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.records import Lesson, Likely, Report
from graphic_tmm.paper.drawing import Bezier, Ink
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make


@cache
def report(case: str) -> Report:
    readings = read_readings(CASES / "check" / f"{case}.csv")
    return check(read(CASES / "check" / "sc.toml"), readings)


def lesson(case: str) -> Lesson:
    return next(one for one in report(case).lessons if 0 in one.names)


def accelerations(position: str, normal: float = 1.0) -> dict[str, complex]:
    """Return a, n2, b from the pole, mm; ``normal``: how many times as long n is, -1 from the wrong end."""
    phi = math.radians(45.0 * int(position))
    a = CRANK * cmath.exp(1j * phi)
    b = complex(a.real + math.sqrt(ROD**2 - a.imag**2), 0.0)
    turn = -(1j * OMEGA * a).imag / (b - a).real
    at_a = -(OMEGA**2) * a
    n = at_a - turn**2 * (b - a) * normal
    on = 1j * (b - a)
    at_b = n - on * n.imag / on.imag  # the acceleration of B has no y
    return {"a": at_a / MU_A, "n2": n / MU_A, "b": at_b / MU_A}


def ends(ink: Ink) -> list[complex]:
    if isinstance(ink, Bezier):
        return list(ink.controls)
    return [complex(x, y) for x, y, _ in ink.path]


def test_the_normal_from_the_wrong_end_is_drawn_to_the_other_end() -> None:
    told = lesson("normal_from_the_wrong_end_sc")
    picture = told.picture
    assert picture is not None
    assert picture.mistaken is not None
    due, amiss = accelerations(told.position), accelerations(told.position, -1.0)
    assert picture.due == pytest.approx((due["a"], due["n2"]), abs=1e-6)
    assert picture.found == pytest.approx((due["a"], amiss["n2"]), abs=1e-6)
    red = [z for one in picture.mistaken for z in ends(one)]
    assert min(abs(z - amiss["b"]) for z in red) < 1e-6  # what follows is drawn, too
    assert min(abs(z - due["n2"]) for z in red) > 1.0
    assert abs(amiss["b"] - due["b"]) > 10.0


def test_what_was_left_out_is_drawn_without_it() -> None:
    told = lesson("normal_forgotten_sc")
    assert told.picture is not None
    due, amiss = accelerations(told.position), accelerations(told.position, 0.0)
    assert told.picture.mistaken is not None
    red = [z for one in told.picture.mistaken for z in ends(one)]
    assert min(abs(z - amiss["b"]) for z in red) < 1e-6
    assert min(abs(z - due["b"]) for z in red) > 1.0


def test_a_zero_was_left_out() -> None:
    (first,) = report("normal_forgotten_sc").mistakes
    assert first.says.endswith("an2 was left out")
    assert first.like == ()


def test_a_mistake_shows_in_a_reading_where_its_own_is_right() -> None:
    told = lesson("normal_from_the_wrong_end_sc")
    assert told.shown is not None
    assert told.shows is not None
    assert (told.shown.taken.segment, told.shown.verdict) == ("an2", "fine")
    assert (told.shows.taken.segment, told.shows.verdict) == ("πb", "wrong")
    assert told.position == told.shown.taken.position == told.shows.taken.position


def test_the_lesson_is_on_the_step_in_the_plan_where_it_was_made() -> None:
    """The force of inertia is drawn in three views; the force polygon's was reversed."""
    made = make(read(CASES / "check" / "fsc.toml"), exact=True)
    assert made.mechanism is not None
    marks = [step.it for step in made.mechanism.construction.steps]
    letter = next(one.letter for one in marks if one.view == "forces 2-3" and "i3" in one.letter)
    assert sum(one.letter == letter for one in marks) > 1
    found = Likely("", "it was", (2,), 1, 0.0, plan="forces", segment="R12", step=letter)
    told = Teacher(made).lessons((), (found._replace(view="forces 2-3"),), by(made))
    assert [one.view for one in told] == ["forces 2-3"]


@pytest.mark.slow
def test_a_mistake_in_a_force_polygon_is_drawn_beside_what_is_due() -> None:
    """The load laid off the other way: its side is due, the same side turned round is what was drawn."""
    said = report_of(with_mistake(kind_of("load along the velocity"), 0, 70000, ways=("mm",)))
    assert not isinstance(said, str)
    picture = next(one for one in said.lessons if 0 in one.names).picture
    assert picture is not None
    assert picture.mistaken
    (start, end), (begun, ended) = picture.due, picture.found
    assert abs(start - begun) < 1e-6
    assert abs((ended - begun) + (end - start)) < 1e-6 * abs(end - start)
