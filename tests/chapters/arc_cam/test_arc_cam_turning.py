"""A cam given by arcs that turns on the page: its follower touches it at every angle, laid there by shapely."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import shapely
from support.gallery import SHEETS
from support.turned import inside, laid, picture

from graphic_tmm import motion
from graphic_tmm.page.turning import PLACES
from graphic_tmm.scene.read import read

HEAD = 'title = "T"\nlanguage = "en"\n[arc_cam]\nspeed = "600 rpm"\nparts = 12\nnose = "7 mm"\n'
ARCS = HEAD + 'base = "20 mm"\ndistance = "22 mm"\nflank = "60 mm"\n'
CASES = {
    "tangential": str(SHEETS / "arc-cam"),
    "offset": ARCS + 'follower = "roller"\nroller = "10 mm"\noffset = "4 mm"\n',
    "clockwise": ARCS + 'follower = "roller"\nroller = "10 mm"\nturns = "clockwise"\n',
    "edge": ARCS + 'follower = "roller"\nroller = 0\n',
    "flat": ARCS + 'follower = "flat"\n',
    "rocker": ARCS + 'follower = "rocker"\nroller = "8 mm"\nlever = "50 mm"\ncentres = "60 mm"\n',
    "flat rocker": ARCS + 'follower = "flat rocker"\ncentres = "70 mm"\n',
}
NEAR = 0.02
"""What lies between two degrees, and behind the last one of the lift, is told in proportion, mm."""


@pytest.mark.parametrize("case", CASES)
def test_the_follower_touches_the_arcs(tmp_path: Path, case: str) -> None:
    cam, *rest = picture(tmp_path, CASES[case]).bodies
    (follower,) = (body for body in rest if body.moves)
    contour = [stroke for stroke in cam.strokes if stroke.part == "contour"]
    assert len(contour) == 4
    sides = []
    for turn in np.arange(0.0, 360.0, 3.7):
        profile = inside(laid(cam, turn, part="contour"))
        own = laid(follower, turn, "body" if case == "edge" else "main")
        assert shapely.intersection(own, profile.buffer(-NEAR)).length == 0.0, turn
        assert own.distance(profile) < NEAR, turn
        sides.append(own.bounds)
    assert np.ptp(sides, axis=0).max() > 3.0, "it has gone somewhere"


@pytest.mark.parametrize("case", CASES)
def test_the_page_and_motion_tell_the_same(tmp_path: Path, case: str) -> None:
    """At every degree of the turn, mm or degrees."""
    place = picture(tmp_path, CASES[case]).values[1]
    path = Path(CASES[case]) if "\n" not in CASES[case] else tmp_path / "scene.toml"
    due = motion(read(path), np.arange(360.0), plans="arc_cam", exact=True).columns["S"]
    due = np.degrees(due) if place.unit == "°" else 1000.0 * due
    assert isinstance(place.course, tuple)
    np.testing.assert_allclose(place.course, due, rtol=0.0, atol=10.0**-PLACES)
