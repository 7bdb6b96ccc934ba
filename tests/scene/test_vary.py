"""A scene with other values: as if they stood in its file; refused as the file would be."""

from __future__ import annotations

import pickle
import tomllib

import pytest
from support.each import each
from support.gallery import SHEETS

import graphic_tmm as tmm
from graphic_tmm.scene.splice import set_to
from graphic_tmm.scene.vary import put

TEXT = (SHEETS / "engine" / "scene.toml").read_text(encoding="utf-8")
ENGINE = tmm.read("engine")


def like(scene: tmm.Scene, other: tmm.Scene) -> bool:
    told = [
        repr((one.title, one.mechanism, one.row, one.tasks, one.sheets)) for one in (scene, other)
    ]
    return told[0] == told[1]


@each(
    "key, path, value, written",
    [
        ("drive.speed", ("drive", "speed"), "600 rpm", '"600 rpm"'),
        ("l", ("lengths", "l"), "0.7 m", '"0.7 m"'),
        ("links.1.l", ("lengths", "l"), 0.7, "0.7"),
        ("link 2, mass", ("link", 1, "mass"), 4.5, "4.5"),
        ("links.2.mass", ("link", 1, "mass"), "4.5 kg", '"4.5 kg"'),
        ("sheet 1, format", ("sheet", 0, "format"), "A2", '"A2"'),
        ("title", ("title",), "Другой", '"Другой"'),
    ],
)
def test_a_value_is_as_if_it_stood_in_the_file(key, path, value, written) -> None:
    due = tmm.read(set_to(TEXT, path, written))
    assert like(ENGINE.with_({key: value}), due)
    assert not like(ENGINE, due)


def test_names_that_python_can_spell_are_keywords() -> None:
    assert like(ENGINE.with_(l="0.7 m", title="T"), ENGINE.with_({"l": 0.7, "title": "T"}))


def test_none_takes_out_and_sections_come_whole() -> None:
    assert "flywheel" in ENGINE.tasks
    bare = ENGINE.with_(flywheel=None, sheet=None, hand={"name": "cad"})
    assert "flywheel" not in bare.tasks
    assert (bare.hand, bare.ruler) == ("cad", 0.01)


def test_changes_follow_one_another_and_leave_the_first_as_it_was() -> None:
    before = repr(ENGINE)
    twice = ENGINE.with_(l=0.7).with_({"drive.speed": 60.0})
    assert like(twice, ENGINE.with_({"l": 0.7, "drive.speed": 60.0}))
    assert repr(ENGINE) == before


@each("source", [TEXT, tomllib.loads(TEXT), TEXT.encode()])
def test_scenes_that_no_file_holds_may_change_too(source) -> None:
    assert like(tmm.read(source).with_(l=0.7), ENGINE.with_(l=0.7))


def test_a_scene_goes_to_another_process_with_what_is_written() -> None:
    there = pickle.loads(pickle.dumps(ENGINE))
    assert like(there.with_(l=0.7), ENGINE.with_(l=0.7))


@each(
    "values, says",
    [
        ({"drive.sped": 3}, '^engine: drive.sped: .*did you mean "speed"'),
        ({"drive.speed": "3 kg"}, '^engine: drive.speed: "3 kg" is a mass'),
        ({"drive.speed": {1}}, "drive.speed: a scene cannot hold this .set."),
        ({"sheet[0]": 1}, "the scene has no such key"),
        ({"link 9, mass": 1}, '"link 9, mass" means nothing here'),
        ({"title.x.y": 1}, "the scene has no such key"),
        ({"nothing": None}, "the scene has no such key"),
        ({"l": 1, "links.1.l": 2}, "this is the same key as l; keep one"),
        ({"drive.speed": object(), "l": object()}, r"(?s)drive.speed.*\n.*l: a scene cannot"),
    ],
)
def test_what_cannot_be_is_refused_at_its_key(values, says) -> None:
    with pytest.raises(tmm.SceneError, match=says):
        ENGINE.with_(values)


def test_a_value_is_put_into_a_copy() -> None:
    doc = {"a": {"b": [1, 2]}}
    assert put(doc, ("a", "b", 1), 5) == {"a": {"b": [1, 5]}}
    assert put(doc, ("c", "d"), 5) == {**doc, "c": {"d": 5}}
    assert put(doc, ("a", "b"), None) == {"a": {}}
    assert doc == {"a": {"b": [1, 2]}}
    for path in (("a", "b", 2), ("a", "b", -1), ("a", "b", "c"), ("a", 1), ("a", "b", 0, "c")):
        with pytest.raises(LookupError):
            put(doc, path, 1)
    with pytest.raises(LookupError):
        put(doc, ("c", "d"), None)
