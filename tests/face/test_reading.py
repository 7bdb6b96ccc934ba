"""A scene is read from wherever it stands: the same scene, the same faults."""

from __future__ import annotations

import tomllib
from pathlib import Path

import numpy as np
import pytest
from support.each import each
from support.gallery import ALL, SHEETS

import graphic_tmm as tmm
from graphic_tmm.face.reading import refuse_unlettered

NAME = "crank-rocker"
FILE = SHEETS / NAME / "scene.toml"
TEXT = FILE.read_text(encoding="utf-8")
TABLES = tomllib.loads(TEXT)


def mechanism(scene: tmm.Scene) -> str:
    return repr((scene.title, scene.mechanism, scene.row, scene.tasks, scene.sheets))


@each("source", [NAME, FILE, str(FILE), FILE.parent, str(FILE.parent), TEXT, TEXT.encode(), TABLES])
def test_a_scene_is_the_same_wherever_it_stands(source) -> None:
    assert mechanism(tmm.read(source)) == mechanism(tmm.read(NAME))


def test_a_scene_is_its_own_and_the_default_one_is_that_of_the_commands() -> None:
    scene = tmm.read(NAME)
    assert tmm.read(scene) is scene
    assert tmm.read().title == tmm.read("windrower").title


@each("name", ALL)
def test_tables_are_read_as_the_file_is(name) -> None:
    tables = tomllib.loads((SHEETS / name / "scene.toml").read_text(encoding="utf-8"))
    assert mechanism(tmm.read(tables)) == mechanism(tmm.read(name))
    assert tmm.read(tables).told.keys() == tmm.read(name).told.keys()


def test_the_names_of_scenes_are_those_of_the_command() -> None:
    assert list(tmm.scenes()) == ALL


def test_tables_may_hold_tuples_and_numbers_of_numpy() -> None:
    tables = tomllib.loads(TEXT)
    tables["frame"] = {**tables["frame"], "O": (np.float64(0.0), np.int64(0))}
    assert mechanism(tmm.read(tables)) == mechanism(tmm.read(NAME))


def test_a_language_may_be_asked_for() -> None:
    assert tmm.read("engine", language="en").language == "en"
    assert tmm.read("engine").language == "ru"
    with pytest.raises(tmm.SceneError, match=r'"xx".*it is one of'):
        tmm.read("engine", language="xx")


@each(
    "source, says",
    [
        ("windrowr", 'windrowr: .*did you mean the scene "windrower"'),
        (Path("nowhere/scene.toml"), "there is no such file"),
        ("a\nb", "^scene:1: this is not TOML"),
        (b"\xff\n", "not in UTF-8"),
        ({**TABLES, "title": 3}, "^scene: title: the number 3 stands here"),
        ({**TABLES, "titel": "T"}, '^scene: titel: "titel" means nothing here; did you mean "title"'),
        ({**TABLES, "drive": {**TABLES["drive"], "speed": object()}}, r"drive.speed: a scene cannot hold this"),
        ({**TABLES, "title": "\ud800"}, "title: a scene cannot hold this"),
        ({**TABLES, "drive": {3: 4}}, "drive: the keys of a table are texts, not int"),
        (3.0, "not from this .float."),
    ],
)  # fmt: skip
def test_what_is_no_scene_is_refused_with_the_remedy(source, says) -> None:
    with pytest.raises(tmm.SceneError, match=says):
        tmm.read(source)


def test_endless_tables_are_refused() -> None:
    deep: dict[str, object] = {}
    deep["drive"] = deep
    with pytest.raises(tmm.SceneError, match="a scene cannot hold this"):
        tmm.read(deep)


def test_letters_that_no_sheet_can_hold_are_refused_before_it_is_drawn() -> None:
    scene = tmm.read(NAME).with_(title="漢")
    with pytest.raises(tmm.SceneError, match="title"):
        refuse_unlettered(scene)
    refuse_unlettered(tmm.read(NAME))
    with pytest.raises(tmm.SceneError, match="title"):
        _ = tmm.draw(scene).sheets
