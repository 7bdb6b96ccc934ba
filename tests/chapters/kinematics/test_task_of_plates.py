"""What a task says of a plate on three legs: which of its places is drawn, and its special point."""

from __future__ import annotations

import cmath
import math
import re
from pathlib import Path

import pytest
from support.gallery import SHEETS
from support.plate_by_hand import LENGTHS, SCENE, laid, turned

from graphic_tmm.chapters.kinematics.task_sheet import positions, special_points
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene

EN = r"Of the places of link 3 .* at φ = (\d+)° its line BC stands at (\d+)° to the x axis"
RU = r"Из сборок со звеном 3 .* при φ = (\d+)° его прямая BC стоит под углом (\d+)° к оси x"


def triad(folder: Path) -> Scene:
    path = folder / "scene.toml"
    path.write_text(SCENE.format(language="en"), "utf-8")
    return read(path)


@pytest.mark.parametrize(("language", "says"), [("en", EN), ("ru", RU)])
def test_the_place_is_told_by_its_angle_where_the_scheme_shows_it(
    language: str, says: str, tmp_path: Path
) -> None:
    told = "\n".join(positions(triad(tmp_path), language)).replace("\u00a0", " ")
    found = re.search(says, told)
    assert found is not None, told
    angle, line = map(float, found.groups())
    ways = [turned(one) for one in laid(math.radians(angle), LENGTHS)]
    off = [abs(cmath.phase(cmath.exp(1j * (way - math.radians(line))))) for way in ways]
    assert min(off) < math.radians(0.51)
    assert sum(one < math.radians(5.0) for one in off) == 1, "no other place is near it"


def test_letters_of_lengths_are_written_with_an_index() -> None:
    told = "\n".join(positions(read(SHEETS / "landing-gear" / "scene.toml"), "en"))
    assert re.search(
        r"at l_[A-Z]+\u00a0= [\d.]+\u00a0mm|at l_[A-Z]+\u00a0=\u00a0[\d.]+\u00a0mm", told
    )
    assert "{" not in told


def test_special_points_are_asked_for_by_their_links(tmp_path: Path) -> None:
    (told,) = special_points(triad(tmp_path), "en")
    assert told.startswith("Assur's special point of group 2-3-4-5 is found")
    assert not [*special_points(read(SHEETS / "windrower" / "scene.toml"), "en")]
    assert "Of the places" not in "".join(
        positions(read(SHEETS / "windrower" / "scene.toml"), "en")
    )
