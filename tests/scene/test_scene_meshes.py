"""What wheels on links cannot be: each told with its key and a remedy."""

from __future__ import annotations

from pathlib import Path

import pytest

from graphic_tmm.errors import SceneError, StructureError
from graphic_tmm.mechanism.structure import dissect
from graphic_tmm.scene.read import read

SCENE = """
title = "T"
language = "en"
[frame]
O = [0, 0]
D = ["120 mm", 0]
[[link]]
number = 1
points = { O = [0, 0], A = ["40 mm", 0] }
[[link]]
number = 2
points = { A = [0, 0], B = ["110 mm", 0] }
[[link]]
number = 3
points = { B = [0, 0], C = ["100 mm", 0] }
side = "left of AC"
[[link]]
number = 4
points = { D = [0, 0], C = ["45 mm", 0] }
[[mesh]]
links = [1, 4]
centres = ["O", "D"]
teeth = [40, 20]
phase = "60 deg"
[drive]
link = 1
speed = "60 rpm"
"""


def scene_with(tmp_path: Path, *changes: tuple[str, str]) -> Path:
    text = SCENE
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    (tmp_path / "scene.toml").write_text(text, encoding="utf-8")
    return tmp_path / "scene.toml"


def test_wheels_are_understood(tmp_path: Path) -> None:
    mechanism = read(scene_with(tmp_path)).mechanism
    assert mechanism is not None
    (mesh,) = mechanism.meshes
    assert (mesh.links, mesh.centres, mesh.sizes) == ((1, 4), ("O", "D"), (40.0, 20.0))
    assert (mesh.toothed, mesh.internal, mesh.start, mesh.pressure) == (True, False, 60.0, 20.0)


@pytest.mark.parametrize("internal", [False, True])
def test_radii_come_to_the_distance_of_the_centres(tmp_path: Path, internal: bool) -> None:
    radii = '["240 mm", "120 mm"]' if internal else '["80 mm", "40 mm"]'
    told = f"radii = {radii}\ninternal = {str(internal).lower()}"
    mechanism = read(scene_with(tmp_path, ("teeth = [40, 20]", told))).mechanism
    assert mechanism is not None
    (mesh,) = mechanism.meshes
    first, second = mesh.reaches(0.12)
    assert first == pytest.approx(0.24 if internal else 0.08)
    assert second == pytest.approx(-0.12 if internal else 0.04)


WRONG = {
    "one link": (("links = [1, 4]", "links = [1]"), "links", "two different ones"),
    "the same link twice": (("links = [1, 4]", "links = [4, 4]"), "links", "two different ones"),
    "one letter": (('["O", "D"]', '["O", "O"]'), "centres", "two different ones"),
    "nothing of its size": (("teeth = [40, 20]", ""), "teeth", "teeth = [20, 40]"),
    "one number": (("teeth = [40, 20]", "teeth = [40]"), "teeth", "two numbers"),
    "no such link": (("links = [1, 4]", "links = [1, 7]"), "links", "there is no link 7"),
    "a letter of another": (('["O", "D"]', '["O", "B"]'), "centres", "not a letter of link 4"),
    "no rigid distance": (
        ('["O", "D"]', '["A", "C"]'),
        "centres",
        "no link besides 1, 4 has both A and C",
    ),
    "radii that do not meet": (
        ("teeth = [40, 20]", 'radii = ["80 mm", "50 mm"]'),
        "radii",
        "120 mm apart, but the radii come to 130 mm (their sum)",
    ),
    "radii inside that do not": (
        ("teeth = [40, 20]", 'radii = ["200 mm", "90 mm"]\ninternal = true'),
        "radii",
        "come to 110 mm (their difference)",
    ),
    "a ring as large as its wheel": (
        ("teeth = [40, 20]", "teeth = [40, 40]\ninternal = true"),
        "teeth",
        "larger than the one in it",
    ),
    "teeth of a belt": (
        ("teeth = [40, 20]", 'teeth = [40, 20]\nby = "chain"'),
        "teeth",
        "a sprocket with z teeth for a chain of the pitch t has z·t/2π",
    ),
    "pulleys that meet": (
        ("teeth = [40, 20]", 'radii = ["80 mm", "50 mm"]\nby = "belt"'),
        "radii",
        "120 mm apart, but the radii come to 130 mm: wheels that a belt",
    ),
    "a belt inside": (
        ("teeth = [40, 20]", 'radii = ["20 mm", "50 mm"]\nby = "belt"\ninternal = true'),
        "internal",
        "internal is said of teeth",
    ),
    "a belt of no kind": (
        ("teeth = [40, 20]", 'radii = ["20 mm", "50 mm"]\nby = "rope"'),
        "by",
        '"teeth", "belt", "crossed belt", "chain"',
    ),
    "another link as well": (
        ("points = { D = [0, 0], C", "passive = true\npoints = { D = [0, 0], C"),
        "links",
        "link 4 is passive",
    ),
}


@pytest.mark.parametrize("case", WRONG)
def test_what_wheels_cannot_be(tmp_path: Path, case: str) -> None:
    change, key, words = WRONG[case]
    with pytest.raises(SceneError) as error:
        read(scene_with(tmp_path, change))
    faults = [str(fault) for fault in error.value.faults]
    assert any(words in fault and key in fault for fault in faults), faults


def test_a_link_that_bears_too_many_pairs_is_told_with_the_mobility(tmp_path: Path) -> None:
    more = '[[mesh]]\nlinks = [1, 4]\ncentres = ["O", "D"]\nteeth = [30, 30]\n[drive]'
    mechanism = read(scene_with(tmp_path, ("[drive]", more))).mechanism
    assert mechanism is not None
    with pytest.raises(StructureError, match=r"W = 3·4 − 2·5 − 2 = 0"):
        dissect(mechanism)
