"""What a scene asks to be drawn: the main position, the poles, sheets without a mechanism."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from support.gallery import SHEETS

from graphic_tmm.errors import SceneError
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene

ENGINE = (SHEETS / "engine" / "scene.toml").read_text(encoding="utf-8")
PLANS = re.search(r"\[plans\][^\[]*(\[\"S2\"\])?", ENGINE)


def scene(folder: Path, text: str) -> Scene:
    file = folder / "scene.toml"
    file.write_text(text, encoding="utf-8")
    return read(file)


def with_plans(*lines: str) -> str:
    assert PLANS is not None
    section = "\n".join(("[plans]", *lines, 'velocities = "turned"', "", ""))
    return ENGINE.replace(PLANS.group(), section)


def faults(folder: Path, text: str) -> list[tuple[str, str]]:
    with pytest.raises(SceneError) as refused:
        scene(folder, text)
    return [(fault.key, fault.message) for fault in refused.value.faults]


def test_the_main_position_and_the_pole_are_read(tmp_path: Path) -> None:
    made = scene(tmp_path, with_plans("main = 7", 'velocity_pole = "common"'))
    assert (made.main, made.common_pole) == ("7", True)
    assert scene(tmp_path, with_plans('velocity_pole = "общий"')).common_pole


@pytest.mark.parametrize(
    ("line", "key", "says"),
    [
        ("main = 13", "plans.main", "from 1 to 12"),
        ('main = "7*"', "plans.main", "name it first"),
        ("main = 2.5", "plans.main", "a position is a number"),
        ("main = true", "plans.main", "a position is a number"),
        ('velocity_pole = "shared"', "plans.velocity_pole", "own"),
        ("velocity_poles = 1", "plans.velocity_poles", "velocity_pole"),
    ],
)
def test_what_cannot_be_meant_is_told(tmp_path: Path, line: str, key: str, says: str) -> None:
    ((found, message),) = faults(tmp_path, with_plans(line))
    assert found == key
    assert says in message


def test_a_sheet_that_shows_no_mechanism_needs_none(tmp_path: Path) -> None:
    made = scene(tmp_path, 'title = "T"\n[[sheet]]\nplace = ["lettering"]\n')
    assert made.mechanism is None


@pytest.mark.parametrize(
    "text",
    [
        'title = "T"\n',
        'title = "T"\n[[sheet]]\nplace = ["lettering", "positions"]\n',
        'title = "T"\n[[sheet]]\nplace = ["lettering"]\n[[sheet]]\n',
    ],
)
def test_a_sheet_that_shows_one_does(tmp_path: Path, text: str) -> None:
    keys = {key for key, _ in faults(tmp_path, text)}
    assert keys == {"frame", "link", "drive"}
