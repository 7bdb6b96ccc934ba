"""Pictures whose bodies turn, as data: what stands, what moves, in which room, only where there are such."""

from __future__ import annotations

import numpy as np
import pytest
from support import pages
from support.boards import in_usual_size
from support.gallery import ALL, scene
from support.turned import laid

from graphic_tmm.page.page import page, page_data
from graphic_tmm.page.turning import (
    RigidBody,
    Rotation,
    Shift,
    along,
    turning_data,
    turning_pictures,
)
from graphic_tmm.paper.drawing import line
from graphic_tmm.project import own_boards


def test_a_row_goes_on_from_its_end_to_its_beginning() -> None:
    row = tuple(float(k) for k in range(360))
    assert along(row, 12.25) == pytest.approx(12.25)
    assert along(row, 359.5) == pytest.approx(179.5)
    assert along(row, -1.0) == along(row, 719.0) == pytest.approx(359.0)
    assert along(-0.5, 720.0) == -360.0


def test_a_carried_body_turns_about_its_own_axis_first() -> None:
    """A point of a wheel that is carried once round and turns against the carrier as much stays upright."""
    body = RigidBody((line("main", 3j, 4j),), (Rotation(2j, -1.0), Rotation(0j, 1.0)))
    spots = body.moved(np.array([3j]), 90.0)
    assert spots[0] == pytest.approx(-2 + 1j)
    (own,) = laid(body, 90.0).geoms
    assert own.coords[0] == pytest.approx((-2.0, 1.0))
    assert Shift(1j, 2.0).moved(np.array([1 + 0j]), 3.0)[0] == pytest.approx(1 + 6j)


def test_a_picture_has_room_for_all_places_of_its_bodies() -> None:
    made, sheets = pages.on_sheets("cam", "ru")
    told = turning_data(made, sheets)
    assert told is not None
    (figure,) = told["figures"]
    (picture,) = turning_pictures(made)
    left, top, wide, high = figure["box"]
    for body in picture.bodies:
        for turn in range(0, 360, 7):
            low = laid(body, turn).bounds
            assert low[0] >= left
            assert low[2] <= left + wide
            assert -low[1] <= top + high
            assert -low[3] >= top
    assert len(figure["bodies"]) == len(picture.bodies) == 3


def test_a_whole_wheel_is_told_once() -> None:
    made, sheets = pages.on_sheets("gear-pair", "ru")
    told = turning_data(made, sheets)
    assert told is not None
    wheels = [body for figure in told["figures"] for body in figure["bodies"] if "copies" in body]
    assert [body["copies"][0] for body in wheels] == [15, 25]
    assert all(len(body["strokes"]) == 1 for body in wheels)


def test_only_what_turns_brings_its_program() -> None:
    made, sheets = pages.on_sheets("lettering", "ru")
    assert turning_data(made, sheets) is None
    assert "turning" not in page_data(made, sheets)
    assert '["turning"]' not in page(made, sheets)
    made, sheets = pages.on_sheets("cam", "ru")
    text = page(made, sheets, practised=True)
    assert text.count('["turning"]=') == 2, "its room, its keys"
    assert text == page(made, sheets, practised=True)


@pytest.mark.every
@pytest.mark.parametrize("name", [name for name in ALL if own_boards(scene(name))])
def test_of_every_scene_what_turns_can_be_told(name: str) -> None:
    """None of a board of its own fails to, whatever is drawn on it; a picture turns something."""
    for shown in turning_pictures(in_usual_size(scene(name), exact=True)):
        assert any(body.moves for body in shown.bodies)
