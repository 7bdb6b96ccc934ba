"""What a scene says to act on its mechanism comes with its scheme, where it stands and whither it goes."""

from __future__ import annotations

import cmath
import math
from pathlib import Path
from typing import Any

import pytest
from support.gallery import SHEETS
from support.served import SMALL

from graphic_tmm.language.catalogue import speaking
from graphic_tmm.serve.scheme.act import SchemeAct, scheme

FILE = Path("scheme.toml")
WEIGHED = SMALL.replace(
    'B = ["0.3 m", 0] }', 'B = ["0.3 m", 0], S2 = ["0.1 m", "0.02 m"] }\nmass = 2\ncentre = "S2"'
)


def shown(text: str, **asked: Any) -> dict[str, Any]:
    return scheme(text.encode(), FILE, SchemeAct(**asked), speaking("en"))


def signs(more: str, at: float = 60.0, small: str = SMALL) -> dict[str, dict[str, Any]]:
    return {one["letter"]: one for one in shown(small + more, at=at)["loads"]}


def place(found: dict[str, Any], key: str = "at") -> complex:
    return complex(*found[key])


def places(at: float) -> dict[str, complex]:
    return {k: complex(*z) for k, z in shown(SMALL, at=at)["sketch"]["places"].items()}


FORCE = '[[load]]\nlink = {link}\npoint = "{point}"\nforce = "190 N"\ndirection = "{way}"\n'


@pytest.mark.parametrize("at", [60.0, 200.0, 300.0])
def test_a_force_stands_at_its_point_though_nothing_asks_for_forces(at: float) -> None:
    there = places(at)
    fixed = signs(FORCE.format(link=2, point="A", way="-30 deg"), at)["F_2"]
    assert abs(place(fixed) - there["A"]) < 1e-9
    assert abs(place(fixed, "way") - cmath.rect(1, -math.pi / 6)) < 1e-9
    along = signs(FORCE.format(link=2, point="B", way="along AB"), at)["F_2"]
    bar = there["B"] - there["A"]
    assert abs(place(along, "way") - bar / abs(bar)) < 1e-9


@pytest.mark.parametrize(
    ("turns", "at", "way"),
    [("counterclockwise", 60.0, 1.0), ("counterclockwise", 250.0, -1.0), ("clockwise", 60.0, -1.0)],
)
def test_what_resists_goes_against_the_slider(turns: str, at: float, way: float) -> None:
    small = SMALL.replace('"counterclockwise"', f'"{turns}"')
    found = signs(FORCE.format(link=3, point="B", way="against velocity"), at, small)["F_3"]
    assert abs(place(found, "way") - way) < 1e-9


def test_moments_weights_and_springs_have_signs_of_their_own() -> None:
    more = """[effects]
gravity = true
[[load]]
link = 1
moment = "-12 N*m"
[[spring]]
between = ["O", "B"]
rate = "2 kN/m"
free = "100 mm"
"""
    found = signs(more, small=WEIGHED)
    there = places(60.0)
    assert found.keys() == {"M_1", "G_2", "c"}
    assert found["M_1"]["turns"] == -1
    assert found["M_1"]["way"] == [0, 0]
    assert abs(place(found["M_1"]) - (there["O"] + there["A"]) / 2) < 1e-9
    bar = (there["B"] - there["A"]) / 0.3
    assert abs(place(found["G_2"]) - there["A"] - (0.1 + 0.02j) * bar) < 1e-9
    assert abs(place(found["G_2"], "way") + 1j) < 1e-9
    assert {abs(place(found["c"], key) - there["B"]) < 1e-9 for key in ("at", "end")} == {
        True,
        False,
    }


def test_gas_pushes_its_piston_towards_the_crank() -> None:
    text = (SHEETS / "locomobile" / "scene.toml").read_text("utf-8")
    (found,) = shown(text)["loads"]
    assert found["letter"] == "P"
    assert found["pushes"]
    assert abs(place(found, "way") + 1) < 1e-9


def test_a_fault_of_something_else_hides_no_load() -> None:
    force = FORCE.format(link=3, point="B", way="0 deg")
    assert "F_3" in signs(f'{force}[hand]\nname = "nobody"\n[cam]\nstroke = "28 kg"\n')
    assert signs(force.replace("190 N", "190 kg")) == {}


def test_every_place_of_a_turn_has_its_loads() -> None:
    text = SMALL + FORCE.format(link=3, point="B", way="against velocity")
    turn = shown(text, turn=12)["turn"]
    ways = [one["way"][0] for (one,) in turn["loads"]]
    assert len(ways) == len(turn["at"])
    assert [round(way) for way in ways[1:6]] == [1] * 5
    assert [round(way) for way in ways[7:12]] == [-1] * 5
    for (one,), spot in zip(turn["loads"], turn["places"]["B"], strict=True):
        assert one["at"] == pytest.approx(spot)
