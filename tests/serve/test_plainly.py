"""In the studio a fault is told by what its forms call things: nobody has to have seen the file."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from support import wrong_scenes
from support.refusals import SCENE
from support.served import SMALL

from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.scene.declare import keys_of
from graphic_tmm.scene.read import judged
from graphic_tmm.scene.sections import declared
from graphic_tmm.serve.jobs import Refused, Task, formed, schemed
from graphic_tmm.serve.plainly import fault_text, place_words, plainly
from graphic_tmm.serve.scheme.act import SchemeAct, scheme

EN = speaking("en")
PLACES = [
    ("link 2, points.A", "point A of link 2", "точка A звена 2"),
    ("link 2, mass", "link 2: its mass", "звено 2: его масса"),
    ("frame.O", "point O of the frame", "точка O стойки"),
    ("frame.y.through.1", "guide y of the frame", "направляющая y стойки"),
    ("lengths.OA", "length OA", "длина OA"),
    (
        "drive.speed",
        "the driving link and its motion: its angular speed",
        "ведущее звено и его движение: его угловая скорость",
    ),
    ("load 1, force", "forces and moments on links, 1: its size", "силы и моменты на звеньях, 1: её величина"),
    ("plans.trajectories[1]", "What is drawn: points whose paths are drawn", ""),
    ("drive.sped", "", ""),
    ("nothing", "", ""),
    ("", "", ""),
]  # fmt: skip


@pytest.mark.parametrize(("key", "english", "russian"), PLACES)
def test_a_place_is_told_in_words(key: str, english: str, russian: str) -> None:
    assert place_words(key, EN) == english
    assert not russian or place_words(key, speaking("ru")) == russian


MESSAGES = [
    (
        'nothing says how large it is; write force = "190 N", moment, by_position or by_angle',
        "load 1, force",
        "nothing says how large it is; write “its size”: 190 N, moment, “its size in each position” or "
        "“its size by the turn of the crank from the zero position”",
    ),
    (
        "load: nothing is computed of [[load]] without a section [forces]; add it, or take [[load]] out",
        "",
        "forces and moments on links: nothing is computed of “forces and moments on links” without a section "
        "“kinetostatics and the lever”; add it, or take “forces and moments on links” out",
    ),
    (
        'write zero = { point = "D", at = "left" }',
        "drive.extra",
        "write “the zero position”: “the letter of the point”: D; “where it is then”: left",
    ),
    ("drive.turns is wanted", "", "the driving link and its motion: which way it turns is wanted"),
    ('this is not TOML; write speed = "fast"', "", 'this is not TOML; write speed = "fast"'),
    ('"sped" means nothing here; write speed = 1', "drive.sped", '"sped" means nothing here; write speed = 1'),
    ("OA and mu_l both fix the same scale", "scales.OA", "OA and mu_l both fix the same scale"),
]  # fmt: skip


@pytest.mark.parametrize(("says", "key", "plain"), MESSAGES)
def test_a_remedy_names_what_forms_have(says: str, key: str, plain: str) -> None:
    assert plainly(says, EN, key) == plain


def faults() -> Iterator[Fault]:
    """What scenes are refused for that are wrong in one thing."""
    rows = [one for each in vars(wrong_scenes).values() if isinstance(each, list) for one in each]
    for before, after, *_ in rows:
        try:
            judged(SCENE.replace(before, after, 1).encode(), Path("scene.toml"))
        except SceneError as error:
            yield from error.faults


SECTIONS = "|".join(declared())
KEYS = "|".join(
    name
    for one in declared().values()
    for name, key in keys_of(one.record).items()
    if re.search(r"[^\W\d_]{4}", key.says.partition(";")[0])
)
OF_A_FILE = re.compile(rf"\[({SECTIONS})\]|\b({SECTIONS})\.({KEYS})\b|\b({KEYS}) = ")


@pytest.mark.parametrize("language", ["en", "ru"])
def test_no_fault_of_a_form_speaks_of_keys(language: str) -> None:
    speech, seen, changed = speaking(language), 0, 0
    for fault in faults():
        if not place_words(fault.key, speech) or "TOML" in fault.message or "[" in fault.message:
            continue
        seen += 1
        says = fault_text(fault, speech)
        changed += bool(OF_A_FILE.search(speech(fault.message)))
        assert not OF_A_FILE.search(says), says
    assert seen > 60
    assert changed > 3


def refused(text: str, asked: SchemeAct) -> Any:
    found = schemed(Task(text.encode(), "scene.toml", None, "en"), asked)
    assert isinstance(found, Refused)
    return found.faults


def test_a_refusal_of_the_editor_says_where_it_is() -> None:
    (fault,) = refused(SMALL, SchemeAct(section="load", typed={"link": "3", "point": "B"}))
    assert fault.key == "load 1, force"
    assert fault.place == "forces and moments on links, 1: its size"
    assert "“its size”: 190 N" in fault.text
    text = SMALL.replace('["0.3 m", 0]', '["0.3 kg", 0]')
    wrong = scheme(SMALL.encode(), Path("s.toml"), SchemeAct(), EN)
    assert wrong["errors"] == []
    (fault,) = refused(text, SchemeAct(at=30.0))
    assert fault.place == "point B of link 2"


def test_every_field_of_the_form_has_its_place_in_words() -> None:
    found = formed(Task(SMALL.encode(), "scene.toml", None, "en"))
    fields = [one for group in found for one in group["fields"]]
    places = {one["key"]: one["place"] for one in fields}
    assert places["drive.speed"] == "the driving link and its motion: its angular speed"
    without = {key.partition(".")[0] for key, one in places.items() if not one}
    assert without <= {"scales", "title_block"}  # of which no more is said than a unit, or nothing


def test_russian_labels_stand_in_russian_quotes() -> None:
    says = plainly("write force = 5", speaking("ru"), "load 1, force")
    assert says == "write «её величина»: 5"
