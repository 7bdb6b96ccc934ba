"""A cam that turns on the page: its follower touches it at every angle, laid there by shapely."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import shapely
from support.boards import in_usual_size
from support.gallery import SHEETS
from support.scenes import written
from support.turned import inside, laid, picture, points

from graphic_tmm import motion
from graphic_tmm.page.turning import PLACES, turning_pictures
from graphic_tmm.scene.read import read

HEAD = """title = "T"
language = "en"
[cam]
rise = "120 deg"
upper_dwell = "30 deg"
fall = "90 deg"
parts = 12
"""
CASES = {
    "sine": str(SHEETS / "cam"),
    "lifts": str(SHEETS / "two-lifts"),
    "flat rocker": str(SHEETS / "flat-rocker-cam"),
    "edge": HEAD + 'stroke = "50 mm"\nr0 = "50 mm"\nlaw = "cosine"\nroller = "0 mm"\n',
    "offset": HEAD
    + 'stroke = "30 mm"\nr0 = "50 mm"\nlaw = "3-4-5"\noffset = "15 mm"\nroller = "10 mm"\n',
    "clockwise": HEAD
    + 'stroke = "30 mm"\nr0 = "50 mm"\nlaw = "3-4-5"\noffset = "-9 mm"\nroller = "10 mm"\n'
    + 'turns = "clockwise"\n',
    "flat": HEAD + 'stroke = "20 mm"\nlaw = "3-4-5"\nfollower = "flat"\nr0 = "70 mm"\n',
    "rocker": HEAD
    + 'stroke = "25 deg"\nlaw = "sine"\nfollower = "rocker"\nlever = "80 mm"\n'
    + 'centres = "100 mm"\nroller = "10 mm"\n',
    "along": HEAD
    + 'stroke = "25 deg"\nlaw = "sine"\nfollower = "rocker"\nlever = "80 mm"\n'
    + 'centres = "100 mm"\nroller = "10 mm"\nturns = "clockwise"\n',
}
ROUNDED = 10.0**-PLACES
"""The last decimal that the page is told."""
TURNS = np.arange(0.0, 360.0, 3.7)
NEAR = 0.1
"""A line is three times as broad; profile and diagram pass their positions by curves of their own."""


@pytest.mark.parametrize("case", CASES)
def test_the_follower_touches_the_cam(tmp_path: Path, case: str) -> None:
    shown = picture(tmp_path, CASES[case])
    cam, *rest = shown.bodies
    (follower,) = (body for body in rest if body.moves)
    pen = "body" if case == "edge" else "main"
    sides = []
    for turn in TURNS:
        profile, own = inside(laid(cam, turn, "main")), laid(follower, turn, pen)
        assert profile.contains(shapely.Point(0.0, 0.0))
        assert shapely.intersection(own, profile.buffer(-NEAR)).length == 0.0, turn
        assert own.distance(profile) < NEAR, turn
        sides.append(own.bounds)
    assert np.ptp(sides, axis=0).max() > 5.0, "it has gone somewhere"


def test_what_is_told_is_the_law(tmp_path: Path) -> None:
    """The sine law: half the stroke in the middle of the rise, all of it on the dwell, mm."""
    shown = picture(tmp_path, CASES["sine"])
    turn, place = shown.values
    assert (turn.course, place.unit) == (1.0, "мм")
    assert isinstance(place.course, tuple)
    assert len(place.course) == 360
    due = {0: 0.0, 25: 28.0 * (0.25 - 1 / (2 * np.pi)), 50: 14.0, 110: 28.0, 165: 14.0, 300: 0.0}
    for angle, far in due.items():
        assert place.course[angle] == pytest.approx(far, abs=ROUNDED), angle


@pytest.mark.parametrize("case", CASES)
def test_the_page_and_motion_tell_the_same(tmp_path: Path, case: str) -> None:
    """At every degree of the turn, mm or degrees: also where it lies between two positions."""
    place = picture(tmp_path, CASES[case]).values[1]
    path = Path(CASES[case]) if "\n" not in CASES[case] else tmp_path / "scene.toml"
    due = motion(read(path), np.arange(360.0), plans="cam", exact=True).columns["S"]
    due = np.degrees(due) if place.unit == "°" else 1000.0 * due
    assert isinstance(place.course, tuple)
    np.testing.assert_allclose(place.course, due, rtol=0.0, atol=ROUNDED)


def test_a_roller_in_a_groove_touches_both_flanks(tmp_path: Path) -> None:
    text = HEAD + 'stroke = "30 mm"\nr0 = "60 mm"\nlaw = "3-4-5"\nroller = "8 mm"\ngroove = true\n'
    shown = picture(tmp_path, text)
    cam, *rest = shown.bodies
    (follower,) = (body for body in rest if body.moves)
    axes = np.concatenate([points(one) for one in shown.stands.strokes])
    for turn in TURNS:
        flanks = laid(cam, turn, "main")
        assert np.ptp(axes, axis=0).max() > flanks.bounds[2] - flanks.bounds[0], (
            "they reach beyond it"
        )
        (roller,) = (one for one in shapely.polygonize([laid(follower, turn, "main")]).geoms)
        assert not flanks.intersects(roller.buffer(-NEAR)), turn
        touched = flanks.intersection(roller.buffer(NEAR)).buffer(NEAR)
        assert len(shapely.get_parts(touched)) == 2, "one flank on each side"


def test_a_drum_has_no_picture_that_turns(tmp_path: Path) -> None:
    path = written(
        tmp_path, HEAD + 'stroke = "30 mm"\nlaw = "3-4-5"\nroller = "8 mm"\nform = "drum"\n'
    )
    assert not list(turning_pictures(in_usual_size(read(path), exact=True)))
