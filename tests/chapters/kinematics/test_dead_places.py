"""Where what slides cannot turn the next link, a sentence names the drive and the place."""

from __future__ import annotations

import re

import pytest
from support import gallery
from support.driven_scenes import BOOM, SLIDER, scene

import graphic_tmm
from graphic_tmm.chapters.kinematics.dead_places import dead_places
from graphic_tmm.errors import TmmError
from graphic_tmm.studio import make

ROW = 'speed = "0.05 m/s"\nfrom = "{}"\nto = "{}"\npositions = 5\n'


@pytest.mark.parametrize(
    ("text", "ends", "says"),
    [
        (BOOM, ("100 mm", "900 mm"), "rod of link 3 cannot turn link 1 in positions 0, 4: GN passes through O"),
        (SLIDER, ("200 mm", "400 mm"), "Link 1 cannot move link 3 in positions 0, 4: B, A, O lie in one line"),
    ],
    ids=["rod", "slider"],
)  # fmt: skip
def test_a_dead_place_is_told(text: str, ends: tuple[str, str], says: str) -> None:
    (drawn,) = make(scene(text, ROW.format(*ends)), exact=True).boards
    assert any(says in one for one in dead_places(drawn, "en"))


def test_no_dead_place_is_told_where_there_is_none() -> None:
    (drawn,) = make(scene(BOOM, ROW.format("200 mm", "800 mm")), exact=True).boards
    assert not list(dead_places(drawn, "en"))


def test_a_stroke_beyond_reach_is_refused_with_one_that_can_be_drawn() -> None:
    with pytest.raises(TmmError, match=r"assembles for l from 100\.0 to 900\.0 mm only") as refused:
        make(scene(BOOM, ROW.format("50 mm", "80 mm")))
    ends = re.findall(r'"([\d.]+ mm)"', str(refused.value))
    velocities = graphic_tmm.draw(scene(BOOM, ROW.format(*ends)), exact=True).table("velocities")
    assert (velocities["omega1"].value[0] != 0.0).all()


TANGENT = """title = "Tangent"
language = "en"
[frame]
O = [0, 0]
x = {{ through = [0, 0.12], angle = "{tilt} deg" }}
[[link]]
number = 1
points = {{ O = [0, 0], A = [0.17, 0] }}
[[link]]
number = 2
points = {{ D = [0, 0] }}
slides = {{ on = 1, along = "OA" }}
[[link]]
number = 3
points = {{ D = [0, 0] }}
slides = {{ on = "frame", along = "x" }}
[drive]
link = 1
{drive}
"""
PARALLEL = "At φ = {}° both guides of group 2-3 are parallel and meet nowhere"


@pytest.mark.parametrize(
    ("row", "due"),
    [
        ('from = "100 deg"\nto = "170 deg"', []),
        ('from = "150 deg"\nto = "210.3 deg"', [190.5]),
        ('from = "-30 deg"\nto = "171 deg"', [10.5]),
        ('zero = "33 deg"', [10.5, 190.5]),
    ],
)
def test_guides_that_become_parallel_end_what_a_crank_can_do(row: str, due: list[float]) -> None:
    """The bar would come back from the other side of infinity, with figures that look right."""
    text = TANGENT.format(tilt=10.5, drive=f'speed = "9 rad/s"\npositions = 6\n{row}')
    (drawn,) = make(graphic_tmm.read(text), exact=True).boards
    assert [one.partition(":")[0] for one in dead_places(drawn, "en")] == [
        PARALLEL.format(f"{at:g}") for at in due
    ]


def test_guides_that_keep_their_angle_are_not_parallel() -> None:
    yoke = gallery.scene("scotch-yoke")
    (drawn,) = make(yoke, exact=True).boards[:1]
    assert not list(dead_places(drawn, "en"))
