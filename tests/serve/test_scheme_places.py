"""A plate that a mouse moves stays in the place that was drawn, whatever place its scene said."""

from __future__ import annotations

import copy
import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.plates import machine
from support.turns import in_turn

import graphic_tmm as tmm
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.page.assemblies import assemblies
from graphic_tmm.serve.scheme.act import SchemeAct, scheme
from graphic_tmm.studio import make

FILE = Path("scene.toml")
NEAR = re.compile(r"near *= .*\nnear_at *= .*")
HAND = 0.003
"""How far a mouse moves each pin, m, standard deviation."""


def after(text: str, act: SchemeAct) -> dict[str, Any]:
    return scheme(text.encode(), FILE, act, speaking("en"))


@pytest.mark.parametrize("seed", in_turn(range(24), 4))
def test_a_plate_is_where_it_was_drawn(seed: int) -> None:
    one = machine(seed)
    at = math.degrees(one.phi)
    there = one.text.replace("positions = 12", f'positions = ["{at:.12f} deg"]')
    chance = np.random.default_rng(seed)
    for place in (p for group in assemblies(make(tmm.read(there))) for p in group["places"]):
        other = NEAR.sub("\n".join(place["written"]), one.text)
        sketch = copy.deepcopy(after(other, SchemeAct(at=at))["sketch"])
        for letter in "BCF":
            x, y = sketch["places"][letter]
            sketch["places"][letter] = [x + chance.normal(0, HAND), y + chance.normal(0, HAND)]
        lies = after(one.text, SchemeAct(sketch=sketch))["sketch"]["places"]
        off = max(math.dist(lies[k], z) for k, z in sketch["places"].items())
        assert (
            off < 0.02
        )  # lengths are written to the mm, which moves a plate so far that is nearly free


def test_what_nobody_moved_keeps_its_lines() -> None:
    text = machine(1).text
    sketch = after(text, SchemeAct(at=200.0))["sketch"]
    now = after(text, SchemeAct(sketch=sketch))["text"]
    assert NEAR.search(now)[0] == NEAR.search(text)[0]
