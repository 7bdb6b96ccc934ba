"""Values that were changed in a scene's page stand in its file: nothing else of it is touched."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest
from support.scenes import source
from support.served import SMALL

from graphic_tmm.errors import TmmError
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.serve.scheme.act import SchemeAct, scheme

EN = speaking("en")
FILE = Path("scene.toml")
OWN = """[[link]]
number = 1
points.A = ["120 mm", "0 mm"]

[drive]
speed = 12.5
"""


def put(text: str, own: str) -> str:
    return scheme(text.encode(), FILE, SchemeAct(own=own), EN)["text"]


def test_a_changed_value_is_written_where_it_stands_in_the_unit_that_it_has() -> None:
    text = SMALL.replace('A = ["0.1 m", 0] }', 'A = ["0.1 m", 0] }  # the crank')
    now = put(text, OWN)
    assert now == text.replace("0.1 m", "0.12 m").replace("10 1/s", "12.5 1/s")
    assert put(now, OWN) == now
    turning = put(SMALL.replace("10 1/s", "300 rpm"), "[drive]\nspeed = 10.471975511966\n")
    assert 'speed = "100 rpm"' in turning


def test_a_mass_takes_the_place_of_a_weight_and_a_guide_of_the_frame_moves() -> None:
    text = SMALL.replace("B = [0, 0] }\n", 'B = [0, 0] }\nmass = "200 N"\n')
    own = (
        '[frame]\nx = { through = ["0 mm", "5 mm"], angle = "0.0 deg" }\n'
        '\n[[link]]\nnumber = 3\nmass = "25 kg"\n'
    )
    now = put(text, own)
    assert now == text.replace('"200 N"', '"25 kg"').replace("[0, 0], angle", '[0, "5 mm"], angle')


def test_what_another_section_says_is_written_too() -> None:
    """A page copies bores and rims as well: a number of a table, in the unit that it has."""
    text = source("engine")
    new = '[flywheel]\nD_e = "500 mm"\n'
    now = put(text, new)
    assert now != text
    assert put(now, new) == now
    assert tomllib.loads(now)["flywheel"]["D_e"] == "500 mm"
    assert {k: v for k, v in tomllib.loads(now).items() if k != "flywheel"} == {
        k: v for k, v in tomllib.loads(text).items() if k != "flywheel"
    }


@pytest.mark.parametrize(
    ("own", "says"),
    [
        ("[drive", "cannot be set here"),
        ("link = 1", "cannot be set here"),
        ('[[link]]\nnumber = 2\npoints.B = ["10 mm", 0]\n', "cannot be assembled"),
        ('[[link]]\nnumber = 2\npoints.B = ["10 kg", 0]\n', "length"),
    ],
)
def test_what_cannot_be_is_refused(own: str, says: str) -> None:
    with pytest.raises(TmmError, match=says):
        scheme(SMALL.encode(), FILE, SchemeAct(own=own, at=90.0), EN)


def test_of_a_scene_by_places_it_is_said_what_to_do() -> None:
    text = SMALL.replace("[[link]]", '[joints]\nA = ["0.1 m", 0]\nB = ["0.4 m", 0]\n[[link]]', 1)
    for was, now in (
        ('{ O = [0, 0], A = ["0.1 m", 0] }', '["O", "A"]'),
        ('{ A = [0, 0], B = ["0.3 m", 0] }', '["A", "B"]'),
        ("{ B = [0, 0] }", '["B"]'),
    ):
        text = text.replace(was, now)
    with pytest.raises(TmmError, match="move the pins in the scheme"):
        put(text, OWN)
