"""A train that turns on the page: the teeth of wheels that touch meet at every angle, laid there by shapely."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
import shapely
from support.gallery import SHEETS
from support.turned import laid, moved, picture

from graphic_tmm.chapters.trains.task import SCHEMES
from graphic_tmm.page.turning import RigidBody, TurningPicture

HEAD = 'title = "T"\nlanguage = "en"\n[planetary]\nmodule = "5 mm"\nspeed = "1440 rpm"\n'


def case(scheme: str, teeth: str, more: str = "") -> str:
    return f'{HEAD}scheme = "{scheme}"\nteeth = {teeth}\n{more}\n'


CASES = {
    "usual": ("ring", str(SHEETS / "planetary")),
    "two drive": ("ring", str(SHEETS / "differential")),
    "3K": ("3K", str(SHEETS / "train-3k")),
    "odd": ("ring", case("ring", "[24, 21, 66]")),
    "carrier drives": ("ring", case("ring", "[24, 24, 72]", 'driving = "H"')),
    "carrier stands": ("ring", case("ring", "[24, 24, 72]", 'fixed = "H"')),
    "two rows": ("external-internal", case("external-internal", "[24, 36, 24, 84]")),
    "outside": ("external-external", case("external-external", "[40, 30, 28, 42]")),
    "inside": ("internal-internal", case("internal-internal", "[90, 30, 36, 96]")),
    "wide": (
        "external-external",
        case(
            "external-external", "[100, 20, 20, 101]", 'driving = "H"\nfixed = "1"\nsatellites = 1'
        ),
    ),
    "in a ring": ("internal", case("internal", "[60, 24]", 'driving = "H"\nfixed = "1"')),
    "arm": ("external", case("external", "[40, 20]")),
    "behind another": ("ring", case("ring", "[25, 32, 89]", "before = [20, 30]")),
}
TURNS = (0.0, 1.0, 37.3, 180.0, 725.9, -1234.5)
NEAR = 2e-3
"""Radii, places and turns are told to 1e-4 mm and degrees, after whole turns too."""


class Wheel(NamedTuple):
    """A wheel by its number: its pitch circle, the strokes of its teeth."""

    name: str
    disc: RigidBody
    teeth: RigidBody

    @property
    def radius(self) -> float:
        """The pitch radius, mm."""
        (x, _, _), (u, _, _) = self.disc.strokes[0].path  # type: ignore[union-attr]
        return abs(u - x) / 2

    def centre(self, turn: float) -> complex:
        spot = shapely.Point(self.teeth.centre.real, self.teeth.centre.imag)
        at = moved(spot, self.disc, turn)
        return complex(at.x, at.y)

    def middles(self, turn: float) -> np.ndarray:
        """Where the strokes of the teeth cross the pitch circle."""
        ends = np.array([line.coords for line in laid(self.teeth, turn).geoms])
        return ends.mean(axis=1) @ np.array([1.0, 1.0j])


def wheels(shown: TurningPicture) -> Iterator[Wheel]:
    for disc, teeth in pairwise(shown.bodies):
        if teeth.copies > 1:
            yield Wheel(disc.letters[0].text, disc, teeth)


def off(wheel: Wheel, contact: complex, turn: float) -> float:
    """How far beyond a place on its circle the nearest tooth stands, along the circle counter-clockwise, mm."""
    ways = (wheel.middles(turn) - wheel.centre(turn)) / (contact - wheel.centre(turn))
    angles = np.angle(ways)
    return float(angles[np.abs(angles).argmin()]) * wheel.radius


@pytest.mark.parametrize("train", CASES)
def test_wheels_in_mesh_roll(tmp_path: Path, train: str) -> None:
    scheme, text = CASES[train]
    found = list(wheels(picture(tmp_path, text)))
    meshes = 0
    for wheel, rim, sense, _ in SCHEMES[scheme].meshes:
        (central,) = (one for one in found if one.name == wheel)
        carried = [one for one in found if one.name == rim]
        assert carried
        pitch = 2.0 * np.pi * central.radius / central.teeth.copies
        for turn in TURNS:
            for satellite in carried:
                axis, main = satellite.centre(turn), central.centre(turn)
                assert abs(axis - main) == pytest.approx(
                    central.radius + sense * satellite.radius, abs=NEAR
                )
                contact = main + central.radius * (axis - main) / abs(axis - main)
                own, other = (off(one, contact, turn) for one in (central, satellite))
                apart = abs(own + sense * other)
                assert min(apart, abs(apart - pitch)) < NEAR, (wheel, rim, turn)
                meshes += 1
    assert meshes >= len(TURNS)


@pytest.mark.parametrize("train", ["usual", "behind another"])
def test_it_turns_as_willis_says(tmp_path: Path, train: str) -> None:
    """U_1H = 1 + 89/25 as published; the ring stands, the satellite turns back by −1127/2888."""
    shown = picture(tmp_path, CASES[train][1])
    rates = {value.letter: value.course for value in shown.values}
    first = rates["φ_{1}"]
    assert abs(first) == 1.0
    assert rates["φ_{H}"] / first == pytest.approx(25.0 / (25.0 + 89.0))
    assert rates["φ_{2}"] / first == pytest.approx(-1127.0 / 2888.0, rel=0.003)
    assert "φ_{3}" not in rates
    (ring,) = (one for one in wheels(shown) if one.name == "3")
    assert ring.disc.moves == ring.teeth.moves == ()
