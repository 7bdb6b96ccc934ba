"""What a passive link cannot be, have or carry: each told with its key."""

from __future__ import annotations

from pathlib import Path

import pytest

from graphic_tmm.errors import SceneError
from graphic_tmm.scene.read import read

SCENE = """
title = "T"
language = "en"
[frame]
O = [0, 0]
D = [0.75, 0]
E = [1.5, 0]
y = { through = [0, 0], angle = "90 deg" }
[[link]]
number = 1
points = { O = [0, 0], A = [0.3, 0] }
[[link]]
number = 2
points = { A = [0, 0], B = [0.75, 0], C = [1.5, 0] }
[[link]]
number = 3
points = { D = [0, 0], B = [0.3, 0] }
side = "left of AD"
flips_at = ["0 deg", "180 deg"]
[[link]]
number = 4
passive = true
points = { E = [0, 0], C = [0.3, 0] }
[drive]
link = 1
speed = "60 rpm"
"""
HELD = "points = { E = [0, 0], C = [0.3, 0] }"


def told(folder: Path, *changes: tuple[str, str], more: str = "") -> list[str]:
    """Return the faults of the scene, with so much changed in it."""
    text = SCENE
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    path = folder / "scene.toml"
    path.write_text(text + more, encoding="utf-8")
    try:
        read(path)
    except SceneError as error:
        return [f"{one.key}: {one.message}" for one in error.faults]
    return []


def test_one_that_is_held_is_taken(tmp_path: Path) -> None:
    assert told(tmp_path) == []
    scene = read(tmp_path / "scene.toml")
    assert scene.mechanism is not None
    assert [link.number for link in scene.mechanism.links] == [1, 2, 3]
    assert [link.number for link in scene.mechanism.passive] == [4]


@pytest.mark.parametrize(
    ("changes", "key", "says"),
    [
        ([(HELD, HELD + "\nmass = 2")], "link 4, mass", "carries no forces"),
        ([(HELD, HELD + "\nJ = 2")], "link 4, J", "leave J out"),
        ([(HELD, HELD + '\nside = "left of AD"')], "link 4, side", "tells where it lies"),
        ([(HELD, "points = { C = [0, 0], F = [0.3, 0] }")], "link 4, points", "shares C with"),
        ([(HELD, "points = { C = [0, 0], B = [0.75, 0] }")], "link 4, points", "stand on link 2"),
        (
            [(HELD, HELD + '\nslides = { on = "frame", along = "y" }')],
            "link 4, slides",
            "two letters of other links, or by a letter",
        ),
        ([("[drive]\nlink = 1", "[drive]\nlink = 4")], "drive.link", "cannot drive"),
        (
            [("points = { D = [0, 0], B", 'slides = { on = 4, along = "EC" }\npoints = { D = [0, 0], B')],
            "link 3, slides",
            "held by a passive link",
        ),
    ],
)  # fmt: skip
def test_what_it_cannot_have_is_refused(
    tmp_path: Path, changes: list[tuple[str, str]], key: str, says: str
) -> None:
    (fault,) = told(tmp_path, *changes)
    assert fault.startswith(key)
    assert says in fault


def test_no_load_stands_on_it(tmp_path: Path) -> None:
    more = '[[load]]\nlink = 4\npoint = "C"\nforce = 10\n[forces]\n'
    (fault,) = told(tmp_path, more=more)
    assert "load 1, link" in fault
    assert "link 4 is passive and carries no forces" in fault
    more = "[[load]]\nlink = 2\nfrom = 4\nmoment = 10\n[forces]\n"
    (fault,) = told(tmp_path, more=more)
    assert "load 1, from" in fault


def test_no_spring_is_held_by_it(tmp_path: Path) -> None:
    spring = '[[spring]]\nbetween = ["K", "A"]\nrate = "2 kN/m"\nfree = 0.1\n[forces]\n'
    (fault,) = told(tmp_path, (HELD, HELD[:-1] + ", K = [0.1, 0.1] }"), more=spring)
    assert '"K" stands on a passive link alone' in fault
    assert not told(tmp_path, more=spring.replace('"K"', '"E"'))


def test_a_pin_of_its_own_alone_has_no_friction(tmp_path: Path) -> None:
    more = "[friction]\nf = 0.1\nradius = 0.01\npairs = { C = 0.2 }\n[effects]\nfriction = true\n[forces]\n"
    (fault,) = told(tmp_path, more=more)
    assert fault.startswith("friction.pairs.C")
