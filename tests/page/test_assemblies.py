"""The ways to assemble a group on the page: each is drawn by the lines that stand under it."""

from __future__ import annotations

import cmath
import math
import re

import pytest
from chapters.kinematics.test_branches import places
from support import gallery
from support.plates import Machine, machine
from support.squares import square
from support.turns import in_turn

import graphic_tmm as tmm
from graphic_tmm.page.assemblies import assemblies
from graphic_tmm.studio import make

NEAR = re.compile(r'near = "([^"]+)"\nnear_at = "([^"]+)"')


def begun(one: Machine) -> str:
    """Return a machine's scene that is drawn where it was laid."""
    return one.text.replace("positions = 12", f'positions = ["{math.degrees(one.phi):.12f} deg"]')


def turned(text: str, one: Machine, plate: int, first: str, second: str) -> float:
    """Return how a plate of a scene is turned where the machine was laid, degrees."""
    moved = tmm.motion(tmm.read(text), [math.degrees(one.phi)])
    way = moved.places[second, plate][0] - moved.places[first, plate][0]
    own = one.letters[second, plate] - one.letters[first, plate]
    return math.degrees(cmath.phase(complex(way) / own))


def check(one: Machine, plate: int, most: int) -> int:
    """Write the lines of each picture into the scene and see what is drawn; return how many there are."""
    text = begun(one)
    (group,) = assemblies(make(tmm.read(text)))
    ((own, _),) = NEAR.findall(text)
    first, second = [letter for letter, on in one.letters if on == plate][:2]
    found = []
    for place in group["places"]:
        written = "\n".join(place["written"])
        ((near, at),) = NEAR.findall(written)
        assert float(at.removesuffix(" deg")) == pytest.approx(math.degrees(one.phi), rel=1e-5)
        angle = float(near.removesuffix(" deg"))
        off = turned(NEAR.sub(written, text), one, plate, first, second) - angle
        assert abs((off + 180) % 360 - 180) < 1e-2  # near_at has six figures
        away = abs((angle - float(own.removesuffix(" deg")) + 180) % 360 - 180)
        assert place["taken"] == (away < 1e-2)
        found.append(angle)
    assert sum(place["taken"] for place in group["places"]) == 1
    assert 1 < len(found) <= most
    return len(found)


@pytest.mark.parametrize("seed", in_turn(range(24), 4))
def test_a_picture_of_a_plate_is_drawn_by_its_lines(seed: int) -> None:
    one = machine(seed)
    if (most := places(one)) > 1:
        check(one, one.links[-1], most)


@pytest.mark.parametrize("seed", in_turn(range(8), 2))
def test_a_picture_of_joined_plates_is_drawn_by_its_lines(seed: int) -> None:
    laid = square(seed)
    check(laid.machine, laid.plates[0], len(laid.places()))


def test_a_scene_of_dyads_has_none() -> None:
    assert assemblies(gallery.made("crank-rocker")) == []
