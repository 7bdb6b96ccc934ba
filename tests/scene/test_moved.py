"""Scenes whose text follows a moved mechanism: what says the same stays to the byte, no comment is lost."""

from __future__ import annotations

import copy
import difflib
import re
import tomllib
from dataclasses import replace
from typing import Any

import pytest
from support import gallery
from support.dragged import movable, off
from support.each import each
from support.sketched import Standing, standing

import graphic_tmm
from graphic_tmm.errors import SceneError
from graphic_tmm.mechanism.sketch import built, lying, placed
from graphic_tmm.scene.link_tables import slides_of, tables_of
from graphic_tmm.scene.mechanism import Joints
from graphic_tmm.scene.moved import rewritten, uses
from graphic_tmm.scene.packaged import FILE
from graphic_tmm.scene.splice import Unplaced

FILES = [
    *(gallery.SHEETS / name / FILE for name in gallery.ALL),
    *sorted(gallery.CASES.rglob("*.toml")),
]
ROCKER = (gallery.SHEETS / "crank-rocker" / FILE).read_text("utf-8")
NAMED = (gallery.SHEETS / "windrower-published" / FILE).read_text("utf-8")
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
SPECIAL = ("parallel-cranks",)
"""Lengths that have to be equal: with a joint moved it does not assemble."""


def text_of(name: str) -> str:
    return (gallery.SHEETS / name / FILE).read_bytes().decode("utf-8")


def comments(text: str) -> list[str]:
    return re.findall(r"#[^\n]*", text)


def lines(old: str, new: str) -> list[str]:
    """The lines of a text that differ, as they are now."""
    return [
        line[2:] for line in difflib.ndiff(old.splitlines(), new.splitlines()) if line[:2] == "+ "
    ]


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


def with_links(text: str, **links: dict[str, Any] | None) -> dict[str, Any]:
    """The links of a scene, some with other keys, by "_" and number; None: without the link."""
    told = copy.deepcopy(tomllib.loads(text)["link"])
    kept = [one for one in told if links.get(f"_{one['number']}", {}) is not None]
    return {"link": [one | (links.get(f"_{one['number']}") or {}) for one in kept]}


@each("file", FILES)
def test_what_says_the_same_stays_to_the_byte(file: Any) -> None:
    text = file.read_bytes().decode("utf-8")
    doc = tomllib.loads(text)
    assert rewritten(text, doc) == text
    assert rewritten(text, {}) == text


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


@each("name", [name for name in gallery.NAMES if name not in SPECIAL])
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


@each("name", [name for name in gallery.NAMES if name not in SPECIAL])
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


def test_a_link_that_is_no_more_goes_with_its_comments_and_no_others() -> None:
    text = ROCKER.replace(
        "[[link]]\nnumber = 2", "# the coupler:\n# a plate\n[[link]]\nnumber = 2"
    ).replace('side   = "left of AC" ', '# nothing\nside   = "left of AC" ')
    text = text.replace("[[link]]\nnumber = 3", "# of all links\n\n[[link]]\nnumber = 3")
    new = rewritten(text, with_links(text, _2=None))
    gone = text[text.index("# the coupler:") : text.index("# of all links")]
    assert "# nothing" in gone
    assert new == text.replace(gone, "")
    assert rewritten(text, with_links(text, _3=None)).count("[[link]]") == 2
    none = rewritten(text, {"link": []})
    assert "link" not in tomllib.loads(none)
    assert none.startswith(ROCKER[: ROCKER.index("[[link]]")])


def test_a_new_link_stands_behind_the_last_laid_out_as_scenes_are() -> None:
    fresh = {
        "number": 4,
        "points": {"B": [0, 0], "D": ["31 mm", 0]},
        "slides": {"on": "frame", "along": "y"},
    }
    new = rewritten(ROCKER, {"link": [*tomllib.loads(ROCKER)["link"], fresh]})
    block = (
        "\n[[link]]\n"
        "number = 4\n"
        'points = { B = [0, 0], D = ["31 mm", 0] }\n'
        'slides = { on = "frame", along = "y" }\n'
    )
    at = ROCKER.index("\n[drive]")
    assert new == ROCKER[:at] + block + ROCKER[at:]
    back = rewritten(new, {"link": tomllib.loads(ROCKER)["link"]})
    assert back == ROCKER


HEAD = 'title = "x"\nlanguage = "en"\n'
BEGUN = """
[frame]
number = 6
O = [0, 0]

[[link]]
number = 1
points = { O = [0, 0], A = ["70 mm", 0] }

[[link]]
number = 2
points = { A = [0, 0], B = ["0.2 m", 0] }
mass   = 0.1
J      = 1e-06
side   = "left of AO"

[drive]
link  = 1
speed = "90 rpm"
"""


def test_a_new_scene_is_laid_out_as_scenes_are() -> None:
    assert rewritten(HEAD, tomllib.loads(BEGUN)) == HEAD + BEGUN
    assert rewritten(HEAD.rstrip(), tomllib.loads(BEGUN)) == HEAD + BEGUN


def test_links_come_behind_the_frame_and_sections_before_the_next() -> None:
    at = BEGUN.index("[drive]")
    frame, rest = BEGUN[:at], BEGUN[at:]
    told = tomllib.loads(frame)
    assert rewritten(HEAD + "\n" + rest, told) == HEAD + frame + rest
    ragged = rest.replace("link  =", "link =")
    assert "\nmass = 0.1\n" in rewritten(HEAD + "\n" + ragged, told)


@pytest.mark.parametrize("newline", ["\n", "\r\n"])
@pytest.mark.parametrize("mark", ["", "\ufeff"])
def test_line_ends_and_the_mark_of_the_file_stay(newline: str, mark: str) -> None:
    text = mark + ROCKER.replace("\n", newline)
    fresh = {"number": 4, "points": {"B": [0, 0]}}
    tables = with_links(ROCKER, _1={"points": {"O": [0, 0], "A": ["21 mm", 0]}})
    new = rewritten(text, {"link": [*tables["link"], fresh]})
    assert new.startswith(mark + "# A film-feed")
    assert new.count("\n") == new.count(newline)
    assert new.count('A = ["21 mm", 0]') == 1
    assert rewritten(new, {"link": tomllib.loads(ROCKER)["link"]}) == text


@pytest.mark.parametrize(
    ("old", "new"),
    [
        (
            'points = { O = [0, 0], A = ["20 mm", 0] }',
            'points = { O = [0, 0], A = ["21.5 mm", 0] }',
        ),
        ("points.O = [0, 0]\npoints.A = [0.02, 0]", "points.O = [0, 0]\npoints.A = [0.0215, 0]"),
        (
            "points = { O = [0, 0], A = ['2,0 cm', 0] }",
            'points = { O = [0, 0], A = ["2,15 cm", 0] }',
        ),
        (
            '[link.points]  # of it\nO = [0, 0]\nA = [\n  "20mm",  # far\n  0,\n]',
            '[link.points]  # of it\nO = [0, 0]\nA = [\n  "21.5mm",  # far\n  0,\n]',
        ),
    ],
)
def test_points_are_changed_in_the_form_and_unit_that_they_have(old: str, new: str) -> None:
    line = 'points = { O = [0, 0], A = ["20 mm", 0] }'
    text = ROCKER.replace(line, old)
    told = with_links(ROCKER, _1={"points": {"O": [0, 0], "A": ["21.5 mm", 0]}})
    assert rewritten(text, told) == ROCKER.replace(line, new)
    assert rewritten(text, with_links(ROCKER)) == text


def test_letters_and_keys_come_and_go_in_the_tables_that_are_there() -> None:
    told = with_links(
        ROCKER,
        _1={"points": {"O": [0, 0], "A": ["20 mm", 0], "K": ["5 mm", "3 mm"]}, "mass": "1 kg"},
        _3={"points": {"B": ["45 mm", 0], "C": [0, 0]}, "side": "left of AC"},
    )
    for one in told["link"]:
        if one["number"] == 3:
            del one["centre"]
    new = rewritten(ROCKER, told)
    assert tomllib.loads(new)["link"] == told["link"]
    assert 'A = ["20 mm", 0], K = ["5 mm", "3 mm"] }\nmass   = "1 kg"\n' in new
    assert comments(new) == comments(ROCKER)


@pytest.mark.parametrize(
    "slides",
    [
        'slides = { on = "frame", along = "y" }   # on y\n',
        'slides.on = "frame"   # on y\nslides.along = "y"\n',
        '# its guide\n[link.slides]\non = "frame"   # on y\nalong = "y"\n',
        '[[link.slides]]\non = "frame"   # on y\nalong = "y"\n\n[[link.slides]]\non = 1\nalong = "OA"\n',
    ],
)
def test_a_table_that_is_no_more_goes_from_every_form(slides: str) -> None:
    at = ROCKER.index("\n[drive]")
    text = f"{ROCKER[:at]}{slides}{ROCKER[at:]}"
    new = rewritten(text, {"link": tomllib.loads(ROCKER)["link"]})
    assert new.replace("# on y\n", "") == ROCKER
    assert rewritten(text, tomllib.loads(text)) == text


def test_dotted_keys_may_all_be_others() -> None:
    dotted = 'points.O = [0, 0]   # there\npoints.A = ["20 mm", 0]'
    text = ROCKER.replace('points = { O = [0, 0], A = ["20 mm", 0] }', dotted)
    told = with_links(ROCKER, _1={"points": {"K": [0, 0], "L": ["20 mm", 0]}})
    new = rewritten(text, told)
    assert tomllib.loads(new)["link"] == told["link"]
    assert comments(new) == comments(text)


def test_what_is_left_out_and_means_nothing_else_is_not_written() -> None:
    """A default that is written stays; one that is not stays unwritten."""
    told = with_links(ROCKER, _1={"passive": False, "slides": []})
    told["frame"] = tomllib.loads(ROCKER)["frame"] | {"number": 0}
    assert rewritten(ROCKER, told) == ROCKER
    text = ROCKER.replace("[frame]", "[frame]\nnumber = 0")
    assert rewritten(text, {"frame": tomllib.loads(ROCKER)["frame"]}) == text


def test_a_name_that_stands_in_several_places_changes_here_alone_or_everywhere() -> None:
    path = ("link", 2, "points", "C", 0)
    places = uses(NAMED, path)
    assert path in places
    assert ("frame", "y", "through", 1) in places
    assert len(places) == 4
    assert uses(NAMED, ("lengths", "BC")) == places
    assert uses(NAMED, ("frame", "y", "through", 1)) == ()
    assert uses(NAMED, ("link", 2, "mass")) == ()
    points = {"B": [0, 0], "C": ["-200 mm", 0], "S3": ["-BC", 0]}
    told = with_links(NAMED, _3={"points": points})
    here = rewritten(NAMED, told)
    assert lines(NAMED, here) == [
        'points = { B = [0, 0], C = ["-200 mm", 0], S3 = ["-BC", 0] }     # its x axis points from C up to B'
    ]
    assert lines(NAMED, rewritten(NAMED, told, everywhere=True)) == ['BC = "200 mm"']
    points["S3"] = ["-150 mm", 0]
    both = rewritten(NAMED, with_links(NAMED, _3={"points": points}), everywhere=True)
    assert [line[:70] for line in lines(NAMED, both)] == [
        'BC = "200 mm"',
        'points = { B = [0, 0], C = ["-BC", 0], S3 = ["-150 mm", 0] }     # its',
    ]


def test_a_name_that_stands_once_is_the_place_of_its_length() -> None:
    text = ROCKER.replace('A = ["20 mm", 0] }', 'A = ["2 r", 0] }').replace(
        "[frame]", "[lengths]\nr = 0.01    # half\n\n[frame]"
    )
    told = with_links(text, _1={"points": {"O": [0, 0], "A": ["26 mm", 0]}})
    assert lines(text, rewritten(text, told)) == ["r = 0.013    # half"]


def test_a_length_that_a_task_gives_changes_here_alone() -> None:
    text = text_of("windrower")
    told = with_links(text, _1={"points": {"O": [0, 0], "A": ["120 mm", 0], "S1": ["0.5 OA", 0]}})
    assert 'A = ["120 mm", 0]' in rewritten(text, told)
    with pytest.raises(Unplaced):
        rewritten(text, told, everywhere=True)


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


def test_a_body_that_others_are_welded_to_is_kept_and_its_change_refused() -> None:
    scene, doc = graphic_tmm.read(WELDED), tomllib.loads(WELDED)
    assert scene.mechanism is not None
    places = {
        letter: complex(z[0]) for (letter, _), z in graphic_tmm.motion(scene, [0.0]).places.items()
    }
    drawn = lying(scene.mechanism, places)
    own = built(placed(drawn, {"B": places["B"] + 0.01}), 0.0, scene.mechanism).mechanism
    new = rewritten(WELDED, tables_of(own, Joints(to=1e-3), doc))
    assert lines(WELDED, new) == ['points = { A = [0, 0], B = ["160 mm", 0] }']
    own = built(placed(drawn, {"E": places["E"] + 0.01}), 0.0, scene.mechanism).mechanism
    with pytest.raises(SceneError, match="link 1 has arms"):
        tables_of(own, doc=doc)


def test_what_cannot_be_followed_is_refused() -> None:
    text = "frame = { O = [0, 0] }\nlink = [{ number = 1 }, { number = 2 }]\n"
    with pytest.raises(Unplaced):
        rewritten(text, {"link": [{"number": 1}]})


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
