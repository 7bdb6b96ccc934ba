"""Where what slides cannot turn the next link, a sentence names the drive and the place."""

from __future__ import annotations

import re

import pytest
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
