"""Places of a plate: as many as a search along one angle finds, the one that is named, none that is not."""

from __future__ import annotations

import cmath
import math
import re

import numpy as np
import pytest
from support.gallery import SHEETS
from support.plates import Machine, machine
from support.turns import in_turn

import graphic_tmm as tmm
from graphic_tmm.errors import TmmError

PARTS = 20_000
"""So finely the plate is turned in the search: finer than two places of any of the machines are apart."""


def places(one: Machine) -> int:
    """Return in how many ways three turning legs hold the plate: changes of sign along its angle.

    With the plate at an angle its pin B is on two circles, about A and about D less BC; F is then too far
    from E, or too near.
    """
    bodies, q = one.bodies, one.bodies.start()
    plate = one.links[-1]
    own = {letter: one.letters[letter, plate] for letter in "BCF"}
    ends = {}
    for pin in bodies.pins:
        legs = {letter: k for (letter, k) in one.letters if letter in "BCF" and k != plate}
        for letter, leg in legs.items():
            if leg == pin.first and pin.second != plate:
                ends[letter] = bodies.place(q, pin.second, pin.b)
    reach = {letter: abs(bodies.place(q, plate, own[letter]) - end) for letter, end in ends.items()}
    turned = np.exp(2j * np.pi * np.arange(PARTS) / PARTS)
    first, second = ends["B"], ends["C"] - (own["C"] - own["B"]) * turned
    base = second - first
    d = np.abs(base)
    foot = (d * d + reach["B"] ** 2 - reach["C"] ** 2) / (2 * d)
    with np.errstate(invalid="ignore"):
        height = np.sqrt(reach["B"] ** 2 - foot**2)
    found = 0
    rows = []
    for side in (1, -1):
        b = first + (foot + 1j * side * height) * base / d
        rows.append(np.abs(b + (own["F"] - own["B"]) * turned - ends["F"]) - reach["F"])
    there = np.isfinite(rows[0])
    after = np.roll(there, -1)
    for row in rows:
        both = there & after
        found += int(np.sum(both & (np.sign(row) != np.sign(np.roll(row, -1)))))
    # both sides meet where the circles touch: there the curve of F goes on from the one to the other
    for k in np.flatnonzero(there != after):
        at = k if there[k] else (k + 1) % PARTS
        found += int(np.sign(rows[0][at]) != np.sign(rows[1][at]))
    return found


def refused(one: Machine) -> str:
    """Return how the first direction is refused near which no place is."""
    (line,) = (row for row in one.text.splitlines() if row.startswith("near ="))
    for angle in range(0, 360, 10):
        try:
            tmm.motion(tmm.read(one.text.replace(line, f'near = "{angle} deg"')), [0.0])
        except TmmError as error:
            if "near = one of" in str(error):
                return str(error)
    raise AssertionError("every direction is near a place")


@pytest.mark.parametrize("seed", in_turn(range(80), 8))
def test_as_many_places_as_there_are(seed: int) -> None:
    one = machine(seed)
    assert f"can be assembled in {places(one)} ways" in refused(one)


def test_places_that_are_listed_are_taken() -> None:
    one = machine(1)
    (line,) = (row for row in one.text.splitlines() if row.startswith("near ="))
    listed = re.findall(
        r'"(-?[\d.]+) deg"', refused(one).split("one of")[1].split(", and near_at")[0]
    )
    assert len(listed) == places(one)
    plates = set()
    for angle in listed:
        moved = tmm.motion(
            tmm.read(one.text.replace(line, f'near = "{angle} deg"')), [math.degrees(one.phi)]
        )
        plate = one.links[-1]
        way = moved.places["C", plate][0] - moved.places["B", plate][0]
        own = one.letters["C", plate] - one.letters["B", plate]
        found = math.degrees(cmath.phase(complex(way) / own))
        assert abs((found - float(angle) + 180) % 360 - 180) < 1e-3
        plates.add(round(found, 3))
    assert len(plates) == len(listed)


def test_places_are_listed_where_there_are_most() -> None:
    """Where the landing gear begins two of its places are; the other two come in as the drive moves on."""
    text = (SHEETS / "landing-gear" / "scene.toml").read_text("utf-8")
    bare = "".join(line for line in text.splitlines(True) if not line.startswith("near"))
    with pytest.raises(TmmError, match="can be assembled in 4 ways"):
        tmm.motion(tmm.read(bare), [0.5])
