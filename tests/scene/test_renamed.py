"""Letters and link numbers of scenes renamed: the same motion, no reference left, and back to the byte."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator
from itertools import pairwise
from typing import Any

import pytest
from support import declared_keys, gallery
from support.each import each

import graphic_tmm
from graphic_tmm.errors import SceneError
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Kind, Sort
from graphic_tmm.scene.packaged import FILE
from graphic_tmm.scene.renamed import exchanged, relettered, renumbered
from graphic_tmm.scene.tables import ByShape, Several

OTHER, NUMBER = "Q7", 77


def text_of(name: str) -> str:
    return (gallery.SHEETS / name / FILE).read_bytes().decode("utf-8")


def places(text: str, renamed: dict[str, str]) -> dict[tuple[str, int], complex]:
    """Where letters stand in one position, by letters as they were and the places of links in the file."""
    scene = graphic_tmm.read(text)
    mechanism = scene.mechanism
    assert mechanism is not None
    order = [link.number for link in (mechanism.frame, *mechanism.drawn)]
    low = (
        mechanism.drive.start if not mechanism.drive.slides else (scene.row.reach or (0.0, 0.0))[0]
    )
    found = graphic_tmm.motion(scene, [low], plans=("positions",)).places
    return {
        (renamed.get(letter, letter), order.index(number)): complex(z[0])
        for (letter, number), z in found.items()
    }


@each("name", gallery.NAMES, turns=20)
def test_a_letter_is_renamed_wherever_it_stands(name: str) -> None:
    """A reference that were left would be a fault of the scene; of the motion nothing changes."""
    text = text_of(name)
    doc = tomllib.loads(text)
    points = {letter for one in doc["link"] for letter in one["points"]}
    was = places(text, {})
    for letter in sorted(points | doc["frame"].keys() - {"number"}):
        new = relettered(text, letter, OTHER)
        assert relettered(new, OTHER, letter) == text
        assert places(new, {OTHER: letter}) == pytest.approx(was, nan_ok=True)
        assert re.findall("#[^\n]*", new) == re.findall("#[^\n]*", text)


@each("name", gallery.NAMES, turns=20)
def test_a_link_is_renumbered_wherever_it_stands(name: str) -> None:
    text = text_of(name)
    was = places(text, {})
    for one in tomllib.loads(text)["link"]:
        new = renumbered(text, one["number"], NUMBER)
        assert renumbered(new, NUMBER, one["number"]) == text
        assert places(new, {}) == pytest.approx(was, nan_ok=True)


@each("name", gallery.NAMES, turns=20)
def test_two_letters_are_exchanged_wherever_they_stand(name: str) -> None:
    text = text_of(name)
    was = places(text, {})
    points = sorted({letter for one in tomllib.loads(text)["link"] for letter in one["points"]})
    for one, other in pairwise(points):
        new = exchanged(text, one, other)
        assert new != text
        assert exchanged(new, other, one) == text
        assert places(new, {one: other, other: one}) == pytest.approx(was, nan_ok=True)


def test_what_stands_in_the_text_alone_gets_the_other_name() -> None:
    text = text_of("crank-rocker")
    assert exchanged(text, "K", "A") == exchanged(text, "A", "K") == relettered(text, "A", "K")
    assert exchanged(text, 9, 2) == exchanged(text, 2, 9) == renumbered(text, 2, 9)
    assert exchanged(text, "K", "L") == exchanged(text, 8, 9) == text


def kinds(sort: Sort) -> Iterator[Kind]:
    if isinstance(sort, Kind):
        yield sort
    elif isinstance(sort, Several):
        yield from kinds(sort.each)
    elif isinstance(sort, ByShape):
        yield from (*kinds(sort.such), *kinds(sort.other))


def test_every_key_that_speaks_of_letters_or_numbers_of_links_can_be_renamed() -> None:
    """A new section whose letters were declared as any text would be left behind."""
    speaks = re.compile(r"\bletters?\b|the number of the (\w+ )?link|links of its ends")
    found = {
        name: [kind for kind in kinds(one.kind) if kind.told != v.SWITCH.told]
        for name, one in declared_keys.ALL
        if speaks.search(one.says)
    }
    assert {"load.point", "load.from_point", "link.centre", "drive.link"} <= found.keys()
    assert not [name for name, some in found.items() if any(one.renamed is None for one in some)]


FORMS = """title = "B in a title"   # B
[frame]
B = [0, 0]
[frame.B1]  # a guide: B1
through = [0, 0]
angle = 0
[lengths]
AB = 0.1
[[link]]
number = 1
"points".'A' = [0, 0]
points."B" = ['AB', 0]
[[link]]
number = 2
points = ["A", 'C']
slides = [{ on = 1, along = 'AB' }, { on = "frame", along = "B1" }]
side = 'слева от AB'
[joints]
A = ["AB", 0]
C = [0, 0]
[[load]]
link = 1
point = 'B'
direction = "30 deg to AB"   # along AB
"""


def test_each_way_of_writing_a_letter_is_followed_in_its_own_form() -> None:
    expected = (
        FORMS.replace("\nB = [0, 0]", "\nD = [0, 0]")
        .replace('points."B"', "points.D")
        .replace("along = 'AB'", "along = 'AD'")
        .replace("'слева от AB'", "'слева от AD'")
        .replace("point = 'B'", "point = 'D'")
        .replace('"30 deg to AB"', '"30 deg to AD"')
    )
    assert relettered(FORMS, "B", "D") == expected
    guide = FORMS.replace("[frame.B1]", "[frame.y]").replace('along = "B1"', 'along = "y"')
    assert relettered(FORMS, "B1", "y") == guide
    joint = (
        FORMS.replace("'A' =", "E =")
        .replace('["A", ', '["E", ')
        .replace("'AB' }", "'EB' }")
        .replace("от AB", "от EB")
        .replace('\nA = ["AB"', '\nE = ["AB"')
        .replace('to AB"', 'to EB"')
    )
    assert relettered(FORMS, "A", "E") == joint
    crlf = "\ufeff" + FORMS.replace("\n", "\r\n")
    assert relettered(crlf, "B", "D") == "\ufeff" + expected.replace("\n", "\r\n")


def test_link_numbers_are_followed_where_links_are_named() -> None:
    assert renumbered(FORMS, 1, 4) == (
        FORMS.replace("number = 1", "number = 4")
        .replace("on = 1", "on = 4")
        .replace("link = 1", "link = 4")
    )


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("Z", "D", '"Z" is not a letter of the mechanism'),
        ("B", "A", "stands for something else already"),
        ("B", "a", "would both be"),
        ("B", "B1", "stands for something else already"),
        ("B", "P", "kept for the pole"),
        ("B", "BB", "is not a letter"),
        ("B", "А", "looks like"),
    ],
)
def test_letters_that_cannot_be_are_refused(old: str, new: str, says: str) -> None:
    with pytest.raises(SceneError, match=says):
        relettered(FORMS, old, new)


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        (7, 8, "no link 7"),
        (1, 2, "number of another link"),
        (1, 0, "number of the frame"),
        (1, -3, "whole number"),
    ],
)
def test_numbers_that_cannot_be_are_refused(old: int, new: int, says: str) -> None:
    with pytest.raises(SceneError, match=says):
        renumbered(FORMS, old, new)


def test_a_name_that_stays_changes_nothing() -> None:
    told: Any = (relettered(FORMS, "B", "B"), renumbered(FORMS, 1, 1))
    assert told == (FORMS, FORMS)
