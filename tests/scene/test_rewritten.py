"""Texts of scenes with sections that say something else: links come and go, names, ways of writing."""

from __future__ import annotations

import tomllib
from typing import Any

import pytest
from support import gallery
from support.each import each
from support.rewriting import comments, lines, text_of, with_links

from graphic_tmm.scene.moved import rewritten, uses
from graphic_tmm.scene.packaged import FILE
from graphic_tmm.scene.splice import Unplaced

FILES = [
    *(gallery.SHEETS / name / FILE for name in gallery.ALL),
    *sorted(gallery.CASES.rglob("*.toml")),
]


ROCKER = (gallery.SHEETS / "crank-rocker" / FILE).read_text("utf-8")


NAMED = (gallery.SHEETS / "windrower-published" / FILE).read_text("utf-8")


@each("file", FILES)
def test_what_says_the_same_stays_to_the_byte(file: Any) -> None:
    text = file.read_bytes().decode("utf-8")
    doc = tomllib.loads(text)
    assert rewritten(text, doc) == text
    assert rewritten(text, {}) == text


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


def test_what_cannot_be_followed_is_refused() -> None:
    text = "frame = { O = [0, 0] }\nlink = [{ number = 1 }, { number = 2 }]\n"
    with pytest.raises(Unplaced):
        rewritten(text, {"link": [{"number": 1}]})
