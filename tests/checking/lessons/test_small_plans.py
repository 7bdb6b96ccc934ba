"""Small plans: where the due segment or point stands, and the one found, by the vector loop."""

from __future__ import annotations

import pytest
from support.lessons_told import lessons, plan_of_velocities, points_of_positions, row

from graphic_tmm.checking.records import Picture


def picture(*args: object, **more: object) -> Picture | None:
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
