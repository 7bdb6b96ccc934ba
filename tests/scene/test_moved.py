"""Scenes whose text follows a moved mechanism: what says the same stays to the byte, no comment is lost."""

from __future__ import annotations

import re
import tomllib
from dataclasses import replace
from typing import Any

import pytest
from support import gallery
from support.dragged import movable, off
from support.each import each
from support.rewriting import comments, lines, text_of
from support.sketched import Standing, standing

import graphic_tmm
from graphic_tmm.errors import SceneError
from graphic_tmm.mechanism.sketch import built, lying, placed
from graphic_tmm.scene.link_tables import slides_of, tables_of
from graphic_tmm.scene.mechanism import Joints
from graphic_tmm.scene.moved import rewritten
from graphic_tmm.scene.packaged import FILE

ROCKER = (gallery.SHEETS / "crank-rocker" / FILE).read_text("utf-8")


BY_JOINTS = """title = "Slotting machine"
language = "en"
[frame]
O = [0, 0]
B = [0, "-305 mm"]
y = { through = [0, "335 mm"], angle = "0 deg" }
[joints]
A = ["70 mm", "85 mm"]
C = ["117.31 mm", "344.23 mm"]
D = ["-23 mm", "335 mm"]     # the tool
to = "1 mm"
near = "3 mm"
[[link]]
number = 1
points = ["O", "A"]
[[link]]
number = 2
points = ["A"]
slides = { on = 3, along = "BC" }
[[link]]
number = 3
points = ["B", "C"]
[[link]]
number = 4
points = ["C", "D"]
[[link]]
number = 5
points = ["D"]
slides = { on = "frame", along = "y" }
[drive]
link = 1
speed = "100 rpm"
zero = "joints"
"""


SPECIAL = ("parallel-cranks", "rolling-centrodes")
"""Lengths that have to be equal: with a joint moved it does not assemble."""


def others(text: str, letter: str) -> dict[str, Any]:
    """What a scene says but for lengths, and links that have a letter or slide with one that has."""
    doc = tomllib.loads(text)
    near = {one["number"] for one in doc["link"] if letter in one["points"]}
    on = {s["on"] for one in doc["link"] if one["number"] in near for s in slides_of(one)}
    near |= on - {"frame"}
    near |= {one["number"] for one in doc["link"] if {s["on"] for s in slides_of(one)} & near}
    frame = {k: z for k, z in doc["frame"].items() if k != letter}
    links = [one for one in doc["link"] if one["number"] not in near]
    return {k: x for k, x in doc.items() if k != "lengths"} | {"frame": frame, "link": links}


@each("name", gallery.NAMES)
def test_a_mechanism_that_was_not_moved_keeps_the_bytes_of_its_scene(name: str) -> None:
    text = text_of(name)
    for one in standing(name):
        own = built(one.drawn, degrees(one), one.mechanism).mechanism
        for hand in (Joints(), Joints(to=1e-3, near=1e-3)):
            assert rewritten(text, tables_of(own, hand, tomllib.loads(text))) == text


def degrees(one: Standing) -> float:
    drive = one.mechanism.drive
    return one.at if not drive.slides and not drive.rack else 0.0


@each("name", [name for name in gallery.NAMES if name not in SPECIAL], turns=20)
def test_a_joint_that_is_moved_stands_there_in_the_scene(name: str) -> None:
    """5 mm in the position drawn: to 1e-12 m, no comment lost; only links at the joint say anything new."""
    one, text = next(standing(name)), text_of(name)
    for letter, there in movable(one):
        drawn = placed(one.drawn, {letter: there})
        own = built(drawn, degrees(one), one.mechanism).mechanism
        new = rewritten(text, tables_of(own, doc=tomllib.loads(text)))
        assert comments(new) == comments(text)
        assert off(new, one, drawn, {**one.places, letter: there}) < 1e-12, letter
        assert len(new.splitlines()) == len(text.splitlines())
        assert others(text, letter) == others(new, letter)


@each("name", [name for name in gallery.NAMES if name not in SPECIAL], turns=20)
def test_a_hand_that_moves_a_joint_gives_whole_millimetres(name: str) -> None:
    one, text = next(standing(name)), text_of(name)
    for letter, there in movable(one):
        own = built(placed(one.drawn, {letter: there}), degrees(one), one.mechanism).mechanism
        new = rewritten(text, tables_of(own, Joints(to=1e-3, near=1e-3), tomllib.loads(text)))
        for line in lines(text, new):
            assert not re.search(r"\d\.\d{4,} mm", line), line


@each(
    "name, letter, changed",
    [
        ("oscillating-cylinder", "S3", ["points = { C"]),
        ("oscillating-cylinder", "C", ["C =", "points = { C"]),
        ("tipper", "G", ["G ="]),
        ("tangent-mechanism", "S5", ["points = { D"]),
    ],
)
def test_a_slider_and_its_guide_keep_their_own_axes(
    name: str, letter: str, changed: list[str]
) -> None:
    """No mass centre that is moved turns what slides; a guide that lies in its line is told as it was."""
    one, text = next(standing(name)), text_of(name)
    drawn = placed(one.drawn, {letter: dict(movable(one))[letter]})
    own = built(drawn, degrees(one), one.mechanism).mechanism
    new = lines(text, rewritten(text, tables_of(own, Joints(to=1e-3), tomllib.loads(text))))
    assert [line[: len(begin)] for line, begin in zip(new, changed, strict=True)] == changed


CYLINDER = """title = "A swinging cylinder"
language = "en"
[frame]
O = [0, 0]
C = ["160 mm", 0]
[joints]
A = ["24 mm", "32 mm"]
[[link]]
number = 1
points = ["O", "A"]
[[link]]
number = 2
points = ["A"]
slides = [{ on = 3, along = "z", side = "+", cylinder = "oil" }]
[[link]]
number = 3
points = ["C"]
guides = { z = { through = "C", angle = "166.75948008481282 deg" }, q = { through = ["100 mm", 0], angle = 5 } }
[drive]
link = 1
speed = "15 rad/s"
"""


def test_guides_of_a_link_by_joints_are_told_as_they_lie() -> None:
    scene, doc = graphic_tmm.read(CYLINDER), tomllib.loads(CYLINDER)
    assert scene.mechanism is not None
    places = {"O": 0j, "C": 0.16 + 0j, "A": 0.024 + 0.032j}
    drawn = lying(scene.mechanism, places)
    own = built(drawn, 0.0, scene.mechanism).mechanism
    assert rewritten(CYLINDER, tables_of(own, Joints(), doc, drawn)) == CYLINDER
    moved = placed(drawn, {"C": 0.2 + 0j})
    own = built(moved, 0.0, scene.mechanism).mechanism
    new = tomllib.loads(rewritten(CYLINDER, tables_of(own, Joints(), doc, moved)))
    assert new["frame"]["C"] == ["200 mm", 0]
    assert new["link"] == doc["link"]


def test_a_side_by_letters_that_are_no_more_goes_with_them() -> None:
    (one, *_) = standing("crank-rocker")
    text = ROCKER.replace("left of AC", "right of EC")
    own = built(one.drawn, degrees(one), one.mechanism).mechanism
    coupler = own.by_number[2]
    points = {letter: z for letter, z in coupler.points.items() if letter != "E"}
    links = tuple(
        replace(link, side=None, points=points) if link is coupler else link for link in own.links
    )
    new = rewritten(text, tables_of(replace(own, links=links), doc=tomllib.loads(text)))
    assert "side" not in tomllib.loads(new)["link"][1]
    assert comments(new) == comments(text)


WELDED = """title = "T"
language = "en"
[frame]
O = [0, 0]
x = { through = [0, "20 mm"], angle = 0 }
[[link]]
number = 1
points = { O = [0, 0], A = ["50 mm", 0] }
[[link]]
number = 2
points = { O = [0, 0], E = ["30 mm", 0] }
weld = { to = 1, angle = "120 deg" }
[[link]]
number = 3
points = { A = [0, 0], B = ["150 mm", 0] }
[[link]]
number = 4
points = { B = [0, 0] }
slides = { on = "frame", along = "x", side = "right" }
[drive]
link = 1
speed = "60 rpm"
"""


def test_a_body_that_others_are_welded_to_changes_and_so_do_its_arms() -> None:
    scene, doc = graphic_tmm.read(WELDED), tomllib.loads(WELDED)
    assert scene.mechanism is not None
    places = {
        letter: complex(z[0]) for (letter, _), z in graphic_tmm.motion(scene, [0.0]).places.items()
    }
    drawn = lying(scene.mechanism, places)
    own = built(placed(drawn, {"B": places["B"] + 0.01}), 0.0, scene.mechanism).mechanism
    new = rewritten(WELDED, tables_of(own, Joints(to=1e-3), doc))
    assert lines(WELDED, new) == ['points = { A = [0, 0], B = ["160 mm", 0] }']
    own = built(placed(drawn, {"E": places["E"] * 1.5j}), 0.0, scene.mechanism).mechanism
    new = rewritten(WELDED, tables_of(own, Joints(to=1e-3), doc))
    assert lines(WELDED, new) == [
        'points = { O = [0, 0], E = ["45 mm", 0] }',
        'weld = { to = 1, angle = "-150 deg" }',
    ]
    # an arm on which something slides is told in its own axes: nobody draws it otherwise
    railed = WELDED.replace(
        "weld = {", "guides = { z = { through = [0, 0], angle = 0 } }\nweld = {"
    )
    with pytest.raises(SceneError, match="link 1 has arms"):
        tables_of(own, doc=tomllib.loads(railed))


def test_a_scene_by_joints_has_its_joints_moved() -> None:
    text = BY_JOINTS
    scene = graphic_tmm.read(text)
    assert scene.mechanism is not None
    places = {
        "A": 0.07 + 0.085j,
        "C": 0.11731 + 0.34423j,
        "D": -0.023 + 0.335j,
        "O": 0j,
        "B": -0.305j,
    }
    drawn = lying(scene.mechanism, places)
    doc = tomllib.loads(text)
    same = tables_of(
        built(drawn, 50.0, scene.mechanism).mechanism, doc=doc, lies=placed(drawn, places)
    )
    assert rewritten(text, same) == text
    moved = placed(drawn, {**places, "D": -0.04 + 0.335j})
    own = built(moved, 50.0, scene.mechanism).mechanism
    new = rewritten(text, tables_of(own, Joints(to=1e-3), doc, moved))
    assert lines(text, new) == ['D = ["-40 mm", "335 mm"]     # the tool']
    assert graphic_tmm.read(new).mechanism is not None
