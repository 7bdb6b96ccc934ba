"""Poles as they are clicked; the points of a photograph as readings that can be corrected."""

from __future__ import annotations

from pathlib import Path

import pytest

from graphic_tmm.checking.pencil.points import SEEN
from graphic_tmm.checking.pencil.reading import Found, Point, readings
from graphic_tmm.checking.photographed import Photographed, points_drawing, poles_of, write_seen
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.records import FINE, Judged, Report
from graphic_tmm.errors import SheetError


def test_poles_are_read_as_they_are_clicked() -> None:
    given = ["velocities:3=1200.5,840", "accelerations:7*=10,20"]
    assert poles_of(given) == {
        ("velocities", "3"): 1200.5 + 840j,
        ("accelerations", "7*"): 10 + 20j,
    }


@pytest.mark.parametrize(
    "text", ["", "velocities", "velocities=1,2", "velocities:3", "velocities:3=1", ":3=1,2"]
)
def test_a_pole_that_says_too_little_is_refused(text: str) -> None:
    with pytest.raises(SheetError, match="write plan, position and where its pole is"):
        poles_of([text])


@pytest.mark.parametrize("language", ["en", "ru"])
def test_points_seen_come_back_from_their_file(language: str, tmp_path: Path) -> None:
    points = tuple(
        Point(("velocities", letter, "3"), z, z - 10, SEEN, z)
        for letter, z in (("a", 12.344 + 5.678j), ("b", -3.5 - 0.25j))
    )
    seen = Photographed(Found(points, ()), readings(points))
    (file,) = write_seen(str(tmp_path / "seen.csv"), seen, language)
    back = read_readings(file)
    assert [one._replace(last=seen.taken[0].last) for one in back] == list(seen.taken)


def test_every_point_seen_is_shown_with_its_letter_and_error() -> None:
    points = tuple(
        Point(("velocities", letter, "3"), z, z, how, z)
        for letter, z, how in (
            ("a", 30 + 40j, SEEN),
            ("b", 70 + 80j, "unsure"),
            ("c", 0j, "unseen"),
        )
    )
    seen = Photographed(Found(points, ()), readings(points))
    judged = Judged(seen.taken[0], 50.0, 51.0, 1.26, 2.0, 0.5, FINE, own=0.84)
    drawing = points_drawing(seen, Report("scene", "", "en", "student", (judged,), ()))
    assert [label.text for label in drawing.labels] == ["a: 0.8", "b?"]
    middles = [sum(complex(x, y) for x, y, _ in one.path) / 2 for one in drawing.strokes]
    assert middles == pytest.approx([30 + 40j, 30 + 40j, 70 + 80j])
